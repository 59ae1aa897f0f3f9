/* The interface of a PLC program that runs in lock step with a plant: a shared library that exports symplant_program_v1().
 *
 * C99 and later, and C++; includes nothing of symplant. Whatever makes such a library is a compiler of programs:
 * docs/testing-programs.md shows some.
 */
#ifndef SYMPLANT_PROGRAM_H
#define SYMPLANT_PROGRAM_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A variable of the program that is bound to a symbol of the plant: by its name if there is one, else by its address. */
struct symplant_variable {
  const char *symbol;  /* the name of a symbol, or NULL: by address */
  const char *address; /* "%IX3.2", "%QW4"; NULL: none */
  uint8_t writes;      /* 0: the program reads it (an event); 1: it writes it (an operation) */
  uint8_t bits;        /* 1 (one byte, 0 or 1), 8, 16, 32 or 64: the width of the symbol's type */
};

/* A program. It must stay valid and unchanged until the library is closed. All calls come from one thread, and at most one
 * instance lives at a time. */
struct symplant_program {
  uint32_t version;                          /* 1 */
  uint32_t size;                             /* sizeof(struct symplant_program): later members come at the end */
  const char *name;                          /* for messages */
  int64_t period_ns;                         /* from scan to scan; 0: as the user sets it, else 10 ms */
  const struct symplant_variable *variables; /* `count` of them */
  uint32_t count;
  /* Makes an instance, at a cold start. cells[i] is the memory of variable i, aligned to 8 bytes, at one address until
   * destroy(): the host writes those that are read before a scan, and reads those that are written after it. One that a
   * scan does not write keeps its value; at first it has the operation's at t = 0. NULL: failed. */
  void *(*create)(void *const *cells);
  /* One scan, at plant time now_ns. 0: good; otherwise the run ends with this number. */
  int (*scan)(void *instance, int64_t now_ns);
  void (*destroy)(void *instance);
};

/* What the library exports. */
const struct symplant_program *symplant_program_v1(void);

#ifdef __cplusplus
}
#endif

#endif
