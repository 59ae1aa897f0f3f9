/* The program of the harbour crane: three motions that follow the levers, and what limits them. */
#include <stdlib.h>
#include <symplant/program.h>

enum { HOIST, SLEW, LUFF, MOTIONS };
enum {
  POWER_ON, TOP, BOTTOM, IN, OUT, START, ESTOP, RADIUS, FORCE, WIND, /* single inputs */
  OPEN,                                                              /* three each, by motion */
  CLOSED = OPEN + MOTIONS,
  LEVER = CLOSED + MOTIONS,
  POWER = LEVER + MOTIONS, MODE, OVERLOAD, STORM, /* single outputs */
  RELEASE,
  SPEED = RELEASE + MOTIONS,
  COUNT = SPEED + MOTIONS
};

static const struct symplant_variable variables[COUNT] = {
    [POWER_ON] = {.symbol = "PORT_C1_POWER_I_ON", .bits = 1},
    [TOP] = {.symbol = "PORT_C1_HOISTLIMIT_I_TOP", .bits = 1},
    [BOTTOM] = {.symbol = "PORT_C1_HOISTLIMIT_I_BOTTOM", .bits = 1},
    [IN] = {.symbol = "PORT_C1_LUFFLIMIT_I_IN", .bits = 1},
    [OUT] = {.symbol = "PORT_C1_LUFFLIMIT_I_OUT", .bits = 1},
    [START] = {.symbol = "PORT_C1_START_I_PRESSED", .bits = 1},
    [ESTOP] = {.symbol = "PORT_C1_ESTOP_I_PRESSED", .bits = 1},
    [RADIUS] = {.symbol = "PORT_C1_LUFF_I_RADIUS", .bits = 16},
    [FORCE] = {.symbol = "PORT_C1_ROPE_I_FORCE", .bits = 16},
    [WIND] = {.symbol = "PORT_C1_WIND_I_SPEED", .bits = 16},
    [OPEN + HOIST] = {.symbol = "PORT_C1_HOISTBRAKE_I_OPEN", .bits = 1},
    [OPEN + SLEW] = {.symbol = "PORT_C1_SLEWBRAKE_I_OPEN", .bits = 1},
    [OPEN + LUFF] = {.symbol = "PORT_C1_LUFFBRAKE_I_OPEN", .bits = 1},
    [CLOSED + HOIST] = {.symbol = "PORT_C1_HOISTBRAKE_I_CLOSED", .bits = 1},
    [CLOSED + SLEW] = {.symbol = "PORT_C1_SLEWBRAKE_I_CLOSED", .bits = 1},
    [CLOSED + LUFF] = {.symbol = "PORT_C1_LUFFBRAKE_I_CLOSED", .bits = 1},
    [LEVER + HOIST] = {.symbol = "PORT_C1_LEVER_I_HOIST", .bits = 16},
    [LEVER + SLEW] = {.symbol = "PORT_C1_LEVER_I_SLEW", .bits = 16},
    [LEVER + LUFF] = {.symbol = "PORT_C1_LEVER_I_LUFF", .bits = 16},
    [POWER] = {.symbol = "PORT_C1_POWER_O_ON", .writes = 1, .bits = 1},
    [MODE] = {.symbol = "PORT_C1_MODE_O_NUMBER", .writes = 1, .bits = 16},
    [OVERLOAD] = {.symbol = "PORT_C1_OVERLOAD_O_ON", .writes = 1, .bits = 1},
    [STORM] = {.symbol = "PORT_C1_STORM_O_ON", .writes = 1, .bits = 1},
    [RELEASE + HOIST] = {.symbol = "PORT_C1_HOISTBRAKE_O_OPEN", .writes = 1, .bits = 1},
    [RELEASE + SLEW] = {.symbol = "PORT_C1_SLEWBRAKE_O_OPEN", .writes = 1, .bits = 1},
    [RELEASE + LUFF] = {.symbol = "PORT_C1_LUFFBRAKE_O_OPEN", .writes = 1, .bits = 1},
    [SPEED + HOIST] = {.symbol = "PORT_C1_HOIST_O_SPEED", .writes = 1, .bits = 16},
    [SPEED + SLEW] = {.symbol = "PORT_C1_SLEW_O_SPEED", .writes = 1, .bits = 16},
    [SPEED + LUFF] = {.symbol = "PORT_C1_LUFF_O_SPEED", .writes = 1, .bits = 16},
};

/* 0: a program that leaves the ramps to the converters. */
#ifndef USE_RAMPS
#define USE_RAMPS 1
#endif
/* 0: a program without a load moment limiter. */
#ifndef USE_LIMITER
#define USE_LIMITER 1
#endif

static const double kPeriod = 0.02; /* s */
/* % of full speed per second: 0.5 m/s2, 0.8 deg/s2, 0.3 m/s2 */
static const double kRamp[MOTIONS] = {100 * 0.5 / 1.5, 100 * 0.8 / 8, 100 * 0.3 / 1};
static const double kStorm = 20, kCalm = 16; /* m/s */
static const double kHeavy = 20;             /* t */
static const int kHold = 25;                 /* scans at standstill until the brake closes */

enum mode { OFF, STARTS, READY, WORKS, STOPPED };
enum phase { BRAKED, RELEASES, MOVES, CLOSES };

