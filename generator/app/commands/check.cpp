// symplant check: naming and model diagnostics.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <memory>
#include <numeric>
#include <ostream>
#include <span>
#include <utility>

#include "app/baseline_file.hpp"
#include "app/check_html.hpp"
#include "app/commands.hpp"
#include "app/min_score.hpp"
#include "app/options.hpp"
#include "app/rename_map.hpp"
#include "app/score_json.hpp"
#include "app/score_text.hpp"
#include "check/catalogue.hpp"
#include "diag/annotations.hpp"
#include "diag/json.hpp"
#include "diag/junit.hpp"
#include "diag/sarif.hpp"
#include "diag/text.hpp"
#include "diag/visible_text.hpp"
#include "findings/selection.hpp"
#include "score/score.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/tables/version.hpp"

namespace symplant::app {
namespace {

struct CheckOptions {
  std::vector<std::string> plants;
  PlantOptions plant;
  std::string format = "text";
  std::string output;
  std::string fail_on = "error";
  std::vector<std::string> select;
  std::vector<std::string> ignore;
  std::vector<std::string> min_score;
  std::string baseline;
  std::string write_baseline;
  std::string rename_map;
};

findings::Selection selection_of(const CheckOptions& options) {
  const auto selection = findings::Selection::of(options.select, options.ignore);
  if (!selection) throw CLI::ValidationError("--select/--ignore", diag::visible(selection.error()));
  return *selection;
}

std::vector<MinScore> min_scores_of(const CheckOptions& options) {
  std::vector<MinScore> required;
  for (const std::string& text : options.min_score) {
    const auto read = read_min_score(text);
    if (!read) throw CLI::ValidationError("--min-score", diag::visible(read.error()));
    required.push_back(*read);
  }
  return required;
}

bool reaches(const diag::Diagnostics& diagnostics, diag::Severity least) {
  const auto all = diagnostics.all();
  return std::any_of(all.begin(), all.end(), [&](const auto& finding) { return finding.severity >= least; });
}

/// Whether a list was not read only because it has no symbol: an empty tag table among others is no error.
bool is_empty_list(const diag::Diagnostics& diagnostics) {
  const auto all = diagnostics.all();
  return all.size() == 1 && all.front().rule->slug == "header-alone";
}

void make_notes(diag::Diagnostics& diagnostics) {
  for (diag::Diagnostic& finding : diagnostics.take()) {
    finding.severity = diag::Severity::note;
    diagnostics.add(std::move(finding));
  }
}

/// "no findings, 3 left out by --ignore".
std::string selected_text(const diag::Diagnostics& findings) {
  std::string text = count_text(findings);
  const diag::LeftOutByOption& left_out = findings.left_out();
  if (left_out.not_selected != 0) text += fmt::format(", {} left out by --select", left_out.not_selected);
  if (left_out.ignored != 0) text += fmt::format(", {} left out by --ignore", left_out.ignored);
  if (left_out.baseline != 0) text += fmt::format(", {} in the baseline", left_out.baseline);
  if (left_out.consequences != 0) text += fmt::format(" and {} that follow from them", left_out.consequences);
  return text;
}

/// "io.csv: TIA Portal tag table (workbook), 689 rows; identifier 1 `Name`, ..." for each list.
std::string lists_text(const model::PlantModel& plant) {
  std::string text;
  for (const model::PlantList& list : plant.lists) {
    const read::SymbolTable& table = *list.table;
    text +=
        fmt::format("{}: {}, {} row{}{}{}\n", diag::visible(table.source->path()), table.title, table.rows.size(),
                    table.rows.size() == 1 ? "" : "s", table.summary.empty() ? "" : "; ", diag::visible(table.summary));
  }
  return text;
}

/// Under a custom rule its score, the number of facets and findings; under the built-in one how many names follow it,
/// the number of devices and findings, and the score on a second line.
std::string result_lines(const std::string& list, const model::PlantModel& plant, const score::PlantScore& score,
                         const diag::Diagnostics& findings) {
  const std::string scored = score_text(score.total);
  if (plant.pairing != nullptr) {
    return fmt::format("{}: {}; {} facet{}; {}\n", list, scored, plant.units.size(), plant.units.size() == 1 ? "" : "s",
                       selected_text(findings));
  }
  const std::size_t internal = std::accumulate(plant.internal.begin(), plant.internal.end(), std::size_t{0});
  const std::string lists = plant.lists.size() == 1 ? "" : fmt::format(" of {} lists", plant.lists.size());
  return fmt::format("{0}: {1}\n{0}: {2} of {3} I/O names{4} follow {5}, {6} device{7}{8}; {9}\n", list, scored,
                     score.named, plant.symbols.size(), lists, plant.rule_text(), plant.units.size(),
                     plant.units.size() == 1 ? "" : "s",
                     internal == 0 ? "" : fmt::format(", {} internal row{}", internal, internal == 1 ? "" : "s"),
                     selected_text(findings));
}

/// Runs the command, plant by plant.
class Check {
 public:
  Check(const CheckOptions& options, Context& context)
      : options_(options),
        context_(context),
        selection_(selection_of(options)),
        required_(min_scores_of(options)),
        fail_on_(*diag::severity_of_name(options.fail_on)),
        baseline_(options.baseline, options.write_baseline, context),
        inputs_(options.plants) {}

