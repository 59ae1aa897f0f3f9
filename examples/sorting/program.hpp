// The PLC program of the sorting line: a scan from inputs to outputs, as ladder logic does it.
#pragma once

#include <deque>

namespace sorting {

struct Inputs {
  bool belt_runs = false;
  bool low = false;
  bool high = false;
  bool stop1 = false;
  bool stop2 = false;
  bool push1_out = false;
  bool push1_back = false;
  bool push2_out = false;
  bool push2_back = false;
};

struct Outputs {
  bool belt = false;
  bool push1 = false;
  bool push2 = false;
};

/// Remembers which parts are tall between the photo-eyes and the pushers. Tall parts go to chute 1, low ones to
/// chute 2.
class Program {
 public:
  /// `delay`: how long it waits before it pushes, in scans; a correct program does not wait.
  explicit Program(int delay) : delay_(delay) {}

  Outputs scan(const Inputs& in) {
    if (in.low && !before_.low) to_stop1_.push_back(in.high);
    if (in.stop1 && !before_.stop1 && !to_stop1_.empty()) {
      const bool tall = to_stop1_.front();
      to_stop1_.pop_front();
      if (tall) {
        wait1_ = delay_;
      } else {
        ++to_stop2_;
      }
    }
    if (in.stop2 && !before_.stop2 && to_stop2_ > 0) {
      --to_stop2_;
      wait2_ = delay_;
    }
    before_ = in;
    step(out_.push1, wait1_, in.push1_out);
    step(out_.push2, wait2_, in.push2_out);
    out_.belt = true;
    return out_;
  }

 private:
  static void step(bool& push, int& wait, bool out) {
    if (wait >= 0 && wait-- == 0) push = true;
    if (out) push = false;
  }

  int delay_;
  Inputs before_;
  Outputs out_;
  std::deque<bool> to_stop1_;  ///< parts between the photo-eyes and pusher 1: whether they are tall
  int to_stop2_ = 0;           ///< low parts between the pushers
  int wait1_ = -1;             ///< scans until pusher 1 goes out; -1: it need not
  int wait2_ = -1;
};

}  // namespace sorting