struct motion {
  enum phase phase;
  double speed; /* % */
  int still;    /* scans at standstill */
};

struct crane {
  void *io[COUNT];
  enum mode mode;
  struct motion motions[MOTIONS];
  double force, wind; /* filtered: t, m/s */
};

static void *create(void *const *cells) {
  struct crane *crane = calloc(1, sizeof *crane);
  if (crane == NULL) return NULL;
  for (int i = 0; i < COUNT; ++i) crane->io[i] = cells[i];
  return crane;
}

static int bit(const struct crane *crane, int i) { return *(const uint8_t *)crane->io[i]; }
static int number(const struct crane *crane, int i) { return *(const int16_t *)crane->io[i]; }
static void set_bit(struct crane *crane, int i, int value) { *(uint8_t *)crane->io[i] = (uint8_t)value; }
static void set_number(struct crane *crane, int i, double value) { *(int16_t *)crane->io[i] = (int16_t)value; }
static double limit(double value, double low, double high) { return value < low ? low : value > high ? high : value; }

/* The rated load in t: 40 t up to 22 m, then less, to 16 t at 40 m. */
static double rated(const struct crane *crane) {
  return limit(40 - (number(crane, RADIUS) / 100.0 - 22) * (40 - 16) / (40 - 22), 16, 40);
}

/* The speed that a motion may have, in %: the lever, limited. */
static double allowed(struct crane *crane, int motion) {
  double low = -100, high = 100;
  const double use = USE_LIMITER ? crane->force / rated(crane) : 0;
  if (motion == HOIST) {
    if (crane->force > kHeavy) low = -50, high = 50;
    if (bit(crane, TOP) || use > 1) high = 0;
    if (bit(crane, BOTTOM)) low = 0;
  }
  if (motion == LUFF) {
    if (use > 0.9) high = 30;
    if (bit(crane, OUT) || use > 1) high = 0;
    if (bit(crane, IN)) low = 0;
  }
  return crane->mode == WORKS ? limit(number(crane, LEVER + motion), low, high) : 0;
}

static void move(struct crane *crane, int which) {
  struct motion *motion = &crane->motions[which];
  const double wanted = allowed(crane, which);
  switch (motion->phase) {
    case BRAKED:
      if (wanted != 0) motion->phase = RELEASES;
      break;
    case RELEASES:
      if (bit(crane, OPEN + which)) motion->phase = MOVES;
      motion->still = 0;
      break;
    case MOVES: {
      const double step = USE_RAMPS ? kRamp[which] * kPeriod : 200;
      motion->speed += limit(wanted - motion->speed, -step, step);
      motion->still = motion->speed == 0 ? motion->still + 1 : 0;
      if (motion->still > kHold) motion->phase = CLOSES;
      break;
    }
    case CLOSES:
      if (bit(crane, CLOSED + which)) motion->phase = BRAKED;
      break;
  }
  set_bit(crane, RELEASE + which, motion->phase == RELEASES || motion->phase == MOVES);
  set_number(crane, SPEED + which, motion->speed * 163.84);
}

static int braked(const struct crane *crane) {
  for (int i = 0; i < MOTIONS; ++i) {
    if (crane->motions[i].phase != BRAKED) return 0;
  }
  return 1;
}

static int scan(void *instance, int64_t now_ns) {
  struct crane *crane = instance;
  (void)now_ns;
  crane->force += (number(crane, FORCE) / 10.0 - crane->force) * kPeriod / 0.3;
  crane->wind += (number(crane, WIND) / 10.0 - crane->wind) * kPeriod / 2;
  const int storm = crane->wind > (bit(crane, STORM) ? kCalm : kStorm);
  const int neutral = number(crane, LEVER + HOIST) == 0 && number(crane, LEVER + SLEW) == 0 && number(crane, LEVER + LUFF) == 0;

  switch (crane->mode) {
    case OFF:
      if (bit(crane, START) && !bit(crane, ESTOP)) crane->mode = STARTS;
      break;
    case STARTS:
      if (bit(crane, POWER_ON)) crane->mode = READY;
      break;
    case READY:
      if (!neutral) crane->mode = WORKS;
      break;
    case WORKS:
      if (neutral && braked(crane)) crane->mode = READY;
      break;
    case STOPPED: /* until the levers are in the middle */
      if (neutral && braked(crane) && !storm && !bit(crane, ESTOP)) crane->mode = bit(crane, POWER) ? READY : OFF;
      break;
  }
  if (crane->mode != OFF && (storm || bit(crane, ESTOP))) crane->mode = STOPPED;
  for (int i = 0; i < MOTIONS; ++i) move(crane, i);

  if (crane->mode == STARTS) set_bit(crane, POWER, 1);
  if (crane->mode == STOPPED && bit(crane, ESTOP) && braked(crane)) set_bit(crane, POWER, 0); /* until it is started again */
  set_number(crane, MODE, crane->mode);
  set_bit(crane, OVERLOAD, crane->force > rated(crane));
  set_bit(crane, STORM, storm);
  return 0;
}

const struct symplant_program *symplant_program_v1(void) {
  static const struct symplant_program program = {
      .version = 1,
      .size = sizeof program,
      .name = "crane",
      .period_ns = 20000000,
      .variables = variables,
      .count = COUNT,
      .create = create,
      .scan = scan,
      .destroy = free,
  };
  return &program;
}
