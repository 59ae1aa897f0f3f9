// Damage to whole rows, to types and to initial values.
#include <algorithm>

#include "damage/kinds.hpp"
#include "text/ascii.hpp"

namespace symplant::damage {
namespace {

bool any_row(const Cells&, const Levels&) { return true; }
bool is_bool(const Cells& cells, const Levels&) { return cells.type == "BOOL"; }

/// After the row that it copies, or at a later index.
std::size_t place_behind(const Shop& shop, std::size_t row, Dice& dice) {
  return dice.percent(50) ? row + 1 : row + 1 + dice.below(shop.list.rows.size() - row);
}

/// A changed copy of a row; the tool uses the first of the two, and either may be meant.
template <class Change>
Damaged copy_row(const Shop& shop, Dice& dice, Change&& change) {
  const std::size_t row = pick_row(shop, dice, any_row);
  const std::size_t to = place_behind(shop, row, dice);
  Damaged damaged{shop.list, {to}};
  Cells copy = shop.list.rows[row];
  change(copy);
  damaged.list.rows.insert(damaged.list.rows.begin() + static_cast<std::ptrdiff_t>(to), std::move(copy));
  return damaged;
}

Damaged copy_same(const Shop& shop, Dice& dice) {
  return copy_row(shop, dice, [](Cells&) {});
}

Damaged copy_in_other_case(const Shop& shop, Dice& dice) {
  return copy_row(shop, dice, [](Cells& copy) {
    for (char& c : copy.name) {
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
  });
}

/// An address that no row uses.
Damaged copy_to_free_address(const Shop& shop, Dice& dice) {
  return copy_row(shop, dice, [&](Cells& copy) {
    const bool input = copy.iec.find('I') != std::string::npos;
    const std::string number = std::to_string(20'000 + dice.below(1'000));
    copy.vendor = "";
    copy.iec = (input ? "%I" : "%Q") + std::string(copy.type == "BOOL" ? "X" : "W") + number;
  });
}

/// Inserts a new line into the list.
Damaged insert_line(const Shop& shop, Dice& dice, std::string raw) {
  const std::size_t at = 1 + dice.below(shop.list.rows.size() - 1);
  Damaged damaged{shop.list, {at}};
  Cells row;
  row.raw = std::move(raw);
  damaged.list.rows.insert(damaged.list.rows.begin() + static_cast<std::ptrdiff_t>(at), std::move(row));
  return damaged;
}

Damaged insert_garbage(const Shop& shop, Dice& dice) {
  return insert_line(
      shop, dice,
      dice.pick(std::vector<std::string>{"3007 symbols in all", "--- station 20 ---",
                                         "VAR_GLOBAL,,X0F00,%IX3840,BOOL,FALSE,reserve", "revised 12 May; see mail"}));
}

Damaged open_quote(const Shop& shop, Dice& dice) {
  const std::size_t row = pick_row(shop, dice, any_row);
  Damaged damaged{shop.list, {row}};
  Cells& cells = damaged.list.rows[row];
  cells.comment = "\"" + cells.comment;
  return damaged;
}

Damaged write_after_quote(const Shop& shop, Dice& dice) {
  const std::size_t row = pick_row(shop, dice, any_row);
  Damaged damaged{shop.list, {row}};
  Cells& cells = damaged.list.rows[row];
  cells.comment = "\"" + cells.comment + "\" (new)";
  return damaged;
}

/// Latin-1 among UTF-8.
Damaged write_foreign_byte(const Shop& shop, Dice& dice) {
  const std::size_t row = pick_row(shop, dice, any_row);
  Damaged damaged{shop.list, {row}};
  damaged.list.rows[row].comment +=
      " schlie\xDF"
      "en";
  return damaged;
}

Damaged wrong_size_of_type(const Shop& shop, Dice& dice) {
  const std::size_t row = pick_row(shop, dice, any_row);
  Damaged damaged{shop.list, {row}};
  std::string& type = damaged.list.rows[row].type;
  type = type == "BOOL" ? dice.pick(std::vector<std::string>{"INT", "WORD", "REAL"}) : std::string("DINT");
  if (type != "DINT") damaged.list.rows[row].initial = "0";
  return damaged;
}

Damaged misspell_type(const Shop& shop, Dice& dice) {
  const std::size_t row = pick_row(shop, dice, is_bool);
  Damaged damaged{shop.list, {row}};
  damaged.list.rows[row].type = dice.pick(std::vector<std::string>{"BOL", "BOOLE", "BOOOL", "B00L"});
  return damaged;
}

Damaged misspell_initial(const Shop& shop, Dice& dice) {
  const std::size_t row = pick_row(shop, dice, any_row);
  Damaged damaged{shop.list, {row}};
  damaged.list.rows[row].initial = dice.pick(std::vector<std::string>{"YES", "ON", "TURE", "FLASE", "?", "2,5"});
  if (damaged.list.rows[row].initial == "2,5") damaged.list.rows[row].initial = "\"2,5\"";
  return damaged;
}

/// A second event of a device with Initial TRUE.
Damaged start_twice(const Shop& shop, Dice& dice) {
  const auto starts = [&](const Task& task) { return task.event && shop.list.rows[*task.event].initial == "TRUE"; };
  const auto other = [&](const Task& task) { return task.event && shop.list.rows[*task.event].initial != "TRUE"; };
  const Device& device = pick_device(shop, dice, [&](const Device& at) {
    return std::any_of(at.tasks.begin(), at.tasks.end(), starts) &&
           std::any_of(at.tasks.begin(), at.tasks.end(), other);
  });
  Damaged damaged{shop.list, {}};
  std::vector<std::size_t> others;
  for (const Task& task : device.tasks) {
    if (starts(task)) damaged.roots.push_back(*task.event);
    if (other(task)) others.push_back(*task.event);
  }
  const std::size_t row = dice.pick(others);
  damaged.list.rows[row].initial = "TRUE";
  damaged.roots.push_back(row);
  return damaged;
}

Damaged start_operation(const Shop& shop, Dice& dice) {
  const std::size_t row = pick_row(
      shop, dice, [](const Cells& cells, const Levels& at) { return cells.type == "BOOL" && at.direction == "O"; });
  Damaged damaged{shop.list, {row}};
  damaged.list.rows[row].initial = "TRUE";
  return damaged;
}

}  // namespace

std::vector<Kind> row_kinds() {
  return {
      {"row-copied", "a row copied", "duplicate-symbol", copy_same},
      {"row-copied-case", "a row copied, its name in small letters", "duplicate-symbol", copy_in_other_case},
      {"row-copied-address", "a row copied, with another address", "symbol-declared-differently", copy_to_free_address},
      {"garbage", "a remark, a total or an empty reserve among the rows", "row-without-identifier", insert_garbage},
      {"quote-open", "a quote that is never closed", "unclosed-quote", open_quote},
      {"quote-text", "text behind a closing quote", "text-after-quote", write_after_quote},
      {"foreign-byte", "a letter of another code page", "encoding-assumed", write_foreign_byte},
      {"type-size", "a type of another size than the address", "type-against-address", wrong_size_of_type},
      {"type-misspelt", "a type that there is not, as `BOL`", "type-of-no-io", misspell_type},
      {"initial-misspelt", "an invalid initial value, such as `TURE`", "initial-not-understood", misspell_initial},
      {"initial-twice", "two events of a device TRUE", "initial-ambiguous", start_twice},
      {"initial-operation", "an operation TRUE", "operation-initial-ignored", start_operation},
  };
}

}  // namespace symplant::damage
