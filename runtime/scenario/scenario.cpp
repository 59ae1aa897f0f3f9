// Turns and locations of a scenario's steps, in words.
#include "symplant/scenario/scenario.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace symplant::scenario {
namespace {

constexpr std::uint64_t kMost = std::uint64_t{1} << 63;

bool covers(const Repeat& repeat, std::size_t step) { return repeat.begin <= step && step < repeat.end; }

std::uint64_t times(std::uint64_t a, std::uint64_t b) { return a > kMost / b ? kMost : a * b; }

}  // namespace

std::uint64_t executions(const Scenario& scenario, std::size_t step) {
  std::uint64_t count = 1;
  for (const Repeat& repeat : scenario.repeats) {
    if (covers(repeat, step)) count = times(count, repeat.turns);
  }
  return count;
}

std::string turn_words(const Scenario& scenario, std::size_t step, std::uint64_t number) {
  std::string words;  // repeats around one step are sorted by their ends: the inner ones come first
  for (const Repeat& repeat : scenario.repeats) {
    if (!covers(repeat, step)) continue;
    const std::string inner = words.empty() ? words : ", " + words;
    words = fmt::format("turn {} of {}{}", number % repeat.turns + 1, repeat.turns, inner);
    number /= repeat.turns;
  }
  return words;
}

std::string line_words(const Scenario& scenario, const Step& step) {
  if (step.file == 0) return fmt::format("line {}", step.line);
  return fmt::format("line {} of {}", step.line, scenario.files[step.file]);
}

}  // namespace symplant::scenario
