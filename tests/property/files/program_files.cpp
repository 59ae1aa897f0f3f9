// Draws plants and scenarios, writes files, runs the tool on them, and compares.
#include "property/files/program_files.hpp"

#include <chrono>
#include <filesystem>
#include <iostream>

#include "property/files/files_tally.hpp"
#include "property/files/fixture.hpp"
#include "property/files/plant_json.hpp"
#include "property/files/random_scenario.hpp"
#include "property/files/shrink_files.hpp"
#include "property/random_plant.hpp"

namespace symplant::property::files {
namespace {

/// One plant in this many runs in the program itself.
constexpr std::uint64_t kByProgram = 25;
/// One in this many is also repeated from its trace.
constexpr std::uint64_t kReplayed = 4;

FileCase random_case(std::uint64_t draw) {
  DrawOptions options;
  options.behaviours = false;
  options.most_units = 100;
  options.values = draw % 3 == 0;
  options.naming_rules = false;  // the files of these plants have no naming rule
  FileCase it;
  it.plant = random_plant(draw, options).text;
  make_sayable(it.plant, draw);
  it.style.seed = draw;
  it.style.decorated = draw % 5 != 0;
  it.seed = draw % 3 == 0 ? 0 : draw * 0x9E37'79B9'7F4A'7C15;
  DrawnScenario scenario = random_scenario(draw, it.seed, build(it.plant).plant);
  it.steps = std::move(scenario.steps);
  it.until = scenario.until;
  return it;
}

std::string kind_of(const std::string& difference) { return difference.substr(0, difference.find(' ')); }

class Program {
 public:
  explicit Program(const Options& options) : options_(options) {}

  int run() {
    const auto begin = std::chrono::steady_clock::now();
    int disagreements = 0;
    constexpr int kMostReports = 3;
    for (std::uint64_t draw = options_.seed; draw < options_.seed + options_.plants; ++draw) {
      FileCase it = random_case(draw);
      if (options_.print) return print(it);
      const std::string text = one(it, draw);
      if (text.empty()) continue;
      if (options_.wrong) {
        std::cout << "plant " << draw << " disagrees: " << text << "\n";
        return 0;
      }
      report(it, draw, text);
      if (++disagreements == kMostReports) break;
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    if (!options_.quiet) tally_.print(std::cout, took.count());
    if (options_.wrong) std::cout << "no plant disagrees\n";
    if (disagreements > 0 || options_.wrong) return 1;
    return tally_.missed(std::cout, options_.minimum) ? 1 : 0;
  }

 private:
  static void print(const Files& files) {
    for (const std::string& list : files.lists) std::cout << list;
    std::cout << files.plant << files.scenario;
    if (files.until) std::cout << "until " << *files.until << " ns\n";
  }
  static int print(const FileCase& it) {
    Counts counts;
    const Files files = files_of(it, counts);
    print(files);
    return 0;
  }

  /// The difference; empty if there is no difference.
  std::string one(FileCase& it, std::uint64_t draw) {
    Counts counts;
    auto wanted = expected(it, counts);
    if (!wanted && it.until) {
      // The plant runs too long after the last step.
      it.until.reset();
      counts = {};
      wanted = expected(it, counts);
    }
    if (!wanted) {
      ++tally_.left_aside;
      return {};
    }
    const Files files = files_of(it, counts);
    tally_.add(it, *wanted);
    tally_.counts += counts;
    const bool by_program = !options_.tool.empty() && draw % kByProgram == 0;
    if (by_program) ++tally_.by_program;
    return difference(*wanted, files, by_program ? options_.tool : "", draw % kReplayed == 0);
  }

  /// Of the run of some files from the wanted one, and of its replay from it.
  std::string difference(const Outcome& wanted, const Files& files, const std::string& tool, bool replays) {
    std::string text = files::difference(wanted, workshop_.run(files, tool));
    return text.empty() && replays ? workshop_.replay() : text;
  }

  std::string difference(const FileCase& it, Outcome& wanted, Files& files) {
    Counts counts;
    const auto outcome = expected(it, counts);
    if (!outcome) return {};
    wanted = *outcome;
    files = files_of(it, counts);
    return difference(wanted, files, "", true);
  }

  void report(const FileCase& found, std::uint64_t draw, const std::string& text) {
    std::cout << "seed " << draw << " disagrees: " << text << "\n" << workshop_.said() << std::flush;
    Outcome wanted;
    Files files;
    const FileCase small = shrink(found, [&](const FileCase& candidate) {
      return kind_of(difference(candidate, wanted, files)) == kind_of(text);
    });
    const std::string what = difference(small, wanted, files);
    std::cout << "shrunk:\n";
    print(files);
    std::cout << "seed " << small.seed << "\nthen: " << what << "\n" << workshop_.said() << std::flush;
    if (options_.fixtures.empty()) return;
    const auto folder = std::filesystem::path(options_.fixtures) / ("seed_" + std::to_string(draw));
    write_fixture(folder.string(), files, wanted, what);
  }

  const Options& options_;
  Workshop workshop_;
  FilesTally tally_;
};

}  // namespace

int run_files(const Options& options) {
  return options.replay.empty() ? Program(options).run() : replay_fixtures(options.replay);
}

}  // namespace symplant::property::files
