// SP322 comment-twice: two points have one comment.
#include <fmt/format.h>

#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "check/rules.hpp"
#include "text/utf8.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kCommentTwicePage =
    R"(Two inputs, or two outputs, of a list that names its points by comments have the same comment, and nearly all other comments of the
list are unique. Most often a row was copied and its comment not changed.

**What the model loses.** A naming rule that reads comments cannot distinguish the two: both are the same symbol of a device.

**How to fix it.** Correct the comment that is wrong. If two points mean one thing, number them: `LIMIT 1`, `LIMIT 2`.
)";

constexpr std::size_t kLeastUnique = 20;
constexpr std::size_t kMostShare = 20;  ///< of 20 comments at most one may be used twice
constexpr std::size_t kShortestComment = 8;

using Points = std::vector<const model::Symbol*>;

void check_comment_twice(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  std::vector<std::map<std::pair<std::string_view, tables::Direction>, Points>> lists(plant.lists.size());
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
    for (const auto& [comment, points] : comments) {
      if (points.size() != 2) continue;  // more are spares, or mean one thing
      const model::Symbol& first = *points.front();
      const model::Symbol& second = *points.back();
      diagnostics.add(rule.info, about(second, first),
                      fmt::format("`{}` and `{}` have the same comment `{}`; correct the one that is wrong",
                                  second.name(), first.name(), comment.first),
                      location_of(plant, *second.row, second.row->comment),
                      {{location_of(plant, *first.row, first.row->comment), "the same comment"}});
    }
  }
}

}  // namespace

const Rule kCommentTwice{
    {"SP322", "comment-twice", diag::Severity::warning, "two points have one comment", kCommentTwicePage},
    check_comment_twice};

}  // namespace symplant::check
