// Finds the common causes of many changes.
#include "diff/causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <tuple>

#include "diff/fields.hpp"
#include "text/ascii.hpp"

namespace symplant::diff {
namespace {

using Kind = Cause::Kind;

/// Collects changes by their cause.
class Causes {
 public:
  void add(Kind kind, std::string before, std::string after, std::size_t member) {
    members_[{kind, std::move(before), std::move(after)}].push_back(static_cast<std::uint32_t>(member));
  }

  std::vector<Cause> take() {
    std::vector<Cause> causes;
    for (auto& [key, members] : members_) {
      if (members.size() < kLeastMembers) continue;
      const auto& [kind, before, after] = key;
      causes.push_back({kind, before, after, std::move(members)});
    }
    std::stable_sort(causes.begin(), causes.end(), [](const Cause& a, const Cause& b) {
      return std::pair(a.kind, a.members.front()) < std::pair(b.kind, b.members.front());
    });
    return causes;
  }

 private:
  std::map<std::tuple<Kind, std::string, std::string>, std::vector<std::uint32_t>> members_;
};

bool is_word_character(char c) {
  return static_cast<unsigned char>(c) >= 0x80 || text::is_digit(c) || (text::upper(c) >= 'A' && text::upper(c) <= 'Z');
}

/// Whether no word goes on across a position.
bool is_between_words(std::string_view text, std::size_t at) {
  return at == 0 || at >= text.size() || !is_word_character(text[at]) || !is_word_character(text[at - 1]);
}

/// The first word of a name with a word after it; empty if the name has one word.
std::string_view first_word(std::string_view name) {
  std::size_t end = 0;
  while (end < name.size() && is_word_character(name[end])) ++end;
  return end == name.size() ? std::string_view() : name.substr(0, end);
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

void add_name(Kind kind, std::string_view name, std::size_t member, Causes& causes) {
  const std::string_view word = first_word(name);
  if (word.empty()) return;
  causes.add(kind, kind == Kind::removed ? std::string(word) : "", kind == Kind::added ? std::string(word) : "",
             member);
}

void add_replacement(std::string_view before, std::string_view after, std::size_t member, Causes& causes) {
  const auto [was, is] = replaced_words(before, after);
  causes.add(Kind::replaced, std::string(was), std::string(is), member);
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
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const SymbolChange& change = changes[i];
    if (change.added()) {
      add_name(Kind::added, change.after.in(after).name, i, causes);
      continue;
    }
    const read::ListRow& old = change.before.in(before);
    if (change.removed()) {
      add_name(Kind::removed, old.name, i, causes);
      continue;
    }
    const read::ListRow& now = change.after.in(after);
    if (change.fields.has(Field::name)) add_replacement(old.name, now.name, i, causes);
    if (change.fields.has(Field::address)) add_shift(before, after, change, i, causes);
    if (change.fields.has(Field::type)) causes.add(Kind::retyped, std::string(old.type), std::string(now.type), i);
  }
  return causes.take();
}

std::vector<Cause> device_causes(const model::PlantModel& before, const model::PlantModel& after,
                                 const std::vector<DeviceChange>& changes) {
  Causes causes;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const DeviceChange& change = changes[i];
    if (change.added()) {
      add_name(Kind::added, after.units[change.after].path, i, causes);
    } else if (change.removed()) {
      add_name(Kind::removed, before.units[change.before].path, i, causes);
    } else {
      if (change.renamed) {
        add_replacement(before.units[change.before].path, after.units[change.after].path, i, causes);
      }
      if (!change.items.empty()) causes.add(Kind::modelled, text_of(change.items), "", i);
    }
  }
  std::vector<Cause> found = causes.take();
  for (Cause& cause : found) {
    if (cause.kind == Kind::modelled) cause.before.clear();  // the items of its first member say it
  }
  return found;
}

}  // namespace symplant::diff
