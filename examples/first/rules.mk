# The README's first program, and the usual jobs.
ALL_TARGETS += $(BUILD)/first $(BUILD)/recipes

$(BUILD)/first $(BUILD)/recipes: $(BUILD)/%: examples/first/%.c $(HEADERS) | $(BUILD)
	$(CC) $(CFLAGS) $(WARN) $(CPPFLAGS) $< $(LDFLAGS) -lm -o $@

# the README shows that program and what it prints; the recipes' two numbers a line agree
TEST_TARGETS += test-first
.PHONY: test-first
test-first: $(BUILD)/first $(BUILD)/recipes ; @sh examples/first/test.sh $(BUILD)
