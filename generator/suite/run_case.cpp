// Runs one case of a suite: the scenario, then the comparison with its reference trace.
#include "suite/run_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "compare/formats.hpp"
#include "compare/words.hpp"
#include "recording/read.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/run.hpp"
#include "symplant/tables/pattern.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/whole_file.hpp"

namespace symplant::suite {
namespace {

namespace fs = std::filesystem;
using Verdict = Result::Verdict;
using Reference = Result::Reference;

class CaseRun {
 public:
  CaseRun(const Setup& setup, const host::PlantProgram& plant, const std::string& trace)
      : setup_(setup), plant_(plant), trace_(trace) {}

  Result run(const std::string& name, Speed speed) {
    result_.name = name;
    result_.speed = speed;
    const auto begin = std::chrono::steady_clock::now();
    play();
    std::error_code ignored;
    fs::remove(trace_, ignored);
    result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return std::move(result_);
  }

 private:
  void play() {
    // A PLC is as the case before has left it.
    const bool has_before = !setup_.run.links.empty() && !setup_.suite.before.empty();
    if (has_before && run_scenario(setup_.suite.before, "") != host::kGood) {
      return fail(fmt::format("`{}` has failed, so that the case cannot begin", setup_.suite.before));
    }
    const int code = run_scenario(setup_.suite.scenario(result_.name), trace_);
    result_.verdict = code == host::kGood       ? Verdict::passed
                      : code == host::kFindings ? Verdict::failed
                                                : Verdict::error;
    if (result_.verdict != Verdict::error) judge_trace();
  }

  /// Leaves its messages as those of the result. Returns the exit code.
  int run_scenario(const std::string& scenario, const std::string& trace) {
    host::RunOptions run = setup_.run;
    run.scenario = scenario;
    run.trace = trace;
    run.limit = setup_.suite.limit;
    run.end = &end_;
    std::ostringstream out;
    std::ostringstream err;
    const int code = host::run(plant_, run, out, err);
    result_.messages = message_lines(err.str());
    return code;
  }

  void judge_trace() {
    const trace::PlantNames names(plant_.tables);
    Chosen chosen{&setup_.suite.how.only, {}};
    for (std::uint32_t symbol = 0; symbol < plant_.tables.symbols.size(); ++symbol) {
      if (names.is_operation(symbol)) chosen.operations.insert(names.symbol(symbol));
    }
    if (chooses_nothing(names)) return fail("`only` of suite.json matches no symbol and no location of the plant");
    std::ifstream trace(trace_, std::ios::binary);
    const std::string text = reference_text(trace, chosen, end_);
    if (text.empty()) return fail("the trace of the run is empty: is the folder of temporary files full?");
    const std::string path = setup_.suite.reference(result_.name, result_.speed);
    std::ifstream file(path, std::ios::binary);
    if (file) {
      compare_with(file, path, text);
    } else if (setup_.update) {
      write(path, text, Reference::added);
    }
    if (!setup_.update || result_.reference != Reference::differs) return;
    write(path, text, Reference::updated);
  }

  /// Why a reference trace is not one of this plant; empty: it is.
  std::string other_plant(const std::string& path, const std::string& text) const {
    std::ifstream file(path, std::ios::binary);
    const std::string expected = plant_of(file);
    std::istringstream stream(text);
    const std::string actual = plant_of(stream);
    if (expected == actual) return "";
    return fmt::format("`{}` is of the plant `{}`, not `{}`; `--update` writes it again", path, expected, actual);
  }

  bool chooses_nothing(const trace::PlantNames& names) const {
    const std::vector<std::string>& only = setup_.suite.how.only;
    const auto matches = [&](std::string_view name) {
      return std::any_of(only.begin(), only.end(),
                         [&](const std::string& pattern) { return tables::matches_pattern(name, pattern); });
    };
    for (std::uint32_t symbol = 0; symbol < plant_.tables.symbols.size(); ++symbol) {
      if (matches(names.symbol(symbol))) return false;
    }
    for (std::uint32_t location = 0; location < plant_.tables.material.locations(); ++location) {
      if (matches(names.location(location))) return false;
    }
    return !only.empty();
  }

  void compare_with(std::istream& file, const std::string& path, const std::string& text) {
    const recording::ReadRecording expected = recording::read_recording(file, path);
    if (!expected.error.empty()) {
      if (setup_.update) return write(path, text, Reference::updated);
      return fail(expected.error + "; `--update` writes it again");
    }
    const std::string other = other_plant(path, text);
    if (!other.empty() && setup_.update) return write(path, text, Reference::updated);
    if (!other.empty()) return fail(other);
    std::istringstream stream(text);
    const recording::ReadRecording actual = recording::read_recording(stream, "this run");
    if (!actual.error.empty()) return fail(actual.error);
    if (expected.recording.series.empty() && actual.recording.series.empty()) {  // a program that does nothing
      result_.reference = Reference::same;
      return;
    }
    compare::Options how = setup_.suite.how;
    how.only.clear();  // both have what is chosen
    compare::Comparison comparison = compare::compare(expected.recording, actual.recording, how);
    if (!comparison.error.empty()) return fail(comparison.error);
    compare::drop_unsure(comparison);
    result_.reference = comparison.differences.empty() ? Reference::same : Reference::differs;
    if (comparison.differences.empty()) return;
    if (!setup_.update) result_.verdict = Verdict::failed;
    for (const compare::Difference& difference : comparison.differences) {
      if (result_.messages.size() < kMostMessages) result_.messages.push_back(compare::sentence(difference));
    }
    result_.messages.push_back(compare::summary(comparison));
    result_.chart = compare::chart_data(comparison);
  }

  /// A case that failed has no reference trace: that would accept what failed.
  void write(const std::string& path, const std::string& text, Reference reference) {
    if (result_.verdict != Verdict::passed) {
      result_.messages.push_back("no reference trace is written: the case has failed");
      return;
    }
    if (const std::string error = trace::write_whole_file(path, text); !error.empty())
      return fail(fmt::format("cannot write `{}`: {}", path, error));
    result_.reference = reference;
  }

  void fail(const std::string& message) {
    result_.verdict = Verdict::error;
    result_.messages.push_back(message);
  }

  const Setup& setup_;
  const host::PlantProgram& plant_;
  const std::string trace_;
  tables::Time end_ = 0;  ///< of the run of the case
  Result result_;
};

}  // namespace

Result run_case(const Setup& setup, const host::PlantProgram& plant, const std::string& name, Speed speed,
                const std::string& trace) {
  return CaseRun(setup, plant, trace).run(name, speed);
}

}  // namespace symplant::suite
