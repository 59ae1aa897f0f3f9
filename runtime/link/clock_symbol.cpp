// Which symbols can be the clock of a PLC.
#include "symplant/link/clock_symbol.hpp"

#include "symplant/condition/compare.hpp"

namespace symplant::link {

int clock_bits(tables::DataType type) noexcept {
  switch (type) {
    using enum tables::DataType;
    case int_:
    case uint:
    case word:
      return 16;
    case dint:
    case udint:
    case dword:
      return 32;
    case lint:
    case ulint:
    case lword:
      return 64;
    default:
      return 0;
  }
}

std::string clock_fault(tables::DataType type, tables::Direction direction) {
  if (direction == tables::Direction::event) {
    return "is an event, which the plant writes; a clock is an operation, which the PLC counts up";
  }
  if (clock_bits(type) != 0) return "";
  return "has the type " + std::string(condition::type_name(type)) +
         "; a clock is a whole number of 16, 32 or 64 bits, such as a WORD or a UDINT";
}

}  // namespace symplant::link
