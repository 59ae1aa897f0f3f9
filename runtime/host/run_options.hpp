// The options of `symplant run` and of every generated plant.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "symplant/exec/real_time.hpp"
#include "symplant/link/link_settings.hpp"
#include "symplant/tables/time.hpp"
#include "symplant/trace/output_file.hpp"

namespace CLI {
class App;
}

namespace symplant::host {

/// Files are named by their paths; empty: none. Of those that are written `-` is standard output.
struct RunOptions {
  enum class Clock { automatic, virtual_time, real_time };

  Clock clock = Clock::automatic;  ///< real time where there is a link, else virtual time
  std::optional<tables::Time> until;
  tables::Time cycle = 10 * tables::kMillisecond;
  bool cycle_given = false;        ///< by the user
  std::int64_t max_catch_up = 10;  ///< cycles run at once after a delay
  bool late_given = false;         ///< max_catch_up, by the user
  tables::Time spin = 0;           ///< awake before each deadline for so long
  exec::RealTimeOptions real_time;
  std::optional<link::OnLoss> on_loss;  ///< of every link; nothing: what its settings say
  std::vector<std::string> links;       ///< URL or CONTROLLER=URL; none: the plant's own
  std::string scenario;
  std::string trace;
  std::string vcd;
  std::string findings;
  std::string junit;
  std::string stats;
  std::uint64_t trace_limit = trace::kNoLimit;  ///< bytes, of trace and VCD file each
  std::uint64_t seed = 0;
  bool fail_on_findings = false;
  std::optional<std::uint64_t> rt_check;  ///< cycles to be run under the guard of real time, above 0
};

/// Adds the options to a command; `options` must live until it is parsed.
void add_run_options(CLI::App& app, RunOptions& options);

/// `catch-up:N`, `catch-up` and `slip`: the cycles that are caught up at most, 10 where no number is given. Nothing
/// where the text is none of them.
std::optional<std::int64_t> parse_late(const std::string& text);

/// `500k`, `10M`, `1G`: bytes, with 1024 in a k. Nothing where the text is no size above 0.
std::optional<std::uint64_t> parse_size(const std::string& text);

}  // namespace symplant::host
