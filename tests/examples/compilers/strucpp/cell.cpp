// The cell and a program with numbers, in the form in which STruC++ writes programs.
#include "cell.hpp"

namespace strucpp {

LocatedVar locatedVars[11] = {{LocatedArea::Input, LocatedSize::Bit, 0, 1, {}, nullptr},
                              {LocatedArea::Input, LocatedSize::Bit, 0, 2, {}, nullptr},
                              {LocatedArea::Input, LocatedSize::Bit, 0, 3, {}, nullptr},
                              {LocatedArea::Input, LocatedSize::Bit, 0, 4, {}, nullptr},
                              {LocatedArea::Output, LocatedSize::Bit, 0, 1, {}, nullptr},
                              {LocatedArea::Memory, LocatedSize::Word, 5, 0, {}, nullptr},
                              {LocatedArea::Output, LocatedSize::Bit, 0, 2, {}, nullptr},
                              {LocatedArea::Output, LocatedSize::Bit, 0, 3, {}, nullptr},
                              {LocatedArea::Output, LocatedSize::Bit, 0, 4, {}, nullptr},
                              {LocatedArea::Input, LocatedSize::Word, 5, 0, {}, nullptr},
                              {LocatedArea::Output, LocatedSize::Word, 5, 0, {}, nullptr}};

Program_CELL::Program_CELL() {
  locatedVars[0].pointer = &at_store;
  locatedVars[1].pointer = &at_machine;
  locatedVars[2].pointer = &idle;
  locatedVars[3].pointer = &works;
  locatedVars[4].pointer = &to_machine;
  locatedVars[6].pointer = &to_store;
  locatedVars[7].pointer = &stop;
  locatedVars[8].pointer = &start;
}

void Program_CELL::run() {
  if (phase != 2 || !works) {
    works_since = -1;
  } else if (works_since < 0) {
    works_since = __CURRENT_TIME_NS;
  }
  const bool worked = works_since >= 0 && __CURRENT_TIME_NS - works_since >= 300'000'000;
  if (phase == 0) {
    if (at_store && idle) phase = 1;
  } else if (phase == 1) {
    if (at_machine && idle) phase = 2;
  } else if (phase == 2) {
    if (worked) phase = 3;
  } else if (at_store && idle) {
    phase = 0;
  }
  to_machine = phase == 1;
  start = phase == 2;
  to_store = phase == 3;
  stop = phase == 3;
}

Program_LIMIT::Program_LIMIT() {
  locatedVars[5].pointer = &scans;
  locatedVars[9].pointer = &weight;
  locatedVars[10].pointer = &limit;
}

void Program_LIMIT::run() {
  ++scans;
  limit = static_cast<std::int16_t>(weight + 1);
}

}  // namespace strucpp
