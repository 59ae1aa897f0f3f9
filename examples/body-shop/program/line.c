/* The program of the body-shop line: forty stations work at the same time, then the four shuttles carry all bodies one
 * station on. table.h has the symbols, written from the list; here is what the line does with them.
 */
#include <stdlib.h>

#include "table.h"

/* One step of a station: all its devices of a shape get an operation, and the station waits for an event of all of them. */
struct step {
  enum shape shape;
  enum { PULSE, ON, OFF } how; /* a pulse is on until the event has come; others remain */
  short operation, event, value; /* the event is to be 1 or 0 */
  short by_variant;            /* 1: one symbol on for an estate */
};
/* A device that keeps its position gets a pulse: PULSE(PIN, UP) until the pin is up. */
#define PULSE(shape, to) {shape, PULSE, shape##_O_##to, shape##_I_##to, 1, 0}
#define PULSE_UNTIL(shape, to, event) {shape, PULSE, shape##_O_##to, shape##_I_##event, 1, 0}
#define SWITCH_ON(shape, to) {shape, ON, shape##_O_##to, shape##_I_##to, 1, 0}
#define SWITCH_OFF(shape, to) {shape, OFF, shape##_O_##to, shape##_I_##to, 0, 0}
#define BY_VARIANT(shape, to) {shape, PULSE, shape##_O_##to, shape##_I_##to, 1, 1}
#define END {SHAPES, OFF, 0, 0, 0, 0}

enum { MOST_STEPS = 16 };
static const struct step steps[KINDS][MOST_STEPS] = {
    [UNDER] = {PULSE(PIN, UP), PULSE(CLAMP, CLOSE), SWITCH_ON(LATCH, LOCK), PULSE(GRIPPER, GRIP), SWITCH_ON(WELDER, ON),
               PULSE_UNTIL(ROBOT, JOB2, DONE3), PULSE(ROBOT, HOME1), SWITCH_OFF(WELDER, ON), PULSE(DRESSER, RUN2),
               PULSE(GRIPPER, OPEN), SWITCH_OFF(LATCH, LOCK), PULSE(CLAMP, OPEN), PULSE(PIN, DOWN), END},
    /* The table turns the clamped side to the robots, and back. */
    [SIDE] = {PULSE(PIN, UP), PULSE(CLAMP, CLOSE), PULSE(TABLE, POS2), SWITCH_ON(LATCH, LOCK), SWITCH_ON(WELDER, ON),
              PULSE_UNTIL(ROBOT, JOB2, DONE3), PULSE(ROBOT, HOME1), SWITCH_OFF(WELDER, ON), PULSE(DRESSER, RUN2),
              SWITCH_OFF(LATCH, LOCK), PULSE(TABLE, POS1), PULSE(CLAMP, OPEN), PULSE(PIN, DOWN), END},
    /* The drum brings the gate of the variant while the clamps are open. */
    [FRAME] = {PULSE(PIN, UP), PULSE(LIFTER, HIGH2), BY_VARIANT(DRUM, POS1), PULSE(CLAMP, CLOSE), SWITCH_ON(WELDER, ON),
               PULSE_UNTIL(ROBOT, JOB2, DONE3), PULSE(ROBOT, HOME1), SWITCH_OFF(WELDER, ON), PULSE(DRESSER, RUN2),
               PULSE(CLAMP, OPEN), PULSE(LIFTER, LOW1), PULSE(PIN, DOWN), END},
    [SPOT] = {PULSE(PIN, UP), SWITCH_ON(WELDER, ON), PULSE_UNTIL(ROBOT, JOB2, DONE3), PULSE(ROBOT, HOME1),
              SWITCH_OFF(WELDER, ON), PULSE(DRESSER, RUN2), PULSE(PIN, DOWN), END},
    [ROOF] = {PULSE(PIN, UP), PULSE(LIFTER, HIGH2), PULSE(GRIPPER, GRIP), PULSE(CLAMP, CLOSE), SWITCH_ON(SEALER, ON),
              PULSE_UNTIL(ROBOT, JOB2, DONE3), PULSE(ROBOT, HOME1), SWITCH_OFF(SEALER, ON), PULSE(GRIPPER, OPEN),
              PULSE(CLAMP, OPEN), PULSE(LIFTER, LOW1), PULSE(PIN, DOWN), END},
    [SEAL] = {PULSE(PIN, UP), SWITCH_ON(PUMP, RUN), SWITCH_ON(SEALER, ON), PULSE_UNTIL(ROBOT, JOB2, DONE3),
              PULSE(ROBOT, HOME1), SWITCH_OFF(SEALER, ON), SWITCH_OFF(PUMP, RUN), PULSE(PIN, DOWN), END},
    [INSP] = {PULSE(PIN, UP), PULSE_UNTIL(ROBOT, JOB2, DONE3), PULSE(CAMERA, TAKE2), PULSE(ROBOT, HOME1),
              PULSE(PIN, DOWN), END},
    /* The transfer lifts the skid off the shuttle's way and returns it; its drives hand the body on meanwhile. */
    [MOVE] = {SWITCH_ON(DRIVE, RUN), SWITCH_ON(LATCH, LOCK), PULSE(CONVEYOR, STOP2), PULSE(LIFTER, HIGH2),
              PULSE(LIFTER, LOW1), PULSE(CONVEYOR, EXIT3), PULSE(CONVEYOR, ENTRY1), SWITCH_OFF(LATCH, LOCK), END},
};

