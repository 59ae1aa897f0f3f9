// Hides active malfunctions from the texts for a trainee.
#pragma once

#include <vector>

#include "symplant/trace/history.hpp"

namespace symplant::trace {

/// While it lives, a history has no active malfunctions. No record may be applied meanwhile.
class HiddenMalfunctions {
 public:
  explicit HiddenMalfunctions(History& history) : history_(history) { history_.swap_malfunctions(kept_); }
  ~HiddenMalfunctions() { history_.swap_malfunctions(kept_); }
  HiddenMalfunctions(const HiddenMalfunctions&) = delete;
  HiddenMalfunctions& operator=(const HiddenMalfunctions&) = delete;

 private:
  History& history_;
  std::vector<History::Malfunction> kept_;
};

}  // namespace symplant::trace
