/* The program of the drill station: the belt brings a part to the stop, the clamp holds it, the slide drills it.
 *
 * With -DHOLES it has four holes, which a campaign shows:
 *   1. no step but the start of the spindle has a timeout;
 *   2. a fault stops the slide, but not the spindle;
 *   3. the guard door is not read;
 *   4. the spindle has 10 s to start instead of 2 s.
 */
#include <stdlib.h>
#include <symplant/program.h>

enum { START, GUARD, PART, BELT_RUNS, OPENED, CLOSED, SPINDLE_RUNS, UP, DOWN, /* read */
       BELT, CLOSE, OPEN, SPINDLE, GO_UP, GO_DOWN, LAMP, HORN, COUNT };

static const struct symplant_variable variables[COUNT] = {
    [START] = {.symbol = "DR_S1_BUTTONSTART_I_PUSH", .bits = 1},
    [GUARD] = {.symbol = "DR_S1_GUARD_I_SHUT", .bits = 1},
    [PART] = {.symbol = "DR_S1_STOP_I_PART", .bits = 1},
    [BELT_RUNS] = {.symbol = "DR_S1_BELT_I_RUN", .bits = 1},
    [OPENED] = {.symbol = "DR_S1_CLAMP_I_OPEN", .bits = 1},
    [CLOSED] = {.symbol = "DR_S1_CLAMP_I_CLOSE", .bits = 1},
    [SPINDLE_RUNS] = {.symbol = "DR_S1_SPINDLE_I_RUN", .bits = 1},
    [UP] = {.symbol = "DR_S1_SLIDE_I_UP", .bits = 1},
    [DOWN] = {.symbol = "DR_S1_SLIDE_I_DOWN", .bits = 1},
    [BELT] = {.symbol = "DR_S1_BELT_O_RUN", .writes = 1, .bits = 1},
    [CLOSE] = {.symbol = "DR_S1_CLAMP_O_CLOSE", .writes = 1, .bits = 1},
    [OPEN] = {.symbol = "DR_S1_CLAMP_O_OPEN", .writes = 1, .bits = 1},
    [SPINDLE] = {.symbol = "DR_S1_SPINDLE_O_RUN", .writes = 1, .bits = 1},
    [GO_UP] = {.symbol = "DR_S1_SLIDE_O_UP", .writes = 1, .bits = 1},
    [GO_DOWN] = {.symbol = "DR_S1_SLIDE_O_DOWN", .writes = 1, .bits = 1},
    [LAMP] = {.symbol = "DR_S1_LAMPFAULT_O_ON", .writes = 1, .bits = 1},
    [HORN] = {.symbol = "DR_S1_HORN_O_ON", .writes = 1, .bits = 1},
};

enum step { IDLE, FETCH, CLAMPING, SPEED_UP, DRILL, RETRACT, RELEASE, EJECT };

struct station {
  uint8_t *io[COUNT];
  enum step step;
  int fault;
  int64_t since; /* when the step began, ns */
};

static void *create(void *const *cells) {
  struct station *station = calloc(1, sizeof *station);
  if (station == NULL) return NULL;
  for (int i = 0; i < COUNT; ++i) station->io[i] = cells[i];
  return station;
}

/* The longest time for a step, in ms; 0: it may wait. */
static int64_t most_ms(enum step step) {
#ifdef HOLES
  return step == SPEED_UP ? 10000 : 0;
#else
  switch (step) {
    case IDLE: return 0;
    case FETCH: return 6000;
    case EJECT: return 3000;
    default: return 2000;
  }
#endif
}

/* Whether a step has reached what it is for. */
static int is_done(const struct station *station) {
  uint8_t *const *io = station->io;
  switch (station->step) {
    case IDLE: return *io[START];
    case FETCH: return *io[PART] && *io[BELT_RUNS];
    case CLAMPING: return *io[CLOSED] && !*io[OPENED];
    case SPEED_UP: return *io[SPINDLE_RUNS];
    case DRILL: return *io[DOWN];
    case RETRACT: return *io[UP] && !*io[DOWN];
    case RELEASE: return *io[OPENED] && !*io[CLOSED];
    default: return !*io[PART];
  }
}

/* Whether what must not happen in a step does. */
static int is_unsafe(const struct station *station) {
#ifdef HOLES
  (void)station;
  return 0;
#else
  uint8_t *const *io = station->io;
  const int drills = station->step == DRILL || station->step == RETRACT;
  const int too_early = station->step == CLAMPING && *io[SPINDLE_RUNS]; /* it has not been started */
  return !*io[GUARD] || too_early || (drills && !(*io[CLOSED] && *io[SPINDLE_RUNS]));
#endif
}

static int scan(void *instance, int64_t now_ns) {
  struct station *station = instance;
  uint8_t *const *io = station->io;
  const int64_t most = most_ms(station->step) * INT64_C(1000000);
  if (station->step != IDLE && (is_unsafe(station) || (most > 0 && now_ns - station->since > most))) station->fault = 1;
  if (!station->fault && is_done(station)) {
    station->step = station->step == EJECT ? FETCH : station->step + 1;
    station->since = now_ns;
  }
  const int works = !station->fault;
  const enum step step = station->step;
  *io[BELT] = works && (step == FETCH || step == EJECT);
  *io[CLOSE] = works && step == CLAMPING;
  *io[OPEN] = works && step == RELEASE;
  *io[GO_DOWN] = works && step == DRILL;
  *io[GO_UP] = works ? step == RETRACT : !*io[UP];
  *io[SPINDLE] = works && (step == SPEED_UP || step == DRILL || step == RETRACT);
#ifdef HOLES
  *io[SPINDLE] = step == SPEED_UP || step == DRILL || step == RETRACT;
#endif
  *io[LAMP] = *io[HORN] = (uint8_t)station->fault;
  return 0;
}

const struct symplant_program *symplant_program_v1(void) {
  static const struct symplant_program program = {
      .version = 1,
      .size = sizeof program,
      .name = "drill",
      .period_ns = 10000000,
      .variables = variables,
      .count = COUNT,
      .create = create,
      .scan = scan,
      .destroy = free,
  };
  return &program;
}
