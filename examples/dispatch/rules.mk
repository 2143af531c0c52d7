# examples/dispatch/: one binary for several instruction sets. Off x86 only the base object has anything to differ in.
DISPATCH_X86   := $(if $(filter x86_64 i%86 amd64,$(shell $(CC) -dumpmachine 2>/dev/null | cut -d- -f1)),yes)
DISPATCH_base  :=
DISPATCH_avx2  := $(if $(DISPATCH_X86),-mavx2 -mfma)
DISPATCH_avx512 := $(if $(DISPATCH_X86),-mavx512f -mavx512vl -mfma)
DISPATCH_FLAGS := $(filter-out -march=% -mcpu=%,$(CFLAGS))
ALL_TARGETS    += $(BUILD)/dispatch
TEST_TARGETS   += run-dispatch

$(BUILD)/dispatch: $(wildcard examples/dispatch/*.[ch]) sh_gradient.h | $(BUILD)
	@mkdir -p $(BUILD)/dispatch.d
	$(foreach isa,base avx2 avx512,$(CC) $(DISPATCH_FLAGS) $(DISPATCH_$(isa)) $(WARN) $(CPPFLAGS) -DISA=$(isa) \
	    -c examples/dispatch/kernels.c -o $(BUILD)/dispatch.d/$(isa).o &&) \
	$(CC) $(DISPATCH_FLAGS) $(WARN) $(CPPFLAGS) examples/dispatch/dispatch.c $(BUILD)/dispatch.d/*.o -lm -o $@

.PHONY: run-dispatch
run-dispatch: $(BUILD)/dispatch
	$(BUILD)/dispatch
