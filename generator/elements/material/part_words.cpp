// Recognizes sensors of parts by their names.
#include "elements/material/part_words.hpp"

#include <algorithm>
#include <array>

#include "text/ascii.hpp"

namespace symplant::model {
namespace {

constexpr std::array<std::string_view, 14> kWords{"PE",        "PEC",     "PHOTO",    "PHOTOEYE",    "PART",
                                                  "PARTS",     "PRESENT", "PRESENCE", "PALLET",      "CARRIER",
                                                  "WORKPIECE", "WP",      "OCCUPIED", "LIGHTBARRIER"};

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

bool has_word(std::string_view name) {
  for (std::size_t begin = 0; begin < name.size();) {
    if (!is_letter(name[begin])) {
      ++begin;
      continue;
    }
    std::size_t end = begin;
    while (end < name.size() && is_letter(name[end])) ++end;
    const std::string_view word = name.substr(begin, end - begin);
    if (std::any_of(kWords.begin(), kWords.end(),
                    [&](std::string_view known) { return text::equal_ignoring_case(known, word); })) {
      return true;
    }
    begin = end;
  }
  return false;
}

}  // namespace

bool looks_like_part_sensor(const Symbol& symbol) {
  if (!symbol.reading.is_named()) return has_word(symbol.name());
  return has_word(symbol.reading.device()) || has_word(symbol.reading.task());
}

bool is_driven(const PlantModel& plant, const Symbol& symbol) {
  if (symbol.leader != kNone) return true;
  if (symbol.driven_without_unit()) return true;
  if (symbol.account == Account::constant) return true;
  if (symbol.unit == kNone) return false;
  const Unit& unit = plant.units[symbol.unit];
  for (std::uint32_t e = 0; e < unit.events.size(); ++e) {
    if (&plant.symbols[unit.events[e]] == &symbol) return unit.moves_event(e);
  }
  return false;
}

}  // namespace symplant::model
