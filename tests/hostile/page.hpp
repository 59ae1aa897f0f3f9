// Writes docs/reliability.md from the results.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "trial.hpp"

namespace symplant::hostile {

struct Trials {
  std::vector<std::pair<Input, std::vector<Outcome>>> inputs;
  std::vector<std::pair<Misuse, Outcome>> misuses;
};

/// The whole page. It contains no data that depend on one machine: no times, no sizes.
std::string page(const Trials& trials);

}  // namespace symplant::hostile
