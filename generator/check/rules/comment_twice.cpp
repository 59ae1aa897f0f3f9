// SP322 comment-twice: two points have one comment.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "check/rules.hpp"
#include "text/utf8.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kCommentTwicePage =
    R"(Two inputs, or two outputs, of a list that names its points by comments have the same comment, and nearly all other comments of the
list are unique. Most often a row was copied and its comment not changed. There is one finding for each list.

**What the model loses.** A naming rule that reads comments cannot distinguish the two: both are the same symbol of a device.

**How to fix it.** Correct the comment that is wrong. If two points mean one thing, number them: `LIMIT 1`, `LIMIT 2`.
)";

constexpr std::size_t kLeastUnique = 20;
constexpr std::size_t kMostShare = 20;  ///< of 20 comments at most one may be used twice
constexpr std::size_t kShortestComment = 8;

using Points = std::vector<const model::Symbol*>;
using ByComment = std::map<std::pair<std::string_view, tables::Direction>, Points>;

void report(const Rule& rule, const model::PlantModel& plant, const ByComment& comments,
            diag::Diagnostics& diagnostics) {
  std::vector<const Points*> pairs;
  for (const auto& [comment, points] : comments) {
    if (points.size() == 2) pairs.push_back(&points);  // more are spares, or mean one thing
  }
  if (pairs.empty()) return;
  std::sort(pairs.begin(), pairs.end(),
            [](const Points* a, const Points* b) { return a->front()->row < b->front()->row; });
  const model::Symbol& first = *pairs.front()->front();
  const model::Symbol& second = *pairs.front()->back();
  std::vector<diag::Related> related;
  for (const Points* points : pairs) {
    for (const model::Symbol* symbol : *points) {
      if (symbol == &second) continue;
      related.push_back({location_of(plant, *symbol->row, symbol->row->comment),
                         fmt::format("`{}`: `{}`", symbol->name(), symbol->row->comment)});
    }
  }
  const std::string more = pairs.size() == 1 ? "" : fmt::format("; so do {} more pairs of points", pairs.size() - 1);
  diagnostics.add(rule.info, about(second, first),
                  fmt::format("`{}` and `{}` have the same comment `{}`{}; number or correct them", second.name(),
                              first.name(), second.row->comment, more),
                  location_of(plant, *second.row, second.row->comment), std::move(related));
}

void check_comment_twice(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  std::vector<ByComment> lists(plant.lists.size());
  for (const model::Symbol& symbol : plant.symbols) {
    const std::string_view comment = symbol.row->comment;
    if (!symbol.row->is_named_by_address() || comment.size() < kShortestComment || symbol.leader != model::kNone)
      continue;
    lists[symbol.list][{comment, symbol.direction}].push_back(&symbol);
  }
  for (const auto& comments : lists) {
    std::size_t unique = 0;
    for (const auto& [comment, points] : comments) unique += points.size() == 1 ? 1U : 0U;
    if (unique < kLeastUnique || (comments.size() - unique) * kMostShare > comments.size()) continue;
    report(rule, plant, comments, diagnostics);
  }
}

}  // namespace

const Rule kCommentTwice{
    {"SP322", "comment-twice", diag::Severity::warning, "two points have one comment", kCommentTwicePage},
    check_comment_twice};

}  // namespace symplant::check