enum { ESTATE = 5 };                                 /* a code of the readers of skids */
static const int64_t kSettle = INT64_C(500000000);   /* a body lies still for so long before work begins */
static const int64_t kBeat = INT64_C(30000000000);   /* the least time between strokes: bodies change tracks meanwhile */
static const int64_t kMost = INT64_C(60000000000);   /* a step that takes longer is a fault */

struct station {
  const struct place *place;
  int at;           /* the step; -1: it does not work */
  int worked;       /* in this beat */
  int fault;        /* something was not safe or took too long, and nobody has reset it */
  int64_t since;    /* when the step began; while it does not work: when a body came, -1 without */
};

struct line {
  void *cells[VARIABLES];
  struct station stations[STATIONS];
  enum { WORK, FORTH, BACK } phase;
  int halted;    /* a halt button was pushed, and no start button since */
  int64_t since; /* when the phase began */
};

static uint8_t *bit(struct line *line, const struct station *station, enum shape shape, int device, int symbol) {
  return line->cells[station->place->devices[shape].first + device * symbols_of[shape] + symbol];
}

static void set_word(struct line *line, const struct station *station, enum shape shape, int symbol, uint16_t value) {
  for (int i = 0; i < station->place->devices[shape].count; ++i) {
    *(uint16_t *)(void *)bit(line, station, shape, i, symbol) = value;
  }
}

static void set_all(struct line *line, const struct station *station, enum shape shape, int symbol, uint8_t value) {
  for (int i = 0; i < station->place->devices[shape].count; ++i) *bit(line, station, shape, i, symbol) = value;
}

/* Whether an event of all devices of a shape has a value. */
static int are_all(struct line *line, const struct station *station, enum shape shape, int symbol, uint8_t value) {
  for (int i = 0; i < station->place->devices[shape].count; ++i) {
    if (*bit(line, station, shape, i, symbol) != value) return 0;
  }
  return 1;
}

static uint16_t variant_of(struct line *line, const struct station *station) {
  return *(uint16_t *)(void *)bit(line, station, VARIANT, 0, VARIANT_I_CODE);
}

static int is_safe(struct line *line, const struct station *station) {
  return are_all(line, station, ESTOP, ESTOP_I_SAFE, 1) && are_all(line, station, DOOR, DOOR_I_SHUT, 1) &&
         are_all(line, station, CURTAIN, CURTAIN_I_CLEAR, 1) && are_all(line, station, AIR, AIR_I_GOOD, 1);
}

/* A transfer works in every beat, a station if a body has come to rest in it. */
static int may_begin(struct line *line, struct station *station, int64_t now) {
  if (station->worked) return 0;
  if (station->place->kind == MOVE) return 1;
  if (!are_all(line, station, PART, PART_I_SEEN, 1)) {
    station->since = -1;
    return 0;
  }
  if (station->since < 0) station->since = now;
  return now - station->since >= kSettle;
}

static void begin(struct line *line, struct station *station, int64_t now) {
  const uint16_t variant = variant_of(line, station);
  set_word(line, station, VARIANT, VARIANT_O_CODE, variant);
  set_word(line, station, ROBOT, ROBOT_O_PROG, variant);
  set_word(line, station, WELDER, WELDER_O_SCHEDULE, variant);
  set_word(line, station, SEALER, SEALER_O_FLOW, 400);
  station->at = 0;
  station->since = now;
}

