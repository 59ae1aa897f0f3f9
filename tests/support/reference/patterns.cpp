// Matches character by character.
#include "support/reference/patterns.hpp"

#include <algorithm>
#include <cctype>

namespace symplant::reference {
namespace {

char lower_letter(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

bool fits_from(const std::string& text, std::size_t t, const std::string& pattern, std::size_t p,
               std::vector<std::string>& shares) {
  if (p == pattern.size()) return t == text.size();
  if (pattern[p] == '*') {
    for (std::size_t end = t; end <= text.size(); ++end) {
      shares.push_back(text.substr(t, end - t));
      if (fits_from(text, end, pattern, p + 1, shares)) return true;
      shares.pop_back();
    }
    return false;
  }
  if (t == text.size()) return false;
  const bool same = pattern[p] == '?' || lower_letter(pattern[p]) == lower_letter(text[t]);
  if (!same) return false;
  if (pattern[p] == '?') shares.push_back(text.substr(t, 1));
  if (fits_from(text, t + 1, pattern, p + 1, shares)) return true;
  if (pattern[p] == '?') shares.pop_back();
  return false;
}

}  // namespace

bool is_pattern(const std::string& name) { return name.find_first_of("*?") != name.npos; }

bool fits(const std::string& text, const std::string& pattern) {
  std::vector<std::string> shares;
  return fits_from(text, 0, pattern, 0, shares);
}

std::vector<std::string> shares(const std::string& text, const std::string& pattern) {
  std::vector<std::string> found;
  fits_from(text, 0, pattern, 0, found);
  return found;
}

std::size_t literals(const std::string& pattern) {
  return static_cast<std::size_t>(
      std::count_if(pattern.begin(), pattern.end(), [](char c) { return c != '*' && c != '?'; }));
}

}  // namespace symplant::reference
