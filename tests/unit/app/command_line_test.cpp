// The command line: help, versions, usage errors, completion.
#include "app_support.hpp"
#include "check/catalogue.hpp"

namespace symplant::test {
namespace {

const std::vector<std::string> kCommands{"check", "explain", "rules",      "generate", "model",
                                         "map",   "run",     "completion", "man"};

TEST_CASE("An unknown command is reported with the nearest one") {
  MemoryFileSystem files;
  const ToolRun run = run_tool({"chek", "list.csv"}, files);
  CHECK(run.code == 2);
  CHECK(run.err == "error: unknown command `chek`; did you mean `check`?\n");
  CHECK(run_tool({"x"}, files).err == "error: unknown command `x`; `symplant --help` lists all\n");
  CHECK(contains(run_tool({}, files).err, "A subcommand is required"));
}

TEST_CASE("Every command has help with examples") {
  for (const std::string& command : kCommands) {
    INFO(command);
    const ToolRun run = run_lists({command, "--help"});
    CHECK(run.code == 0);
    CHECK(contains(run.out, "Examples:"));
    CHECK(contains(run.out, "symplant " + command));
    CHECK(run.err.empty());
  }
}

TEST_CASE("The help lists every command, and --version prints the version") {
  const ToolRun help = run_lists({"--help"});
  CHECK(help.code == 0);
  for (const std::string& command : kCommands) CHECK(contains(help.out, command));
  const ToolRun version = run_lists({"--version"});
  CHECK(version.code == 0);
  CHECK(contains(version.out, "symplant "));
}

TEST_CASE("An invalid command line gives exit code 2 and a message") {
  const std::vector<std::vector<std::string>> lines{
      {},
      {"dance"},
      {"check"},
      {"check", "clean.csv", "--fail-on", "sometimes"},
      {"check", "clean.csv", "--format", "pdf"},
      {"check", "clean.csv", "--colour"},
      {"explain"},
      {"rules", "--format", "pdf"},
      {"generate", "clean.csv"},
      {"generate", "-o", "plant"},
      {"model", "clean.csv", "--format", "yaml"},
      {"model"},
      {"map"},
      {"run"},
      {"completion", "fish"},
      {"run", "clean.csv", "--clock", "sundial"},
      {"run", "clean.csv", "--cycle", "soon"},
      {"run", "clean.csv", "--cycle", "0"},
      {"run", "clean.csv", "--cycle", "-1ms"},
      {"run", "clean.csv", "--until", "later"},
      {"run", "clean.csv", "--until", "-1s"},
      {"run", "clean.csv", "--seed", "many"},
      {"run", "clean.csv", "--link", "carrier-pigeon:"},
      {"check", "clean.csv", "--xy", "decimal"},
      {"check", "clean.csv", "--encoding", "morse"},
      {"check", "clean.csv", "--input-format", "tape"},
      {"model", "clean.csv", "--xy", "decimal"},
      {"map", "clean.csv", "--encoding", "morse"},
      {"run", "clean.csv", "--input-format", "tape"},
      {"explain", "SP999"},
      {"model", "clean.csv", "--device", "NOTHING*"},
  };
  for (const auto& line : lines) {
    std::string shown;
    for (const std::string& word : line) shown += word + " ";
    INFO("symplant " << shown);
    const ToolRun run = run_lists(line);
    CHECK(run.code == 2);
    CHECK_FALSE((run.err + run.out).empty());
  }
}

TEST_CASE("Whole numbers must match completely: no sign, no rest, not too large") {
  for (const char* wrong : {"-5", "-1", "+1", "1.5", "1e3", "5x", "0x10", " 1", "", "18446744073709551616"}) {
    for (const std::string option : {"--seed", "--rt-check"}) {
      INFO(option << " `" << wrong << "`");
      const ToolRun run = run_lists({"run", "clean.csv", option, wrong});
      CHECK(run.code == 2);
      CHECK(run.out.empty());
      CHECK(contains(run.err, option + ": "));
    }
  }
  CHECK(contains(run_lists({"run", "clean.csv", "--rt-check", "0"}).err, "`0` is not a whole number from 1 to "));
  CHECK(contains(run_lists({"run", "clean.csv", "--rt-check", "-5"}).err, "`-5` is not a whole number from 1 to "));
  CHECK(run_lists({"run", "clean.csv", "--seed", "18446744073709551615", "--until", "1s"}).code == 0);
}

TEST_CASE("If an error prevents all output, the last line counts the findings") {
  for (const std::string command : {"map", "model", "init", "run"}) {
    INFO(command);
    const ToolRun run = run_lists({command, "error.csv"});
    CHECK(run.code == 2);
    CHECK(run.out.empty());
    CHECK(contains(run.err, "\nerror.csv: 1 error; fix the errors first\n"));
    CHECK_FALSE(contains(run_lists({command, "warning.csv"}).err, "fix the errors"));
  }
  MemoryFileSystem files = lists();
  CHECK(contains(run_tool({"generate", "error.csv", "-o", "made"}, files).err,
                 "error.csv: 1 error; fix the errors first"));
}

TEST_CASE("Options without effect are reported as given") {
  const ToolRun run =
      run_lists({"run", "clean.csv", "--until", "1s", "--late", "catch-up", "--cycle", "10ms", "--on-loss", "hold"});
  CHECK(run.code == 0);
  CHECK(contains(run.err, "warning: `--cycle`, `--on-loss`, `--late` have no effect in virtual time; "));
}

TEST_CASE("A file size limit smaller than the header is rejected") {
  for (const char* small : {"1", "100", "1023"}) {
    const ToolRun run =
        run_lists({"run", "clean.csv", "--until", "1s", "--trace", "/dev/null", "--trace-limit", small});
    CHECK(run.code == 2);
    CHECK(contains(run.err, "is too small, since each file begins with a header: write 1k or more"));
  }
  CHECK(run_lists({"run", "clean.csv", "--until", "1s", "--trace", "/dev/null", "--trace-limit", "1k"}).code == 0);
}

TEST_CASE("Encoding names ignore case") {
  CHECK(run_lists({"check", "clean.csv", "--encoding", "UTF-8"}).code == 0);
  CHECK(run_lists({"check", "clean.csv", "--encoding", "utf-8"}).code == 0);
}

TEST_CASE("explain shows the page of every rule, by id and by slug") {
  for (const diag::RuleInfo* rule : check::catalogue()) {
    const ToolRun by_id = run_lists({"explain", std::string(rule->id)});
    CHECK(by_id.code == 0);
    CHECK(contains(by_id.out, diag::manual_page(*rule)));
    CHECK(run_lists({"explain", std::string(rule->slug)}).out == by_id.out);
  }
}

TEST_CASE("Completion offers every command and option") {
  for (const char* shell : {"bash", "zsh"}) {
    const ToolRun run = run_lists({"completion", shell});
    CHECK(run.code == 0);
    for (const std::string& command : kCommands) CHECK(contains(run.out, command));
    for (const char* option : {"--fail-on", "--depfile", "--device", "--until", "--xy"}) {
      INFO(option);
      CHECK(contains(run.out, option));
    }
  }
}

}  // namespace
}  // namespace symplant::test
