/* The program of the press: presses once each time the robot is out again. */
#include <stdlib.h>
#include <symplant/program.h>

enum { UP, DOWN, GO_UP, GO_DOWN, COUNT };

/* By address, as a compiler of Structured Text gives located variables: the names of the list do not matter. */
static const struct symplant_variable variables[COUNT] = {
    [UP] = {.address = "%IX1", .bits = 1},
    [DOWN] = {.address = "%IX2", .bits = 1},
    [GO_UP] = {.address = "%QX1", .writes = 1, .bits = 1},
    [GO_DOWN] = {.address = "%QX2", .writes = 1, .bits = 1},
};

static const int64_t kStroke = INT64_C(10000000000); /* from stroke to stroke */

struct press {
  uint8_t *io[COUNT];
  int64_t next; /* of the next stroke */
};

static void *create(void *const *cells) {
  struct press *press = calloc(1, sizeof *press);
  if (press == NULL) return NULL;
  for (int i = 0; i < COUNT; ++i) press->io[i] = cells[i];
  press->next = kStroke;
  return press;
}

static int scan(void *instance, int64_t now_ns) {
  struct press *press = instance;
  uint8_t *const *io = press->io;
  if (now_ns >= press->next && *io[UP]) {
    press->next += kStroke;
    *io[GO_DOWN] = 1;
    *io[GO_UP] = 0;
  } else if (*io[DOWN]) {
    *io[GO_DOWN] = 0;
    *io[GO_UP] = 1;
  }
  return 0;
}

const struct symplant_program *symplant_program_v1(void) {
  static const struct symplant_program program = {
      .version = 1,
      .size = sizeof program,
      .name = "press",
      .period_ns = 10000000,
      .variables = variables,
      .count = COUNT,
      .create = create,
      .scan = scan,
      .destroy = free,
  };
  return &program;
}
