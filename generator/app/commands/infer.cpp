// symplant infer: proposes a naming rule for lists.
#include "infer/infer.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <filesystem>
#include <istream>
#include <memory>
#include <ostream>
#include <set>
#include <string_view>
#include <utility>

#include "app/commands.hpp"
#include "app/infer_links.hpp"
#include "app/infer_samples.hpp"
#include "app/infer_text.hpp"
#include "app/options.hpp"
#include "app/own_file.hpp"
#include "diag/visible_text.hpp"
#include "naming/naming_file.hpp"
#include "naming/naming_text.hpp"
#include "naming/profiles.hpp"
#include "symplant/host/exit_codes.hpp"
#include "text/shell_word.hpp"

namespace symplant::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLinksFile = "links.csv";

struct InferOptions {
  std::vector<std::string> files;
  std::string output;
  std::vector<std::size_t> accept;
  std::vector<std::size_t> refuse;
  bool force = false;
  PlantOptions plant;
};

/// The ready naming rules, and those that the user gives.
std::vector<name::Naming> known_rules(const InferInputs& read) {
  std::vector<name::Naming> known;
  for (const naming::Profile& profile : naming::profiles()) {
    known.push_back(std::move(*naming::read_naming(profile.text()).naming));
  }
  known.insert(known.end(), read.given.begin(), read.given.end());
  return known;
}

/// Whether a file is a ready naming rule, as `symplant naming NAME -o FILE` writes it.
bool is_profile(std::string_view file) {
  return std::ranges::any_of(naming::profiles(),
                             [&](const naming::Profile& profile) { return profile.text() == file; });
}

/// Runs the command.
class Infer {
 public:
  Infer(const InferOptions& options, Context& context)
      : options_(options), context_(context), report_out_(options.output.empty() ? context.err : context.out) {}

  void run() {
    auto read = read_samples(context_, options_.files, options_.plant);
    if (!read) return;
    if (read->samples.empty()) {
      return fail(
          "no address in the lists is one of an input or output: infer needs lists with the addresses of inputs and "
          "outputs");
    }
    report_out_ << infer_lists_text(read->derived.plant);
    infer::Proposal proposal = infer::infer(read->samples, known_rules(*read));
    if (options_.plant.verbose) {
      for (const std::string& step : proposal.steps) context_.err << "decided: " << diag::visible(step) << "\n";
    }
    const infer::Report report = infer::report_of(proposal.naming, read->samples);
    if (!take_answers(report)) return;
    report_out_ << infer_report_text(report, answers_);
    ask(report);
    name::Counts score = report.score;
    if (!answers_.refused.empty() || !answers_.accepted.empty()) {
      proposal.naming = answered(std::move(proposal.naming), report, *read);
      score = infer::score_of(proposal.naming, read->samples);
    }
    if (proposal.naming.rules.empty()) {
      report_out_ << "the names follow no rule: no naming rule was written; describe the devices in plant.json\n";
      context_.exit_code = host::kFindings;
      return;
    }
    if (!write(proposal.naming, report, read->files)) return;
    report_out_ << infer_score_text(score) << "; next: " << next_command(read->plant) << "\n";
  }

 private:
  void fail(const std::string& message) {
    context_.err << "error: " << diag::visible(message) << "\n";
    context_.exit_code = host::kBadInput;
  }

  /// Turns the numbers of an option into indexes. False if one of them is out of range.
  bool take(const std::vector<std::size_t>& numbers, std::string_view option, std::string_view things,
            std::size_t first, std::size_t count, std::set<std::size_t>& indexes) {
    for (const std::size_t number : numbers) {
      if (number > first && number <= first + count) {
        indexes.insert(number - first - 1);
        continue;
      }
      fail(count == 0 ? fmt::format("{} {}: there are no {}", option, number, things)
                      : fmt::format("{} {}: the {} are {} to {}", option, number, things, first + 1, first + count));
      return false;
    }
    return true;
  }

  bool take_answers(const infer::Report& report) {
    const std::size_t links = report.correspondences.size();
    return take(options_.refuse, "--refuse", "correspondences", 0, links, answers_.refused) &&
           take(options_.accept, "--accept", "questions", links, report.questions.size(), answers_.accepted);
  }

  /// A `y` or `n` of the person; nothing at the end of the answers.
  std::optional<bool> answer(const std::string& question) {
    for (std::string line;
         context_.err << question << " [y/n] " << std::flush, std::getline(*context_.answers, line);) {
      if (line == "y" || line == "Y") return true;
      if (line == "n" || line == "N") return false;
    }
    context_.err << "\n";
    return std::nullopt;
  }

  /// Asks for each line of the report on a terminal. The end of the answers leaves the rest as it is.
  void ask(const infer::Report& report) {
    if (context_.answers == nullptr || !options_.accept.empty() || !options_.refuse.empty()) return;
    for (std::size_t i = 0; i < report.correspondences.size(); ++i) {
      const auto yes = answer(fmt::format("{}: {}?", i + 1, correspondence_text(report.correspondences[i])));
      if (!yes) return;
      if (!*yes) answers_.refused.insert(i);
    }
    for (std::size_t i = 0; i < report.questions.size(); ++i) {
      const infer::Question& question = report.questions[i];
      const auto yes = answer(fmt::format("{}: {}: {}?", report.correspondences.size() + i + 1,
                                          question.about_interlocks() ? "pair these interlocks" : "always on",
                                          question_text(question)));
      if (!yes) return;
      if (*yes) answers_.accepted.insert(i);
    }
  }

