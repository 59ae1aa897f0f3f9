// Rules: what the lists are on a link.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "check/rules.hpp"
#include "model/classify.hpp"
#include "read/parts.hpp"

namespace symplant::check {
namespace {

constexpr std::uint64_t kLocations = 65'536;
constexpr std::size_t kMostRelated = 10;

bool is_on_link(const model::Symbol& symbol) {
  const int bits = model::data_type_bits(symbol.type);
  return symbol.address && bits != 8 && bits == static_cast<int>(symbol.address->size);
}

bool has_location(const model::Symbol& symbol) {
  const std::uint64_t locations = static_cast<std::uint64_t>(std::max(1, model::data_type_bits(symbol.type) / 16));
  return symbol.address->plain && symbol.address->number <= (kLocations - locations) / locations;
}

/// Of one table of one controller.
struct PackedTable {
  std::size_t placed = 0;
  std::vector<std::uint32_t> others;
};

class AddressesOfLink {
 public:
  explicit AddressesOfLink(const model::PlantModel& plant) : plant_(plant), tables_(4 * plant.controllers.size()) {}

  std::vector<PackedTable> run() {
    std::vector<bool> given(plant_.symbols.size());
    for (const model::ControllerLink& link : plant_.links) {
      for (const link::MapRow& row : link.rows) given[row.symbol] = row.number != link::MapRow::kDefault;
    }
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      const model::Symbol& symbol = plant_.symbols[i];
      if (given[i] || !is_on_link(symbol)) continue;
      const std::size_t kind = (symbol.direction == tables::Direction::operation ? 2U : 0U) +
                               (symbol.type == tables::DataType::boolean ? 1U : 0U);
      PackedTable& table = tables_[4 * plant_.controller_of(symbol) + kind];
      if (has_location(symbol)) {
        ++table.placed;
      } else {
        table.others.push_back(i);
      }
    }
    return std::move(tables_);
  }

 private:
  const model::PlantModel& plant_;
  std::vector<PackedTable> tables_;
};

void check_address_without_number(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  constexpr std::array<std::string_view, 4> kTables{"input registers", "discrete inputs", "holding registers", "coils"};
  const std::vector<PackedTable> tables = AddressesOfLink(plant).run();
  for (std::size_t t = 0; t < tables.size(); ++t) {
    const PackedTable& table = tables[t];
    if (table.others.empty() || table.placed <= table.others.size()) continue;
    const model::Symbol& symbol = plant.symbols[table.others.front()];
    std::vector<diag::Related> related;
    for (std::size_t i = 1; i < std::min(table.others.size(), kMostRelated); ++i) {
      const model::Symbol& other = plant.symbols[table.others[i]];
      related.push_back({location_of(plant, *other.row, other.address_cell()), "this one has no number either"});
    }
    diagnostics.add(
        rule.info, about(symbol),
        fmt::format("`{}` has no number on a link, so {} other {} are in list order and do not have their own "
                    "numbers: correct it, or give `{}` a `number` in `links`",
                    symbol.address_cell(), table.placed + table.others.size() - 1, kTables[t % 4], symbol.name()),
        location_of(plant, *symbol.row, symbol.address_cell()), std::move(related));
  }
}

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

const Rule kAddressWithoutNumber{
    {"SP317", "address-without-number", diag::Severity::warning,
     "one address without a number makes the others lose theirs on the link",
     R"(A symbol on a link has the number of its address: `%IX1.5` is discrete input 13, `%QX7` is coil 7. Some addresses have no number:
a bit of 8 or more (`%IX1.8`), three parts, a number of 65536 or more. Then all symbols of the table are packed in list order,
since they could overlap otherwise. Here most addresses of a table have a number, and a few have none.

**What the model loses.** Every coil, input or register of that table has another number on the link than its address. Wiring the
PLC by addresses fails without a message.

**How to fix it.** Correct the address. Or give the symbol a `number` in the description's `links`: then the others keep theirs.
A list in which all addresses consist of word and bit (`%IX1.15`) is packed as a whole and has no finding.
)"},
    check_address_without_number};

const Rule kSeveralLists{
    {"SP330", "several-lists", diag::Severity::warning, "a text holds several lists one after the other",
     R"(The header occurs again, or the addresses start over: most of the next rows have I/O addresses that rows before them have. Most
often the lists of several PLCs were joined into one file. The related rows show where each list begins.

**What the model loses.** All rows are read as the symbols of one PLC. Two symbols on one address are kept equal, although they
are signals of different PLCs.

**How to fix it.** Give each list its controller in plant.json:
`"symbols": [ { "file": "all.csv", "part": 1, "controller": "PLC1" }, { "file": "all.csv", "part": 2, "controller": "PLC2" } ]`.
Parts count from 1. If all rows belong to one PLC, set `"check": { "severity": { "several-lists": "note" } }`.
)",
     diag::Rank::address},
    check_several_lists};

}  // namespace symplant::check
