// SP212 text-cut: comments end at the length limit of a field.
#include <fmt/format.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "check/rules.hpp"
#include "text/shape.hpp"
#include "text/utf8.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kTextCutPage =
    R"(Many comments of a list have exactly the same greatest length, more than have any length just below: the engineering tool, or an
export, cut them there. GX Works keeps 32 characters of a device comment.

**What the model loses.** A naming rule that reads comments lacks the end of these texts, which often says what a signal means:
`forward end` and `forward start` may be cut to one text.

**How to fix it.** Shorten the comments in the engineering tool so that the important word is within the limit, or export them
with a longer field.
)";

constexpr std::size_t kShortestLimit = 16;
constexpr std::size_t kLeastCut = 5;
constexpr std::size_t kNeighbors = 4;  ///< lengths below the greatest to compare with

/// Comments of one list by length, in characters.
struct Lengths {
  std::map<std::size_t, std::set<std::string>> shapes;  ///< comments that differ in numbers only say nothing
  std::vector<const model::Symbol*> longest;
};

bool are_cut(const Lengths& lengths) {
  if (lengths.shapes.empty()) return false;
  const std::size_t length = lengths.shapes.rbegin()->first;
  const std::size_t count = lengths.shapes.rbegin()->second.size();
  if (length < kShortestLimit || count < kLeastCut) return false;
  std::size_t below = 0;
  for (std::size_t i = 1; i <= kNeighbors; ++i) {
    const auto found = lengths.shapes.find(length - i);
    below += found == lengths.shapes.end() ? 0 : found->second.size();
  }
  return count * kNeighbors > 2 * below;  // twice as many as the mean of those below
}

void check_text_cut(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  std::vector<Lengths> lists(plant.lists.size());
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.row->comment.empty()) continue;
    Lengths& lengths = lists[symbol.list];
    const std::size_t length = text::count_code_points(symbol.row->comment);
    if (lengths.shapes.empty() || length > lengths.shapes.rbegin()->first) lengths.longest.clear();
    lengths.shapes[length].insert(text::shape_of(symbol.row->comment));
    if (length == lengths.shapes.rbegin()->first) lengths.longest.push_back(&symbol);
  }
  for (const Lengths& lengths : lists) {
    if (!are_cut(lengths)) continue;
    const model::Symbol& first = *lengths.longest.front();
    diagnostics.add(rule.info, diag::Subjects{{symbol_named(first.name())}, {}, {}},
                    fmt::format("{} comments have exactly {} characters and none has more: they are probably cut, such "
                                "as `{}`; shorten them in the engineering tool",
                                lengths.longest.size(), lengths.shapes.rbegin()->first, first.row->comment),
                    location_of(plant, *first.row, first.row->comment));
  }
}

}  // namespace

const Rule kTextCut{
    {"SP212", "text-cut", diag::Severity::warning, "comments end at the length limit of a field", kTextCutPage},
    check_text_cut};

}  // namespace symplant::check
