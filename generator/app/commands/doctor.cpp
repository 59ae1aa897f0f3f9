// symplant doctor: examines a link against a live PLC.
#include "symplant/link/doctor/doctor.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <memory>
#include <ostream>
#include <utility>

#include "app/commands.hpp"
#include "app/doctor_text.hpp"
#include "app/options.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/link/choice.hpp"
#include "symplant/tables/duration.hpp"

namespace symplant::app {
namespace {

constexpr tables::Time kLongestWatch = 24 * 3600 * tables::kSecond;

struct DoctorOptions {
  std::string plant;
  PlantOptions plant_options;
  std::vector<std::string> links;
  std::string format = "text";
  std::string output;
  bool all = false;
  link::doctor::Options examination;
};

/// The links to examine: those of the command line, else the plant's.
std::variant<std::vector<link::LinkChoice>, link::LinkError> links_of(const DoctorOptions& options,
                                                                      const model::PlantModel& plant,
                                                                      const tables::PlantTables& tables) {
  std::vector<link::LinkRequest> requests;
  for (const std::string& text : options.links) requests.push_back(link::parse_request(text));
  if (requests.empty()) {
    for (const description::LinkDescription& link : plant.description->links) {
      requests.push_back({link.controller, link.url});
    }
  }
  if (requests.empty())
    return link::LinkError{link::LinkError::Kind::usage, "the plant has no link: give `--link URL`"};
  auto chosen = link::choose_links(tables, requests);
  if (auto* choices = std::get_if<std::vector<link::LinkChoice>>(&chosen)) {
    for (link::LinkChoice& choice : *choices) {
      if (choice.controller < plant.links.size()) choice.settings = plant.links[choice.controller].settings();
    }
  }
  return chosen;
}

int exit_code_of(const link::LinkError& error) {
  return error.kind == link::LinkError::Kind::usage ? host::kBadInput : host::kEnvironment;
}

void examine(const DoctorOptions& options, Context& context) {
  auto made = compile_for(context, options.plant, options.plant_options);
  if (!made) return;
  const auto compiled = std::make_shared<const Compiled>(std::move(*made));
  context.kept = compiled;
  const tables::PlantTables tables = compiled->tables.tables();
  const auto chosen = links_of(options, compiled->plant, tables);
  const auto fail = [&](const link::LinkError& error) {
    context.err << "error: " << error.message << "\n";
    context.exit_code = exit_code_of(error);
  };
  if (const auto* error = std::get_if<link::LinkError>(&chosen)) return fail(*error);
  host::catch_signals();
  std::string text;
  for (const link::LinkChoice& choice : std::get<std::vector<link::LinkChoice>>(chosen)) {
    if (options.format == "text") {
      context.err << "examining " << choice.url << "\n";
      context.err.flush();
    }
    const auto examined = link::doctor::examine(choice, tables, options.examination);
    if (const auto* error = std::get_if<link::LinkError>(&examined)) return fail(*error);
    const auto& report = std::get<link::doctor::Report>(examined);
    text += options.format == "json" ? doctor_json(report, tables) : doctor_text(report, tables, options.all);
    const int code = !report.reached ? host::kEnvironment : has_findings(report) ? host::kFindings : host::kGood;
    context.exit_code = std::max(context.exit_code, code);
  }
  const int found = context.exit_code;
  if (write_result(context, options.output, base::whole(text), compiled->plant.input_files()))
    context.exit_code = found;
}

}  // namespace

void add_doctor(CLI::App& app, Context& context) {
  auto options = std::make_shared<DoctorOptions>();
  options->examination.stop = &host::stop_requested();
  CLI::App* command =
      app.add_subcommand("doctor", "Examine a link: connection, PLC, every mapped symbol; writes nothing");
  command->add_option("PLANT", options->plant, "a plant.json or a symbol list")->required();
  command->add_option("--link", options->links, "the link to examine (default: the plant's own links)")
      ->type_name("[CONTROLLER=]URL");
  command->add_flag(
      "--write-test", options->examination.write_test,
      "also invert each event in the PLC, see whether it stays, and restore it: only where no machine can "
      "move");
  command
      ->add_option_function<std::string>(
          "--for",
          [options](const std::string& text) {
            const auto time = tables::parse_duration(text);
            if (!time || *time > kLongestWatch) {
              throw CLI::ValidationError("--for", "`" + text + "` is not a time: write one such as 10s, at most 24h");
            }
            options->examination.duration = *time;
          },
          "how long to watch the PLC, or to listen for it (default: 5s)")
      ->type_name("T");
  command->add_option("--format", options->format, "text or json (default: text)")
      ->check(CLI::IsMember({"text", "json"}));
  command->add_option("-o,--output", options->output, "write the report to this file")->type_name("FILE");
  command->add_flag("--all", options->all, "list all symbols, not only those with a finding");
  add_plant_options(*command, options->plant_options);
  command->footer(
      "Exit codes: 0 nothing found; 1 findings; 2 bad input; 3 the PLC was not reached.\nExamples:\n"
      "  symplant doctor plant.json --link \"slmp://192.168.3.39:5000?family=q&events=direct\"\n"
      "  symplant doctor symbols.csv --link modbus-tcp-server://:1502 --for 30s --format json");
  command->callback([options, &context] { examine(*options, context); });
}

}  // namespace symplant::app
