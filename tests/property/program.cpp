// Runs random plants through engine and reference, or stored cases.
#include "property/program.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "lower/lower.hpp"
#include "property/compare.hpp"
#include "property/options.hpp"
#include "property/random_plant.hpp"
#include "property/shrink.hpp"
#include "property/tally.hpp"
#include "property/text_form.hpp"

namespace symplant::property {
namespace {

namespace fs = std::filesystem;

bool of_the_model(const Difference& difference) { return difference.text.starts_with("the model"); }

/// The smallest case that still shows a difference of that kind.
Case smallest(const Case& found, const Difference& first) {
  return shrink(found, [&](const Case& candidate) {
    reference::Counters counters;
    RunCounts counts;
    const auto difference = run_case(candidate, counters, counts);
    return difference && of_the_model(*difference) == of_the_model(first);
  });
}

void report(const Options& options, std::uint64_t seed, const Case& found, const Difference& first) {
  std::cout << "seed " << seed << " disagrees after action " << first.action << ": " << first.text << "\n"
            << std::flush;
  Case shrunk = found;
  if (first.action < shrunk.actions.size()) shrunk.actions.resize(first.action + 1);
  shrunk = smallest(shrunk, first);
  reference::Counters counters;
  RunCounts counts;
  const auto difference = run_case(shrunk, counters, counts);
  const std::string what = difference ? difference->text : "no difference when shrunk";
  const std::string text = write_case(shrunk);
  std::cout << "shrunk:\n" << text << "then: " << what << "\n" << std::flush;
  if (options.fixtures.empty()) return;
  fs::create_directories(options.fixtures);
  std::ofstream file(fs::path(options.fixtures) / ("seed_" + std::to_string(seed) + ".case"));
  file << "# " << what.substr(0, what.find('\n')) << "\n" << text;
}

int replay_file(const fs::path& path) {
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::string fault;
  const auto the_case = read_case(text, fault);
  if (!the_case) {
    std::cout << path.string() << ": " << fault << "\n";
    return 1;
  }
  const model::Derived derived = build(the_case->plant);
  if (!runnable(derived)) {
    std::cout << path.string() << ": no valid plant\n";
    for (const auto& found : derived.evidence.faults) std::cout << found.pointer << ": " << found.message << "\n";
    return 1;
  }
  reference::Counters counters;
  RunCounts counts;
  const auto difference = run_case(*the_case, counters, counts);
  if (!difference) return 0;
  std::cout << path.string() << ": after action " << difference->action << ": " << difference->text << "\n";
  return 1;
}

int replay(const std::string& path) {
  if (!fs::is_directory(path)) return replay_file(path);
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(path)) {
    if (entry.path().extension() == ".case") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  int failed = 0;
  for (const fs::path& file : files) failed += replay_file(file);
  std::cout << files.size() << " cases, " << failed << " failed\n";
  return failed == 0 ? 0 : 1;
}

int run(const Options& options) {
  Tally tally;
  int disagreements = 0;
  constexpr int kMostReports = 5;
  const auto begin = std::chrono::steady_clock::now();
  for (std::uint64_t seed = options.seed; seed < options.seed + options.plants; ++seed) {
    DrawnPlant drawn = random_plant(seed, {.values = options.values});
    Case drawn_case{std::move(drawn.text), random_stimulus(seed, drawn.model)};
    if (options.print) {
      std::cout << write_case(drawn_case);
      return 0;
    }
    tally.add_plant(drawn);
    const lower::EngineTables tables = lower::lower(drawn.model);
    const tables::PlantTables rows = tables.tables();
    const auto difference = run_case(drawn.model, rows, drawn_case.actions, true, tally.counters, tally.run);
    if (!difference) continue;
    if (options.wrong) {
      std::cout << "plant " << seed << " disagrees: " << difference->text << "\n";
      return 0;
    }
    report(options, seed, drawn_case, *difference);
    if (++disagreements == kMostReports) break;
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  if (!options.quiet) tally.print(std::cout, took.count());
  if (options.wrong) std::cout << "no plant disagrees\n";
  if (disagreements > 0 || options.wrong) return 1;
  return tally.missed(std::cout, options.minimum) ? 1 : 0;
}

}  // namespace

int run_program(const std::vector<std::string>& arguments) {
  const auto options = read_options(arguments);
  if (!options) return 2;
  return options->replay.empty() ? run(*options) : replay(options->replay);
}

}  // namespace symplant::property
