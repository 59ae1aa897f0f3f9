// symplant run: runs a plant without a compiler.
#include "symplant/host/run.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "app/commands.hpp"
#include "app/described_programs.hpp"
#include "app/options.hpp"
#include "app/panel_view.hpp"
#include "base/large_memory.hpp"
#include "symplant/host/result_files.hpp"
#include "symplant/host/run_options.hpp"

namespace symplant::app {
namespace {

struct RunOptions {
  std::string plant;
  PlantOptions plant_options;
  host::RunOptions run;
};

/// Whether a symbol would be in a device without a fault of the list.
bool is_faulty(const model::PlantModel& plant, name::Account account) {
  return account == name::Account::task_taken || account == name::Account::unit_too_large ||
         (account == name::Account::no_rule && plant.levels() != nullptr);
}

/// Lines about what the tables do not contain: rows that are not I/O, and symbols in no device.
std::vector<std::string> more(const model::PlantModel& plant) {
  std::vector<std::string> lines;
  std::string internal;
  std::size_t count = 0;
  for (std::size_t i = 0; i < model::kInternalReasons; ++i) {
    if (plant.internal[i] == 0) continue;
    count += plant.internal[i];
    internal += fmt::format("{}{} {}", internal.empty() ? "" : ", ", plant.internal[i],
                            model::internal_reason_text(static_cast<model::InternalReason>(i)));
  }
  if (count != 0) lines.push_back(fmt::format("internal: {} rows ({})", count, internal));
  std::size_t numeric = 0;
  std::size_t faulty = 0;
  std::size_t outside = 0;  // by a custom naming rule
  std::size_t follows = 0;
  std::size_t sensors = 0;
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.unit_of_device() != model::kNone) continue;
    if (symbol.account == model::Account::numeric) {
      ++numeric;
    } else if (symbol.account == model::Account::follows) {
      ++follows;
    } else if (symbol.account == model::Account::senses_parts) {
      ++sensors;
    } else {
      ++(is_faulty(plant, symbol.account) ? faulty : outside);
    }
  }
  if (outside != 0) {
    lines.push_back(fmt::format(
        "in no device: {} by the naming rule, which pairs them with nothing; the links still carry them", outside));
  }
  if (follows != 0) lines.push_back(fmt::format("in no device: {} driven by a condition (`follow`)", follows));
  if (sensors != 0) lines.push_back(fmt::format("in no device: {} driven by parts (sensors of `material`)", sensors));
  if (numeric != 0)
    lines.push_back(fmt::format(
        "in no device: {} numeric, since only BOOL symbols form states; the links still carry them", numeric));
  if (faulty != 0)
    lines.push_back(
        fmt::format("in no device: {} with faults, see `symplant check`; the links still carry them", faulty));
  return lines;
}

/// What a running plant needs of a compiled one: the rest is freed before the start.
class Prepared {
 public:
  Prepared(Compiled compiled, const std::string& plant_file)
      : tables_(std::move(compiled.tables)),
        rows_(tables_.tables()),
        description_(compiled.plant.description),
        view_(compiled.plant),
        programs_(*description_, plant_file),
        controllers_(std::move(compiled.plant.links)),
        more_(more(compiled.plant)),
        inputs_(compiled.plant.input_files()),
        more_views_(more_.begin(), more_.end()),
        input_views_(inputs_.begin(), inputs_.end()) {
    for (const description::LinkDescription& link : description_->links) links_.push_back({link.controller, link.url});
    for (const model::ControllerLink& link : controllers_) settings_.push_back(link.settings());
    for (const description::GivenCheck::Ignore& entry : description_->check.ignore) {
      if (!entry.finding.empty()) ignored_.push_back({entry.finding, entry.symbols, entry.until});
    }
  }
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;

  /// Refers to this object.
  host::PlantProgram program() const {
    return {.tables = rows_,
            .links = links_,
            .programs = programs_.rows(),
            .link_settings = settings_,
            .more = more_views_,
            .ignored = ignored_,
            .view = view_.view(),
            .inputs = input_views_};
  }

