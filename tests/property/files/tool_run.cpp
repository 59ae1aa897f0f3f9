// The tool on the files of a case, in this process or in a separate one.
#include "property/files/tool_run.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include "base/file_system.hpp"
#include "property/files/plant_json.hpp"
#include "support/tool.hpp"

namespace symplant::property::files {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOutputs[] = {"trace.jsonl", "findings.jsonl", "junit.xml"};

int run_here(const std::vector<std::string>& arguments, std::string& said) {
  base::DiskFileSystem disk;
  test::ToolRun run = test::run_tool(arguments, disk);
  said = std::move(run.err);
  return run.code;
}

int run_apart(const std::string& tool, const std::vector<std::string>& arguments, const std::string& said_in,
              std::string& said) {
  std::string command = "'" + tool + "'";
  for (const std::string& argument : arguments) command += " '" + argument + "'";
  const int status = std::system((command + " > /dev/null 2> '" + said_in + "'").c_str());
  said = read_file(said_in);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Of acts and of further instants: Workshop::replay() judges them.
bool is_of_replay(const std::string& line) {
  const std::size_t key = line.find(',');
  return key != line.npos && (line.compare(key, 7, ",\"act\":") == 0 || line.compare(key, 11, ",\"instant\":") == 0);
}

/// "step 3 held", "requirement: r1 failed": for a step, without its expectation.
std::vector<std::string> verdicts_of(const std::string& junit) {
  std::vector<std::string> verdicts;
  for (std::size_t at = junit.find("<testcase"); at != junit.npos;) {
    const std::size_t next = junit.find("<testcase", at + 1);
    const std::string one = junit.substr(at, next == junit.npos ? next : next - at);
    const std::size_t name = one.find(" name=\"") + 7;
    const std::string text = one.substr(name, one.find('"', name) - name);
    const std::string who = text.starts_with("step ") ? text.substr(0, text.find(':')) : text;
    verdicts.push_back(who + (one.find("<failure") == one.npos ? " held" : " failed"));
    at = next;
  }
  return verdicts;
}

/// Each line, as far as both define it.
std::string line_difference(const char* of, const std::vector<std::string>& wanted, const std::vector<std::string>& got,
                            bool whole) {
  for (std::size_t i = 0; i < wanted.size() || i < got.size(); ++i) {
    const std::string no_line = "nothing";
    const std::string& a = i < wanted.size() ? wanted[i] : no_line;
    const std::string& b = i < got.size() ? got[i] : no_line;
    if (a == b || (!whole && b.starts_with(a) && b[a.size()] == ',')) continue;
    return std::string(of) + " " + std::to_string(i + 1) + ": wanted " + a + ", got " + b;
  }
  return {};
}

}  // namespace

Workshop::Workshop() {
  std::string pattern = (fs::temp_directory_path() / "symplant-files-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) std::abort();
  folder_ = pattern;
}

Workshop::~Workshop() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::vector<std::string> Workshop::arguments(const Files& files) const {
  std::vector<std::string> arguments = {"run",     path("plant.json"), "--scenario", path("scenario.json"),
                                        "--trace", path(kOutputs[0]),  "--findings", path(kOutputs[1]),
                                        "--junit", path(kOutputs[2]),  "--seed",     std::to_string(files.seed)};
  if (files.until) arguments.insert(arguments.end(), {"--until", std::to_string(*files.until) + "ns"});
  return arguments;
}

std::string Workshop::replay() {
  const std::string again = path("again.jsonl");
  fs::remove(again);
  const int code = run_here({"run", path("plant.json"), "--replay", path(kOutputs[0]), "--trace", again}, said_);
  if (code > 1) return "replay refused: exit code " + std::to_string(code);
  // What is written to such an operation is not in the trace.
  if (said_.find("changes an operation: the trace has the changed value") != said_.npos) return {};
  return line_difference("replay", lines_of(read_file(path(kOutputs[0]))), lines_of(read_file(again)), true);
}

Outcome Workshop::run(const Files& files, const std::string& tool) {
  for (const char* output : kOutputs) fs::remove(path(output));
  for (std::size_t i = 0; i < files.lists.size(); ++i) write_file(path(kListNames[i]), files.lists[i]);
  write_file(path("plant.json"), files.plant);
  write_file(path("scenario.json"), files.scenario);
  Outcome got;
  const std::vector<std::string> given = arguments(files);
  got.code = tool.empty() ? run_here(given, said_) : run_apart(tool, given, path("said.txt"), said_);
  got.trace = lines_of(read_file(path(kOutputs[0])));
  if (!got.trace.empty()) {
    got.header = got.trace.front();
    got.trace.erase(got.trace.begin());
    std::erase_if(got.trace, is_of_replay);
  }
  got.findings = lines_of(read_file(path(kOutputs[1])));
  got.verdicts = verdicts_of(read_file(path(kOutputs[2])));
  return got;
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_file(const std::string& path, const std::string& content) {
  std::ofstream(path, std::ios::binary) << content;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream from(text);
  for (std::string line; std::getline(from, line);) lines.push_back(line);
  return lines;
}

std::string difference(const Outcome& wanted, const Outcome& got) {
  if (got.code > 1) return "refused: exit code " + std::to_string(got.code);
  if (!wanted.header.empty() && wanted.header != got.header) {
    return "header: wanted " + wanted.header + ", got " + got.header;
  }
  std::string text = line_difference("trace", wanted.trace, got.trace, true);
  if (text.empty()) text = line_difference("finding", wanted.findings, got.findings, false);
  if (text.empty()) text = line_difference("verdict", wanted.verdicts, got.verdicts, true);
  if (text.empty() && wanted.code != got.code) {
    text = "code: wanted " + std::to_string(wanted.code) + ", got " + std::to_string(got.code);
  }
  return text;
}

}  // namespace symplant::property::files
