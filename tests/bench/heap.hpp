// The simulation that is usually written by hand: one object with virtual functions per device, one priority queue of
// due times. The engine must not be slower than this at any size.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <queue>
#include <vector>

#include "symplant/tables/time.hpp"

namespace symplant::bench {

class HeapDevice;

/// Has the same interface and does the same work as LimitPlant, for devices of any kind and for any due times.
class HeapPlant {
 public:
  HeapPlant(std::uint32_t devices, std::uint32_t travel_ticks);
  void tick();
  void schedule(tables::Time due, HeapDevice* device) { queue_.push({due, device}); }
  tables::Time now() const { return now_; }
  void switch_event(std::uint32_t bit, bool on) {
    const std::uint64_t mask = std::uint64_t{1} << (bit % 64);
    events[bit / 64] = on ? events[bit / 64] | mask : events[bit / 64] & ~mask;
    if (on) changed[bit / 64] |= mask;
  }

 private:
  struct Entry {
    tables::Time due;
    HeapDevice* device;
    bool operator<(const Entry& other) const { return due > other.due; }
  };
  static std::size_t words(std::uint32_t devices) { return (devices + 31) / 32; }

  tables::Time now_ = 0;
  std::priority_queue<Entry> queue_;
  std::vector<std::uint64_t> last_;
  std::vector<std::unique_ptr<HeapDevice>> devices_;

 public:
  std::vector<std::uint64_t> operations;
  std::vector<std::uint64_t> events;
  std::vector<std::uint64_t> changed;  ///< events that turned on since the controller last read them
};

class HeapDevice {
 public:
  virtual ~HeapDevice() = default;
  virtual void rise(HeapPlant& plant, std::uint32_t operation) = 0;
  virtual void arrive(HeapPlant& plant) = 0;
};

class HeapSolenoid final : public HeapDevice {
 public:
  HeapSolenoid(std::uint32_t first_bit, tables::Time travel) : travel_(travel), first_bit_(first_bit) {}
  void rise(HeapPlant& plant, std::uint32_t operation) override {
    if (moving_ || operation == state_) return;
    plant.switch_event(first_bit_ + state_, false);
    state_ = operation;
    moving_ = true;
    plant.schedule(plant.now() + travel_, this);
  }
  void arrive(HeapPlant& plant) override {
    moving_ = false;
    plant.switch_event(first_bit_ + state_, true);
  }

 private:
  tables::Time travel_;
  std::uint32_t first_bit_;
  std::uint32_t state_ = 0;  ///< or the target of a move
  bool moving_ = false;
};

inline constexpr tables::Time kHeapTick = 10 * tables::kMillisecond;

inline HeapPlant::HeapPlant(std::uint32_t devices, std::uint32_t travel_ticks)
    : last_(words(devices)), operations(words(devices)), events(words(devices)), changed(words(devices)) {
  for (std::uint32_t d = 0; d < devices; ++d) {
    events[d / 32] |= std::uint64_t{1} << (2 * (d % 32));
    devices_.push_back(std::make_unique<HeapSolenoid>(2 * d, travel_ticks * kHeapTick));
  }
}

inline void HeapPlant::tick() {
  now_ += kHeapTick;
  while (!queue_.empty() && queue_.top().due <= now_) {
    HeapDevice* const device = queue_.top().device;
    queue_.pop();
    device->arrive(*this);
  }
  for (std::uint32_t word = 0; word < operations.size(); ++word) {
    const std::uint64_t risen = (operations[word] ^ last_[word]) & operations[word];
    last_[word] = operations[word];
    for (std::uint64_t bits = risen; bits != 0; bits &= bits - 1) {
      const auto bit = static_cast<std::uint32_t>(std::countr_zero(bits));
      devices_[word * 32 + bit / 2]->rise(*this, bit % 2);
    }
  }
}

}  // namespace symplant::bench
