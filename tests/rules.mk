# tests/: every tests/test_*.c is a cmocka program of its own; `make test` ends with running them all.
TESTS_DIR      := $(BUILD)/tests
TESTS_SOURCES  := $(sort $(wildcard tests/test_*.c))
TESTS_PROGRAMS := $(TESTS_SOURCES:tests/%.c=$(TESTS_DIR)/%)
TESTS_HELPERS  := $(TESTS_DIR)/ref.o $(TESTS_DIR)/report.o
# The references must keep their arithmetic whatever CFLAGS the headers are tested with.
TESTS_REF_FLAGS := -std=gnu99 -O2 -ffp-contract=off -fno-fast-math
TESTS_LIBS     := -lcmocka -lm
TESTS_LIBS_test_reference := -lgsl -lgslcblas -lflint-arb -lflint

.PHONY: test-unit $(TESTS_SOURCES:tests/%.c=run-%)

$(TESTS_DIR): ; @mkdir -p $@

$(TESTS_DIR)/%.o: tests/%.c tests/report.h tests/ref.h | $(TESTS_DIR)
	$(CC) $(TESTS_REF_FLAGS) $(WARN) -Itests -c -o $@ $<

$(TESTS_PROGRAMS): $(TESTS_DIR)/%: tests/%.c $(TESTS_HELPERS) $(wildcard sh_*.h tests/*.h)
	$(CC) $(CPPFLAGS) $(CFLAGS) $(WARN) -Itests -o $@ $< $(TESTS_HELPERS) $(TESTS_LIBS_$*) $(TESTS_LIBS)

# one of them: make run-test_gradient_basis
$(TESTS_SOURCES:tests/%.c=run-%): run-%: $(TESTS_DIR)/%
	$(TESTS_DIR)/$*

define TESTS_RUN_ALL
@failed=; for t in $(TESTS_PROGRAMS); do echo "== $$t"; ./$$t 2>&1 || failed="$$failed $$t"; done; \
	if [ -n "$$failed" ]; then echo "FAILED:$$failed"; exit 1; fi
endef

test-unit: $(TESTS_PROGRAMS)
	$(TESTS_RUN_ALL)

# The recipe of `test` itself, so that the programs run last and the output ends with cmocka's summary.
test: $(TESTS_PROGRAMS)
	$(TESTS_RUN_ALL)

# The headers in every language, compiler and instruction set: a quick part with `make test`, all of it here.
.PHONY: test-matrix test-matrix-quick
TEST_TARGETS += test-matrix-quick
test-matrix-quick: ; @sh tests/matrix.sh quick $(BUILD)
test-matrix:       ; @sh tests/matrix.sh full $(BUILD)

# The oracle program against mpmath, every function, convention and error: a little with `make test`, more here.
.PHONY: test-oracle oracle-check
TEST_TARGETS += test-oracle
test-oracle: $(BUILD)/sh-oracle
	@$(PYTHON) tests/check_oracle.py $(BUILD)/sh-oracle --queries 1
	@$(PYTHON) tests/check_oracle_polygon.py $(BUILD)/sh-oracle --queries 1 --self-check 2
oracle-check: $(BUILD)/sh-oracle
	@$(PYTHON) tests/check_oracle.py $(BUILD)/sh-oracle --bands all --queries 8
	@$(PYTHON) tests/check_oracle_polygon.py $(BUILD)/sh-oracle --queries 24 --self-check 16

# The tests under the sanitizers; memory needs clang and everything instrumented, so it runs without cmocka. The references
# are optimised, they are most of the time. -fsanitize-memory-track-origins says where an uninitialised value was born.
TESTS_SANITIZED := $(filter-out tests/test_reference.c,$(TESTS_SOURCES))
.PHONY: sanitize sanitize-address sanitize-memory
sanitize: sanitize-address sanitize-memory
sanitize-address sanitize-memory: sanitize-%: | $(TESTS_DIR)
	@set -e; case $* in address) f="-fsanitize=address,undefined -fno-sanitize-recover=all" ;; memory) f="-fsanitize=memory" ;; esac; \
	for h in ref report; do clang -std=gnu99 -O2 $$f -Itests/plain -Itests -c -o $(TESTS_DIR)/$*-$$h.o tests/$$h.c; done; \
	for t in $(TESTS_SANITIZED); do echo "== $* $$t"; \
	clang -std=gnu99 -O0 -DSH_UNROLLED_BANDS=3 $$f -I. -Itests/plain -Itests -o $(TESTS_DIR)/$* $$t \
	    $(TESTS_DIR)/$*-ref.o $(TESTS_DIR)/$*-report.o -lm; \
	SH_TEST_EFFORT=0.05 $(TESTS_DIR)/$*; done; \
	echo "== $* examples/oracle"; clang -std=gnu99 -O0 -DSH_UNROLLED_BANDS=3 $$f -I. -o $(TESTS_DIR)/$* examples/oracle/sh-oracle.c -lm; \
	$(PYTHON) tests/check_oracle.py $(TESTS_DIR)/$* --function text

# make install and cmake --install, each used from a folder of its own
.PHONY: test-install
TEST_TARGETS += test-install
test-install: ; @sh tests/install.sh

# the headers on WebAssembly's SIMD, in node
TEST_TARGETS += test-wasm
.PHONY: test-wasm
test-wasm: ; @sh tests/wasm/run.sh $(BUILD)/wasm

# Raw bits into every call of sh_polygon.h: what comes out is finite, and nothing is written beside it. A few rounds with
# `make test`; FUZZ_ROUNDS=1000000 takes twenty minutes.
FUZZ_ROUNDS ?= 20000
.PHONY: fuzz-polygon test-fuzz
fuzz: fuzz-polygon
TEST_TARGETS += test-fuzz
fuzz-polygon: $(BUILD)/fuzz_polygon
	$(BUILD)/fuzz_polygon $(FUZZ_ROUNDS)
test-fuzz: $(BUILD)/fuzz_polygon
	$(BUILD)/fuzz_polygon 3000
$(BUILD)/fuzz_polygon: tests/fuzz_polygon.c sh_polygon.h sh_gradient.h | $(BUILD)
	$(CC) $(CPPFLAGS) -std=gnu99 -O1 -fsanitize=address,undefined -fno-sanitize-recover=all -DSH_UNROLLED_BANDS=3 $(WARN) -o $@ $< -lm
