// The paper's cell with an SLMP link to a PLC that runs its program.
#pragma once

#include <atomic>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/slmp/slmp_plc.hpp"
#include "symplant/link/link.hpp"
#include "unit/exec/cell.hpp"

namespace symplant::test {

/// Where the PLC's program reads its inputs: bit n of the cell is number `first` + n of a bit device, or bit n of a
/// word.
struct CellInputs {
  const char* device = "X";
  std::uint32_t first = 0;
};

/// One scan of the cell's program. Its step is in D10, the number of finished rounds in D0.
inline void scan_cell(slmp::PlcMemory& memory, const CellInputs& inputs = {}) {
  const auto x = [&](std::uint32_t n) {
    if (inputs.device[0] == 'D' && inputs.device[1] == '\0') return (memory.word("D", inputs.first) >> n & 1) != 0;
    return memory.bit(inputs.device, inputs.first + n);
  };
  const auto y = [&](std::uint32_t n, bool on) { memory.set_bit("Y", n, on); };
  const bool home = x(1) && x(3);  // the AGV at P1, the machine idle
  std::uint16_t step = memory.word("D", 10);
  if (step == 0 && home) step = 1;
  if (step == 1 && x(2)) step = 2;
  if (step == 2 && x(4)) step = 3;
  if (step == 3 && home) {
    step = 0;
    memory.set_word("D", 0, static_cast<std::uint16_t>(memory.word("D", 0) + 1));
  }
  memory.set_word("D", 10, step);
  y(1, step == 1);
  y(4, step == 2);
  y(2, step == 3);
  y(3, step == 3);
}

/// Opens the link to a server on this machine, and cycles the plant in a thread as fast as possible: 1 ms of plant time
/// a cycle. Its PLC counts as silent after 20,000 cycles without an answer.
class CellClient {
 public:
  CellClient(std::uint16_t port, const std::string& parameters, link::LinkSettings settings = {})
      : tables_(cell_tables()), plant_(tables_) {
    settings.loss_after = 20 * tables::kSecond;
    auto result =
        link::open_link({"slmp://127.0.0.1:" + std::to_string(port) + "?" + parameters, 0, settings}, tables_);
    if (auto* error = std::get_if<link::LinkError>(&result)) throw std::runtime_error(error->message);
    link_ = std::move(std::get<std::unique_ptr<link::Link>>(result));
    plant_->advance_to(0);
    write();
    cycling_ = std::thread([this] { run(); });
  }
  ~CellClient() {
    stop_ = true;
    cycling_.join();
  }
  CellClient(const CellClient&) = delete;
  CellClient& operator=(const CellClient&) = delete;

  link::Link& link() { return *link_; }
  exec::LinkState state() const { return state_; }
  /// Symbols that the PLC overwrites, so far.
  std::uint64_t overwritten() const { return overwritten_; }
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
      if (link_->take_overwritten() != tables::kNone) ++overwritten_;
      plant_->advance_to(plant_->now() + tables::kMillisecond);
      write();
      state_ = link_->state();
      std::this_thread::yield();
    }
  }

  tables::PlantTables tables_;
  OwnedPlant plant_;
  std::unique_ptr<link::Link> link_;
  std::string messages_;
  std::atomic<bool> stop_{false};
  std::atomic<exec::LinkState> state_{exec::LinkState::waiting};
  std::atomic<std::uint64_t> overwritten_{0};
  std::thread cycling_;
};

}  // namespace symplant::test
