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

# The tables of the headers: make tables writes them, make check-tables compares. tools/gen_lobes.py --optimise searches new
# directions for sh_polygon.h's lobe sets.
TABLES := gradient product lobes
TABLE_CHECKS += $(TABLES:%=check-tables-%)
.PHONY: $(TABLES:%=tables-%) $(TABLES:%=check-tables-%)
tables: $(TABLES:%=tables-%)
$(TABLES:%=tables-%): tables-%:
	$(PYTHON) tools/gen_$*.py
$(TABLES:%=check-tables-%): check-tables-%:
	$(PYTHON) tools/gen_$*.py --check

# tests/conventions/golden.csv against the real packages (network for npm; what is missing is named and skipped).
.PHONY: check-conventions
check-conventions:
	$(PYTHON) tests/conventions/check.py $(BUILD)/conventions
