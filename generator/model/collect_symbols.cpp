// Collects the rows of all lists: symbols, internal rows, repeated names.
#include "model/collect_symbols.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "base/index_table.hpp"
#include "base/large_memory.hpp"
#include "model/classify.hpp"
#include "text/ascii.hpp"

namespace symplant::model {
namespace {

/// A row and the index of its list.
struct RowOfList {
  const read::ListRow* row;
  std::uint32_t list;
};

/// Finds rows by their names. Rows are numbered over all lists.
class RowNames {
 public:
  explicit RowNames(const std::vector<PlantList>& lists) : lists_(lists) {
    for (const PlantList& list : lists) {
      begins_.push_back(rows_);
      rows_ += list.table->rows.size();
    }
    by_name_ = base::IndexTable(rows_);
  }

  std::size_t rows() const { return rows_; }

  /// Has to be called for each row before find_or_add(), some rows earlier: fetches what that needs from memory.
  [[gnu::always_inline]] void announce(const read::ListRow& row, std::size_t number) {
    std::uint64_t& hash = hashes_[number % hashes_.size()];
    hash = text::hash_ignoring_case(row.name);
    by_name_.prefetch(hash);
  }

  /// The first row of this name, perhaps the row itself.
  std::uint32_t find_or_add(const read::ListRow& row, std::size_t number) {
    return by_name_.find_or_add(
        hashes_[number % hashes_.size()], static_cast<std::uint32_t>(number),
        [&](std::uint32_t other) { return text::equal_ignoring_case(at(other).row->name, row.name); });
  }

  RowOfList at(std::size_t number) const {
    const auto after = std::upper_bound(begins_.begin(), begins_.end(), number);
    const auto list = static_cast<std::size_t>(after - begins_.begin()) - 1;
    return {&lists_[list].table->rows[number - begins_[list]], static_cast<std::uint32_t>(list)};
  }

  static constexpr std::size_t kAhead = 12;  ///< rows: enough time for an access to memory

 private:
  const std::vector<PlantList>& lists_;
  std::vector<std::size_t> begins_;  ///< of lists; some may have no rows
  std::size_t rows_ = 0;
  std::array<std::uint64_t, 16> hashes_{};  ///< of the rows that are announced
  base::IndexTable by_name_;
};

/// Sorts rows into symbols, internal rows and repeated names.
class SymbolCollector {
 public:
  explicit SymbolCollector(Derived& derived)
      : plant_(derived.plant), evidence_(derived.evidence), names_(plant_.lists) {
    base::reserve_large(plant_.symbols, names_.rows());
  }

  /// Adds the rows of the next list. `take(i)` is called for each row that is a symbol.
  template <class Take>
  void add(std::uint32_t list, const std::vector<name::Reading>& readings, Take take) {
    const std::vector<read::ListRow>& rows = plant_.lists[list].table->rows;
    for (std::size_t i = 0; i < std::min(RowNames::kAhead, rows.size()); ++i) names_.announce(rows[i], next_ + i);
    for (std::size_t i = 0; i < rows.size(); ++i, ++next_) {
      const std::size_t ahead = i + RowNames::kAhead;
      if (ahead < rows.size()) names_.announce(rows[ahead], next_ + RowNames::kAhead);
      const std::uint32_t first = names_.find_or_add(rows[i], next_);
      if (first != next_) {
        evidence_.duplicates.push_back({names_.at(first).row, &rows[i], same(names_.at(first), {&rows[i], list})});
      } else if (add_row(rows[i], list, readings[i])) {
        take(i);
      }
    }
  }

 private:
  /// Whether the row is a symbol.
  bool add_row(const read::ListRow& row, std::uint32_t list, const name::Reading& reading) {
    const RowAddress address = address_of({&row, list});
    Symbol& symbol = plant_.symbols.emplace_back();
    const std::optional<InternalReason> reason = classify(row, reading, address, symbol);
    observe({&row, list}, address, reason);
    if (reason) {
      ++plant_.internal[static_cast<std::size_t>(*reason)];
      plant_.symbols.pop_back();
      return false;
    }
    symbol.list = list;
    const bool is_alias = row.extra != read::kNoExtra && !plant_.lists[list].table->extra_of(row).alias.empty();
    if (is_alias && symbol.direction_by == DirectionBy::address) symbol.direction_by = DirectionBy::alias;
    return true;
  }

  /// Keeps what rules need to know of a row's addresses.
  void observe(const RowOfList& at, const RowAddress& address, const std::optional<InternalReason>& reason) {
    // A row that is internal for another reason may have any address.
    if (!address.bad_cell.empty() && (!reason || *reason == InternalReason::no_direction)) {
      evidence_.bad_addresses.push_back({at.row, address.bad_cell});
    }
    if (address.vendor && (!reason || *reason == InternalReason::memory)) {
      ++plant_.lists[at.list].compared;
      if (address.contradicts) {
        evidence_.address_contradictions.push_back({at.row, at.list, *address.vendor, *address.address});
      }
    }
    if (reason == InternalReason::type && address.address) evidence_.typeless_io.push_back({at.row, address.cell});
  }

  RowAddress address_of(const RowOfList& at) const { return row_address(*at.row, plant_.lists[at.list].dialect()); }

  bool same(const RowOfList& a, const RowOfList& b) const {
    const auto first = address_of(a).address;
    const auto second = address_of(b).address;
    const bool same_address = first && second ? address::same_location(*first, *second) : !first && !second;
    return plant_.lists[a.list].controller == plant_.lists[b.list].controller &&
           text::equal_ignoring_case(a.row->type, b.row->type) && same_address;
  }

  PlantModel& plant_;
  Evidence& evidence_;
  RowNames names_;
  std::size_t next_ = 0;  ///< the number of the next row
};

void collect_lists(PlantModel& plant, const std::vector<ListInput>& lists) {
  for (const ListInput& list : lists) {
    const auto known = std::find_if(plant.controllers.begin(), plant.controllers.end(), [&](const std::string& name) {
      return text::equal_ignoring_case(name, list.controller);
    });
    const auto controller = static_cast<std::uint32_t>(known - plant.controllers.begin());
    if (known == plant.controllers.end()) plant.controllers.push_back(list.controller);
    PlantList& added = plant.lists.emplace_back();
    added.table = list.table;
    added.controller = controller;
    added.prefix = list.prefix;
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

std::vector<const name::Reading*> collect_symbols(Derived& derived, const std::vector<ListInput>& lists) {
  PlantModel& plant = derived.plant;
  collect_lists(plant, lists);
  choose_radices(plant, lists);
  SymbolCollector collector(derived);
  std::vector<const name::Reading*> readings;
  const bool paired = plant.naming().units == name::Units::facets;
  for (std::uint32_t list = 0; list < lists.size(); ++list) {
    const std::vector<name::Reading>& of_rows = lists[list].named.readings;
    collector.add(list, of_rows, [&](std::size_t row) {
      if (paired) readings.push_back(&of_rows[row]);
    });
  }
  return readings;
}

}  // namespace symplant::model
