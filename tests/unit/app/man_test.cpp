// Manual pages: the escaping of texts, and the pages of all commands.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "app/man_page.hpp"
#include "app/roff.hpp"
#include "app_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("roff shows a text unchanged") {
  CHECK(app::roff("plain (text) 50 %") == "plain (text) 50 %");
  CHECK(app::roff("--until 1s") == "\\-\\-until 1s");
  CHECK(app::roff("C:\\new\\table") == "C:\\(rsnew\\(rstable");
  CHECK(app::roff(".start\n.end a.b") == "\\&.start\n\\&.end a.b");
  CHECK(app::roff("'*' `x` \"y\" ^~") == "\\(aq*\\(aq \\(gax\\(ga \\(dqy\\(dq \\(ha\\(ti");
  CHECK(app::roff("").empty());
  CHECK(app::roff_bold("-o") == "\\fB\\-o\\fR");
}

/// The lines of a page that begin with this macro.
std::vector<std::string> lines_with(const std::string& page, const std::string& macro) {
  std::vector<std::string> lines;
  std::istringstream text(page);
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with(macro)) lines.push_back(line.substr(macro.size()));
  }
  return lines;
}

TEST_CASE("A page has the options of its command, by group, with what they need and exclude") {
  CLI::App tool("a tool", "symplant");
  CLI::App* command = tool.add_subcommand("paint", "Paint a plant");
  std::string value;
  command->add_option("PLANT", value, "a plant")->required();
  CLI::Option* color = command->add_option("-c,--color", value, "the color")->type_name("NAME");
  bool shine = false;
  command->add_flag("--shine", shine, "with light")->needs(color)->group("Light");
  command->add_option("--secret", value, "hidden")->group("");
  command->footer("Paint is wet.\nExamples:\n  symplant paint -c '#123'\n  .hidden");
  const std::string page = app::command_page(tool, *command);
  CHECK(lines_with(page, ".SH ") ==
        std::vector<std::string>{"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXIT STATUS", "EXAMPLES", "SEE ALSO"});
  CHECK(contains(page, "symplant\\-paint \\- Paint a plant\n"));
  CHECK(contains(page, "\\fBsymplant paint\\fR [\\fIOPTIONS\\fR] \\fIPLANT\\fR\n"));
  CHECK(contains(page, "Paint a plant.\n.PP\nPaint is wet.\n"));
  CHECK(contains(page, ".TP\n\\fB\\-c\\fR, \\fB\\-\\-color\\fR \\fINAME\\fR\nthe color.\n"));
  CHECK(contains(page, ".SS Light\n.TP\n\\fB\\-\\-shine\\fR\nwith light. Needs \\fB\\-\\-color\\fR.\n"));
  CHECK(contains(page, ".nf\nsymplant paint \\-c \\(aq#123\\(aq\n\\&.hidden\n.fi\n"));
  CHECK_FALSE(contains(page, "secret"));
}

TEST_CASE("man prints the page of the tool and of each command, and writes all of them to a folder") {
  MemoryFileSystem files;
  CHECK(run_tool({"man", "-o", "pages"}, files).code == 0);
  CHECK(files.files.at("pages/symplant.1") == run_tool({"man"}, files).out);
  CHECK(files.files.at("pages/symplant-check.1") == run_tool({"man", "check"}, files).out);
  const auto commands = lines_with(files.files.at("pages/symplant.1"), "\\fBsymplant\\-");
  CHECK(commands.size() == 2 * (files.files.size() - 1));  // under COMMANDS and under SEE ALSO
  for (const auto& [path, page] : files.files) {
    INFO(path);
    CHECK(std::all_of(page.begin(), page.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
  }
  CHECK(contains(files.files.at("pages/symplant-run.1"), "\\fB\\-\\-until\\fR \\fIT\\fR\n"));
}

TEST_CASE("man reports an unknown command, and a folder that cannot be written") {
  MemoryFileSystem files;
  const ToolRun unknown = run_tool({"man", "dance"}, files);
  CHECK(unknown.code == 2);
  CHECK(unknown.err == "error: `dance` is not a command; `symplant --help` lists all\n");
  files.faults["pages/symplant-init.1"] = "no space";
  CHECK(run_tool({"man", "-o", "pages"}, files).code == 3);
  CHECK(files.files.size() == 1);
}

}  // namespace
}  // namespace symplant::test
