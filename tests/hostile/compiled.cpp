// Compiles the code generated from hostile lists, runs it, and reads every name back from its trace.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "inputs.hpp"
#include "process.hpp"

namespace {

using namespace symplant::hostile;
using Json = nlohmann::json;
namespace fs = std::filesystem;

struct Setting {
  std::string tool;
  std::string scratch;
  std::vector<std::string> compiler;  ///< its command line, without the sources
};

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool is_utf8(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::ignore).size() ==
         Json(text).dump(-1, ' ', false, Json::error_handler_t::replace).size();
}

/// The second cell of every row but the first, if the fifth is BOOL and the row is I/O: a separate reader for the
/// lists written in this file.
std::vector<std::string> names_in(const std::string& list) {
  std::vector<std::string> names;
  if (!is_utf8(list)) return names;  // its names are other ones
  std::vector<std::string> cells(1);
  bool quoted = false;
  bool first = true;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const char c = list[i];
    if (c == '"' && quoted && i + 1 < list.size() && list[i + 1] == '"') {
      cells.back() += list[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else if (c == '\n' && !quoted) {
      const bool is_bit = !first && cells.size() > 4 && cells[4] == "BOOL";
      if (is_bit && !cells[3].starts_with("%M")) names.push_back(cells[1]);
      first = false;
      cells.assign(1, "");
    } else {
      cells.back() += c;
    }
  }
  return names;
}

/// Switches every symbol on and off by force.
std::string scenario_of(const std::vector<std::string>& names) {
  Json on;
  Json off;
  for (const std::string& name : names) {
    on[name] = true;
    off[name] = false;
  }
  const Json steps = {{{"at", "0.1s"}, {"force", on}}, {{"plus", "0.1s"}, {"force", off}}};
  return Json{{"symplant-scenario", 1}, {"steps", steps}}.dump();
}

std::set<std::string> names_of_trace(const std::string& trace) {
  std::set<std::string> names;
  for (std::size_t begin = 0; begin < trace.size();) {
    const std::size_t end = std::min(trace.find('\n', begin), trace.size());
    const Json line = Json::parse(trace.substr(begin, end - begin));
    if (line.contains("symbol")) names.insert(line["symbol"].get<std::string>());
    begin = end + 1;
  }
  return names;
}

/// What is wrong with an input's generated plant; empty if it is correct, or if no code is generated.
std::string fault_of(const Setting& setting, const Input& input) {
  const std::string folder = setting.scratch + "/" + "plant";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string text = input.text();
  std::ofstream(folder + "/symbols.csv", std::ios::binary) << (input.kind == Input::Kind::plant ? good_list() : text);
  std::ofstream(folder + "/plant.json", std::ios::binary) << text;
  const std::string file = input.kind == Input::Kind::plant ? "plant.json" : "symbols.csv";
  const auto tool = [&](std::vector<std::string> words) {
    words.insert(words.begin(), setting.tool);
    return run(words, folder, setting.scratch);
  };
  if (tool({"generate", file, "-o", "generated"}).code != 0) return "";
  std::cout << input.what << std::endl;

  std::vector<std::string> compiler{setting.compiler.front(), "-Igenerated", "-o", "program"};
  for (const char* source : {"tables_gen", "main_gen"}) compiler.push_back("generated/" + std::string(source) + ".cpp");
  compiler.insert(compiler.end(), setting.compiler.begin() + 1, setting.compiler.end());
  const Run compiled = run(compiler, folder, setting.scratch);
  if (compiled.code != 0) return "it does not compile: " + compiled.err.substr(0, 2000);

  const std::vector<std::string> names = input.kind == Input::Kind::plant ? std::vector<std::string>{} : names_in(text);
  if (names.empty()) {  // of a description, or in another list format
    const Run started = run({"./program", "--until", "1s"}, folder, setting.scratch);
    return started.code == 0 ? "" : "it does not run: " + started.err;
  }
  std::ofstream(folder + "/scenario.json", std::ios::binary) << scenario_of(names);
  const Run ran = run({"./program", "--scenario", "scenario.json", "--trace", "trace"}, folder, setting.scratch);
  if (ran.code != 0) return "it does not run: " + ran.err.substr(0, 2000);
  const std::string trace = content_of(folder + "/trace");
  if (names_of_trace(trace) != std::set<std::string>(names.begin(), names.end()))
    return "a name is another in the trace";
  if (tool({"run", file, "--scenario", "scenario.json", "--trace", "other"}).code != 0) return "`run` does not run it";
  return content_of(folder + "/other") == trace ? "" : "`run` writes another trace";
}

}  // namespace

// hostile_compiled TOOL SCRATCH COMPILER FLAG...
int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const Setting setting{argv[1], argv[2], {argv + 3, argv + argc}};
  fs::remove_all(setting.scratch);
  fs::create_directories(setting.scratch);
  int faults = 0;
  for (const Input& input : inputs()) {
    if (input.large || input.kind == Input::Kind::scenario) continue;
    const std::string fault = fault_of(setting, input);
    if (fault.empty()) continue;
    std::cerr << "FAULT: " << input.what << ": " << fault << std::endl;
    ++faults;
  }
  fs::remove_all(setting.scratch);
  return faults == 0 ? 0 : 1;
}
