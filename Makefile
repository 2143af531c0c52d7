# shlight: spherical-harmonics lighting in C99 headers. `make help` lists the targets.
.DEFAULT_GOAL := all
SHELL    := /bin/sh
BUILD    := build
CC       ?= cc
CXX      ?= c++
PYTHON   ?= /usr/bin/python3
# The headers need neither of these: they gain from contraction of a*b+c (the GNU dialects' default) and from the machine's ISA.
CFLAGS   ?= -std=gnu99 -O3 -march=native
WARN     := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Wcast-align -Wundef -Werror
CPPFLAGS += -I.
HEADERS  := sh_gradient.h sh_polygon.h sh_interp.h sh_product.h

# each folder's rules.mk adds to these
ALL_TARGETS  :=
TEST_TARGETS :=
TABLE_CHECKS :=

.PHONY: all deps test demo gl-demo gl-bench bench bench-quick fuzz tables check-tables sizes install clean help

# The rules look up what is installed while they are read: `make deps demo` on a bare machine installs before that
# (not with make -n).
ifneq ($(filter deps,$(MAKECMDGOALS)),)
ifeq ($(findstring n,$(firstword -$(MAKEFLAGS))),)
ifneq ($(shell sh tools/deps.sh >&2 || echo failed),)
$(error make deps did not succeed)
endif
endif
endif

include $(sort $(wildcard tests/rules.mk bench/rules.mk tools/rules.mk examples/*/rules.mk))

all: $(ALL_TARGETS)
test: $(TEST_TARGETS) check-tables
check-tables: $(TABLE_CHECKS)

$(BUILD):
	mkdir -p $@

clean:
	rm -rf $(BUILD)

help:
	@echo "make deps         install what tests, bench and demos need (Debian), or list it"
	@echo "make              the examples and the oracle, into build/"
	@echo "make test         all tests; make run-test_NAME one; make sanitize, test-matrix, oracle-check, fuzz the long ones"
	@echo "make demo         the main job: build/demo.png and its table"
	@echo "make gl-demo      the same on the GPU: build/gl-demo.png; make gl-bench times it"
	@echo "make bench        every benchmark, build/bench.csv and plots; make bench-quick the main rows in a minute"
	@echo "make sizes        compile time, size and code size of the headers"
	@echo "make tables       write the generated tables; make check-tables compares them"
	@echo "make install      headers, pkg-config file and CMake package to PREFIX (/usr/local)"
