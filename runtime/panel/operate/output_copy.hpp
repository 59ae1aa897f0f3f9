// The outputs of values, as the thread of the plant copies them for the thread of the panel.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "symplant/plant/plant.hpp"

namespace symplant::panel {

/// One copy at a time: the panel asks, the plant's thread answers at the end of its next cycle, and the numbers belong
/// to the panel until it asks again. Wait-free for both threads.
class OutputCopy {
 public:
  /// The first copy is of the plant as it is.
  explicit OutputCopy(const plant::Plant& plant) : numbers_(plant.tables().values.outputs) { copy(plant); }

  // For the thread of the plant:
  /// Copies if the panel has asked: O(outputs). Otherwise it costs one atomic read; of a plant without values, nothing.
  void give(const plant::Plant& plant) noexcept {
    if (numbers_.empty() || !asked_.load(std::memory_order_acquire)) return;
    copy(plant);
    asked_.store(false, std::memory_order_release);
  }

  // For the thread of the panel:
  bool empty() const noexcept { return numbers_.empty(); }
  /// Whether there is a copy.
  bool is_here() const noexcept { return !asked_.load(std::memory_order_acquire); }
  /// The copy. To be called only if it is here.
  std::span<const double> numbers() const noexcept { return numbers_; }
  /// Asks for a new copy. To be called only if there is one.
  void ask() noexcept { asked_.store(true, std::memory_order_release); }

 private:
  void copy(const plant::Plant& plant) noexcept {
    for (std::uint32_t output = 0; output < numbers_.size(); ++output) numbers_[output] = plant.output(output);
  }

  std::vector<double> numbers_;
  std::atomic<bool> asked_{false};
};

}  // namespace symplant::panel
