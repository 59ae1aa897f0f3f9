// Pairs for a terminal.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "diag/visible_text.hpp"
#include "learn/pairs_formats.hpp"
#include "symplant/trace/words.hpp"

namespace symplant::learn {
namespace {

std::string delays(const Follows& follows) {
  std::string text =
      fmt::format("{} of {} changes, after {}", follows.hits, follows.changes, trace::seconds(follows.median));
  if (follows.spread() != 0) {
    text += fmt::format(" ({} to {})", trace::seconds(follows.least), trace::seconds(follows.most));
  }
  return text;
}

std::string name_list(const std::vector<std::uint32_t>& symbols, const model::PlantModel& plant) {
  std::string text;
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < symbols.size() ? ", " : " and ");
    text += plant.symbols[symbols[i]].name();
  }
  return text;
}

std::string pair_text(const Pair& pair, const model::PlantModel& plant) {
  return fmt::format("{} -> {}{}{}: {}", plant.symbols[pair.operation].name(), pair.inverted ? "not " : "",
                     plant.symbols[pair.event].name(),
                     pair.named ? " (names pair the operation with another event)" : "", evidence(pair));
}

std::string interlock_text(const Interlock& interlock, const model::PlantModel& plant) {
  const bool together = interlock.kind == Interlock::Kind::together;
  return fmt::format("{} follows {}{}, {}", plant.symbols[interlock.event].name(), together ? "one of " : "",
                     name_list(interlock.operations, plant),
                     together ? "which change together" : "each at some of its changes");
}

}  // namespace

std::string evidence(const Pair& pair) {
  std::string text = delays(pair.on);
  text += pair.follows_off() ? "; off: " + delays(pair.off) : "; off: does not follow";
  return text + fmt::format("; by chance at most {} of {}", pair.chance.most, pair.chance.changes);
}

std::string pairs_text(const Pairs& pairs, const model::PlantModel& plant) {
  std::string text =
      fmt::format("{} of recordings, resolution {}: {} operations and {} events that names do not pair\n",
                  trace::seconds(pairs.length), trace::seconds(pairs.resolution), pairs.operations, pairs.events);
  const auto add = [&](const std::string& line) { text += diag::visible(line) + "\n"; };
  if (pairs.pairs.empty()) add("no pairs");
  if (!pairs.pairs.empty()) add("pairs (--refuse N,.. leaves some out):");
  for (std::size_t i = 0; i < pairs.pairs.size(); ++i) {
    add(fmt::format("{:4}  {}", i + 1, pair_text(pairs.pairs[i], plant)));
  }
  if (!pairs.fan_outs.empty()) add("operations that drive several events:");
  for (const FanOut& fan_out : pairs.fan_outs) {
    add(fmt::format("      {} -> {}", plant.symbols[fan_out.operation].name(), name_list(fan_out.events, plant)));
  }
  if (!pairs.interlocks.empty()) add("events for which the recordings do not show one operation:");
  for (const Interlock& interlock : pairs.interlocks) add("      " + interlock_text(interlock, plant));
  return text;
}

}  // namespace symplant::learn
