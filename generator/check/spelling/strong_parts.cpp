// Tarjan's algorithm, with an explicit stack instead of recursion.
#include "check/spelling/strong_parts.hpp"

#include <algorithm>
#include <utility>

namespace symplant::check {
namespace {

constexpr std::uint32_t kUnseen = 0xFFFF'FFFF;

class PartSearch {
 public:
  explicit PartSearch(const std::vector<std::vector<std::uint32_t>>& edges)
      : edges_(edges), number_(edges.size(), kUnseen), lowest_(edges.size()), stacked_(edges.size()) {}

  void from(std::uint32_t start) {
    if (number_[start] != kUnseen) return;
    enter(start);
    while (!calls_.empty()) {
      auto& [at, next] = calls_.back();
      if (next == edges_[at].size()) {
        leave(at);
        continue;
      }
      const std::uint32_t to = edges_[at][next++];
      if (number_[to] == kUnseen) {
        enter(to);
      } else if (stacked_[to]) {
        lowest_[at] = std::min(lowest_[at], number_[to]);
      }
    }
  }

  std::vector<std::vector<std::uint32_t>> take() { return std::move(parts_); }

 private:
  void enter(std::uint32_t location) {
    number_[location] = count_;
    lowest_[location] = count_;
    ++count_;
    stack_.push_back(location);
    stacked_[location] = true;
    calls_.emplace_back(location, 0);
  }

  void leave(std::uint32_t location) {
    calls_.pop_back();
    if (!calls_.empty()) {
      const std::uint32_t caller = calls_.back().first;
      lowest_[caller] = std::min(lowest_[caller], lowest_[location]);
    }
    if (lowest_[location] != number_[location]) return;
    std::vector<std::uint32_t> part;
    std::uint32_t member = kUnseen;
    do {
      member = stack_.back();
      stack_.pop_back();
      stacked_[member] = false;
      part.push_back(member);
    } while (member != location);
    std::sort(part.begin(), part.end());
    parts_.push_back(std::move(part));
  }

  const std::vector<std::vector<std::uint32_t>>& edges_;
  std::vector<std::uint32_t> number_;
  std::vector<std::uint32_t> lowest_;
  std::vector<bool> stacked_;
  std::vector<std::uint32_t> stack_;
  std::vector<std::pair<std::uint32_t, std::size_t>> calls_;  // a node, and which of its edges is next
  std::uint32_t count_ = 0;
  std::vector<std::vector<std::uint32_t>> parts_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> strong_parts(const std::vector<std::vector<std::uint32_t>>& edges) {
  PartSearch search(edges);
  for (std::uint32_t i = 0; i < edges.size(); ++i) search.from(i);
  std::vector<std::vector<std::uint32_t>> parts = search.take();
  std::sort(parts.begin(), parts.end());
  return parts;
}

}  // namespace symplant::check
