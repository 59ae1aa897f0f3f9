// symplant learn: times and pairs of a plant from recordings.
#include "learn/learn.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <ostream>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "app/own_file.hpp"
#include "app/recording_options.hpp"
#include "diag/visible_text.hpp"
#include "learn/formats.hpp"
#include "learn/learned_file.hpp"
#include "learn/pairs.hpp"
#include "learn/pairs_formats.hpp"
#include "learn/words.hpp"
#include "symplant/host/exit_codes.hpp"

namespace symplant::app {
namespace {

struct LearnOptions {
  std::string plant;
  std::vector<std::string> recordings;
  std::string output;
  std::string links;
  std::vector<std::size_t> refuse;
  std::uint64_t seed = 0;
  std::string format = "text";
  bool force = false;
  PlantOptions how;
  RecordingOptions reading;
};

using WriteLearned = void (*)(const learn::Learned&, base::TextSink&);

struct LearnFormat {
  const char* name;
  WriteLearned write;
  WriteLearned write_verbose;
};
constexpr std::array<LearnFormat, 3> kLearnFormats{{{"text", learn::write_text, learn::write_long_text},
                                                    {"json", learn::write_json, learn::write_json},
                                                    {"html", learn::write_html, learn::write_html}}};

namespace fs = std::filesystem;

/// The path of a file as the `include` of a description in `plant` names it, with `/`, which every system accepts.
std::string include_path(const std::string& file, const std::string& plant) {
  std::error_code unknown;
  const fs::path folder = fs::weakly_canonical(fs::absolute(plant, unknown).parent_path(), unknown);
  const fs::path whole = fs::weakly_canonical(fs::absolute(file, unknown), unknown);
  const fs::path relative = whole.lexically_relative(folder);
  return (relative.empty() ? whole : relative).generic_string();
}

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code unknown;
  return fs::weakly_canonical(a, unknown) == fs::weakly_canonical(b, unknown);
}

/// What is learned from, kept until the program ends.
struct LearnedPlant {
  Compiled compiled;
  std::vector<learn::Input> inputs;
  learn::Learned learned;
};

/// Runs the command.
class Learn {
 public:
  Learn(const LearnOptions& options, Context& context) : options_(options), context_(context) {}

  void run() {
    if (!options_.output.empty() && !options_.links.empty() && is_same_file(options_.output, options_.links)) {
      return fail("-o and --links name the same file `" + options_.links + "`: give two");
    }
    auto compiled = compile_for(context_, options_.plant, options_.how);
    if (!compiled) return;
    const auto all = std::make_shared<LearnedPlant>(LearnedPlant{std::move(*compiled), {}, {}});
    context_.kept = all;
    const model::PlantModel& plant = all->compiled.plant;
    auto recordings = read_recording_files(options_.recordings, options_.reading, context_);
    if (!recordings) return;
    for (std::size_t i = 0; i < recordings->size(); ++i) {
      observe::Matched matched = observe::adopt(plant, (*recordings)[i]);
      const std::string stranger = no_symbol_error(options_.recordings[i], options_.plant, matched);
      if (!stranger.empty()) return fail(stranger);
      all->inputs.push_back({std::move((*recordings)[i]), std::move(matched)});
    }
    all->learned = learn::learn_times(plant, all->inputs);
    all->learned.pairs = learn::learn_pairs(plant, all->inputs, options_.seed);
    const learn::Learned& learned = all->learned;
    std::set<std::size_t> refused;
    if (!take_refused(learned.pairs, refused)) return;
    if (!write_times(learned) || !write_links(learned, refused)) return;
    for (const std::string& warning : learn::unused_warnings(learned)) {
      context_.err << "warning: " << diag::visible(warning) << "\n";
    }
    const auto format = std::find_if(kLearnFormats.begin(), kLearnFormats.end(),
                                     [&](const LearnFormat& one) { return options_.format == one.name; });
    write_result(
        context_, "",
        [&](base::TextSink& sink) { (options_.how.verbose ? format->write_verbose : format->write)(learned, sink); },
        {});
    if (!learned.groups.empty() || !learned.pairs.pairs.empty()) return;
    context_.err << "nothing was learned: the recordings show no move that the model explains, and no pair\n";
    context_.exit_code = host::kFindings;
  }

 private:
  void fail(const std::string& message) {
    context_.err << "error: " << diag::visible(message) << "\n";
    context_.exit_code = host::kBadInput;
  }

