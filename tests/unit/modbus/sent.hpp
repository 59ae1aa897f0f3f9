// Symbols of a dialog test, and what a PLC was sent.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "support/modbus/modbus_plc.hpp"
#include "unit/link/symbol_list.hpp"

namespace symplant::test {

inline constexpr auto kOperation = SymbolList::kOut;
inline constexpr auto kEvent = SymbolList::kIn;

inline void add_bits(SymbolList& list, tables::Direction direction, std::initializer_list<std::uint32_t> numbers) {
  for (const std::uint32_t number : numbers) {
    list.add((direction == kEvent ? "I" : "O") + std::to_string(number), direction, number);
  }
}

using Texts = std::vector<std::string>;

/// Functions and addresses of the requests since the last call: "1:3+5" reads coils 3 to 7.
inline Texts sent(modbus::ModbusPlc& plc) {
  Texts texts;
  for (const modbus::Bytes& pdu : plc.requests()) {
    texts.push_back(std::to_string(pdu[0]) + ":" + std::to_string(pdu[1] * 256 + pdu[2]) + "+" +
                    std::to_string(pdu[3] * 256 + pdu[4]));
  }
  plc.forget_log();
  return texts;
}

}  // namespace symplant::test
