# examples/products/: MP21's tables reproduced, its four shading paths, and what a zonal GGX lobe leaves out.
PRODUCTS_PROGRAMS := $(BUILD)/mp21-tables $(BUILD)/shading-paths $(BUILD)/lobe-fit
ALL_TARGETS  += $(PRODUCTS_PROGRAMS)
TEST_TARGETS += run-products
.PHONY: run-products

$(PRODUCTS_PROGRAMS): $(BUILD)/%: examples/products/%.c $(wildcard sh_*.h) | $(BUILD)
	$(CC) $(CPPFLAGS) $(CFLAGS) $(WARN) -o $@ $< -lm

# each ends with status 1 if a figure it prints is not what it should be
run-products: $(PRODUCTS_PROGRAMS)
	$(BUILD)/mp21-tables
	$(BUILD)/shading-paths
	$(BUILD)/lobe-fit
