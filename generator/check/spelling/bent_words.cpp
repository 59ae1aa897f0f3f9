// English endings, and words cut short.
#include "check/spelling/bent_words.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "model/sequence.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

constexpr std::size_t kShortestBegin = 3;  ///< of a word that another may begin with

bool is_ending(std::string_view stem, std::string_view rest) {
  constexpr std::array<std::string_view, 8> kEndings{"", "E", "D", "N", "S", "ED", "EN", "ING"};
  if (rest.size() > 1 && !stem.empty() && text::upper(rest.front()) == text::upper(stem.back())) {
    rest.remove_prefix(1);  // GRIPPED, RUNNING
    if (rest.size() < 2) return false;
  }
  return std::any_of(kEndings.begin(), kEndings.end(),
                     [&](std::string_view ending) { return text::equal_ignoring_case(ending, rest); });
}

std::string_view without_number(std::string_view task) {
  while (!task.empty() && task.back() >= '0' && task.back() <= '9') task.remove_suffix(1);
  return task;
}

}  // namespace

bool bent_alike(std::string_view a, std::string_view b) {
  if (model::sequence_number(a) != model::sequence_number(b)) return false;
  a = without_number(a);
  b = without_number(b);
  if (a.size() > b.size()) std::swap(a, b);
  std::size_t same = 0;
  while (same < a.size() && text::upper(a[same]) == text::upper(b[same])) ++same;
  if (same == a.size() && same == b.size()) return false;
  if (same == a.size() && same >= kShortestBegin) return true;
  return same >= 2 && is_ending(a.substr(0, same), a.substr(same)) && is_ending(b.substr(0, same), b.substr(same));
}

}  // namespace symplant::check
