// What a target cannot hold, counted by kind, and the names that were changed.
#include "convert/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diag/visible_text.hpp"

namespace symplant::convert {
namespace {

constexpr std::size_t kExamples = 3;
constexpr std::size_t kLongestExample = 60;  ///< bytes

std::string example(std::string_view name) {
  if (name.size() > kLongestExample) return diag::visible(name.substr(0, kLongestExample)) + "...";
  return diag::visible(name);
}

}  // namespace

Report::Count& Report::count_of(const Loss& loss) {
  const auto known =
      std::find_if(counts_.begin(), counts_.end(), [&](const Count& count) { return count.loss == &loss; });
  Count& count = known != counts_.end() ? *known : counts_.emplace_back(Count{&loss});
  ++count.count;
  return count;
}

void Report::add(const Loss& loss, std::string_view name) {
  Count& count = count_of(loss);
  if (count.count <= kExamples) count.examples.push_back("`" + example(name) + "`");
}

void Report::rename(std::string_view from, std::string_view to, const Loss& why) {
  Count& count = count_of(why);
  if (count.count <= kExamples) count.examples.push_back("`" + example(from) + "` is `" + example(to) + "`");
  renames_.emplace_back(from, to);
}

std::vector<std::string> Report::lines() const {
  std::vector<std::string> lines;
  for (const Count& count : counts_) {
    std::string line = fmt::format("{} {}: {}: {}", count.count, count.count == 1 ? count.loss->one : count.loss->many,
                                   count.loss->why, fmt::join(count.examples, ", "));
    if (count.count > kExamples) line += fmt::format(" and {} more", count.count - kExamples);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace symplant::convert
