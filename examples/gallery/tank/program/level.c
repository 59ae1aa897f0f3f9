/* The program of the tank: holds the level between 40 and 60 l, feeds the consumer, and reports a leak. */
#include <stdlib.h>
#include <symplant/program.h>

enum { LEVEL, HIGH, LOW, DEMAND, PUMP, VALVE, ALARM, COUNT };

static const struct symplant_variable variables[COUNT] = {
    [LEVEL] = {.symbol = "PLANT_T1_TANK_I_LEVEL", .bits = 16},
    [HIGH] = {.symbol = "PLANT_T1_TANK_I_HIGH", .bits = 1},
    [LOW] = {.symbol = "PLANT_T1_TANK_I_LOW", .bits = 1},
    [DEMAND] = {.symbol = "PLANT_T1_BUTTON_I_DEMAND", .bits = 1},
    [PUMP] = {.symbol = "PLANT_T1_PUMP_O_RUN", .writes = 1, .bits = 1},
    [VALVE] = {.symbol = "PLANT_T1_VALVE_O_OPEN", .writes = 1, .bits = 1},
    [ALARM] = {.symbol = "PLANT_T1_LAMP_O_ALARM", .writes = 1, .bits = 1},
};

/* 0: a program that trusts the analog sensor alone. */
#ifndef USE_HIGH_SWITCH
#define USE_HIGH_SWITCH 1
#endif

static const double kOn = 40, kOff = 60; /* l: the pump runs from the one to the other */
static const double kLost = 2;           /* l: more than this leaves a closed tank only by a leak */

struct level {
  const int16_t *level;
  const uint8_t *high, *low, *demand;
  uint8_t *pump, *valve, *alarm;
  double closed_at; /* the level at which the pump stopped and the valve closed */
};

static void *create(void *const *cells) {
  struct level *tank = calloc(1, sizeof *tank);
  if (tank == NULL) return NULL;
  tank->level = cells[LEVEL];
  tank->high = cells[HIGH];
  tank->low = cells[LOW];
  tank->demand = cells[DEMAND];
  tank->pump = cells[PUMP];
  tank->valve = cells[VALVE];
  tank->alarm = cells[ALARM];
  return tank;
}

static int scan(void *instance, int64_t now_ns) {
  struct level *tank = instance;
  const double litres = *tank->level * 120.0 / 27648;
  const int full = USE_HIGH_SWITCH && *tank->high;
  (void)now_ns;

  if (litres < kOn) *tank->pump = 1;
  if (litres > kOff || full) *tank->pump = 0;
  *tank->valve = *tank->demand && *tank->low;

  if (*tank->pump || *tank->valve) tank->closed_at = litres;
  if (full || tank->closed_at - litres > kLost) *tank->alarm = 1; /* until the program starts again */
  return 0;
}

const struct symplant_program *symplant_program_v1(void) {
  static const struct symplant_program program = {
      .version = 1,
      .size = sizeof program,
      .name = "level",
      .period_ns = 100000000,
      .variables = variables,
      .count = COUNT,
      .create = create,
      .scan = scan,
      .destroy = free,
  };
  return &program;
}
