// A plant, a link and a clock that a test of the cycle controls.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <utility>
#include <vector>

#include "symplant/exec/cycle.hpp"
#include "unit/exec/cell.hpp"

namespace symplant::test {

using tables::kMillisecond;
using tables::kSecond;
using tables::Time;

/// Time passes only by sleeping or by request. Its zero is not that of the plant.
class FakeClock final : public exec::Clock {
 public:
  Time now() noexcept override {
    if (on_look) on_look();
    return now_ += costs;
  }
  void sleep_until(Time time) noexcept override {
    longest_sleep = std::max(longest_sleep, time - now_);
    now_ = wakes_early ? now_ + (time - now_ + 1) / 2 : time;
    if (on_sleep) on_sleep();
  }
  void pass(Time duration) noexcept { now_ += duration; }

  Time longest_sleep = 0;
  bool wakes_early = false;
  Time costs = 0;  ///< that pass when the clock is read
  std::function<void()> on_sleep;
  std::function<void()> on_look;

 private:
  Time now_ = 123 * kSecond + 456;
};

/// Records which call came when, and runs what a test needs then.
class FakeLink final : public exec::Exchange {
 public:
  enum class Call { read, write };
  struct Entry {
    Call call;
    Time plant_time;
    std::size_t changed_words;
  };

  void read_operations(plant::Plant& plant, tables::Time now) noexcept override {
    entries.push_back({Call::read, plant.now(), 0});
    read_at.push_back(now);
    if (on_read) on_read(plant);
  }
  void write_events(const plant::Plant& plant, const exec::CycleStatus& status) noexcept override {
    entries.push_back({Call::write, plant.now(), plant.changed_events().size()});
    reported.push_back(status);
    if (on_write) on_write(plant);
  }

  /// Plant times of all writes, in order.
  std::vector<Time> written() const {
    std::vector<Time> times;
    for (const Entry& entry : entries) {
      if (entry.call == Call::write) times.push_back(entry.plant_time);
    }
    return times;
  }

  void leave() noexcept override { ++left; }
  exec::LinkState state() const noexcept override { return stands; }
  bool freezes_plant() const noexcept override { return freezes; }

  std::vector<Entry> entries;
  std::vector<Time> read_at;
  std::vector<exec::CycleStatus> reported;
  int left = 0;
  exec::LinkState stands = exec::LinkState::live;
  bool freezes = false;
  std::function<void(plant::Plant&)> on_read;
  std::function<void(const plant::Plant&)> on_write;
};

struct Bench {
  tables::PlantTables tables = cell_tables();
  OwnedPlant plant{tables};
  FakeClock clock;
  FakeLink link;
  exec::CycleMeter meter;
  std::atomic<bool> stop{false};

  exec::CycleStatistics run(const exec::CycleOptions& options) {
    const std::array<exec::Exchange*, 1> links = {&link};
    exec::run_cycles(*plant, links, options, {.clock = clock, .meter = meter, .stop = stop});
    return meter.statistics();
  }
};

inline std::vector<Time> every_10_ms(int from, int to) {
  std::vector<Time> times;
  for (int cycle = from; cycle <= to; ++cycle) times.push_back(cycle * 10 * kMillisecond);
  return times;
}

}  // namespace symplant::test
