/* The program of the paper's cell: the AGV brings a part, the machine works on it, both go back. */
#include <stdlib.h>
#include <symplant/program.h>

enum { AT_STORE, AT_MACHINE, IDLE, WORKS, TO_MACHINE, TO_STORE, STOP, START, COUNT };

static const struct symplant_variable variables[COUNT] = {
    [AT_STORE] = {.symbol = "EXLINE_MB_AGV_I_P1", .bits = 1},
    [AT_MACHINE] = {.symbol = "EXLINE_MB_AGV_I_P2", .bits = 1},
    [IDLE] = {.symbol = "EXLINE_MB_MC_I_IDLE1", .bits = 1},
    [WORKS] = {.symbol = "EXLINE_MB_MC_I_RUN2", .bits = 1},
    [TO_MACHINE] = {.symbol = "EXLINE_MB_AGV_O_P2", .writes = 1, .bits = 1},
    [TO_STORE] = {.symbol = "EXLINE_MB_AGV_O_P1", .writes = 1, .bits = 1},
    [STOP] = {.symbol = "EXLINE_MB_MC_O_IDLE1", .writes = 1, .bits = 1},
    [START] = {.symbol = "EXLINE_MB_MC_O_RUN2", .writes = 1, .bits = 1},
};

#ifndef WORK_MS
#define WORK_MS 300
#endif

struct cell {
  uint8_t *io[COUNT];
  enum { HOME, FETCH, WORK, BACK } phase;
  int64_t works_since; /* ns; -1: the machine does not work */
};

static void *create(void *const *cells) {
  struct cell *cell = calloc(1, sizeof *cell);
  if (cell == NULL) return NULL;
  for (int i = 0; i < COUNT; ++i) cell->io[i] = cells[i];
  cell->works_since = -1;
  return cell;
}

static int scan(void *instance, int64_t now_ns) {
  struct cell *cell = instance;
  uint8_t *const *io = cell->io;

  if (cell->phase != WORK || !*io[WORKS]) {
    cell->works_since = -1;
  } else if (cell->works_since < 0) {
    cell->works_since = now_ns;
  }
  const int worked = cell->works_since >= 0 && now_ns - cell->works_since >= WORK_MS * INT64_C(1000000);

  switch (cell->phase) {
    case HOME:
      if (*io[AT_STORE] && *io[IDLE]) cell->phase = FETCH;
      break;
    case FETCH:
      if (*io[AT_MACHINE] && *io[IDLE]) cell->phase = WORK;
      break;
    case WORK:
      if (worked) cell->phase = BACK;
      break;
    case BACK:
      if (*io[AT_STORE] && *io[IDLE]) cell->phase = HOME;
      break;
  }
  *io[TO_MACHINE] = cell->phase == FETCH;
  *io[START] = cell->phase == WORK;
  *io[TO_STORE] = cell->phase == BACK;
  *io[STOP] = cell->phase == BACK;
  return 0;
}

const struct symplant_program *symplant_program_v1(void) {
  static const struct symplant_program program = {
      .version = 1,
      .size = sizeof program,
      .name = "cell",
      .variables = variables,
      .count = COUNT,
      .create = create,
      .scan = scan,
      .destroy = free,
  };
  return &program;
}
