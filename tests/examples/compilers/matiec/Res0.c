/* The cell's program, and one with numbers, in the form in which matiec's iec2c writes them. */
#include "iec_types_all.h"

extern TIME __CURRENT_TIME;
extern BOOL *__IX0_1, *__IX0_2, *__IX0_3, *__IX0_4, *__QX0_1, *__QX0_2, *__QX0_3, *__QX0_4;
extern INT *__MW5, *__IW5, *__QW5;

static struct {
  INT phase;
  BOOL timed;
  TIME since;
} cell;

void RES0_init__(void) {
  *__IX0_1 = *__IX0_2 = *__IX0_3 = *__IX0_4 = *__QX0_1 = *__QX0_2 = *__QX0_3 = *__QX0_4 = 0;
  *__MW5 = *__IW5 = *__QW5 = 0;
  cell.phase = 0;
  cell.timed = 0;
}

static void cell_body(void) {
  BOOL worked = 0;
  if (cell.phase != 2 || !*__IX0_4) {
    cell.timed = 0;
  } else if (!cell.timed) {
    cell.timed = 1;
    cell.since = __CURRENT_TIME;
  } else {
    worked = (__CURRENT_TIME.tv_sec - cell.since.tv_sec) * 1000000000L + __CURRENT_TIME.tv_nsec - cell.since.tv_nsec >=
             300000000L;
  }
  switch (cell.phase) {
    case 0: if (*__IX0_1 && *__IX0_3) cell.phase = 1; break;
    case 1: if (*__IX0_2 && *__IX0_3) cell.phase = 2; break;
    case 2: if (worked) cell.phase = 3; break;
    default: if (*__IX0_1 && *__IX0_3) cell.phase = 0;
  }
  *__QX0_1 = cell.phase == 1;
  *__QX0_4 = cell.phase == 2;
  *__QX0_2 = cell.phase == 3;
  *__QX0_3 = cell.phase == 3;
}

void RES0_run__(unsigned long tick) {
  if (tick % 2 == 0) cell_body();
  if (tick % 5 == 0) {
    ++*__MW5;
    *__QW5 = *__IW5 + 1;
  }
}
