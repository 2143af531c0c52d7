# The relight example: the library's main job, end to end. Needs stb (Debian: libstb-dev); OpenMP where cc has it.
RELIGHT_DIR := examples/relight
RELIGHT_SRC := $(addprefix $(RELIGHT_DIR)/,relight.c mesh.c scene.c trace.c shade.c lamps.c picture.c)
RELIGHT_OMP := $(shell echo 'int main(void){return 0;}' | $(CC) -fopenmp -x c - -o /dev/null 2>/dev/null && echo -fopenmp || echo -Wno-unknown-pragmas)

ALL_TARGETS  += $(BUILD)/relight
TEST_TARGETS += test-relight

$(BUILD)/relight: $(RELIGHT_SRC) $(RELIGHT_DIR)/relight.h $(wildcard $(HEADERS)) | $(BUILD)
	$(CC) $(CFLAGS) $(WARN) $(CPPFLAGS) $(RELIGHT_OMP) $(RELIGHT_SRC) $(LDFLAGS) -lm -o $@

demo: $(BUILD)/relight
	$(BUILD)/relight --out $(BUILD)/demo

.PHONY: test-relight
test-relight: $(BUILD)/relight
	$(RELIGHT_DIR)/test.sh $(BUILD)/relight $(BUILD)
