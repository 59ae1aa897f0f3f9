// Carries out the orders of the panel in the thread that runs the plant.
#pragma once

#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <cstddef>
#include <cstdint>

#include "symplant/exec/stepper.hpp"
#include "symplant/panel/operate/order.hpp"
#include "symplant/panel/operate/output_copy.hpp"
#include "symplant/panel/stepping.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/trace/recorder.hpp"

namespace symplant::panel {

/// Advances a plant, with the scenario that is played, and carries out orders at the beginning of each cycle. Wait-free
/// for both threads, without heap, lock or system call: a cycle in which there is no order costs one atomic read.
class Operator final : public exec::Stepper {
 public:
  static constexpr std::size_t kMostOrders = 256;  ///< that wait

  /// `player` and `programs` may be null. `seed` and `cycle` are those of Plant::reset(). All must outlive it.
  Operator(plant::Plant& plant, trace::Recorder& recorder, scenario::Player* player, scenario::ProgramControl* programs,
           std::uint64_t seed, tables::Time cycle);

  /// Adds an order. For one thread other than that of the plant. False if kMostOrders orders wait.
  bool offer(const Order& order) noexcept { return orders_.push(order); }
  /// The outputs of values, as often as that thread asks for them.
  OutputCopy& outputs() noexcept { return outputs_; }
  /// Plant time after the last cycle; for any thread.
  tables::Time now() const noexcept { return now_.load(std::memory_order_relaxed); }

  // For the thread of the plant:
  void advance_to(tables::Time time) noexcept override;
  void advance_within(tables::Time time) noexcept override;
  void hold() noexcept override;
  /// For any thread.
  bool frozen() const noexcept override { return frozen_.load(std::memory_order_relaxed); }
  /// A run with a panel ends by a signal or at `--until`.
  bool over() const noexcept override { return false; }
  /// The time of the next step of the scenario that is played; kNever without one.
  tables::Time next() const noexcept { return player_ != nullptr ? player_->next() : tables::kNever; }
  /// Which of Order::Kind::step_cycle and step_change is in progress, if any.
  Stepping stepping() const noexcept { return stepping_; }

 private:
  engine::Observer* observer() noexcept {
    return player_ != nullptr ? static_cast<engine::Observer*>(player_) : &recorder_;
  }
  void advance(tables::Time time) noexcept;
  void take_orders() noexcept;
  std::uint64_t carry_out(const Order& order) noexcept;
  void act(const scenario::Step& step, std::uint64_t index) noexcept;
  void go(Stepping stepping) noexcept;
  void stop() noexcept;

  plant::Plant& plant_;
  trace::Recorder& recorder_;
  scenario::Player* player_;
  scenario::ProgramControl* programs_;
  std::uint64_t seed_;
  tables::Time cycle_;
  Stepping stepping_ = Stepping::none;
  bool begun_ = false;       ///< the first instant has run
  bool jumped_ = false;      ///< the plant was reset or restored since its last instant
  std::size_t changes_ = 0;  ///< of parts and malfunctions since its last instant
  bool acted_ = false;       ///< orders acted on the plant since its last instant
  bool over_noted_ = false;
  OutputCopy outputs_;
  std::atomic<bool> frozen_{false};
  std::atomic<tables::Time> now_{0};
  boost::lockfree::spsc_queue<Order, boost::lockfree::capacity<kMostOrders>> orders_;
};

}  // namespace symplant::panel
