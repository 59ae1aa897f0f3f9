// The panel of a run.
#include "symplant/host/panel_run.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "symplant/host/exit_codes.hpp"
#include "symplant/host/load_scenario.hpp"
#include "symplant/host/words.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::host {
namespace {

std::string stem(const std::string& path) { return std::filesystem::path(path).stem().generic_string(); }

/// Reads the exercises; false, with a message on `err`, if one is not an exercise.
bool load_exercises(const PanelInput& input, std::vector<panel::ExerciseFile>& files, std::ostream& err) {
  for (const std::string& path : input.options.exercises) {
    auto scenario = load_scenario(path, input.names, input.carried, err);
    if (!scenario) return false;
    if (!scenario->exercise) {
      err << fmt::format("error: the scenario `{}` has no key `exercise` with a title\n", path);
      return false;
    }
    files.push_back({stem(path), std::make_shared<const scenario::Scenario>(std::move(*scenario))});
  }
  return true;
}

/// Creates the folder of the panel's files; false, with a message on `err`, if that fails.
bool make_folder(const std::string& folder, std::ostream& err) {
  if (folder.empty()) return true;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error && std::filesystem::is_directory(folder, error)) return true;
  err << fmt::format("error: cannot use `{}` as a folder of the panel: {}\n", folder,
                     error ? error.message() : "it is not a folder");
  return false;
}

std::string durations_text(const exec::Durations& durations) {
  return fmt::format(R"({{"p50":{},"p99":{},"p999":{},"max":{}}})", durations.p50, durations.p99, durations.p999,
                     durations.max);
}

}  // namespace

int open_panel(const PanelInput& input, Stage& stage, std::ostream& out, std::ostream& err,
               std::unique_ptr<panel::Panel>& panel) {
  if (!input.options.panel) return kGood;
  std::vector<panel::ExerciseFile> exercises;
  if (!load_exercises(input, exercises, err)) return kBadInput;
  if (!make_folder(input.options.panel->files, err)) return kEnvironment;
  std::vector<panel::LinkName> links;
  for (const OpenLink& open : input.links) links.push_back({open.link->url(), open.controller, open.choice.controller});
  auto opened =
      panel::Panel::open(*input.options.panel, {.names = input.names,
                                                .plant = stage.plant,
                                                .recorder = stage.recorder,
                                                .history = stage.history,
                                                .utilization = *stage.outputs.utilization(),
                                                .explainer = stage.explainer,
                                                .behaviours = input.program.behaviours,
                                                .carried = input.carried,
                                                .scenario = input.scenario,
                                                .player = stage.player ? &*stage.player : nullptr,
                                                .programs = stage.programs ? &*stage.programs : nullptr,
                                                .scenario_name = stem(input.options.scenario),
                                                .exercises = std::move(exercises),
                                                .links = std::move(links),
                                                .view = input.program.view,
                                                .seed = input.options.seed,
                                                .cycle = input.real ? input.options.cycle : 0,
                                                .with_plc = input.with_plc,
                                                .by_plc_clock = input.by_plc_clock,
                                                .paced = !input.real,
                                                .resumed = input.resumed,
                                                .log = [&console = input.console](const std::string& message) {
                                                  console.message("warning: " + message + "\n");
                                                }});
  if (const auto* error = std::get_if<link::LinkError>(&opened)) {
    err << "error: panel: " << error->message << "\n";
    return error->kind == link::LinkError::Kind::usage ? kBadInput : kEnvironment;
  }
  panel = std::get<std::unique_ptr<panel::Panel>>(std::move(opened));
  stage.outputs.show_on(*panel);
  if (panel->has_trainees()) {
    out << "panel, trainer: " << panel->link(panel::Role::trainer) << "\n";
    out << "panel, trainee: " << panel->link(panel::Role::trainee) << "\n";
    out << "panel, viewer: " << panel->link(panel::Role::viewer) << "\n";
  } else {
    out << "panel: " << panel->link() << "\n";
  }
  out.flush();
  return kGood;
}

std::vector<exec::LinkState> PanelStatus::states() const {
  std::vector<exec::LinkState> states;
  for (std::size_t i = 0; meter_ != nullptr && i < links_.size() && i < exec::CycleMeter::kMostLinks; ++i) {
    states.push_back(meter_->state(i));
  }
  return states;
}

std::string PanelStatus::text() {
  requests_.resize(links_.size());
  since_.resize(links_.size());
  std::string text = "\"links\":[";
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const link::LinkStatus status = links_[i].link->status();
    const std::uint64_t rate = status.requests - requests_[i];
    requests_[i] = status.requests;
    since_[i] = rate != 0 ? 0 : since_[i] + 1;
    const char* const state =
        meter_ != nullptr && i < exec::CycleMeter::kMostLinks ? state_name(meter_->state(i)) : "waiting";
    text +=
        fmt::format(R"({}{{"state":"{}","requests":{},"rate":{},"last":{},"losses":{}}})", i == 0 ? "" : ",", state,
                    status.requests, rate, status.requests == 0 ? "null" : fmt::format("{}", since_[i]), status.losses);
  }
  text += "],\"cycle\":";
  if (meter_ == nullptr) return text + "null";
  const exec::CycleStatistics cycles = meter_->statistics();
  text += fmt::format(R"({{"cycles":{},"overruns":{},"slipped":{},"late":{},"work":{},"histogram":[)", cycles.cycles,
                      cycles.overruns, cycles.slipped, durations_text(cycles.lateness), durations_text(cycles.work));
  bool first = true;
  for (const auto& [upper, count] : meter_->lateness.by_octave()) {
    text += fmt::format("{}[{},{}]", first ? "" : ",", upper, count);
    first = false;
  }
  return text + "]}";
}

}  // namespace symplant::host
