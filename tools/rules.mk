# tools/: what `make deps` and `make install` do.
PREFIX  ?= /usr/local
VERSION := $(shell sed -n 's/^\# *define SH_VERSION_M[AI][JN]OR *\([0-9]*\).*/\1./p; s/^\# *define SH_VERSION_PATCH *\([0-9]*\).*/\1/p' \
	sh_gradient.h 2>/dev/null | tr -d '\n')

# done by the Makefile while it is read
deps: ; @:

# Headers, pkg-config file and CMake package: the same files as `cmake --install` puts there.
install:
	install -d "$(DESTDIR)$(PREFIX)/include/shlight" "$(DESTDIR)$(PREFIX)/lib/pkgconfig" \
		"$(DESTDIR)$(PREFIX)/lib/cmake/shlight"
	install -m 644 $(wildcard $(HEADERS)) "$(DESTDIR)$(PREFIX)/include/shlight"
	sed -e 's|@PREFIX@|$(abspath $(PREFIX))|' -e 's|@VERSION@|$(VERSION)|' shlight.pc.in \
		>"$(DESTDIR)$(PREFIX)/lib/pkgconfig/shlight.pc"
	sed 's|@VERSION@|$(VERSION)|' tools/shlightConfigVersion.cmake.in \
		>"$(DESTDIR)$(PREFIX)/lib/cmake/shlight/shlightConfigVersion.cmake"
	install -m 644 tools/shlightConfig.cmake "$(DESTDIR)$(PREFIX)/lib/cmake/shlight"

# The tables of sh_product.h: make tables writes them, make check-tables compares.
TABLE_CHECKS += check-tables-product
.PHONY: tables-product check-tables-product
tables: tables-product
tables-product:
	$(PYTHON) tools/gen_product.py
check-tables-product:
	$(PYTHON) tools/gen_product.py --check

# tests/conventions/golden.csv against the real packages (network for npm; what is missing is named and skipped).
.PHONY: check-conventions
check-conventions:
	$(PYTHON) tests/conventions/check.py $(BUILD)/conventions

# The rules and lobe sets of sh_polygon.h; tools/gen_lobes.py --optimise searches new directions.
TABLE_CHECKS += check-tables-polygon
.PHONY: tables-polygon check-tables-polygon fuzz-polygon
tables: tables-polygon
tables-polygon:
	$(PYTHON) tools/gen_lobes.py
check-tables-polygon:
	$(PYTHON) tools/gen_lobes.py --check

# Raw bits into every call of sh_polygon.h: what comes out is finite, and nothing is written beside it. A few rounds with
# `make test`; FUZZ_ROUNDS=1000000 takes twenty minutes.
FUZZ_ROUNDS ?= 20000
fuzz: fuzz-polygon
.PHONY: test-fuzz
TEST_TARGETS += test-fuzz
fuzz-polygon: $(BUILD)/fuzz_polygon
	$(BUILD)/fuzz_polygon $(FUZZ_ROUNDS)
test-fuzz: $(BUILD)/fuzz_polygon
	$(BUILD)/fuzz_polygon 3000
$(BUILD)/fuzz_polygon: tests/fuzz_polygon.c sh_polygon.h sh_gradient.h | $(BUILD)
	$(CC) $(CPPFLAGS) -std=gnu99 -O1 -fsanitize=address,undefined -fno-sanitize-recover=all -DSH_UNROLLED_BANDS=3 $(WARN) -o $@ $< -lm
