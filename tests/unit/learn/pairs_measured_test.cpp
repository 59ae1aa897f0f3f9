// Measures how many pairs of random plants are found, and how many of those found are right.
#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <iostream>
#include <string>
#include <vector>

#include "learn/pairs.hpp"
#include "support/catch.hpp"
#include "unit/learn/pairs_plant.hpp"
#include "unit/learn/pairs_support.hpp"

namespace symplant::test {
namespace {

struct Measured {
  std::size_t right = 0;
  std::size_t wrong = 0;
  std::size_t all = 0;
  std::size_t together = 0;  ///< pairs that were not proposed, as their operation changes together with others

  double precision() const { return static_cast<double>(right) / static_cast<double>(right + wrong); }
  double recall() const { return static_cast<double>(right) / static_cast<double>(all); }
};

void measure(PairsPlant made, Measured& measured) {
  const Analysed analysed = unnamed_plant(made.operations, made.events);
  const model::PlantModel& plant = analysed.model();
  std::vector<learn::Input> inputs;
  inputs.push_back(input_of(plant, std::move(made.recording)));
  const learn::Pairs pairs = learn::learn_pairs(plant, inputs, 0);
  const auto name = [&](std::uint32_t symbol) { return std::string(plant.symbols[symbol].name()); };
  measured.all += made.pairs.size();
  for (const learn::Pair& pair : pairs.pairs) {
    const bool right = made.pairs.erase({name(pair.operation), name(pair.event), pair.inverted}) != 0;
    ++(right ? measured.right : measured.wrong);
  }
  for (const learn::Interlock& interlock : pairs.interlocks) {
    for (const std::uint32_t operation : interlock.operations) {
      for (const bool inverted : {false, true}) {
        measured.together += made.pairs.erase({name(operation), name(interlock.event), inverted});
      }
    }
  }
}

Measured measure(const PlantProfile& profile, std::uint64_t seeds) {
  Measured measured;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) measure(random_pairs_plant(seed, profile), measured);
  return measured;
}

TEST_CASE("Of random plants with 20 cycles, 98 of 100 proposed pairs are right and 80 of 100 are found") {
  PlantProfile profile;
  for (const bool fixed : {true, false}) {
    profile.fixed_sequence = fixed;
    const Measured measured = measure(profile, 50);
    INFO((fixed ? "fixed sequence" : "sequence by chance"));
    CHECK(measured.precision() >= 0.98);
    CHECK(measured.recall() >= 0.80);
  }
}

/// Prints the table of docs/learn-pairs.md.
TEST_CASE("The table of pairs of random plants", "[.table]") {
  struct Line {
    const char* what;
    PlantProfile profile;
  };
  const auto with = [](const char* what, auto change) {
    Line line{what, {}};
    change(line.profile);
    return line;
  };
  const std::vector<Line> lines = {
      with("each cycle in the same order", [](PlantProfile&) {}),
      with("each cycle in another order", [](PlantProfile& p) { p.fixed_sequence = false; }),
      with("same order, one sequence", [](PlantProfile& p) { p.most_stations = 1; }),
      with("same order, 60 % of steps begin two moves", [](PlantProfile& p) { p.forks = 0.6; }),
      with("same order, every step is one move",
           [](PlantProfile& p) {
             p.forks = 0;
             p.always_together = 0;
           }),
      with("same order, times +-5 %", [](PlantProfile& p) { p.jitter = 0.05; }),
      with("same order, times +-2 %", [](PlantProfile& p) { p.jitter = 0.02; }),
      with("same order, 10 cycles", [](PlantProfile& p) { p.cycles = 10; }),
      with("same order, 6 cycles", [](PlantProfile& p) { p.cycles = 6; }),
      with("same order, 100 cycles", [](PlantProfile& p) { p.cycles = 100; }),
      with("same order, a reading each 10 ms", [](PlantProfile& p) { p.resolution = 0.01; }),
      with("same order, a reading each 200 ms", [](PlantProfile& p) { p.resolution = 0.2; }),
  };
  for (const Line& line : lines) {
    const Measured measured = measure(line.profile, 200);
    std::cout << fmt::format("| {} | {:.3f} | {:.3f} | {:.3f} |\n", line.what, measured.precision(), measured.recall(),
                             static_cast<double>(measured.together) / static_cast<double>(measured.all));
  }
}

/// Prints how long large plants take.
TEST_CASE("The time that pairs take", "[.speed]") {
  struct Large {
    std::size_t devices;
    std::size_t stations;
    std::size_t cycles;
  };
  constexpr std::array<Large, 4> kLarge = {{{1150, 80, 20}, {1150, 80, 58}, {1150, 30, 30}, {1150, 8, 10}}};
  for (const Large& large : kLarge) {
    PlantProfile profile;
    profile.least_devices = profile.most_devices = large.devices;
    profile.most_stations = large.stations;
    profile.cycles = large.cycles;
    PairsPlant made = random_pairs_plant(3, profile);
    const Analysed analysed = unnamed_plant(made.operations, made.events);
    const std::size_t symbols = made.operations.size() + made.events.size();
    const std::size_t changes = made.recording.order.size();
    const double hours = static_cast<double>(made.recording.end) / 3.6e12;
    std::vector<learn::Input> inputs;
    inputs.push_back(input_of(analysed.model(), std::move(made.recording)));
    const std::clock_t begin = std::clock();
    const learn::Pairs pairs = learn::learn_pairs(analysed.model(), inputs, 0);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    std::cout << fmt::format("{} symbols, {} changes in {:.2f} h: {:.2f} s, {} of {} pairs\n", symbols, changes, hours,
                             seconds, pairs.pairs.size(), made.pairs.size());
  }
}

}  // namespace
}  // namespace symplant::test
