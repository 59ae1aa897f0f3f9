// Slips, endings, and the deletion neighborhood.
#include "check/words.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "model/sequence.hpp"
#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::check {
namespace {

constexpr std::uint32_t kNothing = 0xFFFF'FFFF;

bool is_letter(char32_t c) { return !(c >= '0' && c <= '9') && c != '#' && c != '_'; }

std::size_t first_difference(std::u32string_view a, std::u32string_view b) {
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
}

/// The hashes of a word and of it without each of its letters.
std::vector<std::size_t> neighborhood(const std::u32string& word) {
  const std::hash<std::u32string> hash;
  std::vector<std::size_t> keys;
  if (word.size() > 128) return keys;
  keys.push_back(hash(word));
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (is_letter(word[i])) keys.push_back(hash(word.substr(0, i) + word.substr(i + 1)));
  }
  return keys;
}

}  // namespace

bool bent_alike(std::string_view a, std::string_view b) {
  const auto stem = [](std::string_view task) {
    std::string word = text::to_upper(task.substr(0, task.find_last_not_of("0123456789") + 1));
    if (word.ends_with('E')) word.pop_back();  // CLOSE, CLOSING
    return word;
  };
  const std::string first = stem(a);
  const std::string second = stem(b);
  if (model::sequence_number(a) != model::sequence_number(b) || text::equal_ignoring_case(a, b)) return false;
  return std::min(first.size(), second.size()) >= 3 && (first.starts_with(second) || second.starts_with(first));
}

std::u32string capitals(std::string_view text) {
  std::u32string points;
  for (std::size_t at = 0; at < text.size(); at += text::code_point_at(text, at).length) {
    const char32_t point = text::code_point_at(text, at).value;
    points += point < 0x80 ? static_cast<char32_t>(text::upper(static_cast<char>(point))) : point;
  }
  return points;
}

bool differ_by_slip(std::u32string_view a, std::u32string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.size() - a.size() > 1 || a == b || std::ranges::count_if(a, is_letter) < 2) return false;
  const std::size_t first = first_difference(a, b);
  if (a.size() < b.size()) return is_letter(b[first]) && a.substr(first) == b.substr(first + 1);
  if (differ_by_another_letter(a, b)) return true;
  return first + 1 < a.size() && is_letter(a[first]) && is_letter(a[first + 1]) && a[first] == b[first + 1] &&
         a[first + 1] == b[first] && a.substr(first + 2) == b.substr(first + 2);
}

bool differ_by_another_letter(std::u32string_view a, std::u32string_view b) {
  if (a.size() != b.size() || a == b) return false;
  const std::size_t first = first_difference(a, b);
  return is_letter(a[first]) && is_letter(b[first]) && a.substr(first + 1) == b.substr(first + 1);
}

bool differ_by_ending(std::u32string_view a, std::u32string_view b) {
  constexpr std::array<std::u32string_view, 5> kEndings{U"D", U"ED", U"S", U"ING", U"N"};
  if (a.size() > b.size()) std::swap(a, b);
  return b.starts_with(a) && std::ranges::find(kEndings, b.substr(a.size())) != kEndings.end();
}

bool may_be_codes(std::u32string_view a, std::u32string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  const bool another = differ_by_another_letter(a, b);
  if (a.size() == b.size() && !another) return false;
  const std::size_t at = first_difference(a, b);
  const auto letter = b.begin() + static_cast<std::ptrdiff_t>(at);
  const auto end = std::find_if_not(letter, b.end(), is_letter);
  if (end - std::find_if_not(std::make_reverse_iterator(letter), b.rend(), is_letter).base() <= 4) return true;
  const auto both_in = [&](std::u32string_view letters) {
    return letters.find(a[at]) != letters.npos && letters.find(b[at]) != letters.npos;
  };
  return another && (both_in(U"XYZ") || (letter + 1 == end && (both_in(U"ABCD") || both_in(U"LR"))));
}

NearWords::NearWords(const std::vector<CountedWord>& words) : words_(words) {
  for (std::uint32_t i = 0; i < words.size(); ++i) order_.push_back(i);
  std::ranges::stable_sort(order_, [&](auto a, auto b) { return words[a].count > words[b].count; });
  for (std::uint32_t place = 0; place < words.size(); ++place) {
    for (const std::size_t key : neighborhood(words[order_[place]].text)) {
      auto& best = files_.try_emplace(key, std::array{kNothing, kNothing, kNothing}).first->second;
      for (std::uint32_t& kept : best) {
        kept = std::min(kept, place);
        if (kept == place) break;
      }
    }
  }
}

std::vector<std::uint32_t> NearWords::near(const std::u32string& text) const {
  std::set<std::uint32_t> places;
  for (const std::size_t key : neighborhood(text)) {
    const auto file = files_.find(key);
    if (file == files_.end()) continue;
    for (const std::uint32_t place : file->second) {
      if (place != kNothing && differ_by_slip(text, words_[order_[place]].text)) places.insert(place);
    }
  }
  std::vector<std::uint32_t> near(places.begin(), places.end());
  for (std::uint32_t& place : near) place = order_[place];
  return near;
}

}  // namespace symplant::check
