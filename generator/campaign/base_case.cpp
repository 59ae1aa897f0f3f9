// The run without a fault.
#include "campaign/base_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>
#include <variant>

#include "symplant/host/exit_codes.hpp"
#include "symplant/host/programs.hpp"
#include "symplant/host/run.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/program/library.hpp"
#include "symplant/tables/lists.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/trace/words.hpp"

namespace symplant::campaign {
namespace {

using tables::Time;

/// The readers of a run: each program, and all PLCs at links together. The text is empty, or says what is wrong.
std::string find_readers(const Setup& setup, const host::PlantProgram& plant, const trace::PlantNames& names,
                         BaseCase& base) {
  std::vector<Reader>& readers = base.readers;
  const auto chosen = host::programs_of(plant, setup.run);
  if (const auto* error = std::get_if<std::string>(&chosen)) return *error;
  std::ostringstream messages;
  host::Programs programs;
  const auto& choices = std::get<host::ProgramChoices>(chosen);
  if (host::open_programs(choices, names, programs, messages) != host::kGood) return messages.str();
  const std::size_t symbols = plant.tables.symbols.size();
  for (const host::OpenProgram& one : programs) {
    base.programs.push_back(fmt::format("{} ({}, {})", one.loaded->program().name, one.choice.file, one.digest));
    Reader& reader =
        readers.emplace_back(Reader{one.times.period, std::vector<bool>(symbols), {one.choice.options.controller}});
    for (std::uint32_t i = 0; i < one.loaded->program().count; ++i) {
      const std::uint32_t symbol = one.binding.symbols[i];
      if (one.loaded->program().variables[i].writes == 0 && symbol != tables::kNone) reader.events[symbol] = true;
    }
  }
  if (setup.run.links.empty()) return "";
  const std::vector<bool> with_program = host::controllers_of(choices);
  Reader& reader = readers.emplace_back(Reader{0, std::vector<bool>(symbols), {}});
  for (std::uint32_t controller = 0; controller < tables::split_names(plant.tables.controller_names).size();
       ++controller) {
    if (controller >= with_program.size() || !with_program[controller]) reader.controllers.push_back(controller);
  }
  for (std::uint32_t symbol = 0; symbol < symbols; ++symbol) {
    const std::uint32_t controller = tables::controller_of(plant.tables, symbol);
    reader.events[symbol] =
        !names.is_operation(symbol) && (controller >= with_program.size() || !with_program[controller]);
  }
  return "";
}

std::vector<std::string> files_of_programs(const Setup& setup, const host::PlantProgram& plant) {
  std::vector<std::string> files;
  const auto chosen = host::programs_of(plant, setup.run);
  for (const host::ProgramChoice& choice : std::get<host::ProgramChoices>(chosen)) files.push_back(choice.file);
  return files;
}

/// The longest time without a change of an operation up to `end`, of each station.
std::map<std::uint32_t, Time> station_pauses(const BaseCase& base, Time end) {
  std::map<std::uint32_t, Time> longest;
  std::map<std::uint32_t, Time> last;
  for (const Change& change : base.log.symbols) {
    if (!base.paced[change.of] || change.time > end) continue;
    const std::uint32_t station = base.stations[change.of];
    longest[station] = std::max(longest[station], change.time - last[station]);
    last[station] = change.time;
  }
  for (const auto& [station, time] : last_changes(base.log, base)) {
    longest[station] = std::max(longest[station], end - std::min(end, last[station]));
  }
  return longest;
}

}  // namespace

std::string without_severity(std::string text) {
  constexpr std::string_view kError = "error: ";
  if (text.starts_with(kError)) text.erase(0, kError.size());
  return text;
}

Ended run_logged(const Setup& setup, const host::PlantProgram& plant, const std::string& fault, Time at,
                 std::optional<Time> until, RunLog& log) {
  host::RunOptions run = setup.run;
  run.scenario = setup.scenario;
  run.fault = fault;
  run.fault_at = at;
  run.until = until;
  run.limit = setup.limit;
  run.end = &log.end;
  run.records = [&log](const trace::Record& record) { log.take(record); };
  std::ostringstream out;
  std::ostringstream err;
  Ended ended;
  ended.code = host::run(plant, run, out, err);
  ended.messages = err.str();
  return ended;
}

Time longest_pause(const RunLog& log, const std::vector<bool>& operations, Time end) {
  Time longest = 0;
  Time last = 0;
  for (const Change& change : log.symbols) {
    if (!operations[change.of] || change.time > end) continue;
    longest = std::max(longest, change.time - last);
    last = change.time;
  }
  return std::max(longest, end - last);
}

std::vector<bool> paced_operations(const RunLog& log, const std::vector<bool>& operations) {
  constexpr Time kLongest = tables::kSecond;
  constexpr std::size_t kLeast = 8;  // changes
  struct Rhythm {
    std::size_t changes = 0;
    Time last = 0;
    Time shortest = tables::kNever;
    Time longest = 0;
  };
  std::vector<Rhythm> rhythms(operations.size());
  for (const Change& change : log.symbols) {
    Rhythm& rhythm = rhythms[change.of];
    const Time gap = change.time - std::exchange(rhythm.last, change.time);
    if (rhythm.changes++ == 0) continue;
    rhythm.shortest = std::min(rhythm.shortest, gap);
    rhythm.longest = std::max(rhythm.longest, gap);
  }
  std::vector<bool> paced = operations;
  bool any = false;
  for (std::uint32_t symbol = 0; symbol < operations.size(); ++symbol) {
    const Rhythm& rhythm = rhythms[symbol];
    const bool beats = rhythm.changes >= kLeast && rhythm.longest <= kLongest &&
                       2 * rhythm.longest <= 3 * rhythm.shortest && log.end - rhythm.last <= 2 * rhythm.longest;
    if (beats) paced[symbol] = false;
    any = any || (paced[symbol] && rhythm.changes != 0);
  }
  return any ? paced : operations;
}

std::map<std::uint32_t, Time> last_changes(const RunLog& log, const BaseCase& base) {
  std::map<std::uint32_t, Time> last;
  for (std::uint32_t symbol = 0; symbol < base.operations.size(); ++symbol) {
    if (base.paced[symbol]) last.emplace(base.stations[symbol], 0);
  }
  for (const Change& change : log.symbols) {
    if (base.paced[change.of]) last[base.stations[change.of]] = change.time;
  }
  return last;
}

std::optional<BaseCase> run_base(const Setup& setup, const host::PlantProgram& plant, const trace::PlantNames& names,
                                 std::vector<std::uint32_t> stations, int pauses, std::string& error, int& code) {
  BaseCase base;
  base.stations = std::move(stations);
  const auto fail = [&](std::string message, int exit_code) {
    error = std::move(message);
    code = exit_code;
    return std::nullopt;
  };
  error = find_readers(setup, plant, names, base);
  if (!error.empty()) return fail(without_severity(error), host::kBadInput);
  if (base.readers.empty()) {
    return fail("a campaign tests a PLC program: give one with `--program`, or the PLC with `--link`", host::kBadInput);
  }
  for (std::uint32_t symbol = 0; symbol < plant.tables.symbols.size(); ++symbol) {
    base.operations.push_back(names.is_operation(symbol));
    if (names.is_operation(symbol)) base.symbol_of.emplace(names.symbol(symbol), symbol);
  }
  base.in_virtual_time = setup.run.links.empty();
  base.window = setup.window.value_or(base.in_virtual_time ? 0 : 2 * setup.run.cycle);
  RunLog first;
  const auto is_stopped = [] { return host::stop_requested().load(); };
  Ended ended = run_logged(setup, plant, "", 0, std::nullopt, first);
  if (is_stopped()) return fail("ended by a signal in the base case", host::kFindings);
  if (ended.code == host::kFindings) {
    return fail(
        fmt::format("the base case `{}` does not pass, so no fault is tried:\n{}", setup.scenario, ended.messages),
        ended.code);
  }
  if (ended.code != host::kGood) return fail(without_severity(ended.messages), ended.code);
  base.case_end = first.end;
  base.paced = paced_operations(first, base.operations);
  const Time pause = longest_pause(first, base.paced, first.end);
  const auto changes = [&](const Change& change) { return base.operations[change.of]; };
  if (std::none_of(first.symbols.begin(), first.symbols.end(), changes)) {
    return fail(
        fmt::format("in the base case `{}` no operation changes, so faults cannot show; let its scenario do what "
                    "starts the program",
                    setup.scenario),
        host::kBadInput);
  }
  for (const std::string& file : files_of_programs(setup, plant)) {
    if (!program::is_still_loaded(file)) continue;
    return fail(
        fmt::format("the program `{}` keeps its variables when it is closed, so each run would change the next one: "
                    "compile it with `-fno-gnu-unique`",
                    file),
        host::kBadInput);
  }
  ended = run_logged(setup, plant, "", 0, first.end + pauses * pause, base.log);
  if (is_stopped()) return fail("ended by a signal in the base case", host::kFindings);
  if (ended.code != host::kGood) {
    return fail(
        fmt::format("the base case `{}` passes, but not in the {} after its end, in which each run with a fault goes "
                    "on:\n{}",
                    setup.scenario, trace::seconds(pauses * pause), ended.messages),
        ended.code);
  }
  base.pause = longest_pause(base.log, base.paced, first.end + pause);
  base.pauses = station_pauses(base, first.end + pause);
  base.recorded = recorded(base.log, names, base.operations, "without the fault");
  return base;
}

}  // namespace symplant::campaign