  void run() {
    for (const std::string& word : selection_.former()) {
      context_.err << "warning: " << check::former_rule(word) << "\n";
    }
    if (!baseline_.open()) return;
    for (const std::string& plant : options_.plants) look_at(plant);
    look_at_baseline();
    if (!options_.rename_map.empty()) write_renames();
    write_result(context_, options_.output, base::whole(rendered()), inputs_);
  }

 private:
  void look_at(const std::string& file) {
    diag::Diagnostics diagnostics;
    Progress progress(context_.err, context_.progress);
    CompileOptions how = compile_options(context_, file, options_.plant);
    how.tables = false;
    how.selection = selection_;
    how.known = {baseline_.baseline(), file};
    auto compiled = compile(how, context_.files, progress, diagnostics);
    if (compiled) {
      const std::vector<std::string> read = compiled->plant.input_files();
      inputs_.insert(inputs_.end(), read.begin(), read.end());
    }
    if (compiled && options_.plant.verbose) report_decisions(context_, *compiled);
    if (options_.plant.verbose) report_ignored(context_, diagnostics);
    left_out_.by_description += diagnostics.ignored().size();
    left_out_.by_options += diagnostics.left_out().total();
    int code = reaches(diagnostics, fail_on_) ? host::kFindings : host::kGood;
    const bool empty_of_many = !compiled && options_.plants.size() > 1 && is_empty_list(diagnostics);
    if (empty_of_many) {
      make_notes(diagnostics);
      code = host::kGood;
    } else if (!compiled) {
      code = host::kBadInput;
    }
    context_.exit_code = std::max(context_.exit_code, code);
    if (options_.format == "text") {
      if (compiled) text_ += lists_text(compiled->plant);
      if (empty_of_many) text_ += fmt::format("{}: no symbols, left out\n", diag::visible(file));
      text_ += empty_of_many && !options_.plant.verbose
                   ? ""
                   : diag::render_text(diagnostics.all(), {.colour = context_.colour_out && options_.output.empty(),
                                                           .all = options_.plant.verbose,
                                                           .least = least_shown()});
    }
    if (compiled && !options_.rename_map.empty()) renames_.add(compiled->plant, diagnostics);
    std::vector<diag::Gate> gates =
        compiled ? look_at_score(file, compiled->plant, diagnostics) : std::vector<diag::Gate>();
    if (options_.format == "html" && !compiled) page_.add(file, diagnostics);
    if (options_.format != "text") {
      reports_.push_back({file, std::move(diagnostics), compiled.has_value() || empty_of_many, std::move(gates)});
    }
    if (compiled) context_.kept = std::make_shared<const Compiled>(std::move(*compiled));
  }

  void write_renames() {
    if (!write_result(context_, options_.rename_map, renames_.text(), inputs_)) return;
    context_.err << fmt::format(
        "{}: {} rename{} proposed, {} of them safe{}\n", diag::visible(options_.rename_map), renames_.size(),
        renames_.size() == 1 ? "" : "s", renames_.safe(),
        renames_.taken() == 0 ? "" : fmt::format("; {} left out, since the new name is taken", renames_.taken()));
  }

  void look_at_baseline() {
    diag::Diagnostics stale;
    baseline_.close(stale, inputs_);
    if (stale.all().empty()) return;
    if (reaches(stale, fail_on_)) context_.exit_code = std::max(context_.exit_code, int{host::kFindings});
    if (options_.format == "text") {
      text_ += diag::render_text(stale.all(), {.colour = context_.colour_out && options_.output.empty()});
    } else {
      reports_.push_back({options_.baseline, std::move(stale)});
    }
  }

  /// Notes are only counted, unless the options ask for them.
  diag::Severity least_shown() const {
    return options_.select.empty() ? std::min(fail_on_, diag::Severity::warning) : diag::Severity::note;
  }

  /// Shows the score of a plant, and returns whether it is as required.
  std::vector<diag::Gate> look_at_score(const std::string& file, const model::PlantModel& plant,
                                        const diag::Diagnostics& findings) {
    const score::PlantScore score = score::score_of(plant);
    if (options_.format == "text") {
      text_ += score_details(plant, score, options_.plant.verbose);
      text_ += result_lines(file, plant, score, findings);
    } else if (options_.format == "html") {
      page_.add(file, plant, score, findings);
    } else if (options_.format == "json") {
      scores_.push_back(score_json(file, plant, score));
    }
    std::vector<diag::Gate> gates;
    for (const MinScore& required : required_) {
      diag::Gate& gate = gates.emplace_back();
      gate.name = "min-score " + required.written;
      gate.failure = failed(required, score.total).value_or("");
      if (gate.failure.empty()) continue;
      context_.err << fmt::format("error: {}: {}\n", diag::visible(file), gate.failure);
      context_.exit_code = std::max(context_.exit_code, int{host::kFindings});
    }
    return gates;
  }

