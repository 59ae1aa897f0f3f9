// The arithmetic of accuracy, in cases worked out by hand.
#include <cmath>
#include <string>
#include <vector>

#include "study/study.hpp"
#include "study_support.hpp"

namespace symplant::test {
namespace {

using recording::Series;
using study::Curve;
using study::Movement;
using study::Recorded;
using tables::Time;

constexpr Time kMs = tables::kMillisecond;

bool is_near(double value, double wanted) { return std::abs(value - wanted) < 1e-9; }

/// A number that is 0 at first and changes each 100 ms by `step`, `count` times, the first time at `first` ms.
Series moving(Time first, double step, int count) {
  Series series{"N", Series::Kind::number, {}, {{0, 0}}, false};
  for (int i = 0; i < count; ++i) series.changes.push_back({(first + 100 * i) * kMs, step * (i + 1)});
  return series;
}

void append(Series& series, const Series& more) {
  const double from = series.changes.back().value;
  for (std::size_t i = 1; i < more.changes.size(); ++i) {
    series.changes.push_back({more.changes[i].time, from + more.changes[i].value});
  }
}

std::vector<Movement> compared(const Series& recorded, const Series& actual, std::vector<Time> commands = {1000 * kMs},
                               double period = 0) {
  return study::movements_of(Curve{&recorded, &actual, std::move(commands), period, true, 0},
                             {5000 * kMs, 100 * kMs, {}});
}

TEST_CASE("A movement that the run repeats exactly has 100 %, from the command to the rest") {
  const Series recorded = moving(1100, 10, 10);
  const auto movements = compared(recorded, recorded);
  REQUIRE(movements.size() == 1);
  CHECK(movements[0].name == "N");
  CHECK(movements[0].begin == 1000 * kMs);
  CHECK(movements[0].end == 2000 * kMs);
  CHECK(movements[0].accuracy == 1);
}

TEST_CASE("The accuracy of a number is one minus the mean difference as a share of the distance") {
  // 11 readings from 1 s to 2 s: at the first both are 0, at ten the run is 10 behind; 100 / 11 of a distance of 100.
  const auto late = compared(moving(1100, 10, 10), moving(1200, 10, 10));
  REQUIRE(late.size() == 1);
  CHECK(is_near(late[0].accuracy, 1 - 100.0 / 11 / 100));
  // 0, 1, 2 ... 10 ahead: 55 / 11 of 100.
  const auto fast = compared(moving(1100, 10, 10), moving(1100, 11, 10));
  REQUIRE(fast.size() == 1);
  CHECK(is_near(fast[0].accuracy, 1 - 5.0 / 100));
  // A run that does not move: 0, 10 ... 100 behind; 550 / 11 of 100.
  const auto still = compared(moving(1100, 10, 10), moving(1100, 10, 0));
  REQUIRE(still.size() == 1);
  CHECK(is_near(still[0].accuracy, 0.5));
  // One that moves in the other direction, three times as far: 40 * 55 / 11 of 100 is more than the distance.
  const auto away = compared(moving(1100, 10, 10), moving(1100, -30, 10));
  REQUIRE(away.size() == 1);
  CHECK(away[0].accuracy == 0);
}

TEST_CASE("Each movement is compared from where it begins") {
  // The run is 5 ahead after the first movement, and exact in the second.
  Series recorded = moving(1100, 10, 10);
  append(recorded, moving(3100, -10, 10));
  Series actual = moving(1100, 10.5, 10);
  append(actual, moving(3100, -10, 10));
  const auto movements = compared(recorded, actual, {1000 * kMs, 3000 * kMs});
  REQUIRE(movements.size() == 2);
  CHECK(is_near(movements[0].accuracy, 1 - 2.5 / 100));
  CHECK(movements[1].begin == 3000 * kMs);
  CHECK(movements[1].accuracy == 1);
}

TEST_CASE("A number that begins again at its period goes on") {
  Series recorded = moving(1100, 10, 10);
  Series actual = moving(1100, 11, 10);
  for (Series* const series : {&recorded, &actual}) {
    for (Series::Change& change : series->changes) change.value = std::fmod(change.value + 3550, 3600);
  }
  const auto movements = compared(recorded, actual, {1000 * kMs}, 3600);
  REQUIRE(movements.size() == 1);
  CHECK(is_near(movements[0].accuracy, 0.95));
  // Without the period it would seem to move by 3500 in the other direction.
  CHECK_FALSE(is_near(compared(recorded, actual, {1000 * kMs}, 0)[0].accuracy, 0.95));
}

TEST_CASE("What is no movement after a command is not compared") {
  const Series recorded = moving(1100, 10, 10);
  CHECK(compared(recorded, recorded, {}).empty());                        // nothing commands it
  CHECK(compared(recorded, recorded, {2500 * kMs}).empty());              // the command is later
  CHECK(compared(moving(4500, 10, 10), recorded, {4400 * kMs}).empty());  // it has no end in the recording: to 5 s
  CHECK(compared(moving(1100, 10, 0), recorded).empty());                 // it does not move
  Series back = moving(1100, 10, 10);
  append(back, moving(2100, -10, 10));
  CHECK(compared(back, back).empty());  // it comes back without a rest
  const std::vector<recording::Gap> gaps{{1500 * kMs, 100 * kMs}};
  CHECK(study::movements_of(Curve{&recorded, &recorded, {1000 * kMs}, 0, true, 0}, {5000 * kMs, 100 * kMs, gaps})
            .empty());
}

TEST_CASE("A movement begins with the first of the commands that follow each other") {
  const Series recorded = moving(1700, 10, 10);
  const auto movements = compared(recorded, recorded, {200 * kMs, 1000 * kMs, 1400 * kMs, 1650 * kMs});
  REQUIRE(movements.size() == 1);
  CHECK(movements[0].begin == 1000 * kMs);
}

TEST_CASE("A number that jitters by one is at rest") {
  Series recorded = moving(1100, 10, 10);
  for (Time t = 2100; t < 5000; t += 100) recorded.changes.push_back({t * kMs, 100.0 + (t / 100 % 2 == 0 ? 1 : 0)});
  const auto movements = compared(recorded, recorded);
  REQUIRE(movements.size() == 1);
  CHECK(movements[0].end == 2000 * kMs);

  for (Series::Change& change : recorded.changes) change.value *= 2;  // now it jitters by two
  CHECK(compared(recorded, recorded).empty());                        // it does not come to rest
  const auto noisy =
      study::movements_of(Curve{&recorded, &recorded, {1000 * kMs}, 0, true, 0.6}, {5000 * kMs, 100 * kMs, {}});
  REQUIRE(noisy.size() == 1);
  CHECK(noisy[0].end == 2000 * kMs);
}

/// The accuracies of moves of the worked clamp, given as from, to, cause and arrival in ms.
std::vector<Movement> of_clamp(const std::vector<std::vector<long>>& recorded,
                               const std::vector<std::vector<long>>& run, Time resolution = 50 * kMs) {
  static const DescribedPlant plant(bits({"L_P_CL_I_OPEN", "L_P_CL_I_CLOSED", "L_P_CL_O_OPEN", "L_P_CL_O_CLOSED"}),
                                    R"("devices": {"L_P_CL": {"actuation": "bistable"}})");
  const auto moves = [](const std::vector<std::vector<long>>& rows) {
    std::vector<observe::Move> made;
    for (const std::vector<long>& row : rows) {
      observe::Move move;
      move.unit = 0;
      move.from = static_cast<std::uint32_t>(row[0]);
      move.to = static_cast<std::uint32_t>(row[1]);
      move.transition = 0;
      move.cause = row[2] * kMs;
      move.arrived = row[3] * kMs;
      made.push_back(move);
    }
    return made;
  };
  return study::movements_of(plant.compiled().plant, moves(recorded), moves(run), 0, {20000 * kMs, resolution, {}});
}

TEST_CASE("The accuracy of a device is one minus the difference of its durations as a share of the recorded one") {
  const auto longer = of_clamp({{0, 1, 1000, 2000}}, {{0, 1, 1000, 2200}});
  REQUIRE(longer.size() == 1);
  CHECK(longer[0].name == "L_P_CL OPEN -> CLOSED");
  CHECK(is_near(longer[0].accuracy, 0.8));
  CHECK(is_near(of_clamp({{0, 1, 1000, 2000}}, {{0, 1, 1000, 1300}})[0].accuracy, 0.3));
  CHECK(of_clamp({{0, 1, 1000, 2000}}, {{0, 1, 1000, 3500}})[0].accuracy == 0);
  CHECK(of_clamp({{0, 1, 1000, 2000}}, {{0, 1, 1000, 2050}})[0].accuracy == 1);  // as exact as the recording is
  CHECK(is_near(of_clamp({{0, 1, 1000, 2000}}, {{0, 1, 1000, 2050}}, 0)[0].accuracy, 0.95));
}

TEST_CASE("A move of a device is compared with the one that repeats it") {
  const auto movements = of_clamp({{0, 1, 1000, 2000}, {1, 0, 5000, 6000}, {0, 1, 9000, 10000}},
                                  {{0, 1, 1000, 2000}, {0, 1, 9000, 10500}});
  REQUIRE(movements.size() == 3);
  CHECK(movements[0].accuracy == 1);
  CHECK(movements[1].accuracy == 0);  // the run does not have it
  CHECK(movements[2].accuracy == 0.5);
  CHECK(of_clamp({{0, 1, 18500, 19500}}, {}).empty());  // the run may arrive after the end
  CHECK(of_clamp({{0, 1, 0, 1000}}, {}).empty());       // its command may be older than the recording
}

TEST_CASE("The mean of a row is weighted by durations") {
  // 1 s with 100 % and 3 s with 60 %: (1 + 1.8) / 4.
  const std::vector<Movement> movements{{"B", 0, 1000 * kMs, 1}, {"A", 0, 3000 * kMs, 0.6}, {"B", 0, 1000 * kMs, 0.5}};
  const std::vector<study::Row> rows = study::rows_of(movements);
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].name == "A");
  CHECK(rows[1].count == 2);
  CHECK(rows[1].least == 0.5);
  CHECK(rows[1].greatest == 1);
  CHECK(rows[1].mean == 0.75);
  CHECK(is_near(study::total_of({movements[0], movements[1]}).mean, 0.7));
}

}  // namespace
}  // namespace symplant::test
