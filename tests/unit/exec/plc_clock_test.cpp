// Plant time from a PLC's clock: its rate, its phase, and that it never goes back.
#include "symplant/exec/plc_clock.hpp"

#include <string>
#include <vector>

#include "support/catch.hpp"
#include "unit/exec/simulated_plc.hpp"

namespace symplant::test {
namespace {

using exec::PlcClock;

constexpr double kRate = 1e-4;

/// An hour of a simulated PLC.
void check_hour(const std::string& name, const SimulatedPlc& plc) {
  INFO(name);
  const Followed hour = Simulation(plc).run(kHour);
  CHECK(hour.reading.values > 1000);
  CHECK(hour.reading.restarts == 0);
  CHECK(hour.backward == 0);
  CHECK(std::abs(hour.rate() - 1) < kRate);
  const Time bound = hour.largest_step + hour.largest_cycle;
  CHECK(hour.reading.largest_phase_error <= bound);
  if (!plc.delayed) CHECK(hour.farthest <= bound);  // what the network delays, the plant cannot know
}

TEST_CASE("Plant time follows a PLC's clock of any rate") {
  check_hour("the rate of the plant", {});
  check_hour("5 times faster", {.rate_numerator = 5});
  check_hour("5 times slower", {.rate_denominator = 5});
  check_hour("20 % faster", {.rate_numerator = 6, .rate_denominator = 5});
  check_hour("20 % slower", {.rate_numerator = 4, .rate_denominator = 5});
  check_hour("a rate that no number of nanoseconds divides", {.rate_numerator = 997, .rate_denominator = 1013});
}

TEST_CASE("Plant time follows a PLC's clock whose values come at any interval") {
  for (const Time ms : {5, 15, 20, 33, 50, 77, 100, 200, 333, 500}) {
    check_hour("every " + std::to_string(ms) + " ms", {.interval = ms * kMillisecond});
  }
  check_hour("20 to 500 ms", {.interval = 20 * kMillisecond, .more = 480 * kMillisecond});
  check_hour("an odd cycle", {.interval = 33 * kMillisecond, .cycle = 7 * kMillisecond});
  check_hour("units of 100 us", {.unit = 100 * kMicrosecond, .interval = 20 * kMillisecond});
}

TEST_CASE("Plant time follows a PLC's clock whose values come irregularly") {
  check_hour("half an interval late", {.jitter = 50 * kMillisecond});
  check_hour("half a long interval late", {.interval = 500 * kMillisecond, .jitter = 250 * kMillisecond});
  check_hour("delayed by the network", {.jitter = 50 * kMillisecond, .delayed = true});
  check_hour("every fifth lost", {.lost = 20});
  check_hour("every fifth repeated", {.repeated = 20});
  check_hour("all of it",
             {.rate_numerator = 6, .rate_denominator = 5, .jitter = 50 * kMillisecond, .lost = 10, .repeated = 10});
}

TEST_CASE("Plant time stops with the PLC for a minute, and continues with it") {
  check_hour("regular values", {.stops_every = 10 * kMinute});
  check_hour("irregular values", {.jitter = 50 * kMillisecond, .stops_every = kMinute});
}

TEST_CASE("The phase error is at most one interval and one cycle, whatever combines") {
  for (unsigned mix = 0; mix < 64; ++mix) {
    const auto has = [mix](unsigned bit) { return (mix >> bit & 1) != 0; };
    const Time interval = (has(0) ? 50 : 200) * kMillisecond;
    const SimulatedPlc plc{.rate_numerator = has(1) ? 5 : 4,
                           .rate_denominator = 5,
                           .interval = interval,
                           .more = has(2) ? 500 * kMillisecond - interval : 0,
                           .jitter = has(3) ? interval / 2 : 0,
                           .lost = has(4) ? 10 : 0,
                           .stops_every = has(5) ? kMinute : 0};
    const Followed followed = Simulation(plc).run(10 * kMinute);
    INFO(mix);
    const Time bound = followed.largest_step + followed.largest_cycle;
    CHECK(followed.reading.largest_phase_error <= bound);
    CHECK(followed.farthest <= bound);
    CHECK(followed.backward == 0);
    CHECK(followed.reading.restarts == 0);
  }
}

TEST_CASE(
    "After a stop of the PLC plant time does not creep: an interval has at most twice the cycles of the last one") {
  PlcClock clock({32}, 0);
  clock.arrive(0);
  for (const std::uint64_t value : {100U, 200U}) {
    for (int i = 0; i < 10; ++i) clock.step();
    clock.arrive(value);
  }
  for (int i = 0; i < 6000; ++i) clock.step();
  clock.arrive(300);
  const Time begin = clock.now();
  for (int i = 0; i < 10; ++i) clock.step();
  CHECK(clock.now() - begin == 50 * kMillisecond);
}

TEST_CASE("The PLC's clock wraps at its width") {
  check_hour("16 bits", {.bits = 16, .first = 65'000});
  check_hour("16 bits, 5 times faster", {.bits = 16, .rate_numerator = 5, .interval = 500 * kMillisecond});
  check_hour("32 bits", {.first = 0xFFFF'FF00});
  check_hour("64 bits", {.bits = 64, .first = ~std::uint64_t{0} - 1000});
  check_hour("16 bits, written as a negative INT", {.bits = 16, .first = ~std::uint64_t{0} - 100});
}

// --- one value after another

/// The plant times of the next `count` cycles.
std::vector<Time> steps(PlcClock& clock, int count) {
  std::vector<Time> times;
  for (int i = 0; i < count; ++i) times.push_back(clock.step());
  return times;
}

TEST_CASE("The first value only sets the base: plant time waits for the second one") {
  PlcClock clock({16}, kSecond);
  CHECK(steps(clock, 3) == std::vector<Time>(3, kSecond));
  CHECK_FALSE(clock.arrive(40'000));
  CHECK(steps(clock, 4) == std::vector<Time>(4, kSecond));
  CHECK(clock.reading().waits == 0);
  CHECK_FALSE(clock.arrive(40'020));
  CHECK(clock.reading().phase_error == -20 * kMillisecond);
  // To 20 ms ahead of the PLC, in as many steps as the last interval had, and no further.
  const std::vector<Time> expected{kSecond + 10 * kMillisecond, kSecond + 20 * kMillisecond,
                                   kSecond + 30 * kMillisecond, kSecond + 40 * kMillisecond,
                                   kSecond + 40 * kMillisecond, kSecond + 40 * kMillisecond};
  CHECK(steps(clock, 6) == expected);
  CHECK(clock.reading().waits == 2);
  CHECK_FALSE(clock.arrive(40'060));
  CHECK(clock.reading().phase_error == -20 * kMillisecond);
}

TEST_CASE("A repeated value changes nothing") {
  PlcClock clock({16}, 0);
  clock.arrive(0);
  steps(clock, 4);
  clock.arrive(40);
  steps(clock, 2);
  CHECK_FALSE(clock.arrive(40));
  CHECK_FALSE(clock.arrive(0x1'0000 + 40));
  CHECK(clock.reading().values == 2);
  CHECK(steps(clock, 2).back() == 80 * kMillisecond);
}

TEST_CASE("Steps that do not divide evenly reach the target exactly") {
  PlcClock clock({32}, 0);
  clock.arrive(0);
  steps(clock, 7);
  clock.arrive(10);
  const std::vector<Time> times = steps(clock, 7);
  CHECK(times.front() == 20 * kMillisecond / 7);
  CHECK(times[3] == 20 * kMillisecond * 4 / 7);
  CHECK(times.back() == 20 * kMillisecond);
}

TEST_CASE("Plant time that is beyond a new target waits, and never goes back") {
  PlcClock clock({32}, 0);
  clock.arrive(0);
  steps(clock, 2);
  clock.arrive(1000);
  CHECK(steps(clock, 2).back() == 2 * kSecond);
  clock.arrive(1001);
  CHECK(clock.reading().phase_error == 999 * kMillisecond);
  CHECK(steps(clock, 5) == std::vector<Time>(5, 2 * kSecond));
  CHECK(clock.reading().waits == 5);
  clock.arrive(2500);
  CHECK(clock.step() > 2 * kSecond);
}

TEST_CASE("A step of the counter over the limit is a restart, one of the limit is not") {
  PlcClock clock({32, kMillisecond, 10 * kSecond}, 0);
  clock.arrive(0);
  steps(clock, 10);
  CHECK_FALSE(clock.arrive(10'000));
  CHECK(steps(clock, 10).back() == 20 * kSecond);
  CHECK(clock.arrive(20'001));
  CHECK(clock.reading().restarts == 1);
  CHECK(steps(clock, 3).back() == 20 * kSecond);
  CHECK_FALSE(clock.arrive(20'101));  // 3 cycles, 100 ms
  CHECK(clock.reading().phase_error == -100 * kMillisecond);
  CHECK(steps(clock, 3).back() == 20 * kSecond + 200 * kMillisecond);
}

TEST_CASE("A counter that steps back is a restart at every width") {
  for (const int bits : {16, 32, 64}) {
    for (const Time unit : {kMillisecond, 100 * kMicrosecond}) {  // 16 bits of 100 us wrap before the limit of 10 s
      INFO(bits << " bits of " << unit);
      PlcClock clock({bits, unit}, 0);
      clock.arrive(5000);
      steps(clock, 5);
      CHECK_FALSE(clock.arrive(5100));
      const Time before = steps(clock, 5).back();
      CHECK(clock.arrive(0));
      CHECK(steps(clock, 5).back() == before);
      CHECK(clock.reading().restarts == 1);
    }
  }
}

TEST_CASE("A reconnect is a restart if values had arrived, and plant time goes on from where it is") {
  PlcClock clock({16}, 0);
  CHECK_FALSE(clock.restart());
  clock.arrive(100);
  steps(clock, 5);
  clock.arrive(200);
  const Time before = steps(clock, 2).back();
  CHECK(before == 80 * kMillisecond);
  CHECK(clock.restart());
  CHECK(steps(clock, 9).back() == before);
  CHECK_FALSE(clock.arrive(50'000));
  CHECK(steps(clock, 5).back() == before);
  CHECK_FALSE(clock.arrive(50'100));
  CHECK(steps(clock, 5).back() == before + 200 * kMillisecond);
  CHECK(clock.reading().restarts == 1);
}

TEST_CASE("A stopped plant is not caught up, and this is no restart") {
  PlcClock clock({16}, 0);
  clock.arrive(100);
  steps(clock, 5);
  clock.arrive(200);
  const Time before = steps(clock, 5).back();
  clock.hold();
  clock.arrive(9000);
  steps(clock, 5);
  clock.arrive(9100);
  CHECK(steps(clock, 5).back() == before + 200 * kMillisecond);
  CHECK(clock.reading().restarts == 0);
}

TEST_CASE("Skipped cycles count as cycles") {
  PlcClock one({32}, 0);
  PlcClock other({32}, 0);
  for (PlcClock* clock : {&one, &other}) clock->arrive(1);
  steps(one, 10);
  other.step(10);
  for (PlcClock* clock : {&one, &other}) clock->arrive(101);
  CHECK(steps(one, 7).back() == other.step(7));
  CHECK(steps(one, 7).back() == other.step(7));
}

}  // namespace
}  // namespace symplant::test
