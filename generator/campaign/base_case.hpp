// The run without a fault, with which all others are compared.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "campaign/run_log.hpp"
#include "symplant/host/plant_program.hpp"
#include "symplant/host/run_options.hpp"

namespace symplant::campaign {

/// What all runs of a campaign have in common.
struct Setup {
  std::string scenario;                        ///< the file of the base case
  host::RunOptions run;                        ///< programs, links, clock, cycle, seed
  tables::Time limit = 600 * tables::kSecond;  ///< of plant time for the base case
  std::optional<tables::Time> window{};        ///< what times may differ by; nothing: 0, with a link two cycles
};

/// What a program, or a PLC at a link, reads.
struct Reader {
  tables::Time period = 0;   ///< from scan to scan; 0: it may read at any time
  std::vector<bool> events;  ///< by symbol
  std::vector<std::uint32_t> controllers = {};
};

struct BaseCase {
  RunLog log;
  std::vector<Reader> readers;
  std::vector<std::string> programs;  ///< `drill (drill.so, 9c554e4d4920d30f)`
  std::vector<bool> operations;       ///< by symbol
  std::vector<bool> paced;            ///< those that count for pauses: not heartbeats and lamps that always blink
  recording::Recording recorded;      ///< changes of operations
  std::unordered_map<std::string_view, std::uint32_t> symbol_of;  ///< operations by name
  tables::Time case_end = 0;            ///< when its scenario is over; the log ends with the longest pause after that
  tables::Time pause = 0;               ///< the longest time without a change of an operation, over the whole log
  std::vector<std::uint32_t> stations;  ///< by symbol; tables::kNone: in none
  std::map<std::uint32_t, tables::Time> pauses;  ///< by station: the longest time without a change of its operations
  tables::Time window = 0;
  bool in_virtual_time = true;
};

/// A run that has ended.
struct Ended {
  int code = 0;          ///< exit code of host::run()
  std::string messages;  ///< what it wrote to standard error
};

/// Runs a plant until `until`, or with nothing until the scenario is over. `fault` may be empty. The process ends if a
/// program crashes.
Ended run_logged(const Setup& setup, const host::PlantProgram& plant, const std::string& fault, tables::Time at,
                 std::optional<tables::Time> until, RunLog& log);

/// A message without the word before it that says how bad it is.
std::string without_severity(std::string text);

/// The longest time without a change of one of the operations in a log up to `end`.
tables::Time longest_pause(const RunLog& log, const std::vector<bool>& operations, tables::Time end);

/// The operations that do not change at equal intervals of at most a second all the time, as heartbeats do; all if no
/// other one changes.
std::vector<bool> paced_operations(const RunLog& log, const std::vector<bool>& operations);

/// For each station, when the last of its operations changes.
std::map<std::uint32_t, tables::Time> last_changes(const RunLog& log, const BaseCase& base);

/// Runs the base case, then again for its length and this number of its longest `pauses`, 1 if faults begin at its
/// start, 2 if they begin until its end. `stations` are stations_of() the plant. Nothing, with a message in `error` and
/// the exit code in `code`, if it does not pass, if no operation changes, or if it cannot run.
std::optional<BaseCase> run_base(const Setup& setup, const host::PlantProgram& plant, const trace::PlantNames& names,
                                 std::vector<std::uint32_t> stations, int pauses, std::string& error, int& code);

}  // namespace symplant::campaign
