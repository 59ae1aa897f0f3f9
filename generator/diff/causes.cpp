// Finds the common causes of many changes.
#include "diff/causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_set>

#include "diff/fields.hpp"
#include "text/ascii.hpp"

namespace symplant::diff {
namespace {

using Kind = Cause::Kind;

/// `CL#` for `CL027` if the number is also that of `other`: `CX027`.
std::string without_number(std::string_view word, std::string_view other) {
  const auto number = [](std::string_view text) {
    std::size_t at = text.size();
    while (at > 0 && text::is_digit(text[at - 1])) --at;
    return text.substr(at);
  };
  const std::string_view digits = number(word);
  if (digits.empty() || digits.size() == word.size() || digits != number(other)) return std::string(word);
  return std::string(word.substr(0, word.size() - digits.size())) + "#";
}

/// Collects changes by their cause.
class Causes {
 public:
  void add(Kind kind, std::string before, std::string after, std::size_t member) {
    Cause& cause = found_[{kind, before, after}];
    cause.kind = kind;
    cause.before = std::move(before);
    cause.after = std::move(after);
    cause.members.push_back(static_cast<std::uint32_t>(member));
  }

  /// Words with numbers are one cause for all numbers; a single one is named as it is.
  void add_replaced(std::string_view before, std::string_view after, std::size_t member) {
    Cause& cause = found_[{Kind::replaced, without_number(before, after), without_number(after, before)}];
    cause.kind = Kind::replaced;
    cause.members.push_back(static_cast<std::uint32_t>(member));
    if (cause.members.size() == 1) {
      cause.before = before;
      cause.after = after;
    } else if (cause.before != before) {
      cause.before = without_number(before, after);
      cause.after = without_number(after, before);
    }
  }

  std::vector<Cause> take() {
    std::vector<Cause> causes;
    for (auto& [key, cause] : found_) {
      if (cause.members.size() >= kLeastMembers) causes.push_back(std::move(cause));
    }
    std::stable_sort(causes.begin(), causes.end(), [](const Cause& a, const Cause& b) {
      return std::pair(a.kind, a.members.front()) < std::pair(b.kind, b.members.front());
    });
    return causes;
  }

 private:
  std::map<std::tuple<Kind, std::string, std::string>, Cause> found_;
};

bool is_word_character(char c) {
  return static_cast<unsigned char>(c) >= 0x80 || text::is_digit(c) || (text::upper(c) >= 'A' && text::upper(c) <= 'Z');
}

/// Whether no word goes on across a position.
bool is_between_words(std::string_view text, std::size_t at) {
  return at == 0 || at >= text.size() || !is_word_character(text[at]) || !is_word_character(text[at - 1]);
}

/// Calls `use` with `S1` and `S1_D2` for `S1_D2_OPEN`: a name up to the end of each word but the last.
template <class Use>
void for_each_beginning(std::string_view name, Use use) {
  for (std::size_t at = 1; at < name.size(); ++at) {
    if (is_word_character(name[at - 1]) && !is_word_character(name[at])) use(name.substr(0, at));
  }
}

/// Finds what only names of one plant begin with: `S9` if the other plant has no name `S9_...`.
class Beginnings {
 public:
  void offer(std::string_view name) {
    for_each_beginning(name, [&](std::string_view beginning) { own_.insert(beginning); });
  }
  void exclude(std::string_view name) {
    if (own_.empty()) return;
    for_each_beginning(name, [&](std::string_view beginning) { own_.erase(beginning); });
  }
  /// The shortest such beginning; empty without one.
  std::string_view of(std::string_view name) const {
    std::string_view found;
    for_each_beginning(name, [&](std::string_view beginning) {
      if (found.empty() && own_.count(beginning) != 0) found = beginning;
    });
    return found;
  }

