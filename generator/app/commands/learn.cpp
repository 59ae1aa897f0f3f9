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
#include <memory>
#include <ostream>
#include <set>
#include <string>
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

struct LearnFormat {
  const char* name;
  void (*write)(const learn::Learned&, base::TextSink&);
};
constexpr std::array<LearnFormat, 3> kLearnFormats{
    {{"text", learn::write_text}, {"json", learn::write_json}, {"html", learn::write_html}}};

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
    auto compiled = compile_for(context_, options_.plant, options_.how);
    if (!compiled) return;
    const auto all = std::make_shared<LearnedPlant>(LearnedPlant{std::move(*compiled), {}, {}});
    context_.kept = all;
    const model::PlantModel& plant = all->compiled.plant;
    for (const std::string& path : options_.recordings) {
      auto recording = read_recording_file(path, options_.reading, context_);
      if (!recording) return;
      observe::Matched matched = observe::match(plant, *recording);
      all->inputs.push_back({std::move(*recording), std::move(matched)});
    }
    all->learned = learn::learn_times(plant, all->inputs);
    all->learned.pairs = learn::learn_pairs(plant, all->inputs, options_.seed);
    const learn::Learned& learned = all->learned;
    std::set<std::size_t> refused;
    if (!take_refused(learned.pairs, refused)) return;
    if (!learned.groups.empty() && !write_times(learned)) return;
    if (!learned.pairs.pairs.empty() && !write_links(learned, refused)) return;
    const auto format = std::find_if(kLearnFormats.begin(), kLearnFormats.end(),
                                     [&](const LearnFormat& one) { return options_.format == one.name; });
    write_result(context_, "", [&](base::TextSink& sink) { format->write(learned, sink); }, {});
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

  /// Writes the file for plant.json.
  bool write_times(const learn::Learned& learned) {
    if (options_.output.empty()) return true;
    if (!write_own(options_.output, with_mark(learn::learned_file(learned)), learned)) return false;
    context_.err << fmt::format("wrote {}; plant.json takes it by \"include\": [\"{}\"]\n",
                                diag::visible(options_.output), diag::visible(learn::file_name(options_.output)));
    return true;
  }

  bool write_links(const learn::Learned& learned, const std::set<std::size_t>& refused) {
    if (options_.links.empty()) return true;
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
      "Exit codes: 0 something was learned; 1 the recordings show no move and no pair; 2 bad input or usage.\n"
      "Examples:\n  symplant learn plant.json monday.jsonl tuesday.jsonl -o learned.json\n"
      "  symplant learn plant.json scope.csv --rename names.csv --format html > times.html");
  command->callback([options, &context] { Learn(*options, context).run(); });
}

}  // namespace symplant::app
