# shlight: spherical-harmonics lighting in C99 headers.   make help
.DEFAULT_GOAL := all
SHELL   := /bin/sh
BUILD   := build
CC      ?= cc
CXX     ?= c++
PYTHON  ?= /usr/bin/python3
# The headers want contraction of a*b+c (the GNU dialects' default) and the ISA of this machine; they need neither.
CFLAGS  ?= -std=gnu99 -O3 -march=native
WARN    := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Wcast-align -Wundef -Werror
CPPFLAGS += -I.
HEADERS := sh_gradient.h sh_polygon.h sh_interp.h sh_product.h

ALL_TARGETS :=
TEST_TARGETS :=
TABLE_CHECKS :=

.PHONY: all deps test demo gl-demo gl-bench bench bench-quick fuzz tables check-tables sizes install clean help

include $(wildcard tests/rules.mk bench/rules.mk examples/*/rules.mk tools/rules.mk)

all: $(ALL_TARGETS)
test: $(TEST_TARGETS) check-tables
check-tables: $(TABLE_CHECKS)

$(BUILD):
	mkdir -p $@

clean:
	rm -rf $(BUILD)
