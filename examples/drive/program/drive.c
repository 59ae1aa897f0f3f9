/* The program of the drive: finds the limit switch at 0 mm, then moves to the target of the panel. */
#include <stdlib.h>
#include <symplant/program.h>

enum { COUNTER, TARGET, LOW, HIGH, SPEED, THERE, COUNT };

static const struct symplant_variable variables[COUNT] = {
    [COUNTER] = {.symbol = "CONV_AX1_ENCODER_I_COUNT", .bits = 16},
    [TARGET] = {.symbol = "CONV_AX1_PANEL_I_TARGET", .bits = 16},
    [LOW] = {.symbol = "CONV_AX1_LIMIT_I_LOW", .bits = 1},
    [HIGH] = {.symbol = "CONV_AX1_LIMIT_I_HIGH", .bits = 1},
    [SPEED] = {.symbol = "CONV_AX1_DRIVE_O_SPEED", .writes = 1, .bits = 16},
    [THERE] = {.symbol = "CONV_AX1_LAMP_O_THERE", .writes = 1, .bits = 1},
};

/* 0: a program that forgets that the counter overflows. */
#ifndef USE_OVERFLOW
#define USE_OVERFLOW 1
#endif

static const double kFast = 1000, kSearch = -100; /* mm/s */
static const double kBraking = 400;               /* mm/s2, less than the converter's ramp */
static const double kNear = 0.5;                  /* mm: the target is reached */

struct drive {
  const uint16_t *counter;
  const int16_t *target;
  const uint8_t *low, *high;
  int16_t *speed;
  uint8_t *there;
  int started, found; /* the counter was read, the switch at 0 mm was found */
  uint16_t last;      /* the counter at the scan before */
  int32_t steps;      /* from the switch at 0 mm */
};

static void *create(void *const *cells) {
  struct drive *drive = calloc(1, sizeof *drive);
  if (drive == NULL) return NULL;
  drive->counter = cells[COUNTER];
  drive->target = cells[TARGET];
  drive->low = cells[LOW];
  drive->high = cells[HIGH];
  drive->speed = cells[SPEED];
  drive->there = cells[THERE];
  return drive;
}

/* The steps since the scan before: the difference modulo 65536, from -32768 to 32767. */
static int steps_since(uint16_t now, uint16_t last) { return USE_OVERFLOW ? (int16_t)(uint16_t)(now - last) : now - last; }

/* The speed from which the carriage can still stop at this distance. */
static double speed_for(double distance) {
  const double length = distance < 0 ? -distance : distance;
  double speed = kFast;
  while (speed > 10 && speed * speed > 2 * kBraking * length) speed -= 1;  /* a square root needs libm */
  if (speed > 5 * length) speed = 5 * length; /* the last millimeters: proportional to the distance */
  return distance < 0 ? -speed : speed;
}

static int scan(void *instance, int64_t now_ns) {
  struct drive *drive = instance;
  (void)now_ns;
  if (drive->started) drive->steps += steps_since(*drive->counter, drive->last);
  drive->started = 1;
  drive->last = *drive->counter;
  if (!drive->found && *drive->low) {
    drive->found = 1;
    drive->steps = 0;
  }

  const double distance = *drive->target - drive->steps / 20.0;
  double speed = drive->found ? speed_for(distance) : kSearch;
  *drive->there = drive->found && distance <= kNear && distance >= -kNear;
  if (*drive->there) speed = 0;
  if ((*drive->high && speed > 0) || (*drive->low && speed < 0)) speed = 0;
  *drive->speed = (int16_t)(speed * 16384 / 1000);
  return 0;
}

const struct symplant_program *symplant_program_v1(void) {
  static const struct symplant_program program = {
      .version = 1,
      .size = sizeof program,
      .name = "drive",
      .period_ns = 10000000,
      .variables = variables,
      .count = COUNT,
      .create = create,
      .scan = scan,
      .destroy = free,
  };
  return &program;
}