/* Runs the step that the station is in. */
static void work(struct line *line, struct station *station, int64_t now) {
  const struct step *step = &steps[station->place->kind][station->at];
  if (step->shape == SHAPES) {
    station->at = -1;
    station->worked = 1;
    station->since = -1;
    return;
  }
  const int shift = step->by_variant && variant_of(line, station) == ESTATE;
  set_all(line, station, step->shape, step->operation + shift, step->how != OFF);
  if (are_all(line, station, step->shape, step->event + shift, (uint8_t)step->value)) {
    if (step->how == PULSE) set_all(line, station, step->shape, step->operation + shift, 0);
    ++station->at;
    station->since = now;
  } else if (now - station->since > kMost) {
    station->fault = 1;
  }
}

static void scan_station(struct line *line, struct station *station, int64_t now) {
  const int safe = is_safe(line, station);
  if (!safe) station->fault = 1;
  if (safe && *bit(line, station, BUTTONRESET, 0, BUTTONRESET_I_PUSH)) {
    if (station->fault) station->since = now;
    station->fault = 0;
  }
  if (*bit(line, station, BUTTONHALT, 0, BUTTONHALT_I_PUSH)) line->halted = 1;
  if (*bit(line, station, BUTTONSTART, 0, BUTTONSTART_I_PUSH)) line->halted = 0;

  const int automatic = *bit(line, station, SELECTOR, 0, SELECTOR_I_AUTO);
  if (automatic && !station->fault) {
    if (station->at >= 0) {
      work(line, station, now);
    } else if (line->phase == WORK && may_begin(line, station, now)) {
      begin(line, station, now);
    }
  }
  *bit(line, station, LIGHTRED, 0, LIGHTRED_O_ON) = (uint8_t)station->fault;
  *bit(line, station, LIGHTGREEN, 0, LIGHTGREEN_O_ON) = automatic && !station->fault && station->at >= 0;
  *bit(line, station, LIGHTAMBER, 0, LIGHTAMBER_O_ON) = !station->fault && station->at < 0;
  *bit(line, station, HORN, 0, HORN_O_ON) = safe && station->fault;
}

/* Whether a station lets the shuttles move. */
static int lets_move(struct line *line, struct station *station) {
  return station->at < 0 && !station->fault && *bit(line, station, SELECTOR, 0, SELECTOR_I_AUTO) &&
         (station->worked || station->place->kind == MOVE || !are_all(line, station, PART, PART_I_SEEN, 1));
}

static int do_all_let_move(struct line *line) {
  for (int s = 0; s < STATIONS; ++s) {
    if (!lets_move(line, &line->stations[s])) return 0;
  }
  return 1;
}

/* Moves all shuttles; returns whether they have arrived. */
static int move_shuttles(struct line *line, int operation, int event) {
  int arrived = 1;
  for (int s = 0; s < STATIONS; ++s) arrived &= are_all(line, &line->stations[s], SHUTTLE, event, 1);
  for (int s = 0; s < STATIONS; ++s) set_all(line, &line->stations[s], SHUTTLE, operation, !arrived);
  return arrived;
}

static int scan(void *instance, int64_t now) {
  struct line *line = instance;
  for (int s = 0; s < STATIONS; ++s) scan_station(line, &line->stations[s], now);
  switch (line->phase) {
    case WORK:
      if (line->halted || now - line->since < kBeat || !do_all_let_move(line)) return 0;
      line->phase = FORTH;
      break;
    case FORTH:
      if (!move_shuttles(line, SHUTTLE_O_FRONT3, SHUTTLE_I_FRONT3)) return 0;
      line->phase = BACK;
      break;
    case BACK:
      if (!move_shuttles(line, SHUTTLE_O_BACK1, SHUTTLE_I_BACK1)) return 0;
      for (int s = 0; s < STATIONS; ++s) line->stations[s].worked = 0;
      line->phase = WORK;
      break;
  }
  line->since = now;
  return 0;
}

static void *create(void *const *cells) {
  struct line *line = calloc(1, sizeof *line);
  if (line == NULL) return NULL;
  for (int i = 0; i < VARIABLES; ++i) line->cells[i] = cells[i];
  for (int s = 0; s < STATIONS; ++s) line->stations[s] = (struct station){.place = &places[s], .at = -1, .since = -1};
  return line;
}

const struct symplant_program *symplant_program_v1(void) {
  static const struct symplant_program program = {
      .version = 1,
      .size = sizeof program,
      .name = "line",
      .period_ns = 10000000,
      .variables = variables,
      .count = VARIABLES,
      .create = create,
      .scan = scan,
      .destroy = free,
  };
  return &program;
}
