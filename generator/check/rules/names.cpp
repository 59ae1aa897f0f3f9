// Rules: names against the naming rule.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "check/rules.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

/// Reports each name with a fault. `text_of(symbol)` is the message.
template <class Text>
void report_names(const Rule& rule, const Subject& subject, name::NameFault fault, diag::Diagnostics& diagnostics,
                  Text text_of) {
  for (const model::Symbol& symbol : subject.plant.symbols) {
    if (!breaks_rule(subject, symbol, fault)) continue;
    diag::Location location = location_of(subject.plant, symbol);
    narrow(location, symbol);
    diagnostics.add(rule.info, about_name(subject.plant, symbol), text_of(symbol), std::move(location));
  }
}

void check_wrong_number_of_levels(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const name::NamingRule& naming = *subject.plant.rule;
  const std::size_t wanted = naming.levels.size();
  report_names(rule, subject, name::NameFault::wrong_number_of_levels, diagnostics, [&](const model::Symbol& symbol) {
    const std::size_t levels = symbol.reading.levels;
    return fmt::format("`{}` has {} level{}, `{}` requires {}: its device is unknown, {}; {}", symbol.name(), levels,
                       levels == 1 ? "" : "s", naming.pattern, wanted, consequence(symbol),
                       levels > wanted ? "remove a level or join two" : "add the missing levels");
  });
}

void check_empty_level(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  report_names(rule, subject, name::NameFault::empty_level, diagnostics, [](const model::Symbol& symbol) {
    return fmt::format(
        "`{}` has an empty level: its device is unknown, {}; write the missing word or remove the "
        "surplus separator",
        symbol.name(), consequence(symbol));
  });
}

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
  const text::Span part = symbol.reading.where();
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
        symbol.name(), faulty_part(symbol), plant.rule->pattern, consequence(symbol), word, symbol.address_cell());
  }
  return fmt::format(
      "`{}` has no direction, `{}` requires `I` or `O` before the task: {}; add `{}`, as its address `{}` says, "
      "and join words, for example `{}`",
      symbol.name(), plant.rule->pattern, consequence(symbol), word, symbol.address_cell(), example);
}

void check_direction_not_io(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  report_names(rule, subject, name::NameFault::direction_not_io, diagnostics,
               [&](const model::Symbol& symbol) { return direction_message(subject.plant, symbol); });
}

void check_illegal_character(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!breaks_rule(subject, symbol, name::NameFault::illegal_character)) continue;
    diag::Location location = location_of(plant, symbol);
    narrow(location, symbol);
    diag::Diagnostic& finding =
        diagnostics.add(rule.info, about_name(plant, symbol),
                        fmt::format("`{}` has `{}`, which is neither letter nor digit nor separator: {}; "
                                    "remove it or write `_` instead",
                                    symbol.name(), faulty_part(symbol), consequence(symbol)),
                        location);
    std::string renamed(symbol.name());
    renamed.replace(symbol.reading.where().begin, faulty_part(symbol).size(), "_");
    finding.renames.push_back(rename_of(symbol, std::move(renamed), false));
  }
}

void check_direction_conflict(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  if (conflicts_are_errors(subject.plant)) report_direction_conflicts(rule, subject, diagnostics);
}

void check_path_ambiguous(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (plant.pairing == nullptr) return;
  for (const pairing::Remark& remark : plant.pairing->remarks) {
    if (remark.kind != pairing::Remark::Kind::path_ambiguous) continue;
    const model::Symbol& symbol = plant.symbols[remark.input];
    const model::Symbol& other = plant.symbols[remark.other];
    diagnostics.add(rule.info, about(symbol),
                    fmt::format("`{}` is the path of another device too, with other levels or of another controller: "
                                "names in conditions and plant.json mean the first device",
                                symbol.reading.device_path()),
                    location_of(plant, symbol), {{location_of(plant, other), "a symbol of the other device"}});
  }
}

void check_role_taken(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (plant.pairing == nullptr) return;
  for (const pairing::Remark& remark : plant.pairing->remarks) {
    if (remark.kind != pairing::Remark::Kind::role_taken) continue;
    const model::Symbol& symbol = plant.symbols[remark.input];
    const model::Symbol& first = plant.symbols[remark.other];
    diagnostics.add(rule.info, about(symbol),
                    fmt::format("`{}` fits the same role of an archetype as `{}`, which comes first; make the text of "
                                "the role more specific",
                                symbol.name(), first.name()),
                    location_of(plant, symbol), {{location_of(plant, first), "the symbol that has the role"}});
  }
}

}  // namespace

