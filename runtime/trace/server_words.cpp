// The texts of findings of a server link about the requests of its clients.
#include "symplant/trace/server_words.hpp"

#include <fmt/format.h>

#include "symplant/link/modbus/refusals.hpp"

namespace symplant::trace {
namespace {

/// A duration of a link: `0.4 ms`, `50 ms`.
std::string milliseconds(tables::Time time) {
  const std::string text = fmt::format("{:.1f}", static_cast<double>(time) / 1e6);
  return (text.ends_with(".0") ? text.substr(0, text.size() - 2) : text) + " ms";
}

/// `on for 50 ms`; of an inverted symbol by its meaning, with the bit of the PLC: `off for 50 ms (bit 1)`.
std::string pulse_words(const ServedSymbol& symbol, const tables::MissedPulse& pulse) {
  const bool inverted = symbol.inverted;
  return fmt::format("{} for {}{}", pulse.on != inverted ? "on" : "off",
                     pulse.length == 0 ? "less than a cycle of the plant" : milliseconds(pulse.length),
                     inverted ? fmt::format(" (bit {})", pulse.on ? 1 : 0) : "");
}

/// `192.168.0.5`.
std::string ipv4_text(std::uint64_t address) {
  return fmt::format("{}.{}.{}.{}", address >> 24 & 0xFF, address >> 16 & 0xFF, address >> 8 & 0xFF, address & 0xFF);
}

}  // namespace

std::string not_read_words(const ServedSymbol& symbol, const tables::MissedPulse& pulse) {
  return fmt::format(
      "not read: {}, was {}, between two reads of the PLC, which reads it {}; check whether the PLC must read it more "
      "often, or whether the sensor is on for longer in the real plant",
      symbol.words, pulse_words(symbol, pulse),
      pulse.every == 0 ? "in every cycle of the plant" : "about every " + milliseconds(pulse.every));
}

std::string not_sampled_words(const ServedSymbol& symbol, const tables::MissedPulse& pulse) {
  return fmt::format(
      "not sampled: {}, was {}, between two cycles of the plant, so that it had no effect; check how long the program "
      "holds the output, or give a shorter `--cycle`",
      symbol.words, pulse_words(symbol, pulse));
}

std::string several_writers_words(const ServedSymbol& symbol, std::uint64_t writers) {
  const std::uint64_t first = writers >> 32;
  const std::uint64_t second = writers & 0xFFFF'FFFF;
  std::string clients = "two clients";
  if (first != 0 && first == second) clients = "two connections of " + ipv4_text(first);
  if (first != 0 && second != 0 && first != second) {
    clients = fmt::format("two clients, {} and {},", ipv4_text(first), ipv4_text(second));
  }
  return fmt::format(
      "several writers: {}, {} wrote different values to it within a cycle; check which of them is the PLC, and let no "
      "other one write this number",
      symbol.words, clients);
}

std::string refused_by_server_words(const tables::Refusal& refusal, std::string_view link) {
  return fmt::format("request refused: {} answered {}", link, link::modbus::answer_text(refusal));
}

}  // namespace symplant::trace
