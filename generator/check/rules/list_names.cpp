// Rules: names of a whole list, and what an engineering tool accepts.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "check/rules.hpp"
#include "convert/identifiers.hpp"
#include "text/utf8.hpp"

namespace symplant::check {
namespace {

/// Fewer names get a finding each.
constexpr std::size_t kLeastFaulty = 4;
constexpr std::size_t kLargestShare = 3;  ///< one of 3

struct NameCount {
  std::size_t all = 0;
  std::size_t follow = 0;
  std::array<std::size_t, 6> by_fault{};  ///< by NameFault

  /// The fault of more than a third of the names.
  std::optional<name::NameFault> most_common() const {
    const auto most = std::max_element(by_fault.begin(), by_fault.end());
    if (*most < kLeastFaulty || *most * kLargestShare <= all) return std::nullopt;
    return static_cast<name::NameFault>(most - by_fault.begin());
  }
};

/// Under a custom rule the score counts the symbols that match none of its patterns.
std::vector<NameCount> count_names(const model::PlantModel& plant) {
  std::vector<NameCount> counts(plant.lists.size());
  for (const model::Symbol& symbol : plant.symbols) {
    NameCount& count = counts[symbol.list];
    const name::NameFault fault = symbol.reading.fault;
    ++count.all;
    if (fault == name::NameFault::none) {
      ++count.follow;
    } else if (fault != name::NameFault::not_linked) {
      ++count.by_fault[static_cast<std::size_t>(fault)];
    }
  }
  return counts;
}

std::string_view in_words(name::NameFault fault) {
  switch (fault) {
    case name::NameFault::wrong_number_of_levels:
      return "have another number of levels";
    case name::NameFault::empty_level:
      return "have an empty level";
    case name::NameFault::direction_not_io:
      return "have no direction";
    default:
      return "have characters that are neither letters nor digits";
  }
}

void check_named_otherwise(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (plant.units.empty()) return;  // SP415 reports it
  const std::vector<NameCount> counts = count_names(plant);
  std::vector<bool> reported = subject.named_otherwise;
  reported.flip();
  for (const model::Symbol& symbol : plant.symbols) {
    const NameCount& count = counts[symbol.list];
    if (reported[symbol.list] || symbol.reading.fault != count.most_common()) continue;
    reported[symbol.list] = true;
    const name::NameFault fault = symbol.reading.fault;
    const std::string file = plant.lists[symbol.list].name();
    diagnostics.add(rule.info,
                    fmt::format("{} of {} I/O names in `{}` {}, and {} follow `{}`: the list is named by another rule; "
                                "let `symplant infer {} -o naming.json` propose it",
                                count.by_fault[static_cast<std::size_t>(fault)], count.all, file, in_words(fault),
                                count.follow, plant.rule->pattern, file),
                    location_of(plant, symbol));
  }
}

struct Limit {
  std::string_view tool;  ///< the beginning of SymbolTable::title
  std::size_t characters;
};
constexpr std::array kLimits{Limit{"GX IEC Developer", 32}, Limit{"Logix Designer", 40}, Limit{"TIA Portal", 128}};

/// Null if the tool has no limit that is known.
const Limit* limit_of(const read::SymbolTable& table) {
  const auto found = std::find_if(kLimits.begin(), kLimits.end(), [&](const Limit& limit) {
    return table.title.substr(0, limit.tool.size()) == limit.tool;
  });
  return found == kLimits.end() ? nullptr : &*found;
}

void check_name_too_long(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    const Limit* limit = limit_of(*plant.lists[symbol.list].table);
    // A part of a structure or array has a longer path than its tag.
    const bool is_part = symbol.name().find_first_of(".[") != std::string_view::npos;
    if (limit == nullptr || is_part || symbol.name().size() <= limit->characters) continue;
    const std::size_t length = text::count_code_points(symbol.name());
    if (length <= limit->characters) continue;
    diagnostics.add(rule.info, about(symbol),
                    fmt::format("`{}` has {} characters, and {} accepts {}; shorten it", symbol.name(), length,
                                limit->tool, limit->characters),
                    location_of(plant, symbol));
  }
}

void check_reserved_word(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!convert::is_iec_reserved(symbol.name())) continue;
    diag::Diagnostic& finding = diagnostics.add(
        rule.info, about(symbol),
        fmt::format("`{}` is a reserved word of IEC 61131-3: programs cannot use it as a name; rename it",
                    symbol.name()),
        location_of(plant, symbol));
    finding.renames.push_back(rename_of(symbol, convert::iec_identifier(symbol.name()), false));
  }
}

}  // namespace

std::vector<bool> lists_named_otherwise(const model::PlantModel& plant) {
  std::vector<bool> otherwise;
  for (const NameCount& count : count_names(plant)) otherwise.push_back(count.most_common().has_value());
  return otherwise;
}

bool breaks_rule(const Subject& subject, const model::Symbol& symbol, name::NameFault fault) {
  return symbol.reading.fault == fault && !subject.named_otherwise[symbol.list];
}

const Rule kNamedOtherwise{
    {"SP208", "named-otherwise", diag::Severity::warning, "many names of a list break the naming rule alike",
     R"(More than a third of the I/O names of a list break the naming rule alike, such as another number of levels: the list is
named by another rule. Single names are not reported then, and neither are their devices; the rules about addresses and types
still report.

**What the model loses.** The symbols whose names do not follow the rule are in no device: they are served, and nothing moves
them.

**How to fix it.** Let symplant propose the rule: `symplant infer LIST -o naming.json`, then `symplant check LIST --naming
naming.json`. `symplant naming` lists ready-made rules, and docs/naming.md explains how to write one in ten lines.
)",
     diag::Rank::name},
    check_named_otherwise};

const Rule kNameTooLong{
    {"SP213", "name-too-long", diag::Severity::warning, "a name is longer than its engineering tool accepts",
     R"(A symbol's name has more characters than the engineering tool of its list accepts: 32 in GX IEC Developer, 40 in
Logix Designer, 128 in TIA Portal. Lists that were written by hand or by a script have such names.

**What the model loses.** Nothing here. But an import into the engineering tool refuses the name or cuts it, and then the names
of the plant and of the program differ.

**How to fix it.** Shorten the name.
)"},
    check_name_too_long};

const Rule kReservedWord{
    {"SP214", "reserved-word", diag::Severity::warning, "a name is a word of IEC 61131-3",
     R"(A symbol is named like a keyword, an elementary type or a standard function of IEC 61131-3: `STEP`, `TIME`, `LIMIT`.

**What the model loses.** Nothing here. But a program in structured text cannot use the name, and tools refuse to import it.

**How to fix it.** Rename the symbol. `symplant convert` writes `_STEP`.
)"},
    check_reserved_word};

}  // namespace symplant::check
