// Runs folders of files and compares the results with the stored ones.
#include "property/files/fixture.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "property/files/plant_json.hpp"

namespace symplant::property::files {
namespace {

namespace fs = std::filesystem;

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

int replay_one(const fs::path& folder, Workshop& workshop) {
  const auto content = [&](const char* name) { return read_file((folder / name).string()); };
  Files files{{}, content("plant.json"), content("scenario.json"), 0, {}};
  for (const char* name : kListNames) {
    if (fs::exists(folder / name)) files.lists.push_back(content(name));
  }
  Outcome wanted;
  std::istringstream run(content("run.txt"));
  std::string word;
  for (std::int64_t value = 0; run >> word >> value;) {
    if (word == "seed") files.seed = static_cast<std::uint64_t>(value);
    if (word == "until") files.until = value;
    if (word == "code") wanted.code = static_cast<int>(value);
  }
  wanted.trace = lines_of(content("expected.trace"));
  wanted.findings = lines_of(content("expected.findings"));
  wanted.verdicts = lines_of(content("expected.verdicts"));
  const std::string text = difference(wanted, workshop.run(files, ""));
  if (text.empty()) return 0;
  std::cout << folder.string() << ": " << text << "\n" << workshop.said();
  return 1;
}

}  // namespace

void write_fixture(const std::string& folder, const Files& files, const Outcome& wanted, const std::string& about) {
  const fs::path at(folder);
  fs::create_directories(at);
  const auto write = [&](const char* name, const std::string& content) { write_file((at / name).string(), content); };
  for (std::size_t i = 0; i < files.lists.size(); ++i) write(kListNames[i], files.lists[i]);
  write("plant.json", files.plant);
  write("scenario.json", files.scenario);
  std::string run = "seed " + std::to_string(files.seed) + "\ncode " + std::to_string(wanted.code) + "\n";
  if (files.until) run += "until " + std::to_string(*files.until) + "\n";
  write("run.txt", run);
  write("expected.trace", joined(wanted.trace));
  write("expected.findings", joined(wanted.findings));
  write("expected.verdicts", joined(wanted.verdicts));
  write("about.txt", about + "\n");
}

int replay_fixtures(const std::string& folder) {
  std::vector<fs::path> folders;
  if (fs::exists(fs::path(folder) / "plant.json")) folders.emplace_back(folder);
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_directory()) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  Workshop workshop;
  int failed = 0;
  for (const fs::path& one : folders) failed += replay_one(one, workshop);
  std::cout << folders.size() << " folders, " << failed << " failed\n";
  return failed == 0 && !folders.empty() ? 0 : 1;
}

}  // namespace symplant::property::files