 private:
  const lower::EngineTables tables_;
  const tables::PlantTables rows_;
  const std::shared_ptr<const description::Description> description_;  ///< its texts are in links and settings
  const PanelView view_;
  const DescribedPrograms programs_;
  const std::vector<model::ControllerLink> controllers_;
  const std::vector<std::string> more_;
  const std::vector<std::string> inputs_;
  const std::vector<std::string_view> more_views_;
  const std::vector<std::string_view> input_views_;
  std::vector<host::DefaultLink> links_;
  std::vector<link::LinkSettings> settings_;
  std::vector<host::IgnoredFinding> ignored_;
};

/// What a plant may be read from, as far as it shows before it is read: itself, the naming rule, and each result file
/// whose name is in the text of a plant.json, which may have faults.
std::vector<std::string> possible_inputs(const Context& context, const std::string& plant, const std::string& naming,
                                         const host::RunOptions& run) {
  std::vector<std::string> files;
  if (!plant.empty()) files.push_back(plant);
  if (!naming.empty()) files.push_back(naming);
  if (std::filesystem::path(plant).extension() != ".json") return files;
  const auto text = context.files.read(plant);
  for (const std::string& file : {run.junit, run.findings, run.stats}) {
    const std::string name = std::filesystem::path(file).filename().string();
    if (text && !name.empty() && text->find(name) != std::string::npos) files.push_back(file);
  }
  return files;
}

}  // namespace

void add_run(CLI::App& app, Context& context) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Run the plant, with a PLC or in virtual time; no compiler is needed");
  command->add_option("PLANT", options->plant, "a plant.json or a symbol list")->required();
  host::add_run_options(*command, options->run);
  add_plant_options(*command, options->plant_options);
  command->footer(
      "Examples:\n  symplant run symbols.csv --link modbus-tcp-server://127.0.0.1:1502\n"
      "  symplant run plant.json --cycle 1ms --priority 50 --cpu 1 --lock-memory --stay-awake --stats stats.json\n"
      "  symplant run plant.json --until 10s --trace trace.jsonl\n"
      "  symplant run plant.json --link PLC1=modbus-tcp-server://:1502 --link PLC2=modbus-tcp-server://:1503\n"
      "  symplant run symbols.csv --program cell.so --scenario first_cycle.json\n"
      "  symplant run symbols.csv --scenario first_cycle.json --vcd run.vcd --junit report.xml\n"
      "  symplant run symbols.csv --scenario first_cycle.json --why LINE_P1_CLAMP1 --why LINE_P1_CLAMP1_I_CLOSED");
  command->callback([options, &context] {
    std::optional<Compiled> compiled;
    const std::vector<std::string> possible =
        possible_inputs(context, options->plant, options->plant_options.naming, options->run);
    const std::vector<std::string_view> inputs(possible.begin(), possible.end());
    context.exit_code =
        host::with_results(options->run, options->plant, context.out, context.err, [&](host::ResultFiles& files) {
          files.replace_unless_among(inputs);
          compiled = compile_for(context, options->plant, options->plant_options);
          return context.exit_code;
        });
    if (!compiled) return;
    const Prepared prepared(std::move(*compiled), options->plant);
    compiled.reset();
    base::return_freed_memory();
    context.exit_code = host::run(prepared.program(), options->run, context.out, context.err);
  });
}

void fail_run(const CLI::App& app, std::string_view error, const Context& context) {
  const CLI::App* const command = app.get_subcommand("run");
  if (!command->parsed()) return;
  const auto first = [&](const char* name) {
    const auto& results = command->get_option(name)->results();
    return results.empty() ? std::string() : results.front();
  };
  const host::RunOptions files = host::result_files_of(*command);
  const std::vector<std::string> possible = possible_inputs(context, first("PLANT"), first("--naming"), files);
  const std::vector<std::string_view> inputs(possible.begin(), possible.end());
  host::fail_unread_run(files, inputs, "symplant run", error, context.out);
}

}  // namespace symplant::app
