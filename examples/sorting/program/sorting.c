/* The program of the sorting line: tall parts go to chute 1, low ones to chute 2. */
#include <stdlib.h>
#include <symplant/program.h>

enum { RUNS, LOW, HIGH, STOP1, STOP2, OUT1, BACK1, OUT2, BACK2, RUN, PUSH1, PUSH2, COUNT };

static const struct symplant_variable variables[COUNT] = {
    [RUNS] = {.symbol = "SO_M_BELT_I_RUN", .bits = 1},
    [LOW] = {.symbol = "SO_M_LOW_I_PART", .bits = 1},
    [HIGH] = {.symbol = "SO_M_HIGH_I_PART", .bits = 1},
    [STOP1] = {.symbol = "SO_M_STOP1_I_PART", .bits = 1},
    [STOP2] = {.symbol = "SO_M_STOP2_I_PART", .bits = 1},
    [OUT1] = {.symbol = "SO_M_PUSH1_I_OUT", .bits = 1},
    [BACK1] = {.symbol = "SO_M_PUSH1_I_BACK", .bits = 1},
    [OUT2] = {.symbol = "SO_M_PUSH2_I_OUT", .bits = 1},
    [BACK2] = {.symbol = "SO_M_PUSH2_I_BACK", .bits = 1},
    [RUN] = {.symbol = "SO_M_BELT_O_RUN", .writes = 1, .bits = 1},
    [PUSH1] = {.symbol = "SO_M_PUSH1_O_OUT", .writes = 1, .bits = 1},
    [PUSH2] = {.symbol = "SO_M_PUSH2_O_OUT", .writes = 1, .bits = 1},
};

#ifndef PUSH_DELAY
#define PUSH_DELAY 0
#endif
/* How many scans a new program waits before it pushes; a correct program does not wait. */
int sorting_push_delay = PUSH_DELAY;

enum { MOST = 16 }; /* parts between the photo-eyes and pusher 1 */

struct line {
  uint8_t *io[COUNT];
  int delay;
  uint8_t low, stop1, stop2;  /* of the scan before */
  uint8_t tall[MOST];         /* the parts between the photo-eyes and pusher 1, a ring */
  unsigned entered, left;     /* how many entered and left it */
  int to_stop2;               /* low parts between the pushers */
  int wait1, wait2;           /* scans until a pusher goes out; -1: it need not */
};

static void *create(void *const *cells) {
  struct line *line = calloc(1, sizeof *line);
  if (line == NULL) return NULL;
  for (int i = 0; i < COUNT; ++i) line->io[i] = cells[i];
  line->delay = sorting_push_delay;
  line->wait1 = line->wait2 = -1;
  return line;
}

static void push(uint8_t *go, int *wait, uint8_t out) {
  if (*wait >= 0 && (*wait)-- == 0) *go = 1;
  if (out) *go = 0;
}

static int scan(void *instance, int64_t now_ns) {
  struct line *line = instance;
  uint8_t *const *io = line->io;
  (void)now_ns;

  if (*io[LOW] && !line->low && line->entered - line->left < MOST) line->tall[line->entered++ % MOST] = *io[HIGH];
  if (*io[STOP1] && !line->stop1 && line->entered != line->left) {
    if (line->tall[line->left++ % MOST]) {
      line->wait1 = line->delay;
    } else {
      ++line->to_stop2;
    }
  }
  if (*io[STOP2] && !line->stop2 && line->to_stop2 > 0) {
    --line->to_stop2;
    line->wait2 = line->delay;
  }
  line->low = *io[LOW];
  line->stop1 = *io[STOP1];
  line->stop2 = *io[STOP2];

  push(io[PUSH1], &line->wait1, *io[OUT1]);
  push(io[PUSH2], &line->wait2, *io[OUT2]);
  *io[RUN] = 1;
  return 0;
}

const struct symplant_program *symplant_program_v1(void) {
  static const struct symplant_program program = {
      .version = 1,
      .size = sizeof program,
      .name = "sorting",
      .period_ns = 20000000,
      .variables = variables,
      .count = COUNT,
      .create = create,
      .scan = scan,
      .destroy = free,
  };
  return &program;
}
