// Damage to a symbol's name.
#include <algorithm>
#include <array>

#include "damage/kinds.hpp"

namespace symplant::damage {
namespace {

using Part = std::string Levels::*;

constexpr std::size_t kShortest = 3;  ///< letters of a misspelled word: UP with one letter more may be any other word

/// One letter added, removed, changed, or two swapped; digits do not change.
std::string misspelt(const std::string& word, Dice& dice) {
  std::string letters = letters_of(word);
  const std::string digits = digits_of(word);
  const std::size_t at = dice.below(letters.size());
  const char letter = static_cast<char>('A' + dice.below(26));
  switch (dice.below(4)) {
    case 0:
      letters.insert(letters.begin() + static_cast<std::ptrdiff_t>(at + dice.below(2)), letter);
      break;
    case 1:
      letters.erase(at, 1);
      break;
    case 2:
      letters[at] = letter;
      break;
    default:
      std::swap(letters[at], letters[at + 1 < letters.size() ? at + 1 : at - 1]);
      break;
  }
  return letters + digits;
}

/// Whether a letter at its end makes it another form of the word: CLOSED. SP405 reports those.
bool is_bent(const std::string& word, const std::string& other) { return other == word + "D" || other == word + "S"; }

/// Whether the list has the word at that level.
bool known(const Shop& shop, Part part, const std::string& word) {
  return std::any_of(shop.list.rows.begin(), shop.list.rows.end(), [&](const Cells& row) {
    const auto levels = levels_of(row.name);
    return levels && letters_of((*levels).*part) == letters_of(word);
  });
}

Damaged misspell(const Shop& shop, Dice& dice, Part part) {
  const std::size_t row =
      pick_row(shop, dice, [&](const Cells&, const Levels& at) { return letters_of(at.*part).size() >= kShortest; });
  Levels levels = *levels_of(shop.list.rows[row].name);
  std::string word;
  do {
    word = misspelt(levels.*part, dice);
  } while (known(shop, part, word) || is_bent(letters_of(levels.*part), letters_of(word)));
  levels.*part = word;
  Damaged damaged{shop.list, {row}};
  damaged.list.rows[row].name = levels.name();
  return damaged;
}

Damaged misspell_line(const Shop& shop, Dice& dice) { return misspell(shop, dice, &Levels::line); }
Damaged misspell_process(const Shop& shop, Dice& dice) { return misspell(shop, dice, &Levels::process); }
Damaged misspell_device(const Shop& shop, Dice& dice) { return misspell(shop, dice, &Levels::device); }
Damaged misspell_task(const Shop& shop, Dice& dice) { return misspell(shop, dice, &Levels::task); }

bool any(const Cells&, const Levels&) { return true; }

/// Changes the name of any row.
template <class Change>
Damaged rename_any(const Shop& shop, Dice& dice, Change&& change) {
  const std::size_t row = pick_row(shop, dice, any);
  Damaged damaged{shop.list, {row}};
  damaged.list.rows[row].name = change(*levels_of(shop.list.rows[row].name));
  return damaged;
}

constexpr std::array<Part, 5> kParts{&Levels::line, &Levels::process, &Levels::device, &Levels::direction,
                                     &Levels::task};

Damaged miss_level(const Shop& shop, Dice& dice) {
  return rename_any(shop, dice, [&](const Levels& levels) {
    const std::size_t missing = dice.below(kParts.size());
    std::string name;
    for (std::size_t i = 0; i < kParts.size(); ++i) {
      if (i != missing) name += (name.empty() ? "" : "_") + levels.*kParts[i];
    }
    return name;
  });
}

Damaged empty_level(const Shop& shop, Dice& dice) {
  return rename_any(shop, dice, [&](const Levels& whole) {
    Levels levels = whole;
    levels.*kParts[dice.below(kParts.size())] = "";
    return levels.name();
  });
}

/// A separator inside a word: CLAMP_1, BUTTON_START.
Damaged split_level(const Shop& shop, Dice& dice) {
  const std::size_t row = pick_row(shop, dice, [](const Cells&, const Levels& at) {
    return at.device.size() >= 3 && !digits_of(at.device).empty();
  });
  Levels levels = *levels_of(shop.list.rows[row].name);
  levels.device.insert(letters_of(levels.device).size(), "_");
  Damaged damaged{shop.list, {row}};
  damaged.list.rows[row].name = levels.name();
  return damaged;
}

Damaged write_other_direction(const Shop& shop, Dice& dice) {
  return rename_any(shop, dice, [&](Levels levels) {
    levels.direction = dice.pick(std::vector<std::string>{"X", "Y", "Q", "0", "1", "IN", "OUT"});
    return levels.name();
  });
}

Damaged illegal_character(const Shop& shop, Dice& dice) {
  return rename_any(shop, dice, [&](const Levels& levels) {
    const std::string character = dice.pick(std::vector<std::string>{" ", "-", ".", "/", "#", "%"});
    std::string name = levels.name();
    const std::size_t at = 1 + dice.below(name.size() - 2);
    if (name[at] == '_' || dice.percent(50)) return name.replace(at, 1, character);  // replaces a letter or a separator
    return name.insert(at, character);
  });
}

std::string other_side(Levels levels) {
  levels.direction = levels.direction == "I" ? "O" : "I";
  return levels.name();
}

/// The letter of the other side, if the other side has no such symbol.
Damaged turn_direction(const Shop& shop, Dice& dice) {
  const std::size_t row = pick_row(shop, dice, [&](const Cells& cells, const Levels& at) {
    return cells.type == "BOOL" && !shop.list.has(other_side(at));
  });
  Damaged damaged{shop.list, {row}};
  damaged.list.rows[row].name = other_side(*levels_of(shop.list.rows[row].name));
  return damaged;
}

/// The letter of the other side, if such a symbol exists already: either row may be meant.
Damaged turn_direction_onto_other(const Shop& shop, Dice& dice) {
  const std::size_t row = pick_row(shop, dice, [&](const Cells& cells, const Levels& at) {
    return cells.type == "BOOL" && shop.list.has(other_side(at));
  });
  Damaged damaged{shop.list, {row}};
  const std::string name = other_side(*levels_of(shop.list.rows[row].name));
  damaged.list.rows[row].name = name;
  for (std::size_t i = 0; i < shop.list.rows.size(); ++i) {
    if (shop.list.rows[i].name == name) damaged.roots.push_back(i);
  }
  return damaged;
}

}  // namespace

std::vector<Kind> name_kinds() {
  return {
      {"line-misspelt", "the line's name, one letter more, less, other, or two swapped", "name-slip", misspell_line},
      {"process-misspelt", "the same for the process", "name-slip", misspell_process},
      {"device-misspelt", "the same for the device", "name-slip", misspell_device},
      {"task-misspelt", "the same for the task", "name-slip", misspell_task},
      {"level-missing", "a level of the name left out", "wrong-number-of-levels", miss_level},
      {"level-empty", "a level of the name empty, as in `LINE__DEV_I_ON`", "empty-level", empty_level},
      {"level-split", "a level too many, as in `CLAMP_1`", "wrong-number-of-levels", split_level},
      {"direction-unknown", "another word than I or O for the direction", "direction-not-io", write_other_direction},
      {"character", "a blank, hyphen, point ... within the name", "illegal-character", illegal_character},
      {"direction-turned", "O for I or I for O in the name", "direction-against-address", turn_direction},
      {"direction-turned-onto", "the same, where the other direction has that symbol already",
       "symbol-declared-differently", turn_direction_onto_other},
  };
}

}  // namespace symplant::damage
