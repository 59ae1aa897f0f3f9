// The commands that each hostile input runs under, and invalid command lines.
#include <array>

#include "trial.hpp"

namespace symplant::hostile {
namespace {

std::vector<Command> commands_of(const std::string& file) {
  std::vector<Command> all{{"check", {"check", file}}, {"check", {"check", "--format", "json", file}}};
  for (const char* format : {"json", "table", "dot", "svg", "mermaid", "scxml", "html"}) {
    all.push_back({"model", {"model", "--format", format, "-o", "../out/result", file}});
  }
  all.push_back({"map", {"map", file}});
  all.push_back({"init", {"init", file}});
  all.push_back({"diff", {"diff", file, "symbols.csv", "--format", "markdown"}});
  all.push_back({"diff", {"diff", "symbols.csv", file, "--verbose"}});
  all.push_back({"diff", {"diff", file, file, "--format", "json", "-o", "../out/result"}});
  for (const char* result : {"../out/io.csv", "../out/io.txt", "../out/io.xlsx", "../out/io.xml", "../out/io.st"}) {
    all.push_back({"convert", {"convert", file, result, "--renamed", "../out/renames"}});
  }
  all.push_back({"convert", {"convert", file, "../out/io.st", "--dialect", "openplc"}});
  all.push_back(
      {"generate",
       {"generate", file, "-o", "../out/generated", "--behaviours", "../out/own", "--depfile", "../out/depfile"}});
  all.push_back({"run",
                 {"run", file, "--until", "1s", "--trace", "../out/trace", "--vcd", "../out/vcd", "--findings",
                  "../out/findings", "--stats", "../out/stats"}});
  return all;
}

const std::string& long_word() {
  static const std::string word(20'000, 'x');
  return word;
}

}  // namespace

std::span<const Command> commands(Input::Kind kind) {
  static const std::vector<Command> of_list = commands_of("symbols.csv");
  static const std::vector<Command> of_plant = commands_of("plant.json");
  static const std::vector<Command> of_scenario{
      {"run --scenario",
       {"run", "symbols.csv", "--scenario", "scenario.json", "--trace", "../out/trace", "--junit", "../out/junit"}}};
  switch (kind) {
    case Input::Kind::list:
      return of_list;
    case Input::Kind::plant:
      return of_plant;
    case Input::Kind::scenario:
      break;
  }
  return of_scenario;
}

std::span<const Misuse> misuses() {
  static const std::vector<Misuse> all{
      {"a folder as the list", {"check", "."}},
      {"a folder as plant.json", {"run", ".."}},
      {"a file that is not there", {"check", "none.csv"}},
      {"a file below a file", {"model", "symbols.csv/symbols.csv"}},
      {"a file name of 5,000 characters", {"map", std::string(5'000, 'x')}},
      {"an empty file name", {"check", ""}},
      {"a file that fails while it is read", {"check", "/proc/self/mem"}},
      {"a file without an end", {"check", "/dev/zero"}},
      {"a full disk: the result of `model`", {"model", "symbols.csv", "-o", "/dev/full"}},
      {"a full disk: the result of `check`", {"check", "symbols.csv", "--output", "/dev/full"}},
      {"a full disk: the trace", {"run", "symbols.csv", "--until", "1s", "--trace", "/dev/full"}},
      {"a full disk: the VCD file", {"run", "symbols.csv", "--until", "1s", "--vcd", "/dev/full"}},
      {"a full disk: the JUnit file", {"run", "symbols.csv", "--until", "1s", "--junit", "/dev/full"}},
      {"a full disk: the numbers of a run", {"run", "symbols.csv", "--until", "1s", "--stats", "/dev/full"}},
      {"a full disk: the depfile", {"generate", "symbols.csv", "-o", "../out/new", "--depfile", "/dev/full"}},
      {"a full disk: the state at the end", {"run", "symbols.csv", "--until", "1s", "--save", "/dev/full"}},
      {"generated code into a file", {"generate", "symbols.csv", "-o", "symbols.csv"}},
      {"generated code below a file", {"generate", "symbols.csv", "-o", "symbols.csv/below"}},
      {"generated code in a folder without write permission", {"generate", "symbols.csv", "-o", "/proc/generated"}},
      {"a result into a folder", {"model", "symbols.csv", "-o", "."}},
      {"a result over the input", {"model", "symbols.csv", "-o", "symbols.csv"}},
      {"a result over the input, by another name", {"init", "symbols.csv", "-o", "../in/symbols.csv"}},
      {"a trace over the input", {"run", "symbols.csv", "--until", "1s", "--trace", "symbols.csv"}},
      {"a converted list over the input", {"convert", "symbols.csv", "../in/symbols.csv"}},
      {"a full disk: a converted list", {"convert", "symbols.csv", "/dev/full", "--to", "tia-xlsx"}},
      {"a difference over an input", {"diff", "symbols.csv", "symbols.csv", "-o", "../in/symbols.csv"}},
      {"a full disk: a difference", {"diff", "symbols.csv", "symbols.csv", "-o", "/dev/full"}},
      {"two results in one file", {"run", "symbols.csv", "--until", "1s", "--trace", "../out/x", "--vcd", "../out/x"}},
      {"templates that are not there", {"generate", "symbols.csv", "-o", "../out/new", "--templates", "/dev/null"}},
      {"`explain` of no rule", {"explain", "no-such-rule\x1B[31m%n"}},
      {"`explain` of 20,000 characters", {"explain", long_word()}},
      {"`schema` of nothing", {"schema", "../../etc/passwd"}},
      {"an unknown command", {"\x1B[31m{{x}}"}},
      {"an unknown option", {"check", "--\xE2\x80\xAE", "symbols.csv"}},
      {"an unknown format", {"model", "--format", long_word(), "symbols.csv"}},
      {"an unknown encoding", {"check", "--encoding", "%n%n", "symbols.csv"}},
      {"an unknown kind of list", {"check", "--input-format", "*/", "symbols.csv"}},
      {"a pattern of 20,000 stars", {"model", "--device", repeated("*x", 10'000), "symbols.csv"}},
      {"an invalid time", {"run", "symbols.csv", "--until", "99999999999999999999s"}},
      {"a negative time", {"run", "symbols.csv", "--until", "-1s"}},
      {"a seed beyond 64 bits", {"run", "symbols.csv", "--until", "1s", "--seed", "18446744073709551616"}},
      {"a link that leads nowhere", {"run", "symbols.csv", "--link", "modbus-tcp-server://127.0.0.1:99999"}},
      {"a link of another kind", {"run", "symbols.csv", "--link", "file:///etc/passwd"}},
      {"a list as the state at the start", {"run", "symbols.csv", "--until", "1s", "--resume", "symbols.csv"}},
      {"a list as a trace", {"show", "symbols.csv", "symbols.csv"}},
      {"a panel at a port beyond 65535", {"run", "symbols.csv", "--panel", "127.0.0.1:99999"}},
      {"a panel at no address", {"run", "symbols.csv", "--panel", "%n%n"}},
      {"a panel's token that is easy to guess",
       {"run", "symbols.csv", "--panel", "127.0.0.1:0", "--panel-token", "symbols.csv"}},
      {"a panel's token without an end",
       {"run", "symbols.csv", "--panel", "127.0.0.1:0", "--panel-token", "/dev/zero"}},
      {"a file as the folder of a panel",
       {"run", "symbols.csv", "--panel", "127.0.0.1:0", "--panel-files", "symbols.csv"}},
      {"no arguments", {}},
  };
  return all;
}

}  // namespace symplant::hostile
