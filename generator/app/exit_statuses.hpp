// What the exit codes of the tool mean, for the help and the manual pages.
#pragma once

#include <array>
#include <string_view>

#include "symplant/host/exit_codes.hpp"

namespace symplant::app {

struct ExitStatus {
  int code;
  std::string_view meaning;
};

constexpr std::array kExitStatuses{
    ExitStatus{host::kGood, "good"},
    ExitStatus{host::kFindings, "findings or failed expectations"},
    ExitStatus{host::kBadInput, "bad input or usage"},
    ExitStatus{host::kEnvironment, "the environment (a port in use, no permission)"},
};

}  // namespace symplant::app
