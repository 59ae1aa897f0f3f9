// Collects the rows of all lists: symbols, internal rows, repeated names.
#include "model/collect_symbols.hpp"

#include <algorithm>
#include <variant>

#include "base/index_table.hpp"
#include "base/large_memory.hpp"
#include "model/classify.hpp"
#include "text/ascii.hpp"

namespace symplant::model {
namespace {

/// Rows to fetch ahead: enough time for an access to memory.
constexpr std::size_t kAhead = 12;

/// Sorts rows into symbols, internal rows and repeated names.
class SymbolCollector {
 public:
  SymbolCollector(Derived& derived, std::size_t rows)
      : plant_(derived.plant), evidence_(derived.evidence), by_name_(rows) {
    base::reserve_large(plant_.symbols, rows);
    base::reserve_large(indexes_, rows);
    if (plant_.reader == nullptr) return;
    plant_.levels = std::make_shared<std::vector<name::LevelTexts>>();
    plant_.levels->reserve(rows);  // symbols point to them
  }

  /// Fetches the hash slot of a row that will be added soon.
  [[gnu::always_inline]] void announce(const read::ListRow& row) const {
    by_name_.prefetch(text::hash_ignoring_case(row.name));
  }

  /// Whether the row is a symbol.
  template <class Reading>
  bool add(const read::ListRow& row, std::uint32_t list, const Reading& reading) {
    const auto index = static_cast<std::uint32_t>(indexes_.size());
    const std::uint32_t first = by_name_.find_or_add(
        text::hash_ignoring_case(row.name), index,
        [&](std::uint32_t other) { return text::equal_ignoring_case(indexes_[other].row->name, row.name); });
    if (first != index) {
      evidence_.duplicates.push_back({indexes_[first].row, &row, same(indexes_[first], {&row, list})});
      return false;
    }
    indexes_.push_back({&row, list});
    const RowAddress address = address_of(row, list);
    auto result = classify(row, reading, address);
    const auto* reason = std::get_if<InternalReason>(&result);
    // A row that is internal for another reason may have any address.
    if (!address.bad_cell.empty() && (reason == nullptr || *reason == InternalReason::no_direction)) {
      evidence_.bad_addresses.push_back({&row, address.bad_cell});
    }
    if (address.vendor && (reason == nullptr || *reason == InternalReason::memory)) {
      ++plant_.lists[list].compared;
      if (address.contradicts) {
        evidence_.address_contradictions.push_back({&row, list, *address.vendor, *address.address});
      }
    }
    if (reason != nullptr && *reason == InternalReason::type && address.address) {
      evidence_.typeless_io.push_back({&row, address.cell});
    }
    if (reason != nullptr) {
      ++plant_.internal[static_cast<std::size_t>(*reason)];
    } else {
      Symbol& symbol = plant_.symbols.emplace_back(std::get<Symbol>(result));
      symbol.list = list;
      keep_levels(symbol, reading);
      const bool is_alias = row.extra != read::kNoExtra && !plant_.lists[list].table->extra_of(row).alias.empty();
      if (is_alias && symbol.direction_by == DirectionBy::address) symbol.direction_by = DirectionBy::alias;
    }
    return reason == nullptr;
  }

 private:
  struct Location {
    const read::ListRow* row;
    std::uint32_t list;
  };

  static void keep_levels(const Symbol&, const name::NameReading&) {}
  /// Under a custom rule the levels are not those of the name.
  void keep_levels(Symbol& symbol, const name::RuleReading& reading) {
    name::LevelTexts& levels = plant_.levels->emplace_back();
    levels.line = reading.line;
    levels.process = reading.process;
    levels.device = reading.device;
    symbol.reading = name::NameReading::of(levels, symbol.reading.fault, symbol.reading.direction);
  }

  RowAddress address_of(const read::ListRow& row, std::uint32_t list) const {
    return row_address(row, plant_.lists[list].dialect());
  }

  bool same(const Location& a, const Location& b) const {
    const auto first = address_of(*a.row, a.list).address;
    const auto second = address_of(*b.row, b.list).address;
    const bool same_address = first && second ? address::same_location(*first, *second) : !first && !second;
    return plant_.lists[a.list].controller == plant_.lists[b.list].controller &&
           text::equal_ignoring_case(a.row->type, b.row->type) && same_address;
  }

  PlantModel& plant_;
  Evidence& evidence_;
  std::vector<Location> indexes_;  ///< rows of different names
  base::IndexTable by_name_;       ///< name -> index in `indexes_`
};

void collect_lists(PlantModel& plant, const std::vector<ListInput>& lists) {
  for (const ListInput& list : lists) {
    const auto known = std::find_if(plant.controllers.begin(), plant.controllers.end(), [&](const std::string& name) {
      return text::equal_ignoring_case(name, list.controller);
    });
    const auto controller = static_cast<std::uint32_t>(known - plant.controllers.begin());
    if (known == plant.controllers.end()) plant.controllers.push_back(list.controller);
    plant.lists.push_back({list.table, controller, {}, {}});
  }
}

/// Chooses one radix of X and Y for each controller, which the rows of all its lists prove together.
void choose_radices(PlantModel& plant, const std::vector<ListInput>& lists) {
  for (std::uint32_t controller = 0; controller < plant.controllers.size(); ++controller) {
    std::vector<const read::SymbolTable*> tables;
    std::optional<address::Radix> option;
    for (std::size_t i = 0; i < lists.size(); ++i) {
      if (plant.lists[i].controller != controller) continue;
      tables.push_back(lists[i].table.get());
      if (!option) option = lists[i].xy;
    }
    const RadixChoice choice = choose_radix(tables, option);
    for (std::size_t i = 0; i < lists.size(); ++i) {
      PlantList& list = plant.lists[i];
      if (list.controller != controller) continue;
      const read::SymbolTable* const table = lists[i].table.get();
      list.own = tables.size() == 1 ? choice : choose_radix({&table, 1}, lists[i].xy);
      list.radix = choice;
    }
  }
}

}  // namespace

std::vector<const name::RuleReading*> collect_symbols(Derived& derived, const std::vector<ListInput>& lists) {
  PlantModel& plant = derived.plant;
  collect_lists(plant, lists);
  choose_radices(plant, lists);
  std::size_t rows = 0;
  for (const ListInput& list : lists) rows += list.table->rows.size();
  SymbolCollector collector(derived, rows);
  std::vector<const name::RuleReading*> readings;
  for (std::uint32_t list = 0; list < lists.size(); ++list) {
    const auto& table = lists[list].table->rows;
    for (std::size_t i = 0; i < table.size(); ++i) {
      if (i + kAhead < table.size()) collector.announce(table[i + kAhead]);
      if (!lists[list].named.by_rule.empty()) {
        const name::RuleReading& reading = lists[list].named.by_rule[i];
        if (collector.add(table[i], list, reading)) readings.push_back(&reading);
      } else {
        collector.add(table[i], list, lists[list].named.readings[i]);
      }
    }
  }
  return readings;
}

}  // namespace symplant::model
