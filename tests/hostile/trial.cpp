// One hostile input under every command.
#include "trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "process.hpp"
#include "text/utf8.hpp"

namespace symplant::hostile {
namespace {

namespace fs = std::filesystem;

void write(const std::string& path, const std::string& content) { std::ofstream(path, std::ios::binary) << content; }

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The files below a folder.
std::map<std::string, std::string> files_below(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files[entry.path().string()] = content_of(entry.path());
  }
  return files;
}

/// The output folder: some results exist there from an earlier run.
void make_out(const std::string& out) {
  fs::remove_all(out);
  fs::create_directories(out + "/generated");
  for (const char* file : {"/generated/tables_gen.cpp", "/result", "/trace", "/vcd", "/junit"})
    write(out + file, "old\n");
}

/// The slugs of errors in text output, at most three.
std::string errors_in(const std::string& text) {
  std::vector<std::string> slugs;
  std::size_t begin = 0;
  while (begin < text.size() && slugs.size() < 3) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::size_t open = text.rfind("[SP", end);
    const bool reported =
        open != text.npos && open > begin && text.substr(begin, end - begin).find("error: ") != text.npos;
    if (reported) {
      const std::size_t slug = text.find(' ', open) + 1;
      std::string word = text.substr(slug, text.find(']', slug) - slug);
      if (std::find(slugs.begin(), slugs.end(), word) == slugs.end()) slugs.push_back(std::move(word));
    }
    begin = end + 1;
  }
  return fmt::format("{}", fmt::join(slugs, ", "));
}

std::string words_of(const Run& run) {
  switch (run.code) {
    case 0:
      return "good";
    case 1:
      return "findings";
    case 2:
      return "refused";
    case 3:
      return "environment";
    default:
      return fmt::format("exit code {}", run.code);
  }
}

/// `for_people`: standard output is not a machine-readable format.
void judge(const Run& run, const Limits& limits, int highest, bool for_people, std::vector<std::string>& faults) {
  if (run.code < 0) faults.push_back(fmt::format("it was ended by signal {}", run.signal));
  if (run.code > highest) faults.push_back(fmt::format("exit code {}", run.code));
  if (run.cpu_seconds > limits.cpu_seconds) faults.push_back(fmt::format("it took {:.1f} s", run.cpu_seconds));
  if (run.peak_kilobytes > limits.peak_kilobytes)
    faults.push_back(fmt::format("it took {} MB", run.peak_kilobytes / 1024));
  if (run.ill_formed || (for_people && run.steers_terminal))
    faults.emplace_back("it wrote control characters, or no UTF-8");
  if (run.code >= 2 && run.out.empty() && run.err.empty()) faults.emplace_back("it was refused without a word");
}

/// Intermediate files must be complete or absent.
void judge_files(const std::map<std::string, std::string>& before, const std::map<std::string, std::string>& after,
                 bool refused, std::vector<std::string>& faults) {
  for (const auto& [path, content] : after) {
    if (path.ends_with(".tmp")) faults.push_back("it left " + path);
    const auto old = before.find(path);
    const bool same = old != before.end() && old->second == content;
    const bool reports = path.ends_with("/junit") && content.find("<error message=") != content.npos;
    if (refused && !same && !reports) faults.push_back("it was refused, and wrote " + path);
  }
  if (!refused) return;
  for (const auto& [path, content] : before) {
    if (after.count(path) == 0) faults.push_back("it was refused, and removed " + path);
  }
}

/// The first line that reports an error or an unsupported request; else the first line.
std::string line_about_it(const std::string& said) {
  std::string first;
  for (std::size_t begin = 0; begin < said.size();) {
    const std::size_t end = std::min(said.find('\n', begin), said.size());
    const std::string line = said.substr(begin, end - begin);
    if (line.find("error: ") != line.npos || line.find("cannot ") != line.npos) return line;
    if (first.empty()) first = line;
    begin = end + 1;
  }
  return first;
}

const char* file_of(Input::Kind kind) {
  switch (kind) {
    case Input::Kind::list:
      return "symbols.csv";
    case Input::Kind::plant:
      return "plant.json";
    case Input::Kind::scenario:
      break;
  }
  return "scenario.json";
}

}  // namespace

std::vector<Outcome> try_out(const std::string& tool, const Input& input, const Limits& limits,
                             const std::string& scratch) {
  const std::string in = scratch + "/in";
  const std::string out = scratch + "/out";
  fs::create_directories(in);
  write(in + "/symbols.csv", good_list());
  write(in + "/" + file_of(input.kind), input.text());

  std::vector<Outcome> outcomes;
  for (const Command& command : commands(input.kind)) {
    make_out(out);
    const auto before = files_below(out);
    std::vector<std::string> arguments{tool};
    arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
    const Run run = hostile::run(arguments, in, scratch);

    Outcome outcome{command.column, words_of(run), {}};
    const auto& words = command.arguments;
    const bool for_people = std::find(words.begin(), words.end(), "--format") == words.end();
    judge(run, limits, 2, for_people, outcome.faults);
    judge_files(before, files_below(out), run.code == 2, outcome.faults);
    if (run.code == 2 && for_people) {
      const std::string said = run.err + run.out;
      if (said.find(input.index == nullptr ? file_of(input.kind) : input.index) == said.npos)
        outcome.faults.push_back("no location is named: " + said.substr(0, 200));
    }
    if (command.column == "check" && command.arguments.size() == 2) {
      const std::string errors = errors_in(run.out + run.err);
      if (!errors.empty()) outcome.cell += ": " + errors;
    }
    for (std::string& fault : outcome.faults)
      fault = fmt::format("{}: {}: {}", input.what, fmt::join(command.arguments, " "), fault);
    outcomes.push_back(std::move(outcome));
  }
  fs::remove_all(in);
  fs::remove_all(out);
  return outcomes;
}

Outcome try_out(const std::string& tool, const Misuse& misuse, const Limits& limits, const std::string& scratch) {
  const std::string in = scratch + "/in";
  const std::string out = scratch + "/out";
  fs::create_directories(in);
  write(in + "/symbols.csv", good_list());
  make_out(out);
  const auto inputs_before = files_below(in);
  const auto before = files_below(out);
  std::vector<std::string> arguments{tool};
  arguments.insert(arguments.end(), misuse.arguments.begin(), misuse.arguments.end());
  const Run run = hostile::run(arguments, in, scratch);

  std::string line = line_about_it(run.err.empty() ? run.out : run.err);
  constexpr std::size_t kShown = 120;
  if (line.size() > kShown) {
    std::size_t end = kShown;
    while (text::is_continuation(line[end])) --end;
    line = line.substr(0, end) + " ...";
  }
  Outcome outcome{"", fmt::format("{} | {}", run.code, line), {}};
  judge(run, limits, 3, true, outcome.faults);
  if (run.code == 0 && run.err.empty()) outcome.faults.emplace_back("nothing was wrong with it");
  if (files_below(in) != inputs_before) outcome.faults.emplace_back("an input is another");
  judge_files(before, files_below(out), run.code == 2, outcome.faults);
  for (std::string& fault : outcome.faults) fault = fmt::format("{}: {}", misuse.what, fault);
  fs::remove_all(in);
  fs::remove_all(out);
  return outcome;
}

}  // namespace symplant::hostile
