# The README's first program.
ALL_TARGETS += $(BUILD)/first

$(BUILD)/first: examples/first/first.c sh_gradient.h | $(BUILD)
	$(CC) $(CFLAGS) $(WARN) $(CPPFLAGS) examples/first/first.c $(LDFLAGS) -lm -o $@
