// What a server has answered with an exception, in words.
#include "symplant/link/modbus/refusals.hpp"

#include <string_view>
#include <utility>

namespace symplant::link::modbus {

namespace {

/// "function 15 (write coils)".
std::string function_words(std::uint8_t function) {
  constexpr std::array<std::pair<std::uint8_t, std::string_view>, 10> kFunctionNames = {
      {{1, "read coils"},
       {2, "read discrete inputs"},
       {3, "read holding registers"},
       {4, "read input registers"},
       {5, "write one coil"},
       {6, "write one register"},
       {15, "write coils"},
       {16, "write registers"},
       {22, "mask a register"},
       {23, "read and write registers"}}};
  std::string text = "function " + std::to_string(function);
  for (const auto& [code, name] : kFunctionNames) {
    if (code == function) text.append(" (").append(name).append(")");
  }
  return text;
}

/// What an exception of the plant's server means, and what to do.
std::string_view server_exception_words(std::uint16_t code) {
  switch (code) {
    case 1:
      return "the plant does not have this function; use functions 1 to 6, 15, 16, 22 and 23";
    case 2:
      return "the request goes beyond the end of the map; compare its numbers with those of `symplant map`";
    case 3:
      return "the quantity, the length or the value is invalid; check the request in the PLC's project";
    default:
      return "the client does not read its answers; let it wait for the answer before its next request";
  }
}

}  // namespace

std::string answer_text(const tables::Refusal& refusal) {
  constexpr std::uint16_t kUnknownFunction = 1;
  std::string text = function_words(refusal.function);
  if (refusal.code != kUnknownFunction) text += " from number " + std::to_string(refusal.address) + " on";
  text += (refusal.code < 10 ? " with exception 0" : " with exception ") + std::to_string(refusal.code) + ": ";
  return text.append(server_exception_words(refusal.code));
}

}  // namespace symplant::link::modbus
