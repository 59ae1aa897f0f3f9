// When a link counts as lost, and when its PLC's writes count again.
#include "symplant/link/health.hpp"

#include <vector>

#include "support/catch.hpp"

using namespace symplant;
using exec::LinkState;
using link::LinkHealth;
using link::Verdict;
using tables::kMillisecond;
using tables::kSecond;

namespace {

constexpr tables::Time kCycle = 10 * kMillisecond;

/// A link that is checked every 10 ms.
struct HealthBench {
  LinkHealth health{kSecond, kSecond};
  tables::Time now = 1234;
  std::vector<tables::Time> lost_at;

  Verdict look(bool heard, bool complete = true) {
    now += kCycle;
    const Verdict verdict = health.look(now, heard, complete);
    if (verdict == Verdict::lose) lost_at.push_back(now);
    return verdict;
  }
  /// Checks for a time without requests; returns the last verdict.
  Verdict silent(tables::Time time) {
    Verdict last = Verdict::hold;
    for (tables::Time t = 0; t < time; t += kCycle) last = look(false);
    return last;
  }
};

}  // namespace

TEST_CASE("A link waits until its PLC is heard for the first time, and is never lost before") {
  HealthBench bench;
  CHECK(bench.health.state() == LinkState::waiting);
  CHECK(bench.silent(10 * kSecond) == Verdict::hold);
  CHECK(bench.health.state() == LinkState::waiting);
  CHECK(bench.lost_at.empty());
  CHECK(bench.look(true) == Verdict::apply);
  CHECK(bench.health.state() == LinkState::live);
}

TEST_CASE("A PLC's first write acts at once, without waiting for a complete image") {
  HealthBench bench;
  CHECK(bench.look(true, false) == Verdict::apply);
}

TEST_CASE("A link is lost after its time without requests, and not a cycle earlier") {
  HealthBench bench;
  bench.look(true);
  const tables::Time heard = bench.now;
  CHECK(bench.silent(kSecond - kCycle) == Verdict::apply);
  CHECK(bench.health.state() == LinkState::live);
  CHECK(bench.look(false) == Verdict::lose);
  CHECK(bench.health.state() == LinkState::lost);
  CHECK(bench.lost_at == std::vector<tables::Time>{heard + kSecond});
  CHECK(bench.health.losses() == 1);
}

TEST_CASE("A lost link stays lost, and is lost once") {
  HealthBench bench;
  bench.look(true);
  CHECK(bench.silent(60 * kSecond) == Verdict::hold);
  CHECK(bench.lost_at.size() == 1);
}

TEST_CASE("Requests in time keep a link alive forever") {
  HealthBench bench;
  for (int i = 0; i < 100; ++i) {
    CHECK(bench.look(true) == Verdict::apply);
    CHECK(bench.silent(kSecond - kCycle) == Verdict::apply);
  }
  CHECK(bench.lost_at.empty());
}

TEST_CASE("After a loss writes act together, when all has been written again") {
  HealthBench bench;
  bench.look(true);
  bench.silent(2 * kSecond);
  CHECK(bench.look(true, false) == Verdict::hold);
  CHECK(bench.health.state() == LinkState::lost);
  CHECK(bench.look(true, false) == Verdict::hold);
  CHECK(bench.look(true, true) == Verdict::apply);
  CHECK(bench.health.state() == LinkState::live);
}

TEST_CASE("After a loss an incomplete image acts when its time is over") {
  HealthBench bench;
  bench.look(true);
  bench.silent(2 * kSecond);
  CHECK(bench.look(true, false) == Verdict::hold);
  const tables::Time returned = bench.now;
  Verdict verdict = Verdict::hold;
  while (verdict == Verdict::hold && bench.now < returned + 5 * kSecond) verdict = bench.look(true, false);
  CHECK(verdict == Verdict::apply);
  CHECK(bench.now == returned + kSecond);
  CHECK(bench.health.state() == LinkState::live);
}

TEST_CASE("A complete image counts only when its PLC has been heard again") {
  HealthBench bench;
  bench.look(true);
  bench.silent(2 * kSecond);
  CHECK(bench.look(false, true) == Verdict::hold);
  CHECK(bench.look(true, true) == Verdict::apply);
}

TEST_CASE("A PLC that returns and leaves before its image is complete is lost again") {
  HealthBench bench;
  bench.health = LinkHealth(kSecond, 5 * kSecond);
  bench.look(true);
  bench.silent(2 * kSecond);
  bench.look(true, false);
  Verdict verdict = Verdict::hold;
  for (int i = 0; i < 100 && verdict == Verdict::hold; ++i) verdict = bench.look(false, false);
  CHECK(verdict == Verdict::lose);
  CHECK(bench.health.losses() == 2);
  CHECK(bench.look(false, true) == Verdict::hold);
}

TEST_CASE("A cycle longer than the loss time is no loss while its PLC is heard between cycles") {
  LinkHealth health(kSecond, kSecond);
  for (tables::Time hour = 1; hour < 5; ++hour) CHECK(health.look(hour * 3600 * kSecond, true, true) == Verdict::apply);
}
