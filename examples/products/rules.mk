# examples/products/: MP21's tables reproduced, and its four shading paths.
PRODUCTS_PROGRAMS := $(BUILD)/mp21-tables $(BUILD)/shading-paths
ALL_TARGETS  += $(PRODUCTS_PROGRAMS)
TEST_TARGETS += run-products
.PHONY: run-products

$(PRODUCTS_PROGRAMS): $(BUILD)/%: examples/products/%.c $(wildcard sh_*.h) | $(BUILD)
	$(CC) $(CPPFLAGS) $(CFLAGS) $(WARN) -o $@ $< -lm

# both end with status 1 if a figure they print is not what it should be
run-products: $(PRODUCTS_PROGRAMS)
	$(BUILD)/mp21-tables
	$(BUILD)/shading-paths
