/* The program of the oven: a PI controller with a limited output, and what switches the heater off. */
#include <stdlib.h>
#include <symplant/program.h>

enum { TEMP, SETPOINT, HOT, START, POWER, READY, ALARM, COUNT };

static const struct symplant_variable variables[COUNT] = {
    [TEMP] = {.symbol = "HEAT_O1_OVEN_I_TEMP", .bits = 16},
    [SETPOINT] = {.symbol = "HEAT_O1_PANEL_I_SETPOINT", .bits = 16},
    [HOT] = {.symbol = "HEAT_O1_LIMITER_I_HOT", .bits = 1},
    [START] = {.symbol = "HEAT_O1_START_I_ON", .bits = 1},
    [POWER] = {.symbol = "HEAT_O1_HEATER_O_POWER", .writes = 1, .bits = 16},
    [READY] = {.symbol = "HEAT_O1_READY_O_ON", .writes = 1, .bits = 1},
    [ALARM] = {.symbol = "HEAT_O1_ALARM_O_ON", .writes = 1, .bits = 1},
};

/* 0: the integral part grows while the output is at its limit. */
#ifndef ANTI_WINDUP
#define ANTI_WINDUP 1
#endif
/* 0: the program does not look at the limiter. */
#ifndef USE_LIMITER
#define USE_LIMITER 1
#endif

static const double kPeriod = 0.1; /* s */
/* SIMC tuning for 300 K at full power, 240 s, dead time 12 s: kp = 240 / (300 * 2 * 12), ti = 8 * 12. */
static const double kGain = 0.033;  /* of full power, per K */
static const double kReset = 96;    /* s */
static const double kMost = 500;    /* degC: nothing but a wire break reads more */

struct oven {
  const int16_t *temp, *setpoint;
  const uint8_t *hot, *start;
  int16_t *power;
  uint8_t *ready, *alarm;
  double integral;      /* of full power */
  int64_t within_since; /* ns, since when the temperature is near the setpoint; -1: it is not */
};

static void *create(void *const *cells) {
  struct oven *oven = calloc(1, sizeof *oven);
  if (oven == NULL) return NULL;
  oven->temp = cells[TEMP];
  oven->setpoint = cells[SETPOINT];
  oven->hot = cells[HOT];
  oven->start = cells[START];
  oven->power = cells[POWER];
  oven->ready = cells[READY];
  oven->alarm = cells[ALARM];
  oven->within_since = -1;
  return oven;
}

/* The output from 0 to 1 for an error in K. */
static double control(struct oven *oven, double error) {
  const double output = kGain * error + oven->integral;
  const double limited = output > 1 ? 1 : output < 0 ? 0 : output;
  if (!ANTI_WINDUP || output == limited) oven->integral += kGain * error * kPeriod / kReset;
  return limited;
}

static int scan(void *instance, int64_t now_ns) {
  struct oven *oven = instance;
  const double temp = *oven->temp / 10.0, error = *oven->setpoint / 10.0 - temp;
  if (temp > kMost || (USE_LIMITER && *oven->hot)) *oven->alarm = 1; /* until the program starts again */

  const int heats = *oven->start && !*oven->alarm;
  if (!heats) oven->integral = 0;
  *oven->power = heats ? (int16_t)(27648 * control(oven, error) + 0.5) : 0;

  if (!heats || error > 3 || error < -3) {
    oven->within_since = -1;
  } else if (oven->within_since < 0) {
    oven->within_since = now_ns;
  }
  *oven->ready = oven->within_since >= 0 && now_ns - oven->within_since >= INT64_C(30000000000);
  return 0;
}

const struct symplant_program *symplant_program_v1(void) {
  static const struct symplant_program program = {
      .version = 1,
      .size = sizeof program,
      .name = "oven",
      .period_ns = 100000000,
      .variables = variables,
      .count = COUNT,
      .create = create,
      .scan = scan,
      .destroy = free,
  };
  return &program;
}
