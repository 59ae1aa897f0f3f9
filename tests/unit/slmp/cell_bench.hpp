// The paper's cell with an SLMP link to a PLC that runs its program.
#pragma once

#include <cstdint>
#include <string>

#include "support/slmp/slmp_plc.hpp"
#include "unit/link/cell_client.hpp"

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
  std::uint16_t step = memory.word("D", 10);
  const bool finished = run_cell_program(step, x, y);
  if (finished) memory.set_word("D", 0, static_cast<std::uint16_t>(memory.word("D", 0) + 1));
  memory.set_word("D", 10, step);
}

/// The cell with a link to a server on this machine.
class CellClient : public LinkedCell {
 public:
  CellClient(std::uint16_t port, const std::string& parameters, const link::LinkSettings& settings = {},
             tables::Time loss_after = kStaysLive)
      : LinkedCell("slmp://127.0.0.1:" + std::to_string(port) + "?" + patient(parameters), settings, loss_after) {}

 private:
  /// A slow machine is no loss: the default timeout would be one where many tests run at once.
  static std::string patient(const std::string& parameters) {
    return parameters + (parameters.find("timeout=") == std::string::npos ? "&timeout=20s&retry=10ms" : "");
  }
};

}  // namespace symplant::test
