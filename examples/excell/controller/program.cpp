// The cell's program: a sequence of steps, each with one output and the input that ends it.
#include "program.hpp"

namespace excell {

Outputs Program::scan(const Inputs& in, Duration elapsed) {
  waiting_ += elapsed;

  // --- Transitions: a step ends when its input comes on; one transition in a scan, as in a sequential function chart.
  switch (step_) {
    case Step::home:  // bring the cell to its start position: AGV at P1, machine idle
      if (in.agv_p1 && in.mc_idle1) go(Step::agv_to_p2);
      break;
    case Step::agv_to_p2:  // the AGV brings the part to the machine
      if (in.agv_p2) go(Step::run);
      break;
    case Step::run:  // the machine works on it
      if (in.mc_run2) go(Step::idle);
      break;
    case Step::idle:  // the machine goes back to idle
      if (in.mc_idle1) go(Step::agv_to_p1);
      break;
    case Step::agv_to_p1:  // the AGV takes the part away
      if (in.agv_p1) {
        ++cycles_;
        go(Step::agv_to_p2);
      }
      break;
  }

  // --- Outputs: the two commands of a device are never on together.
  const bool home = step_ == Step::home;
  Outputs out;
  out.agv_p2 = step_ == Step::agv_to_p2;
  out.mc_run2 = step_ == Step::run;
  out.mc_idle1 = step_ == Step::idle || (home && !in.mc_idle1);
  out.agv_p1 = step_ == Step::agv_to_p1 || (home && !in.agv_p1);
  return out;
}

void Program::go(Step next) {
  step_ = next;
  waiting_ = Duration{0};
}

std::string Program::step() const {
  switch (step_) {
    case Step::home:
      return "step 0 (start position) waits for EXLINE_MB_AGV_I_P1 (X1) and EXLINE_MB_MC_I_IDLE1 (X3)";
    case Step::agv_to_p2:
      return "step 1 (AGV to P2, EXLINE_MB_AGV_O_P2 on) waits for EXLINE_MB_AGV_I_P2 (X2)";
    case Step::run:
      return "step 2 (machine runs, EXLINE_MB_MC_O_RUN2 on) waits for EXLINE_MB_MC_I_RUN2 (X4)";
    case Step::idle:
      return "step 3 (machine to idle, EXLINE_MB_MC_O_IDLE1 on) waits for EXLINE_MB_MC_I_IDLE1 (X3)";
    case Step::agv_to_p1:
      return "step 4 (AGV to P1, EXLINE_MB_AGV_O_P1 on) waits for EXLINE_MB_AGV_I_P1 (X1)";
  }
  return "";
}

}  // namespace excell