  /// Turns the numbers of --refuse into indexes. False if one of them is out of range.
  bool take_refused(const learn::Pairs& pairs, std::set<std::size_t>& refused) {
    for (const std::size_t number : options_.refuse) {
      if (number > 0 && number <= pairs.pairs.size()) {
        refused.insert(number - 1);
        continue;
      }
      fail(pairs.pairs.empty() ? fmt::format("--refuse {}: the recordings show no pairs", number)
                               : fmt::format("--refuse {}: the pairs are 1 to {}", number, pairs.pairs.size()));
      return false;
    }
    return true;
  }

  /// Says that a file is not written, and why.
  void leave_out(const std::string& file, std::string_view why) {
    context_.err << diag::visible(fmt::format("{} is not written: the recordings show no {}", file, why)) << "\n";
  }

  /// Writes the file for plant.json.
  bool write_times(const learn::Learned& learned) {
    if (options_.output.empty()) return true;
    if (learned.groups.empty()) {
      leave_out(options_.output, "times");
      return true;
    }
    if (!write_own(options_.output, with_mark(learn::learned_file(learned)), learned)) return false;
    const bool described = learned.plant->description_source != nullptr;
    context_.err << diag::visible(fmt::format("wrote {}; {} takes it by \"include\": [\"{}\"]", options_.output,
                                              described ? options_.plant : "a plant.json next to " + options_.plant,
                                              include_path(options_.output, options_.plant)))
                 << "\n";
    return true;
  }

  bool write_links(const learn::Learned& learned, const std::set<std::size_t>& refused) {
    if (options_.links.empty()) return true;
    if (learned.pairs.pairs.empty()) {
      leave_out(options_.links, "pairs that names do not show");
      return true;
    }
    const std::string text = learn::pairs_links(learned.pairs, *learned.plant, refused);
    if (context_.files.holds(options_.links, base::whole(text))) return true;
    if (!write_own(options_.links, text, learned)) return false;
    context_.err << fmt::format("wrote {}; the `links` of a naming rule takes it\n", diag::visible(options_.links));
    return true;
  }

  /// Writes a result. Only a file that symplant wrote may be one of those that the plant is made of, and an existing
  /// one that may be edited is kept.
  bool write_own(const std::string& file, const std::string& text, const learn::Learned& learned) {
    std::vector<std::string> inputs = options_.recordings;
    const auto read = context_.files.read(file);
    const std::string before = read ? *read : std::string();
    if (!has_mark(before)) {
      const std::vector<std::string> plant = learned.plant->input_files();
      inputs.insert(inputs.end(), plant.begin(), plant.end());
    }
    if (overwrites(context_, file, inputs)) return false;
    if (!before.empty() && !options_.force && !is_unedited(before)) {
      fail("`" + file + "` already exists, and may contain your work: name another file, or use --force");
      return false;
    }
    return write_result(context_, file, base::whole(text), {});
  }

  const LearnOptions& options_;
  Context& context_;
};

}  // namespace

void add_learn(CLI::App& app, Context& context) {
  auto options = std::make_shared<LearnOptions>();
  CLI::App* command =
      app.add_subcommand("learn", "Learn times, and pairs of operations and events, from recordings of the real plant");
  command->add_option("PLANT", options->plant, "plant.json, or a symbol list")->required();
  command->add_option("TRACE", options->recordings, "recordings, or traces of runs; each counts for what it has")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "write the times to this file, which plant.json includes (default: only the report)")
      ->type_name("FILE");
  command
      ->add_option("--links", options->links,
                   "write pairs of operations and events that names do not pair to this CSV, for a naming rule")
      ->type_name("FILE");
  command->add_option("--refuse", options->refuse, "pairs to leave out, by their numbers in the report")
      ->delimiter(',')
      ->type_name("N,..");
  command->add_option("--seed", options->seed, "of the random times with which pairs are compared (default: 0)")
      ->type_name("N");
  std::vector<std::string> names;
  names.reserve(kLearnFormats.size());
  for (const LearnFormat& format : kLearnFormats) names.emplace_back(format.name);
  command
      ->add_option("--format", options->format,
                   "of the report: text: a table for each kind of device; json: everything; html: a picture of each "
                   "time, what is odd first")
      ->check(CLI::IsMember(names));
  command->add_flag("--force", options->force, "replace a file of times or links that was edited");
  add_recording_options(*command, options->reading);
  add_plant_options(*command, options->how);
  command->footer(
      "Exit codes: 0 something was learned; 1 the recordings show no move and no pair; 2 bad input or usage, or no "
      "name in a recording is a symbol.\n"
      "Examples:\n  symplant learn plant.json monday.jsonl tuesday.jsonl -o learned.json\n"
      "  symplant learn plant.json scope.csv --rename names.csv --format html > times.html");
  command->callback([options, &context] { Learn(*options, context).run(); });
}

}  // namespace symplant::app
