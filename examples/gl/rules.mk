# The GPU path: M22's grid in a compute shader, shading in a fragment shader. Needs libepoxy, GLFW and stb
# (Debian: libepoxy-dev libglfw3-dev libstb-dev, for the tests also glslang-tools xvfb); without them nothing is
# built.
GL_DIR     := examples/gl
GL_LIBS    := $(shell pkg-config --libs epoxy glfw3 2>/dev/null)
GL_EPOXY   := $(shell pkg-config --libs epoxy 2>/dev/null)
GL_SHADERS := $(addprefix $(GL_DIR)/,sh.glsl polygon.glsl grid.comp surface.vert surface.frag occlusion.frag \
                shade.frag final.frag whole.vert text.vert text.frag)
GL_ROOMS   := context stage programs passes letters check
GL_OBJECTS := $(patsubst %,$(BUILD)/gl/%.o,$(GL_ROOMS) relight-mesh relight-scene relight-trace)
GL_HEADERS := $(GL_DIR)/gl.h examples/relight/relight.h $(BUILD)/gl/gl_shaders.h

.PHONY: gl-demo gl-bench gl-bench-quick gl-doc test-gl check-glsl
TEST_TARGETS += test-gl
TABLE_CHECKS += check-glsl

check-glsl: ; @$(PYTHON) $(GL_DIR)/gen_glsl.py --check

# docs/gl.md from what gl-bench wrote last, or from GL_CSV="FILE ..."
GL_CSV ?= $(BUILD)/gl-bench.csv
gl-doc: ; $(PYTHON) $(GL_DIR)/report.py $(GL_CSV) > docs/gl.md

ifneq ($(GL_LIBS),)
ALL_TARGETS += $(BUILD)/gl-demo

$(BUILD)/gl: ; @mkdir -p $@

# every shader file as an array of its lines, ended by NULL
$(BUILD)/gl/gl_shaders.h: $(GL_SHADERS) | $(BUILD)/gl
	@for f in $(GL_SHADERS); do \
	    echo "static const char *const $$(basename $$f | tr . _)[] = {"; \
	    sed 's/\\/\\\\/g; s/"/\\"/g; s/^/    "/; s/$$/\\n",/' $$f; echo "    NULL"; echo "};"; done > $@

$(BUILD)/gl/%.o: $(GL_DIR)/%.c $(GL_HEADERS) $(wildcard $(HEADERS)) | $(BUILD)/gl
	$(CC) $(CFLAGS) $(WARN) $(CPPFLAGS) -I$(BUILD)/gl -c $< -o $@
$(BUILD)/gl/relight-%.o: examples/relight/%.c examples/relight/relight.h $(wildcard $(HEADERS)) | $(BUILD)/gl
	$(CC) $(CFLAGS) $(WARN) $(CPPFLAGS) $(RELIGHT_OMP) -c $< -o $@
$(BUILD)/gl-demo: $(BUILD)/gl/demo.o $(BUILD)/gl/window.o $(GL_OBJECTS)
	$(CC) $(CFLAGS) $(RELIGHT_OMP) $^ $(LDFLAGS) $(GL_LIBS) -lm -o $@
$(BUILD)/gl-bench: $(BUILD)/gl/bench.o $(GL_OBJECTS)
	$(CC) $(CFLAGS) $(RELIGHT_OMP) $^ $(LDFLAGS) $(GL_EPOXY) -lm -o $@

$(BUILD)/test-gl: $(BUILD)/gl/test_gl.o $(GL_OBJECTS) $(BUILD)/gl/relight-shade.o
	$(CC) $(CFLAGS) $(RELIGHT_OMP) $^ $(LDFLAGS) $(GL_EPOXY) -lm -o $@

test-gl: $(BUILD)/gl-demo $(BUILD)/test-gl
	@$(GL_DIR)/test.sh $(BUILD)
gl-demo: $(BUILD)/gl-demo
	$(BUILD)/gl-demo --out $(BUILD)/gl-demo.png
gl-bench: $(BUILD)/gl-bench
	$(BUILD)/gl-bench --out $(BUILD)/gl-bench.csv
gl-bench-quick: $(BUILD)/gl-bench
	$(BUILD)/gl-bench --quick --out $(BUILD)/gl-bench.csv
else
test-gl:
	@$(GL_DIR)/test.sh $(BUILD)
gl-demo gl-bench gl-bench-quick:
	@echo "$@: libepoxy or GLFW is missing (pkg-config finds no epoxy, glfw3): make deps" >&2; exit 77
endif
