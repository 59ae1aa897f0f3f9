// SP330 several-lists: a text holds several lists one after the other.
#include <fmt/format.h>

#include <vector>

#include "check/rules.hpp"
#include "read/parts.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kSeveralListsPage =
    R"(The header occurs again, or the addresses start over: most of the next rows have I/O addresses that rows before them have. Most
often the lists of several PLCs were joined into one file. The related rows show where each list begins.

**What the model loses.** All rows are read as the symbols of one PLC. Two symbols on one address are kept equal, although they
are signals of different PLCs.

**How to fix it.** Give each list its controller in plant.json:
`"symbols": [ { "file": "all.csv", "part": 1, "controller": "PLC1" }, { "file": "all.csv", "part": 2, "controller": "PLC2" } ]`.
Parts count from 1. If all rows belong to one PLC, set `"check": { "severity": { "several-lists": "note" } }`.
)";

/// Fewer symbols on used addresses are doubles, not another list.
constexpr std::size_t kFewest = 8;

std::vector<std::size_t> followers_by_list(const model::PlantModel& plant) {
  std::vector<std::size_t> counts(plant.lists.size());
  for (const model::Symbol& symbol : plant.symbols) counts[symbol.list] += symbol.leader != model::kNone ? 1U : 0U;
  return counts;
}

/// Explains the symbols on addresses that an earlier list has.
diag::Subjects subjects_of(const model::PlantModel& plant, const model::Evidence& evidence, std::uint32_t list) {
  diag::Subjects subjects;
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.list == list && symbol.leader != model::kNone) subjects.explains.push_back(address_of(symbol.name()));
  }
  for (const auto& [second, first] : evidence.driven_twice) {
    if (plant.symbols[second].list == list) subjects.explains.push_back(address_of(plant.symbols[second].name()));
  }
  return subjects;
}

void check_several_lists(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  const std::vector<std::size_t> followers = followers_by_list(plant);
  for (std::uint32_t i = 0; i < plant.lists.size(); ++i) {
    const read::SymbolTable& table = *plant.lists[i].table;
    if (table.parts.empty() && followers[i] < kFewest) continue;
    const std::vector<std::size_t> begins = read::find_parts(table, plant.lists[i].radix.radix);
    std::vector<diag::Related> related;
    for (std::size_t part = 0; part < begins.size(); ++part) {
      if (begins[part] >= table.rows.size()) continue;
      const read::ListRow& row = table.rows[begins[part]];
      related.push_back({location_of(plant, row, row.name), fmt::format("list {} begins here", part + 2)});
    }
    if (related.empty()) continue;
    const read::ListRow& first = table.rows.front();
    const std::string_view reason = table.parts.empty() ? "the addresses start over" : "the header occurs again";
    std::string message = fmt::format(
        "this text holds {} lists, because {}: they are read as one; if they belong to different PLCs, give each "
        "`\"part\"` its `\"controller\"` in plant.json",
        related.size() + 1, reason);
    diagnostics.add(rule.info, subjects_of(plant, subject.evidence, i), std::move(message),
                    location_of(plant, first, first.name), std::move(related));
  }
}

}  // namespace

const Rule kSeveralLists{{"SP330", "several-lists", diag::Severity::warning,
                          "a text holds several lists one after the other", kSeveralListsPage, diag::Rank::address},
                         check_several_lists};

}  // namespace symplant::check
