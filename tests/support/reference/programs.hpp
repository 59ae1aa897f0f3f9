// PLC programs in lock step with the reference's plant, as simple as possible: all numbers are read before each scan.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "support/reference/reference.hpp"

namespace symplant::reference {

/// A program: a cold start makes a new scan function. `scan` gets the numbers that are read and changes those that are
/// written.
struct Program {
  std::uint32_t controller = 0;
  Time period = 0;
  Time delay = 0;
  bool zero_on_loss = false;
  std::vector<std::uint32_t> reads;
  std::vector<std::uint32_t> writes;  ///< symbols
  using Scan = std::function<void(const std::vector<std::uint64_t>& in, std::vector<std::uint64_t>& out, Time now)>;
  std::function<Scan()> start = {};
};

class LockStep {
 public:
  /// `plant` is at time 0, and has run no instant.
  LockStep(const model::PlantModel& model, Plant& plant, std::vector<Program> programs);

  /// Runs the plant and the scans up to `time`. False if there were more than `most` instants.
  bool advance_to(Time time, int most);
  void restart(std::uint32_t controller);

  long scans = 0;
  long samples = 0;  ///< operations that a scan changed
  long losses = 0;
  long zeroed = 0;  ///< losses after which operations went to zero

 private:
  struct Running {
    Program program;
    Program::Scan scan;
    std::vector<std::uint64_t> at_start;  ///< what it writes, at time 0
    std::vector<std::uint64_t> out;       ///< the program's variables
    std::vector<std::uint64_t> written;   ///< as the plant has them, or soon has
    std::map<std::size_t, std::uint64_t> pending;
    std::map<std::size_t, std::uint64_t> before;  ///< what `written` was, of those that are pending
    Time sample = 0;
    Time next = 0;
    bool lost = false;
  };

  std::uint64_t number(std::uint32_t symbol) const;
  void write(const Running& running, std::size_t index, std::uint64_t number);
  void zero(Running& running);
  void start(Running& running);
  bool is_lost(std::uint32_t controller) const;

  const model::PlantModel& model_;
  Plant& plant_;
  std::vector<Running> running_;
  bool begun_ = false;
};

}  // namespace symplant::reference
