// The options of `symplant run` and of every generated plant.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "symplant/exec/real_time.hpp"
#include "symplant/link/link_settings.hpp"
#include "symplant/panel/options.hpp"
#include "symplant/tables/time.hpp"
#include "symplant/trace/output_file.hpp"
#include "symplant/trace/record.hpp"

namespace CLI {
class App;
}

namespace symplant::host {

/// Files are paths; empty: no file. For output files `-` is standard output.
struct RunOptions {
  enum class Clock { automatic, virtual_time, real_time, plc };

  Clock clock = Clock::automatic;        ///< real time with a link to a PLC, else virtual time
  std::string plc_clock;                 ///< with Clock::plc: the name of the operation that is the PLC's clock
  std::optional<tables::Time> plc_unit;  ///< with Clock::plc: of its lowest bit; nothing: as in the plant's links
  std::optional<tables::Time> until;
  std::optional<tables::Time> limit;  ///< plant time at which a run with an unfinished scenario ends as failed
  tables::Time* end = nullptr;        ///< gets the plant time at which the run ended
  tables::Time cycle = 10 * tables::kMillisecond;
  bool cycle_given = false;        ///< whether the user gave it
  std::int64_t max_catch_up = 10;  ///< most cycles run at once after missed deadlines
  bool late_given = false;         ///< whether the user gave --late
  tables::Time spin = 0;           ///< time of busy-waiting before each cycle
  exec::RealTimeOptions real_time;
  bool arm = false;                        ///< links that go to a PLC write also where the PLC cannot be identified
  std::optional<link::OnLoss> on_loss;     ///< for every link; nothing: as in its settings
  std::vector<std::string> links;          ///< URL or CONTROLLER=URL; empty: the plant's own
  std::vector<std::string> programs;       ///< FILE or CONTROLLER=FILE; empty: the plant's own
  std::optional<tables::Time> scan;        ///< the period of programs that do not set it
  std::optional<tables::Time> scan_delay;  ///< from a scan until its outputs are sampled; nothing: the period
  std::string scenario;
  std::string fault;  ///< a malfunction that starts at `fault_at`; empty: none
  tables::Time fault_at = 0;
  std::string replay;  ///< a trace
  std::string trace;
  std::string vcd;
  std::string findings;
  std::string junit;
  std::string stats;
  std::string save;                                   ///< the state at the end
  std::string resume;                                 ///< the state at the start
  std::optional<panel::PanelOptions> panel;           ///< nothing: no panel
  std::vector<std::string> exercises;                 ///< scenarios that the panel offers
  std::vector<std::string> why;                       ///< names to explain at the end
  std::function<void(const trace::Record&)> records;  ///< gets every record of the run, in its order; empty: none
  std::uint64_t trace_limit = trace::kNoLimit;        ///< bytes, for the trace and the VCD file each
  std::uint64_t seed = 0;
  bool seed_given = false;  ///< whether the user gave it
  bool fail_on_findings = false;
  std::optional<std::uint64_t> rt_check;  ///< number of cycles to run under the real-time guard, above 0
};

/// Adds the options to a command; `options` must outlive the parsing.
void add_run_options(CLI::App& app, RunOptions& options);

/// The result files (--junit, --findings, --stats) of a command line that could not be parsed, as far as it was read.
RunOptions result_files_of(const CLI::App& app);

/// Adds only the options of where the panel serves: --panel, --panel-token.
void add_address_options(CLI::App& app, RunOptions& options, const std::string& purpose);

/// Parses `catch-up:N`, `catch-up` (10) or `slip` (0): the most cycles to catch up. Nothing for any other text.
std::optional<std::int64_t> parse_late(const std::string& text);

/// Parses `500`, `500k`, `10M`, `1G`: bytes, k is 1024. Nothing if the text is not a size above 0.
std::optional<std::uint64_t> parse_size(const std::string& text);

}  // namespace symplant::host