const Rule kWrongNumberOfLevels{
    {"SP201", "wrong-number-of-levels", diag::Severity::warning, "a name has more or fewer levels than the rule",
     R"(A symbol's name has another number of levels than the naming rule requires. The built-in rule is `LINE_PROC_DEV_I|O_TASK`: five
levels of letters and digits, separated by `_`.

**What the model loses.** The device of the symbol is unknown, so it is in no unit: no device drives it, and it drives none. It
is still served: it is in the images, on the links and in the traces, and can be set by hand.

**How to fix it.** Add the missing level, or join two words into one level: `EXLINE_MB_AGV_FAST_O_P2` becomes
`EXLINE_MB_AGVFAST_O_P2`.
)",
     diag::Rank::name},
    check_wrong_number_of_levels};

const Rule kEmptyLevel{
    {"SP202", "empty-level", diag::Severity::warning, "a level of a name is empty",
     R"(A symbol's name has two adjacent separators, or a separator at its beginning or end, so that one of its levels is empty.

**What the model loses.** The symbol is in no unit: no device drives it, and it drives none. It is still served.

**How to fix it.** Write the missing word, or remove the surplus `_`: `EXLINE__AGV_I_P1` becomes `EXLINE_MB_AGV_I_P1`.
)",
     diag::Rank::name},
    check_empty_level};

const Rule kDirectionNotIo{
    {"SP203", "direction-not-io", diag::Severity::warning, "the direction level is neither I nor O",
     R"(The level of a symbol's name that gives its direction holds another word than the naming rule knows. Under the built-in rule
it is `I` (the PLC reads it: an event of the plant) or `O` (the PLC writes it: an operation).

**What the model loses.** The symbol is in no unit: no device drives it, and it drives none. It is still served, in the direction
of its address.

**How to fix it.** Look at the word. If it is a direction in another form (`X`, `IN`, `OUT`, a digit for a letter), write `I` or
`O` instead, as seen from the PLC: `EXLINE_MB_AGV_X_P1` with address X0001 becomes `EXLINE_MB_AGV_I_P1`. If it is part of the
device's or the task's name, the direction is missing: add it, and join words so that the number of levels is right.
`EXTN_PLT1_FRT_Light_Curtain1` becomes `EXTN_PLT1_FRT_I_LightCurtain1`.
)",
     diag::Rank::name},
    check_direction_not_io};

const Rule kIllegalCharacter{
    {"SP204", "illegal-character", diag::Severity::warning, "a name has an illegal character",
     R"(A symbol's name has a character that is neither a letter, nor a digit, nor the separator: a blank, a `-`, a `.`, a bracket.
Letters and digits of every script are allowed.

**What the model loses.** The name cannot be divided into levels, so the symbol is in no unit: no device drives it, and it drives
none. It is still served, under the name that it has.

**How to fix it.** Remove the character, or write the separator instead: `EXLINE-MB_AGV_I_P1` becomes `EXLINE_MB_AGV_I_P1`.
)",
     diag::Rank::name},
    check_illegal_character};

const Rule kDirectionConflict{
    {"SP209", "direction-conflict", diag::Severity::error,
     "a name and its address disagree under a naming rule that forbids it",
     R"(The naming rule has `"direction": { "on-conflict": "error" }`, and the direction in a symbol's name contradicts its address.

**What the model loses.** Nothing is run or generated until all names and addresses agree.

**How to fix it.** Correct the name or the address. If the contradiction is wanted, such as an echo that is named from the
partner's side, remove `on-conflict`: then it is the warning `direction-against-address`.
)",
     diag::Rank::direction},
    check_direction_conflict};

const Rule kPathAmbiguous{
    {"SP206", "path-ambiguous", diag::Severity::warning, "two devices have one path",
     R"(Under a custom naming rule the path of a device is its line, process and device, joined by `_`. Two devices have the same
path, because the levels are divided differently (`A_B` and `C`, `A` and `B_C`), or because they are in two controllers.

**What the model loses.** Both devices are in the model. A condition, a scenario or plant.json that names the path means the
first one only.

**How to fix it.** Divide the levels alike in both rules of naming.json, or add a level, as with `"fixed": { "line": "PLC2" }`.
)"},
    check_path_ambiguous};

const Rule kRoleTaken{
    {"SP207", "role-taken", diag::Severity::warning, "several symbols fit one role of an archetype",
     R"(An archetype of naming.json has one symbol for each role. In a device several symbols match the text of one role.

**What the model loses.** The first symbol in the list has the role. The others are left to later archetypes and to pairing by
words, and drive nothing if nothing else fits them.

**How to fix it.** Make the text of the role more specific, or add `{x}` to all roles, so that each of the symbols belongs to
a model of its kind.
)"},
    check_role_taken};

}  // namespace symplant::check
