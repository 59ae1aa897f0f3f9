// The measured closed loops: a plant under a load, and the controller that drives it.
//
// A motion is: command, leave, travel, arrive, the controller's answer. All loops use the same controller: for every
// event that turned on, it clears the command that led there and sets the opposite command.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "bench/heap.hpp"
#include "bench/limit.hpp"
#include "bench/two_state_plant.hpp"

namespace symplant::bench {

inline constexpr std::uint32_t kTicks = 100;  // of 10 ms: every travel takes 1 s, arrivals are spread over all of them
inline constexpr tables::Time kTick = 10 * tables::kMillisecond;

/// Answers arrivals: `give(bit)` sets the command of that bit and clears the other one of its device. Returns the
/// number of arrivals.
template <class Give>
std::int64_t answer(std::uint32_t word, std::uint64_t arrived, Give give) {
  const std::int64_t motions = std::popcount(arrived);
  for (; arrived != 0; arrived &= arrived - 1) {
    give(word * 64 + (static_cast<std::uint32_t>(std::countr_zero(arrived)) ^ 1));
  }
  return motions;
}

/// *grid* on a hand-written plant: a step is a scan of 10 ms.
template <class Plant>
class HandGrid {
 public:
  explicit HandGrid(std::uint32_t devices) : plant_(devices, kTicks) {
    for (std::uint32_t tick = 0; tick < kTicks; ++tick) {  // a hundredth of the devices starts in each tick
      for (std::uint32_t d = tick; d < devices; d += kTicks) give(plant_.operations.data(), 2 * d + 1);
      step();
    }
  }

  /// Returns the number of motions that ended in the step.
  std::int64_t step() {
    std::int64_t motions = 0;
    plant_.tick();
    std::uint64_t* const operations = plant_.operations.data();
    std::uint64_t* const changed = plant_.changed.data();
    const auto words = static_cast<std::uint32_t>(plant_.changed.size());
    for (std::uint32_t word = 0; word < words; ++word) {
      const std::uint64_t arrived = changed[word];
      if (arrived == 0) continue;
      changed[word] = 0;
      motions += answer(word, arrived, [operations](std::uint32_t bit) { give(operations, bit); });
    }
    return motions;
  }

 private:
  static void give(std::uint64_t* operations, std::uint32_t bit) {
    const std::uint64_t both = std::uint64_t{3} << (bit % 64 & ~1U);
    std::uint64_t& word = operations[bit / 64];
    word = (word & ~both) | (std::uint64_t{1} << (bit % 64));
  }

  Plant plant_;
};
using LimitGrid = HandGrid<LimitPlant>;
using HeapGrid = HandGrid<HeapPlant>;

/// A plant of the engine, and the changed events that the controller reads.
template <class Made>
class EngineLoop {
 public:
  EngineLoop(std::uint32_t devices, const std::vector<tables::Time>& travels)
      : made_(devices, travels), seen_(made_.tables.event_bits / 64) {
    plant().advance_to(0);
    for (std::uint32_t word = 0; word < seen_.size(); ++word) seen_[word] = plant().events()[word] ^ Made::kInverted;
  }

 protected:
  plant::Plant& plant() { return *made_.plant; }

  std::int64_t answer_plant() {
    std::int64_t motions = 0;
    const auto events = plant().events();
    for (const std::uint32_t word : plant().changed_events()) {
      const std::uint64_t now = events[word] ^ Made::kInverted;
      const std::uint64_t arrived = now & ~seen_[word] & Made::kStateEvents;
      seen_[word] = now;
      motions += answer(word, arrived, [this](std::uint32_t bit) {
        const std::uint64_t both = std::uint64_t{3} << (bit % 64 & ~1U);
        plant().set_operations(bit / 64, both, std::uint64_t{1} << (bit % 64) ^ (Made::kInverted & both));
      });
    }
    plant().forget_changed_events();
    return motions;
  }

 private:
  Made made_;
  std::vector<std::uint64_t> seen_;
};

/// Counts what it receives.
class CountingObserver final : public engine::Observer {
 public:
  void instant(const engine::Instant& instant) noexcept override { changes_ += instant.units.size(); }

 private:
  std::size_t changes_ = 0;
};

/// *grid*: arrivals fall on a 10 ms scan; a step is a scan.
template <class Made, bool kObserved = false>
class EngineScan : public EngineLoop<Made> {
 public:
  explicit EngineScan(std::uint32_t devices) : EngineLoop<Made>(devices, {kTicks * kTick}) {
    for (std::uint32_t tick = 0; tick < kTicks; ++tick) {
      for (std::uint32_t d = tick; d < devices; d += kTicks)
        this->plant().set_operation(Made::kStride * d + 1, Made::kInverted == 0);
      step();
    }
  }

  std::int64_t step() {
    this->plant().advance_to(now_, kObserved ? &observer_ : nullptr);
    now_ += kTick;
    return this->answer_plant();
  }

 private:
  tables::Time now_ = 0;
  CountingObserver observer_;
};
using EngineGrid = EngineScan<TwoStatePlant>;
using EngineObserved = EngineScan<TwoStatePlant, true>;
/// *types*: *grid* with devices of several types in random order.
template <std::uint32_t kTypes>
using EngineTypes = EngineScan<ManyTypesPlant<kTypes>>;
/// *rich*: the same, and each device has a condition, an `after` and a disable.
using EngineRich = EngineScan<RichPlant>;

using EngineGuarded = EngineScan<GuardedPlant<false>>;
using EngineWhile = EngineScan<GuardedPlant<true>>;
using EngineSymbols = EngineScan<SymbolPlant<false>>;
using EngineInverted = EngineScan<SymbolPlant<true>>;

/// *distinct*: every arrival is a separate instant, and so is every answer; a step is both.
class EngineDistinct : public EngineLoop<TwoStatePlant> {
 public:
  explicit EngineDistinct(std::uint32_t devices) : EngineLoop(devices, travels(devices)) {
    for (std::uint32_t d = 0; d < devices; ++d) {  // arrivals are spread over the travel time
      plant().set_operation(2 * d + 1, true);
      plant().advance_to(1 + tables::kSecond / devices * tables::Time{d});
      answer_plant();
    }
    for (std::uint32_t d = 0; d < 2 * devices; ++d) step();
  }

  std::int64_t step() {
    plant().advance_to(plant().next_due());
    const std::int64_t motions = answer_plant();
    plant().advance_to(plant().now() + 1);
    return motions;
  }

 private:
  /// Travel times that differ by a prime number of nanoseconds, so that arrivals rarely coincide.
  static std::vector<tables::Time> travels(std::uint32_t devices) {
    std::vector<tables::Time> times;
    for (std::uint32_t d = 0; d < devices; ++d) times.push_back(tables::kSecond + 7919 * tables::Time{d});
    return times;
  }
};

}  // namespace symplant::bench