  /// The rule with the answers in it. If interlocks are to be paired, the search begins again with them; what was
  /// refused is refused there, too.
  name::Naming answered(name::Naming naming, const infer::Report& report, const InferInputs& read) {
    const bool pairs_interlocks = std::any_of(answers_.accepted.begin(), answers_.accepted.end(),
                                              [&](std::size_t i) { return report.questions[i].about_interlocks(); });
    if (!pairs_interlocks) return infer::with_answers(naming, report, answers_.refused, answers_.accepted);
    naming = infer::infer(read.samples, known_rules(read), infer::Interlocks::paired).naming;
    const infer::Report again = infer::report_of(naming, read.samples);
    std::set<std::string_view> refused_texts;
    for (const std::size_t i : answers_.refused) refused_texts.insert(report.correspondences[i].what);
    std::set<std::size_t> refused;
    for (std::size_t i = 0; i < again.correspondences.size(); ++i) {
      if (refused_texts.contains(again.correspondences[i].what)) refused.insert(i);
    }
    return infer::with_answers(infer::with_answers(naming, again, refused, {}), report, {}, answers_.accepted);
  }

  bool write(const name::Naming& naming, const infer::Report& report, const std::vector<std::string>& inputs) {
    const bool links = !naming.links.empty() || !report.open_links.empty();
    if (options_.output.empty()) return write_result(context_, "", base::whole(naming::naming_text(naming)), inputs);
    if (overwrites(context_, options_.output, inputs)) return false;
    const std::string text = with_mark(links ? naming::naming_text(naming, kLinksFile) : naming::naming_text(naming));
    const auto before = context_.files.read(options_.output);
    if (before && !before->empty() && !options_.force && !is_unedited(*before) && !is_profile(*before)) {
      fail("`" + options_.output + "` already exists, and may contain your work: name another file, or use --force");
      return false;
    }
    if (links && !write_links(naming, report, inputs)) return false;
    return write_result(context_, options_.output, base::whole(text), inputs);
  }

  /// An existing file of links may have rows that a person has filled in: it is kept.
  bool write_links(const name::Naming& naming, const infer::Report& report, const std::vector<std::string>& inputs) {
    const std::string file = (fs::path(options_.output).parent_path() / kLinksFile).generic_string();
    if (fs::path(file).lexically_normal() == fs::path(options_.output).lexically_normal()) {
      fail("`" + options_.output + "` is the file of the links: name another file for the naming rule");
      return false;
    }
    const base::TextSource text = base::whole(infer_links_text(naming.links, report.open_links));
    if (context_.files.exists(file) && !context_.files.holds(file, text)) {
      if (!naming.links.empty()) {
        fail("`" + file + "` already exists, and may contain your work: move it, or write to another folder");
        return false;
      }
      report_out_ << "kept " << diag::visible(file) << ", which already exists\n";
      return true;
    }
    if (!write_result(context_, file, text, inputs)) return false;
    if (!report.open_links.empty()) {
      report_out_ << fmt::format("{}: {} to fill in by hand\n", diag::visible(file),
                                 counted(report.open_links.size(), "link"));
    }
    return true;
  }

  std::string next_command(const std::vector<std::string>& files) const {
    std::string command = "symplant check";
    for (const std::string& file : files) command += " " + text::shell_word(diag::visible(file));
    const std::string naming = options_.output.empty() ? "naming.json" : options_.output;
    return command + " --naming " + text::shell_word(diag::visible(naming));
  }

  const InferOptions& options_;
  Context& context_;
  std::ostream& report_out_;
  InferAnswers answers_;
};

}  // namespace

void add_infer(CLI::App& app, Context& context) {
  auto options = std::make_shared<InferOptions>();
  CLI::App* command =
      app.add_subcommand("infer", "Propose a naming rule for symbol lists, and report what it explains");
  command
      ->add_option("FILE", options->files,
                   "symbol lists of one plant, folders with them, or its plant.json: all its lists")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "write the naming rule to this file, and links.csv into its folder if links are open (default: "
                   "standard output)")
      ->type_name("FILE");
  command->add_option("--refuse", options->refuse, "correspondences to leave out, by their numbers in the report")
      ->delimiter(',')
      ->type_name("N,..");
  command
      ->add_option("--accept", options->accept,
                   "inputs to make constant, or interlocks to pair, by the numbers of the questions")
      ->delimiter(',')
      ->type_name("N,..");
  command->add_flag("--force", options->force, "replace a naming rule that was edited");
  add_plant_options(*command, options->plant);
  command->footer(
      "On a terminal, infer asks about each line of the report unless --accept or --refuse is given. The result never\n"
      "pairs fewer symbols than a ready naming rule, or than that of --naming.\n"
      "Examples:\n  symplant infer symbols.csv -o naming.json\n"
      "  symplant infer symbols.csv -o naming.json --refuse 3,5 --accept 12\n"
      "  symplant infer plant.json --verbose > naming.json");
  command->callback([options, &context] { Infer(*options, context).run(); });
}

}  // namespace symplant::app
