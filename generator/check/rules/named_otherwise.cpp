// SP208 named-otherwise: few names of a list follow the naming rule.
#include <fmt/format.h>

#include <vector>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kNamedOtherwisePage =
    R"(Less than a quarter of the I/O names of a list follow the naming rule, and many do not: the list is named by another rule.
Single names are not reported then.

**What the model loses.** The symbols whose names do not follow the rule are in no device: they are served, and nothing moves
them.

**How to fix it.** Let symplant propose the rule: `symplant infer LIST -o naming.json`, then `symplant check LIST --naming
naming.json`. `symplant naming` lists ready-made rules, and docs/naming.md explains how to write one in ten lines.
)";

/// Fewer names get a finding each.
constexpr std::size_t kLeastFaulty = 20;

struct NameCount {
  std::size_t follow = 0;
  std::size_t faulty = 0;
};

std::vector<NameCount> count_names(const model::PlantModel& plant) {
  std::vector<NameCount> counts(plant.lists.size());
  for (const model::Symbol& symbol : plant.symbols) {
    NameCount& count = counts[symbol.list];
    ++(symbol.reading.fault == name::NameFault::none ? count.follow : count.faulty);
  }
  return counts;
}

void check_named_otherwise(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (plant.units.empty()) return;  // SP415 reports it
  const std::vector<NameCount> counts = count_names(plant);
  std::vector<bool> reported = subject.named_otherwise;
  reported.flip();
  for (const model::Symbol& symbol : plant.symbols) {
    if (reported[symbol.list] || symbol.reading.fault == name::NameFault::none) continue;
    reported[symbol.list] = true;
    const NameCount& count = counts[symbol.list];
    const std::string file = plant.lists[symbol.list].name();
    diagnostics.add(
        rule.info,
        fmt::format("{} of {} I/O names in `{}` follow `{}`: the list is named by another rule; let `symplant "
                    "infer {} -o naming.json` propose it, or choose one that `symplant naming` lists",
                    count.follow, count.follow + count.faulty, file, plant.rule->pattern, file),
        location_of(plant, symbol));
  }
}

}  // namespace

std::vector<bool> lists_named_otherwise(const model::PlantModel& plant) {
  std::vector<bool> otherwise;
  for (const NameCount& count : count_names(plant)) {
    otherwise.push_back(count.faulty >= kLeastFaulty && count.follow < (count.follow + count.faulty) / 4);
  }
  return otherwise;
}

bool breaks_rule(const Subject& subject, const model::Symbol& symbol, name::NameFault fault) {
  return symbol.reading.fault == fault && !subject.named_otherwise[symbol.list];
}

const Rule kNamedOtherwise{{"SP208", "named-otherwise", diag::Severity::warning,
                            "few names of a list follow the naming rule", kNamedOtherwisePage, diag::Rank::name},
                           check_named_otherwise};

}  // namespace symplant::check
