// Words that differ by a slip of the hand, found without comparing each with each.
#include "check/spelling/near_words.hpp"

#include <algorithm>
#include <utility>

namespace symplant::check {
namespace {

constexpr std::size_t kFewestLetters = 2;

bool is_letter(char32_t c) { return !(c >= '0' && c <= '9') && c != '#'; }

constexpr std::size_t kLongestCode = 4;

std::size_t first_difference(std::u32string_view a, std::u32string_view b) {
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
}

/// The length of the run of letters at an index.
std::size_t run_at(std::u32string_view word, std::size_t index) {
  std::size_t begin = index;
  std::size_t end = index;
  while (begin > 0 && is_letter(word[begin - 1])) --begin;
  while (end < word.size() && is_letter(word[end])) ++end;
  return end - begin;
}

constexpr std::uint64_t kFactor = 0x0000'0100'0000'01B3;

std::uint64_t step(std::uint64_t hash, char32_t c) { return hash * kFactor + std::uint64_t{c} + 1; }

/// The hashes of a word and of it without each of its letters, in O(length): a polynomial, so that head and tail add
/// up.
std::vector<std::uint64_t> neighbourhood(std::u32string_view word) {
  std::vector<std::uint64_t> keys;
  keys.reserve(word.size() + 1);
  std::uint64_t whole = 0;
  for (const char32_t c : word) whole = step(whole, c);
  keys.push_back(whole);
  std::vector<std::uint64_t> tails(word.size() + 1, 0);  // of what follows an index, and the factor for its length
  std::uint64_t power = 1;
  std::vector<std::uint64_t> powers(word.size() + 1, 1);
  for (std::size_t i = word.size(); i-- > 0;) {
    tails[i] = (std::uint64_t{word[i]} + 1) * power + tails[i + 1];
    power *= kFactor;
    powers[i] = power;
  }
  std::uint64_t head = 0;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (is_letter(word[i])) keys.push_back(head * powers[i + 1] + tails[i + 1]);
    head = step(head, word[i]);
  }
  return keys;
}

}  // namespace

std::size_t letters_in(std::u32string_view word) {
  return static_cast<std::size_t>(std::count_if(word.begin(), word.end(), is_letter));
}

bool differ_by_slip(std::u32string_view a, std::u32string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.size() - a.size() > 1 || a == b || letters_in(a) < kFewestLetters || letters_in(b) < kFewestLetters)
    return false;
  const auto first = static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin()).first - a.begin());
  if (a.size() < b.size()) return is_letter(b[first]) && a.substr(first) == b.substr(first + 1);
  if (!is_letter(a[first]) || !is_letter(b[first])) return false;
  if (a.substr(first + 1) == b.substr(first + 1)) return true;
  return first + 1 < a.size() && is_letter(a[first + 1]) && a[first] == b[first + 1] && a[first + 1] == b[first] &&
         a.substr(first + 2) == b.substr(first + 2);
}

bool differ_by_ending(std::u32string_view a, std::u32string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (!b.starts_with(a)) return false;
  const std::u32string_view ending = b.substr(a.size());
  constexpr std::array<std::u32string_view, 5> kEndings{U"D", U"ED", U"S", U"ING", U"N"};
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

bool differ_by_another_letter(std::u32string_view a, std::u32string_view b) {
  if (a.size() != b.size() || a == b) return false;
  const std::size_t first = first_difference(a, b);
  return is_letter(a[first]) && is_letter(b[first]) && a.substr(first + 1) == b.substr(first + 1);
}

bool differ_by_class_letter(std::u32string_view a, std::u32string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (a.size() == b.size() && !differ_by_another_letter(a, b)) return false;
  return run_at(b, first_difference(a, b)) <= kLongestCode;
}

bool differ_by_axis(std::u32string_view a, std::u32string_view b) {
  if (!differ_by_another_letter(a, b)) return false;
  const std::size_t first = first_difference(a, b);
  const auto both_in = [&](std::u32string_view letters) {
    return letters.find(a[first]) != letters.npos && letters.find(b[first]) != letters.npos;
  };
  if (both_in(U"XYZ")) return true;
  const bool at_end = first + 1 == a.size() || !is_letter(a[first + 1]);
  return at_end && (both_in(U"ABCD") || both_in(U"LR"));
}

NearWords::NearWords(const std::vector<Word>& words) : words_(words) {
  for (std::uint32_t location = 0; location < words.size(); ++location) {
    if (words[location].text.size() > kLongest) continue;
    for (const std::uint64_t key : neighbourhood(words[location].text)) put(key, location);
  }
}

bool NearWords::commoner(std::uint32_t a, std::uint32_t b) const {
  return words_[a].count != words_[b].count ? words_[a].count > words_[b].count : a < b;
}

void NearWords::put(std::uint64_t key, std::uint32_t location) {
  for (std::uint32_t& best : files_[key].best) {
    if (best == location) return;
    if (best == kUndriven || commoner(location, best)) std::swap(best, location);
    if (location == kUndriven) return;
  }
}

std::vector<std::uint32_t> NearWords::commoner_near(std::uint32_t location) const {
  std::vector<std::uint32_t> near;
  const std::u32string_view word = words_[location].text;
  if (word.size() > kLongest) return near;
  for (const std::uint64_t key : neighbourhood(word)) {
    const auto file = files_.find(key);
    if (file == files_.end()) continue;
    for (const std::uint32_t other : file->second.best) {
      if (other == kUndriven || !commoner(other, location) || !differ_by_slip(word, words_[other].text)) continue;
      if (std::find(near.begin(), near.end(), other) == near.end()) near.push_back(other);
    }
  }
  std::sort(near.begin(), near.end(), [&](std::uint32_t a, std::uint32_t b) { return commoner(a, b); });
  return near;
}

}  // namespace symplant::check