 private:
  std::unordered_set<std::string_view> own_;
};

/// Adds the causes of names that came or went together. `names` are those of the changes, `others` all names of the
/// other plant.
void add_names(Kind kind, const std::vector<std::pair<std::string_view, std::size_t>>& names,
               const std::vector<std::string_view>& others, Causes& causes) {
  Beginnings beginnings;
  for (const auto& [name, member] : names) beginnings.offer(name);
  for (const std::string_view other : others) beginnings.exclude(other);
  for (const auto& [name, member] : names) {
    const std::string beginning(beginnings.of(name));
    if (beginning.empty()) continue;
    causes.add(kind, kind == Kind::removed ? beginning : "", kind == Kind::added ? beginning : "", member);
  }
}

/// The names of all rows, or nothing if `needed` is false.
std::vector<std::string_view> row_names(const model::PlantModel& plant, bool needed) {
  std::vector<std::string_view> names;
  if (!needed) return names;
  for (const model::PlantList& list : plant.lists) {
    for (const read::ListRow& row : list.table->rows) names.push_back(row.name);
  }
  return names;
}

std::vector<std::string_view> unit_names(const model::PlantModel& plant) {
  std::vector<std::string_view> names;
  for (const model::Unit& unit : plant.units) names.push_back(unit.path);
  return names;
}

/// Where an address begins, and in what unit it counts.
struct Position {
  address::Address address;
  std::int64_t at = 0;
  bool in_bits = false;  ///< else in addresses
};

std::optional<Position> position_of(const model::PlantModel& plant, const RowRef& at) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 62U;
  const auto address = address_of(plant, at);
  if (!address || !address->assigned) return std::nullopt;
  if (address->bank != address::kNoBank && address->first_bit < kMost) {
    return Position{*address, static_cast<std::int64_t>(address->first_bit), true};
  }
  if (!address->plain || address->area == address::Area::memory || address->number >= kMost) return std::nullopt;
  return Position{*address, static_cast<std::int64_t>(address->number), false};
}

std::string distance_text(const Position& a, const Position& b) {
  const std::int64_t distance = b.at - a.at;
  const std::int64_t element = a.in_bits ? a.address.element : 1;
  const std::int64_t shown = distance % element == 0 ? distance / element : distance;
  const std::string_view unit = element == 1              ? "address"
                                : distance % element != 0 ? "bit"
                                : element == 8            ? "byte"
                                                          : "word";
  const std::string_view plural = shown == 1 || shown == -1 ? "" : element == 1 ? "es" : "s";
  return fmt::format("{:+} {}{}", shown, unit, plural);
}

std::string_view area_text(address::Area area) {
  constexpr std::array<std::string_view, 3> kTexts{"inputs", "outputs", "memory"};
  return kTexts[static_cast<std::size_t>(area)];
}

void add_shift(const model::PlantModel& before, const model::PlantModel& after, const SymbolChange& change,
               std::size_t member, Causes& causes) {
  const auto a = position_of(before, change.before);
  const auto b = position_of(after, change.after);
  const bool comparable = a && b && a->address.area == b->address.area && a->address.size == b->address.size &&
                          a->address.bank == b->address.bank && a->address.element == b->address.element &&
                          a->in_bits == b->in_bits && a->at != b->at;
  if (comparable) causes.add(Kind::shifted, std::string(area_text(a->address.area)), distance_text(*a, *b), member);
}

void add_replacement(std::string_view before, std::string_view after, std::size_t member, Causes& causes) {
  const auto [was, is] = replaced_words(before, after);
  causes.add_replaced(was, is, member);
}

/// A text that is equal for equal changes of models.
std::string text_of(const std::vector<ItemChange>& items) {
  std::string text;
  for (const ItemChange& item : items) {
    text += fmt::format("{}\n{}\n{}\n{}\n", item.element, item.key, item.before ? "=" + *item.before : "",
                        item.after ? "=" + *item.after : "");
  }
  return text;
}

}  // namespace

std::pair<std::string_view, std::string_view> replaced_words(std::string_view before, std::string_view after) {
  const std::size_t shorter = std::min(before.size(), after.size());
  std::size_t begin = 0;
  while (begin < shorter && before[begin] == after[begin]) ++begin;
  std::size_t tail = 0;
  while (tail < shorter - begin && before[before.size() - 1 - tail] == after[after.size() - 1 - tail]) ++tail;
  while (!is_between_words(before, begin) || !is_between_words(after, begin)) --begin;
  while (tail > 0 &&
         (!is_between_words(before, before.size() - tail) || !is_between_words(after, after.size() - tail))) {
    --tail;
  }
  return {before.substr(begin, before.size() - tail - begin), after.substr(begin, after.size() - tail - begin)};
}

std::vector<Cause> symbol_causes(const model::PlantModel& before, const model::PlantModel& after,
                                 const std::vector<SymbolChange>& changes) {
  Causes causes;
  std::vector<std::pair<std::string_view, std::size_t>> added;
  std::vector<std::pair<std::string_view, std::size_t>> removed;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const SymbolChange& change = changes[i];
    if (change.added()) {
      added.emplace_back(change.after.in(after).name, i);
      continue;
    }
    const read::ListRow& old = change.before.in(before);
    if (change.removed()) {
      removed.emplace_back(old.name, i);
      continue;
    }
    const read::ListRow& now = change.after.in(after);
    if (change.fields.has(Field::name)) add_replacement(old.name, now.name, i, causes);
    if (change.fields.has(Field::address)) add_shift(before, after, change, i, causes);
    if (change.fields.has(Field::type)) causes.add(Kind::retyped, std::string(old.type), std::string(now.type), i);
  }
  add_names(Kind::added, added, row_names(before, !added.empty()), causes);
  add_names(Kind::removed, removed, row_names(after, !removed.empty()), causes);
  return causes.take();
}

std::vector<Cause> device_causes(const model::PlantModel& before, const model::PlantModel& after,
                                 const std::vector<DeviceChange>& changes) {
  Causes causes;
  std::vector<std::pair<std::string_view, std::size_t>> added;
  std::vector<std::pair<std::string_view, std::size_t>> removed;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const DeviceChange& change = changes[i];
    if (change.added()) {
      added.emplace_back(after.units[change.after].path, i);
    } else if (change.removed()) {
      removed.emplace_back(before.units[change.before].path, i);
    } else {
      if (change.renamed) {
        add_replacement(before.units[change.before].path, after.units[change.after].path, i, causes);
      }
      if (!change.items.empty()) causes.add(Kind::modelled, text_of(change.items), "", i);
    }
  }
  add_names(Kind::added, added, unit_names(before), causes);
  add_names(Kind::removed, removed, unit_names(after), causes);
  std::vector<Cause> found = causes.take();
  for (Cause& cause : found) {
    if (cause.kind == Kind::modelled) cause.before.clear();  // the items of its first member say it
  }
  return found;
}

}  // namespace symplant::diff
