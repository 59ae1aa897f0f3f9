// The rows of all lists of a plant, as the writers take them.
#include "convert/symbols.hpp"

#include <variant>

#include "base/large_memory.hpp"
#include "model/classify.hpp"
#include "name/symbol_reader.hpp"
#include "naming/load.hpp"
#include "text/ascii.hpp"

namespace symplant::convert {
namespace {

/// The radix of X and Y of each list: one for all lists of a controller.
std::vector<address::Radix> radices(std::span<const List> lists, std::size_t& controllers) {
  std::vector<address::Radix> radices(lists.size());
  std::vector<bool> known(lists.size());
  for (std::size_t first = 0; first < lists.size(); ++first) {
    if (known[first]) continue;
    ++controllers;
    std::vector<const read::SymbolTable*> tables;
    std::vector<std::size_t> same;
    std::optional<address::Radix> option;
    for (std::size_t i = first; i < lists.size(); ++i) {
      if (!text::equal_ignoring_case(lists[i].controller, lists[first].controller)) continue;
      same.push_back(i);
      tables.push_back(lists[i].table.get());
      if (!option) option = lists[i].xy;
    }
    const address::Radix radix = model::choose_radix(tables, option).radix;
    for (const std::size_t i : same) {
      radices[i] = radix;
      known[i] = true;
    }
  }
  return radices;
}

Kind kind_of(const read::ListRow& row, const model::RowAddress& address, name::SymbolReader& reader) {
  // Only a row without an address needs its name.
  const name::Reading reading = address.address ? name::Reading() : reader.read({row.name, {}, {}, {}});
  model::Symbol symbol;
  const auto reason = model::classify(row, reading, address, symbol);
  if (!reason) return symbol.direction == tables::Direction::operation ? Kind::output : Kind::input;
  return *reason == model::InternalReason::constant ? Kind::constant : Kind::internal;
}

}  // namespace

Symbols symbols_of(std::span<const List> lists) {
  Symbols symbols;
  const std::vector<address::Radix> radix = radices(lists, symbols.controllers);
  std::size_t rows = 0;
  for (const List& list : lists) rows += list.table->rows.size();
  base::reserve_large(symbols.all, rows);
  name::SymbolReader reader(naming::strict_naming());
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const read::SymbolTable& table = *lists[i].table;
    symbols.tables.push_back(lists[i].table);
    for (const read::ListRow& row : table.rows) {
      const model::RowAddress address = model::row_address(row, {table.notation, radix[i], &table.io_words});
      symbols.all.push_back({&row, &table.extra_of(row), table.notation, &table.io_words, kind_of(row, address, reader),
                             radix[i] == address::Radix::octal, address.address});
    }
  }
  return symbols;
}

}  // namespace symplant::convert
