// The paper's cell with a link to a PLC, cycled by a thread, and the program of that PLC.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "symplant/link/link.hpp"
#include "unit/exec/cell.hpp"

namespace symplant::test {

/// One scan of the cell's program: `x(n)` reads input n, `y(n, on)` sets output n. True if a round is finished.
template <class X, class Y>
bool run_cell_program(std::uint16_t& step, X x, Y y) {
  const bool home = x(1) && x(3);  // the AGV at P1, the machine idle
  bool finished = false;
  if (step == 0 && home) step = 1;
  if (step == 1 && x(2)) step = 2;
  if (step == 2 && x(4)) step = 3;
  if (step == 3 && home) {
    step = 0;
    finished = true;
  }
  y(1, step == 1);
  y(4, step == 2);
  y(2, step == 3);
  y(3, step == 3);
  return finished;
}

/// `loss_after` of a link that is expected to stay live, however slow its thread is: 20,000 cycles without an answer.
inline constexpr tables::Time kStaysLive = 20 * tables::kSecond;
/// `loss_after` of a link that is expected to be lost: 2,000 cycles without an answer.
inline constexpr tables::Time kGetsLost = 2 * tables::kSecond;

/// Opens the link, and cycles the plant in a thread as fast as possible: 1 ms of plant time a cycle.
class LinkedCell {
 public:
  explicit LinkedCell(const std::string& url, link::LinkSettings settings = {}, tables::Time loss_after = kStaysLive)
      : tables_(cell_tables()), plant_(tables_) {
    settings.loss_after = loss_after;
    auto result = link::open_link({url, 0, settings}, tables_);
    if (auto* error = std::get_if<link::LinkError>(&result)) throw std::runtime_error(error->message);
    link_ = std::move(std::get<std::unique_ptr<link::Link>>(result));
    plant_->advance_to(0);
    write();
    cycling_ = std::thread([this] { run(); });
  }
  ~LinkedCell() {
    stop_ = true;
    cycling_.join();
  }
  LinkedCell(const LinkedCell&) = delete;
  LinkedCell& operator=(const LinkedCell&) = delete;

  link::Link& link() { return *link_; }
  exec::LinkState state() const { return state_; }
  /// Cycles with the link lost, so far.
  std::uint64_t cycles_lost() const { return cycles_lost_; }
  /// Findings of a kind, so far.
  std::uint64_t count(tables::FindingKind kind) const { return found_[static_cast<std::size_t>(kind)]; }
  /// Symbols that the PLC overwrites, so far.
  std::uint64_t overwritten() const { return count(tables::FindingKind::event_overwritten); }
  /// All messages so far, each with a line end.
  std::string messages() {
    for (const std::string& message : link_->take_messages()) messages_ += message + "\n";
    return messages_;
  }

 private:
  void write() {
    link_->write_events(*plant_, {});
    plant_->forget_changed_events();
  }
  void run() {
    while (!stop_) {
      link_->read_operations(*plant_, plant_->now());
      while (const auto found = link_->take_finding()) {
        ++found_[static_cast<std::size_t>(found->kind)];
      }
      plant_->advance_to(plant_->now() + tables::kMillisecond);
      write();
      state_ = link_->state();
      if (state_ == exec::LinkState::lost) ++cycles_lost_;
      std::this_thread::yield();
    }
  }

  tables::PlantTables tables_;
  OwnedPlant plant_;
  std::unique_ptr<link::Link> link_;
  std::string messages_;
  std::atomic<bool> stop_{false};
  std::atomic<exec::LinkState> state_{exec::LinkState::waiting};
  std::atomic<std::uint64_t> cycles_lost_{0};
  std::array<std::atomic<std::uint64_t>, tables::kAllFindingKinds> found_{};
  std::thread cycling_;
};

}  // namespace symplant::test
