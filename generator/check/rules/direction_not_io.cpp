// SP203 direction-not-io: the direction level is neither I nor O.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "check/rules.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kDirectionNotIoPage =
    R"(The level of a symbol's name that gives its direction holds another word than the naming rule knows. Under the built-in rule
it is `I` (the PLC reads it: an event of the plant) or `O` (the PLC writes it: an operation).

**What the model loses.** The symbol is in no unit: no device drives it, and it drives none. It is still served, in the direction
of its address.

**How to fix it.** Look at the word. If it is a direction in another form (`X`, `IN`, `OUT`, a digit for a letter), write `I` or
`O` instead, as seen from the PLC: `EXLINE_MB_AGV_X_P1` with address X0001 becomes `EXLINE_MB_AGV_I_P1`. If it is part of the
device's or the task's name, the direction is missing: add it, and join words so that the number of levels is right.
`EXTN_PLT1_FRT_Light_Curtain1` becomes `EXTN_PLT1_FRT_I_LightCurtain1`.
)";

/// Whether a word is a direction in another form, and not a word of the name.
bool is_direction_sign(std::string_view word) {
  constexpr std::size_t kLongestSign = 2;  // X, DI, 0
  constexpr std::array<std::string_view, 6> kDirections{"IN", "OUT", "INP", "INPUT", "OUTP", "OUTPUT"};
  if (word.size() <= kLongestSign) return true;
  return std::any_of(kDirections.begin(), kDirections.end(),
                     [&](std::string_view direction) { return text::equal_ignoring_case(direction, word); });
}

/// The name with its direction added and the level after it joined to the next one; empty if there is no next one.
std::string name_with_direction(const model::Symbol& symbol, std::string_view direction) {
  const std::string_view name = symbol.name();
  const text::Span part = symbol.reading.where;
  if (part.end + 1 >= name.size()) return {};
  const std::string_view separator = name.substr(part.end, 1);
  return fmt::format("{}{}{}{}{}", name.substr(0, part.begin), direction, separator, faulty_part(symbol),
                     name.substr(part.end + 1));
}

std::string direction_message(const model::PlantModel& plant, const model::Symbol& symbol) {
  const std::string_view word = symbol.direction == tables::Direction::event ? "I" : "O";
  const std::string example = name_with_direction(symbol, word);
  if (is_direction_sign(faulty_part(symbol)) || example.empty()) {
    return fmt::format(
        "`{}` has `{}` as its direction, `{}` requires `I` or `O`: {}; write `{}`, as its address `{}` says",
        symbol.name(), faulty_part(symbol), plant.rule->pattern, consequence(symbol), word, symbol.address_cell);
  }
  return fmt::format(
      "`{}` has no direction, `{}` requires `I` or `O` before the task: {}; add `{}`, as its address `{}` says, "
      "and join words, for example `{}`",
      symbol.name(), plant.rule->pattern, consequence(symbol), word, symbol.address_cell, example);
}

void check_direction_not_io(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!breaks_rule(subject, symbol, name::NameFault::direction_not_io)) continue;
    diag::Location location = location_of(plant, symbol);
    narrow(location, symbol);
    diagnostics.add(rule.info, about_name(plant, symbol), direction_message(plant, symbol), location);
  }
}

}  // namespace

const Rule kDirectionNotIo{{"SP203", "direction-not-io", diag::Severity::warning,
                            "the direction level is neither I nor O", kDirectionNotIoPage, diag::Rank::name},
                           check_direction_not_io};

}  // namespace symplant::check
