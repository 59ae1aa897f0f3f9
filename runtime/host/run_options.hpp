// The options of `symplant run` and of every generated plant.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "symplant/core/time.hpp"

namespace CLI {
class App;
}

namespace symplant::host {

struct RunOptions {
  enum class Clock { automatic, virtual_time, real_time };

  Clock clock = Clock::automatic;  ///< real time where there is a link, else virtual time
  std::optional<core::Time> until;
  core::Time cycle = 10 * core::kMillisecond;
  std::vector<std::string> links;
  std::string trace;  ///< file; empty: none
  std::uint64_t seed = 0;
};

/// Adds the options to a command; `options` must live until it is parsed.
void add_run_options(CLI::App& app, RunOptions& options);

}  // namespace symplant::host
