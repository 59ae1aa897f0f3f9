/* The program of the robot: loads the press between two strokes. */
#include <stdlib.h>
#include <symplant/program.h>

enum { OUT, IN, GO_OUT, GO_IN, COUNT };

static const struct symplant_variable variables[COUNT] = {
    [OUT] = {.symbol = "CELL_HANDLING_ROBOT_I_OUT1", .bits = 1},
    [IN] = {.symbol = "CELL_HANDLING_ROBOT_I_IN2", .bits = 1},
    [GO_OUT] = {.symbol = "CELL_HANDLING_ROBOT_O_OUT1", .writes = 1, .bits = 1},
    [GO_IN] = {.symbol = "CELL_HANDLING_ROBOT_O_IN2", .writes = 1, .bits = 1},
};

static const int64_t kLoad = INT64_C(10000000000); /* from load to load */

/* When it first reaches in: the press comes down at 10 s, 20 s, .. and is up again 1.5 s later. */
#ifndef FIRST_LOAD_MS
#define FIRST_LOAD_MS 4000
#endif

struct robot {
  uint8_t *io[COUNT];
  int64_t next; /* load */
};

static void *create(void *const *cells) {
  struct robot *robot = calloc(1, sizeof *robot);
  if (robot == NULL) return NULL;
  for (int i = 0; i < COUNT; ++i) robot->io[i] = cells[i];
  robot->next = FIRST_LOAD_MS * INT64_C(1000000);
  return robot;
}

static int scan(void *instance, int64_t now_ns) {
  struct robot *robot = instance;
  uint8_t *const *io = robot->io;
  if (now_ns >= robot->next && *io[OUT]) {
    robot->next += kLoad;
    *io[GO_IN] = 1;
    *io[GO_OUT] = 0;
  } else if (*io[IN]) {
    *io[GO_IN] = 0;
    *io[GO_OUT] = 1;
  }
  return 0;
}

const struct symplant_program *symplant_program_v1(void) {
  static const struct symplant_program program = {
      .version = 1,
      .size = sizeof program,
      .name = "robot",
      .period_ns = 40000000,
      .variables = variables,
      .count = COUNT,
      .create = create,
      .scan = scan,
      .destroy = free,
  };
  return &program;
}
