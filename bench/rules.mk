# bench/: one program; suites are compiled once per precision, the baselines also as plain scalar code.
# Objects live in a folder per compiler and flags, so that `make bench-quick CC=clang` rebuilds nothing of gcc's.
BENCH_DIR     := $(BUILD)/bench/$(shell printf '%s' '$(CC) $(CFLAGS)' | cksum | cut -d' ' -f1)
BENCH_CSV     ?= $(BUILD)/bench.csv
BENCH_SUITES  := basis stream lights polygon product interp
BENCH_FORMS   := basis_forms lights_forms polygon_forms product_forms
BENCH_AUTO    := basis_forms lights_forms
BENCH_OBJECTS := $(addprefix $(BENCH_DIR)/,harness.o main.o targets.o floor.o \
                   $(foreach p,f32 f64,$(BENCH_SUITES:%=%_$(p).o) \
                     $(BENCH_FORMS:%=%_$(p).o) $(BENCH_AUTO:%=%_auto_$(p).o)))
BENCH_QUICK   := $(addprefix $(BENCH_DIR)/,harness.o quick.o targets.o floor.o $(patsubst %,%_f32.o, \
                   $(filter-out stream,$(BENCH_SUITES)) $(BENCH_FORMS) $(BENCH_AUTO:%=%_auto)))
# Optional parts, looked for when the bench is built: GSL and Boost as further impls, OpenMP for all threads.
BENCH_GSL     = $(shell pkg-config --exists gsl 2>/dev/null && echo -DBENCH_GSL)
BENCH_BOOST   = $(shell echo '\#include <boost/math/special_functions/spherical_harmonic.hpp>' | \
                  $(CXX) -E -x c++ - >/dev/null 2>&1 && echo -DBENCH_BOOST)
