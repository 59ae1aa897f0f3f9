// docs/reliability.md, made of what was tried.
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

/// The whole page. Nothing in it is of one machine: no times, no sizes.
std::string page(const Trials& trials);

}  // namespace symplant::hostile
