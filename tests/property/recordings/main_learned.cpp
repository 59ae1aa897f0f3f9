// Random plants, recorded every 50 ms: learning must find their true times.
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "learn/learn.hpp"
#include "observe/play.hpp"
#include "property/options.hpp"
#include "property/recordings/observed_moves.hpp"
#include "property/recordings/recorded_run.hpp"
#include "property/recordings/recovered_times.hpp"
#include "property/recordings/timed_plant.hpp"
#include "property/recordings/unit_text.hpp"

namespace symplant::property {
namespace {

constexpr tables::Time kEvery = 50 * tables::kMillisecond;
constexpr tables::Time kLength = 3600 * tables::kSecond;
constexpr std::size_t kLeastMoves = 20;
constexpr std::size_t kMostShown = 60;

/// Moves that are not marked, though their times are not those of the plant.
void show_wrong_moves(std::uint64_t seed, const TimedPlant& plant, const RecordedRun& run,
                      const observe::Matched& matched) {
  std::vector<WrongMove> wrong;
  judge_moves(plant.real, observe::moves_of(plant.described, run.recording, matched), run.moves, 2 * kEvery, wrong);
  for (std::size_t i = 0; i < std::min<std::size_t>(wrong.size(), 3); ++i) {
    const observe::Move& move = wrong[i].move;
    const tables::Time begin = std::max(move.since, move.cause - tables::kSecond) - 3 * tables::kSecond;
    std::cout << "plant " << seed << ": " << wrong[i].text << "\n"
              << unit_text(plant.real, move.unit, run.recording, begin, std::max(move.arrived, move.left));
  }
}

RecoveredTimes learn_plant(const Options& options, std::uint64_t seed, std::vector<std::string>& misses) {
  const TimedPlant plant = timed_plant(seed, {});
  RecordedRun run = record_run(plant.real, {.seed = seed, .length = kLength, .every = kEvery});
  observe::Matched matched = observe::match(plant.described, run.recording);
  if (options.print) show_wrong_moves(seed, plant, run, matched);
  std::vector<learn::Input> inputs;
  inputs.push_back({std::move(run.recording), std::move(matched)});
  return recovered_times(plant.real, learn::learn_times(plant.described, inputs), kLeastMoves, misses);
}

void show(const char* kind, const Recovered& counts) {
  const std::pair<const char*, long> rows[] = {{"learned of at least 20 moves", counts.times},
                                               {"right", counts.right},
                                               {"right, with at least 80 % of the width", counts.wide},
                                               {"of the right kind", counts.of_kind},
                                               {"with a time that the device does not have", counts.outside}};
  for (const auto& [what, count] : rows) std::cout << kind << ": " << count << "  " << what << "\n";
}

int run(const Options& options) {
  RecoveredTimes all;
  std::size_t shown = 0;
  for (std::uint64_t seed = options.seed; seed < options.seed + options.plants; ++seed) {
    std::vector<std::string> misses;
    all += learn_plant(options, seed, misses);
    for (std::size_t i = 0; i < misses.size() && (options.print || shown < kMostShown); ++i, ++shown) {
      std::cout << "plant " << seed << ": " << misses[i] << "\n";
    }
  }
  if (!options.quiet) {
    show("constant times", all.constant);
    show("random times", all.random);
    std::cout << all.few << "  transitions with fewer moves\n";
  }
  // Of a hundred times at most two are not right (docs/recordings-measured.md has the reasons).
  const long times = all.constant.times + all.random.times;
  const long right = all.constant.right + all.random.right;
  const bool good =
      times >= options.minimum && (times - right) * 50 <= times && all.random.wide * 100 >= all.random.times * 90;
  return good != options.wrong ? 0 : 1;
}

}  // namespace
}  // namespace symplant::property

int main(int argc, char** argv) {
  const auto options = symplant::property::read_options({argv + 1, argv + argc});
  return options ? symplant::property::run(*options) : 2;
}
