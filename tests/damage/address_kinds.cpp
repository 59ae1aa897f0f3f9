// Damage to a symbol's addresses.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <stdexcept>

#include "damage/kinds.hpp"

namespace symplant::damage {
namespace {

std::string side_of(const Cells& cells) { return cells.iec.substr(1, 1); }

std::uint64_t number_of(const Cells& cells) { return std::stoull(cells.iec.substr(3)); }

std::string text_of(std::uint64_t number, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, static_cast<unsigned long long>(number));
  return text;
}

/// Both columns, with X and Y counted in hexadecimal.
void set_bit(Cells& cells, bool input, std::uint64_t number) {
  cells.vendor = (input ? "X" : "Y") + text_of(number, "%04llX");
  cells.iec = (input ? "%IX" : "%QX") + std::to_string(number);
}

bool is_bit(const Cells& cells, const Levels&) { return cells.type == "BOOL" && !cells.vendor.empty(); }

/// The far end of the bit addresses, which no symbol uses.
std::uint64_t free_bit(Dice& dice) { return 0x3000 + dice.below(0x800); }

template <class Wanted, class Change>
Damaged change_row(const Shop& shop, Dice& dice, Wanted&& wanted, Change&& change) {
  const std::size_t row = pick_row(shop, dice, wanted);
  Damaged damaged{shop.list, {row}};
  change(damaged.list.rows[row]);
  return damaged;
}

/// Two rows of one side on one address: either may be the wrong one.
Damaged share(const Shop& shop, Dice& dice, bool driven_by_two) {
  const auto has_operation = [&](const Levels& at) {
    return std::any_of(shop.devices.begin(), shop.devices.end(), [&](const Device& device) {
      return device.levels.path() == at.path() && std::any_of(device.tasks.begin(), device.tasks.end(),
                                                              [](const Task& t) { return t.operation.has_value(); });
    });
  };
  const auto fits = [&](const Cells& cells, const Levels& at) {
    return is_bit(cells, at) && (driven_by_two ? at.direction == "I" && has_operation(at) : at.direction == "O");
  };
  const std::size_t first = pick_row(shop, dice, fits);
  const std::string path = levels_of(shop.list.rows[first].name)->path();
  const std::size_t second =
      pick_row(shop, dice, [&](const Cells& cells, const Levels& at) { return fits(cells, at) && at.path() != path; });
  Damaged damaged{shop.list, {first, second}};
  damaged.list.rows[second].vendor = damaged.list.rows[first].vendor;
  damaged.list.rows[second].iec = damaged.list.rows[first].iec;
  return damaged;
}

Damaged share_output(const Shop& shop, Dice& dice) { return share(shop, dice, false); }
Damaged share_driven_input(const Shop& shop, Dice& dice) { return share(shop, dice, true); }

bool has_other_side(const Shop& shop, Levels levels) {
  levels.direction = levels.direction == "I" ? "O" : "I";
  return shop.list.has(levels.name());
}

Damaged other_side(const Shop& shop, Dice& dice, bool task_has_other) {
  return change_row(
      shop, dice,
      [&](const Cells& cells, const Levels& at) {
        return is_bit(cells, at) && has_other_side(shop, at) == task_has_other;
      },
      [&](Cells& cells) { set_bit(cells, side_of(cells) != "I", free_bit(dice)); });
}

Damaged other_side_of_pair(const Shop& shop, Dice& dice) { return other_side(shop, dice, true); }
Damaged other_side_alone(const Shop& shop, Dice& dice) { return other_side(shop, dice, false); }

/// Only one of the columns was updated.
Damaged contradict_number(const Shop& shop, Dice& dice) {
  return change_row(shop, dice, is_bit, [&](Cells& cells) {
    Cells other = cells;
    set_bit(other, side_of(cells) == "I", free_bit(dice));
    if (dice.percent(50)) {
      cells.vendor = other.vendor;
    } else {
      cells.iec = other.iec;
    }
  });
}

/// The row counts X and Y in octal.
Damaged contradict_radix(const Shop& shop, Dice& dice) {
  return change_row(
      shop, dice, [](const Cells& cells, const Levels& at) { return is_bit(cells, at) && number_of(cells) >= 8; },
      [&](Cells& cells) { cells.vendor = cells.vendor.substr(0, 1) + text_of(number_of(cells), "%04llo"); });
}

Damaged contradict_area(const Shop& shop, Dice& dice) {
  return change_row(shop, dice, is_bit, [&](Cells& cells) {
    if (dice.percent(50)) {
      cells.vendor[0] = cells.vendor[0] == 'X' ? 'Y' : 'X';
    } else {
      cells.iec[1] = cells.iec[1] == 'I' ? 'Q' : 'I';
    }
  });
}

Damaged no_address_at_all(const Shop& shop, Dice& dice) {
  return change_row(shop, dice, is_bit, [&](Cells& cells) {
    const std::string none = dice.pick(std::vector<std::string>{"X00G1", "EX0012", "%IY12", "I-O-1", "12", "?"});
    cells.vendor = none[0] == '%' ? "" : none;
    cells.iec = none[0] == '%' ? none : "";
  });
}

Damaged leave_out(const Shop& shop, Dice& dice) {
  return change_row(shop, dice, is_bit, [](Cells& cells) { cells.vendor = cells.iec = ""; });
}

}  // namespace

std::vector<Kind> address_kinds() {
  return {
      {"address-twice", "the address of another device's output", "address-used-twice", share_output},
      {"address-moved-twice", "the address of another device's input, where both move", "event-driven-twice",
       share_driven_input},
      {"address-other-side", "an address of the other direction, where the task has both", "direction-against-address",
       other_side_of_pair},
      {"address-other-side-alone", "the same, where the task has only one", "direction-against-address",
       other_side_alone},
      {"columns-number", "one address column changed, the other not", "addresses-contradict", contradict_number},
      {"columns-radix", "X or Y counted in octal in a list that counts in hexadecimal", "addresses-contradict",
       contradict_radix},
      {"columns-side", "X for Y or Y for X in one of the columns", "addresses-contradict", contradict_area},
      {"address-none", "an invalid address, such as `X00G1`", "address-not-understood", no_address_at_all},
      {"address-missing", "both address columns empty", "no-address", leave_out},
  };
}

}  // namespace symplant::damage