BENCH_OPENMP  = $(shell echo 'int main(void) { return 0; }' | $(CC) -fopenmp -x c - -o /dev/null 2>/dev/null && echo -fopenmp)
BENCH_COMPILE = $(CC) $(CPPFLAGS) $(CFLAGS) $(WARN) -Ibench
# The published forms are scalar code; *_auto is the same file as the compiler likes it.
BENCH_SCALAR  := -fno-tree-vectorize -fno-tree-slp-vectorize
# What includes no header of the library is not rebuilt when one changes.
BENCH_OWN     := $(wildcard bench/*.h)
BENCH_HEADERS  = $(BENCH_OWN) $(HEADERS)

.PHONY: bench-check bench-program check-bench-tables performance-doc

$(BENCH_DIR): ; @mkdir -p $@

$(BENCH_DIR)/%.o: bench/%.c bench/bench.h | $(BENCH_DIR)
	$(BENCH_COMPILE) -DBENCH_FLAGS='"$(CFLAGS)"' -c -o $@ $<
$(BENCH_DIR)/%_f32.o: bench/%.c $(BENCH_HEADERS) | $(BENCH_DIR)
	$(BENCH_COMPILE) -DBENCH_PRECISION=32 $(BENCH_GSL) $(BENCH_BOOST) $(BENCH_OPENMP) -c -o $@ $<
$(BENCH_DIR)/%_f64.o: bench/%.c $(BENCH_HEADERS) | $(BENCH_DIR)
	$(BENCH_COMPILE) -DBENCH_PRECISION=64 $(BENCH_GSL) $(BENCH_BOOST) $(BENCH_OPENMP) -c -o $@ $<
$(BENCH_DIR)/%_forms_f32.o: bench/%_forms.c $(BENCH_OWN) | $(BENCH_DIR)
	$(BENCH_COMPILE) $(BENCH_SCALAR) -DBENCH_PRECISION=32 -c -o $@ $<
$(BENCH_DIR)/%_forms_f64.o: bench/%_forms.c $(BENCH_OWN) | $(BENCH_DIR)
	$(BENCH_COMPILE) $(BENCH_SCALAR) -DBENCH_PRECISION=64 -c -o $@ $<
$(BENCH_DIR)/%_forms_auto_f32.o: bench/%_forms.c $(BENCH_OWN) | $(BENCH_DIR)
	$(BENCH_COMPILE) -DBENCH_AUTO -DBENCH_PRECISION=32 -c -o $@ $<
$(BENCH_DIR)/%_forms_auto_f64.o: bench/%_forms.c $(BENCH_OWN) | $(BENCH_DIR)
	$(BENCH_COMPILE) -DBENCH_AUTO -DBENCH_PRECISION=64 -c -o $@ $<
$(BENCH_DIR)/boost.o: bench/boost.cpp | $(BENCH_DIR)
	$(CXX) -O3 -c -o $@ $<

$(BENCH_DIR)/quick.o: bench/main.c bench/bench.h | $(BENCH_DIR)
	$(BENCH_COMPILE) -DBENCH_FLAGS='"$(CFLAGS)"' -DBENCH_QUICK -c -o $@ $<

# Boost's object is part of the link only where its header is found.
$(BENCH_DIR)/bench: $(BENCH_OBJECTS)
$(BENCH_DIR)/bench-quick: $(BENCH_QUICK)
$(BENCH_DIR)/bench $(BENCH_DIR)/bench-quick:
	$(if $(BENCH_BOOST),$(MAKE) --no-print-directory $(BENCH_DIR)/boost.o)
	$(CC) $(CFLAGS) $(BENCH_OPENMP) -o $@ $^ $(if $(BENCH_BOOST),$(BENCH_DIR)/boost.o -lstdc++) \
	    $(if $(BENCH_GSL),$(shell pkg-config --libs gsl 2>/dev/null)) -lm

bench-program: $(BENCH_DIR)/bench

# Everything, both precisions: tables, build/bench.csv, build/bench-*.svg.
bench: $(BENCH_DIR)/bench
	$(BENCH_DIR)/bench --csv $(BENCH_CSV)
	sh bench/plot.sh $(BENCH_CSV) $(BUILD)

# Within a minute once built: f32, ends with the targets and what was measured. Informative, never a failure.
bench-quick: $(BENCH_DIR)/bench-quick
	$(BENCH_DIR)/bench-quick --csv $(BENCH_CSV:.csv=-quick.csv)

# Every baseline against the library, nothing timed.
bench-check: $(BENCH_DIR)/bench
	$(BENCH_DIR)/bench --check

# The generated baselines are what their generators print.
check-bench-tables: | $(BENCH_DIR)
	$(PYTHON) bench/gen_sloan.py > $(BENCH_DIR)/generated && cmp $(BENCH_DIR)/generated bench/sloan.h
	$(PYTHON) bench/gen_polynomial.py > $(BENCH_DIR)/generated && cmp $(BENCH_DIR)/generated bench/polynomial.h
TABLE_CHECKS += check-bench-tables

tables: bench-tables
bench-tables:
	$(PYTHON) bench/gen_sloan.py > bench/sloan.h
	$(PYTHON) bench/gen_polynomial.py > bench/polynomial.h
.PHONY: bench-tables

# docs/performance.md from the CSVs: this compiler, clang, and the default flags (SSE2).
performance-doc: bench
	-$(MAKE) --no-print-directory bench-quick CC=clang BENCH_CSV=$(BUILD)/bench-clang.csv
	$(MAKE) --no-print-directory bench-quick CFLAGS=-O2 BENCH_CSV=$(BUILD)/bench-O2.csv
	$(PYTHON) bench/report.py $(BENCH_CSV) $(BUILD)/bench-clang-quick.csv $(BUILD)/bench-O2-quick.csv > docs/performance.md

# Instructions, FMAs and spills of the inner loops: light sums, basis values and gradients.
bench-loops: $(BENCH_DIR)/lights_f32.o $(BENCH_DIR)/basis_f32.o
	objdump -d --no-show-raw-insn $(BENCH_DIR)/lights_f32.o | $(PYTHON) bench/loops.py shi_moments_gradient 4
	objdump -d --no-show-raw-insn $(BENCH_DIR)/basis_f32.o | $(PYTHON) bench/loops.py shi_blocks_values 9
	objdump -d --no-show-raw-insn $(BENCH_DIR)/basis_f32.o | $(PYTHON) bench/loops.py shi_blocks_both 36
.PHONY: bench-loops

# Size and compile time of each header, code size of each group of functions.
sizes:
	CC='$(CC)' sh bench/sizes.sh $(BUILD) $(HEADERS)
