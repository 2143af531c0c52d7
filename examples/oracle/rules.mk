# examples/oracle/: the library's answers as text.
ORACLE := $(BUILD)/sh-oracle
ALL_TARGETS += $(ORACLE)

$(ORACLE): examples/oracle/sh-oracle.c examples/oracle/functions.h $(wildcard sh_*.h) | $(BUILD)
	$(CC) $(CPPFLAGS) $(CFLAGS) $(WARN) -o $@ $< -lm
