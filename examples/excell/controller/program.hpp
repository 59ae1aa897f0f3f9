// The cell's program, as a PLC runs it: once a scan, from the input image to the output image.
#pragma once

#include <chrono>
#include <string>

namespace excell {

/// What the plant reports, by the names of the symbol list.
struct Inputs {
  bool agv_p1 = false;    ///< X1  EXLINE_MB_AGV_I_P1
  bool agv_p2 = false;    ///< X2  EXLINE_MB_AGV_I_P2
  bool mc_idle1 = false;  ///< X3  EXLINE_MB_MC_I_IDLE1
  bool mc_run2 = false;   ///< X4  EXLINE_MB_MC_I_RUN2
};

/// The commands to the plant, by the names of the symbol list.
struct Outputs {
  bool agv_p2 = false;    ///< Y1  EXLINE_MB_AGV_O_P2
  bool agv_p1 = false;    ///< Y2  EXLINE_MB_AGV_O_P1
  bool mc_idle1 = false;  ///< Y3  EXLINE_MB_MC_O_IDLE1
  bool mc_run2 = false;   ///< Y4  EXLINE_MB_MC_O_RUN2
};

/// The program, with the memory that a PLC keeps from scan to scan.
class Program {
 public:
  using Duration = std::chrono::milliseconds;

  /// Runs one scan. `elapsed` is the time since the previous scan.
  Outputs scan(const Inputs& in, Duration elapsed);

  /// Cycles of the cell completed.
  unsigned cycles() const { return cycles_; }
  /// How long the present step has been waiting.
  Duration waiting() const { return waiting_; }
  /// The present step and the input that it waits for, in words.
  std::string step() const;

 private:
  enum class Step { home, agv_to_p2, run, idle, agv_to_p1 };

  void go(Step next);

  Step step_ = Step::home;
  Duration waiting_{0};
  unsigned cycles_ = 0;
};

}  // namespace excell