  std::string rendered() {
    if (options_.format == "json") return as_json();
    if (options_.format == "sarif") return as_sarif();
    if (options_.format == "junit") return as_junit();
    if (options_.format == "html") return page_.take();
    if (options_.format == "github") return diag::render_github(reports_, context_.folder);
    if (options_.format == "gitlab") return diag::render_gitlab(reports_, context_.folder);
    return std::move(text_);
  }

  std::string as_json() const {
    std::vector<std::span<const diag::Diagnostic>> all;
    for (const diag::Report& report : reports_) all.push_back(report.findings.all());
    return diag::render_json(all, left_out_, scores_) + "\n";
  }

  std::string as_sarif() const {
    std::size_t results = 0;
    for (const diag::Report& report : reports_) {
      results += report.findings.all().size() + report.findings.ignored().size();
    }
    if (results > diag::kMostSarifResults) {
      context_.err << fmt::format(
          "note: {} of {} findings are left out, the least severe ones: choose with --select, or use --format json\n",
          results - diag::kMostSarifResults, results);
    }
    return diag::render_sarif(reports_, {tables::version(), context_.folder, context_.exit_code});
  }

  std::string as_junit() const {
    diag::JunitOptions options{fail_on_, {}};
    for (const diag::RuleInfo* rule : check::catalogue()) {
      if (selection_.verdict(*rule) == findings::Selection::Verdict::reported) options.rules.push_back(rule);
    }
    return diag::render_junit(reports_, options);
  }

  const CheckOptions& options_;
  Context& context_;
  findings::Selection selection_;
  std::vector<MinScore> required_;
  diag::Severity fail_on_;
  BaselineFile baseline_;
  RenameMap renames_;
  CheckPage page_;
  std::vector<std::string> inputs_;
  std::vector<diag::Report> reports_;
  std::vector<std::string> scores_;  ///< of plants that could be read, as JSON
  diag::LeftOut left_out_;
  std::string text_;
};

}  // namespace

void add_check(CLI::App& app, Context& context) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command =
      app.add_subcommand("check", "Check names and models; show what the model loses with each finding");
  command->add_option("PLANT", options->plants, "plant.json files or symbol lists, each a separate plant")->required();
  command
      ->add_option(
          "--format", options->format,
          "text for people, json for programs, sarif for code scanning, junit for the tests of a build server, "
          "github for annotations of a workflow, gitlab for a Code Quality report, "
          "html for a page that others read (default: text)")
      ->check(CLI::IsMember({"text", "json", "sarif", "junit", "github", "gitlab", "html"}));
  command->add_option("--output", options->output, "write the result to this file")->type_name("FILE");
  command->add_option("--fail-on", options->fail_on, "the lowest severity that makes the exit code 1 (default: error)")
      ->check(CLI::IsMember({"error", "warning", "note"}));
  command
      ->add_option("--select", options->select,
                   "report only these rules: ids, slugs, prefixes of ids (SP4); errors that leave no valid plant are "
                   "always reported")
      ->type_name("RULE,..")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--ignore", options->ignore,
                   "do not report these rules; of --select and --ignore the more specific one applies")
      ->type_name("RULE,..")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--min-score", options->min_score,
                   "exit code 1 if less than this share of the BOOL I/O symbols is paired or accounted for: "
                   "paired=0.3,accounted=80%")
      ->type_name("SCORE,..")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--conventions", options->plant.conventions,
                   "a file with naming conventions by type, direction or pattern, besides those of plant.json (SP22)")
      ->type_name("FILE");
  CLI::Option* baseline =
      command->add_option("--baseline", options->baseline, "report only findings that this file does not have")
          ->type_name("FILE");
  command
      ->add_option("--write-baseline", options->write_baseline,
                   "write the findings to this file; if it exists, only remove what is fixed")
      ->type_name("FILE")
      ->excludes(baseline);
  command
      ->add_option("--rename-map", options->rename_map,
                   "write the new names that the findings propose to this file (CSV), for `symplant convert --renames`")
      ->type_name("FILE");
  add_plant_options(*command, options->plant);
  command->footer(
      "Examples:\n  symplant check symbols.csv\n  symplant check --fail-on warning --format json line1.csv line2.csv\n"
      "  symplant check --select SP2,SP3 --ignore no-address symbols.csv\n"
      "  symplant check --write-baseline baseline.json symbols.csv\n"
      "  symplant check --baseline baseline.json --fail-on warning symbols.csv\n"
      "  symplant check --format sarif --output symplant.sarif plant.json\n"
      "  symplant check --format junit --output symplant.xml plant.json");
  command->callback([options, &context] { Check(*options, context).run(); });
}

}  // namespace symplant::app
