// The formats of symplant diff, its options and exit codes.
#include <nlohmann/json.hpp>

#include "diag/encode.hpp"
#include "diff_support.hpp"

namespace symplant::test {
namespace {

using Json = nlohmann::json;

ToolRun run_diff(const std::string& before, const std::string& after, const std::vector<std::string>& options = {}) {
  MemoryFileSystem files;
  files.files["old.csv"] = before;
  files.files["new.csv"] = after;
  std::vector<std::string> arguments{"diff", "old.csv", "new.csv"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_tool(arguments, files);
}

std::string table(const std::string& rows) { return "Name,Address,Type,Comment\nL_P_K_O_RUN,Y0,BOOL,\n" + rows; }

/// `count` rows.
std::string many(std::size_t count) {
  std::string rows;
  for (std::size_t i = 0; i < count; ++i) rows += fmt::format("N{},X{:X},BOOL,\n", i, i);
  return rows;
}

TEST_CASE("diff: Equal plants give exit code 0, different ones 1") {
  const ToolRun equal = run_diff(table(""), table(""));
  CHECK(equal.code == 0);
  CHECK(equal.out == "old.csv (1 symbol, 1 device) -> new.csv (1 symbol, 1 device)\nno difference\n");
  const ToolRun different = run_diff(table(""), table("A,X0,BOOL,\n"));
  CHECK(different.code == 1);
  CHECK(different.out ==
        "old.csv (1 symbol, 1 device) -> new.csv (2 symbols, 1 device)\n"
        "1 symbol added\n"
        "  A  X0  BOOL  new.csv:3\n"
        "1 symbol added, different model hashes\n");
  CHECK(run_diff(table("A,X0,BOOL,a\n"), table("A,X0,BOOL,b\n")).out ==
        "old.csv (2 symbols, 1 device) -> new.csv (2 symbols, 1 device)\n1 comment changed, equal model hashes\n");
}

TEST_CASE("diff: A list that cannot be read gives exit code 2, with its location") {
  for (const std::string& bad : {std::string(), std::string("Class,Identifier,Type\nVAR_GLOBAL,\"A,BOOL\n")}) {
    const ToolRun first = run_diff(bad, table(""));
    CHECK(first.code == 2);
    CHECK(first.out.empty());
    CHECK(contains(first.err, "old.csv"));
    const ToolRun second = run_diff(table(""), bad);
    CHECK(second.code == 2);
    CHECK(contains(second.err, "new.csv"));
  }
  MemoryFileSystem files;
  CHECK(run_tool({"diff", "none.csv", "none.csv"}, files).code == 2);
  CHECK(run_tool({"diff", "none.csv"}, files).code == 2);
  CHECK(run_diff(table(""), table(""), {"--format", "html"}).code == 2);
}

TEST_CASE("diff: Errors of a list are counted, and its symbols are compared") {
  const std::string twice = list_text({{"L_P_D_I_A", "X1"}, {"L_P_D_I_A", "X2"}});
  const ToolRun run = run_diff(twice, list_text({{"L_P_D_I_A", "X1"}}));
  CHECK(run.code == 1);
  CHECK(run.err == "old.csv: 1 error; `symplant check` shows them\n");
  CHECK(contains(run.out, "1 symbol removed, "));
  CHECK(contains(run.out, "model hashes not compared, because of errors\n"));
  CHECK(run_diff(twice, twice).code == 0);
}

TEST_CASE("diff: Text shows 20 rows of a kind, --verbose all") {
  const ToolRun some = run_diff(table(""), table(many(25)));
  CHECK(contains(some.out, "  N19  X13  BOOL  new.csv:22\n  5 more; --verbose shows them\n"));
  const ToolRun all = run_diff(table(""), table(many(25)), {"--verbose"});
  CHECK(contains(all.out, "  N24  X18  BOOL  new.csv:27\n"));
  CHECK(!contains(all.out, "more"));
}

TEST_CASE("diff: A change with a cause has no row in text, but with --verbose") {
  std::string before;
  std::string after;
  for (int i = 0; i < 4; ++i) {
    before += fmt::format("S1_D{},X{},BOOL,\n", i, i);
    after += fmt::format("S2_D{},X{},BOOL,\n", i, i);
  }
  const ToolRun run = run_diff(table(before), table(after));
  CHECK(contains(run.out,
                 "4 symbols renamed\n  `S1` -> `S2` in 4 symbols, such as `S1_D0` -> `S2_D0`, `S1_D1` -> `S2_D1`, "
                 "`S1_D2` -> `S2_D2`\n4 symbols renamed, "));
  CHECK(contains(run_diff(table(before), table(after), {"--verbose"}).out, "\n  S1_D3  S2_D3  X3  new.csv:6\n"));
}

TEST_CASE("diff: JSON has every change and the members of causes") {
  const ToolRun run = run_diff(table(many(30) + "A,X100,BOOL,a\n"), table("A,X101,BOOL,b\n"), {"--format", "json"});
  CHECK(run.code == 1);
  const Json json = Json::parse(run.out);
  CHECK(json["symplant-diff"] == 1);
  CHECK(json["before"]["file"] == "old.csv");
  CHECK(json["before"]["symbols"] == 32);
  CHECK(json["after"]["model_hash"].get<std::string>().size() == 16);
  CHECK(json["equal"] == false);
  CHECK(json["same_model"] == false);
  CHECK(json["symbols"].size() == 31);
  CHECK(json["symbols"][0]["change"] == "changed");
  CHECK(json["symbols"][0]["fields"] == Json{"address", "comment"});
  CHECK(json["symbols"][0]["before"]["address"] == "X100");
  CHECK(json["symbols"][0]["after"]["row"] == 3);
  CHECK(json["symbols"][1]["change"] == "removed");
  CHECK(!json["symbols"][1].contains("after"));
  const Json devices = Json::parse(
      run_diff(table(""), table("L_P_K_O_STOP,Y1,BOOL,\nL_P_M_O_RUN,Y2,BOOL,\n"), {"--format", "json"}).out)["devices"];
  CHECK(devices[0]["change"] == "changed");
  CHECK(devices[0]["model"][0].contains("element"));
  CHECK(devices[1]["change"] == "added");
  CHECK(devices[1]["after"] == "L_P_M");
}

TEST_CASE("diff: Markdown has tables, collapsed from 11 rows on, of at most 50 rows") {
  const std::string two = run_diff(table(""), table(many(2)), {"--format", "markdown"}).out;
  CHECK(two ==
        "**symplant diff** `old.csv` (1 symbol, 1 device) -> `new.csv` (3 symbols, 1 device): 2 symbols added, "
        "different model hashes\n\n"
        "**2 symbols added**\n\n"
        "| symbol | address | type | row |\n|---|---|---|---|\n"
        "| `N0` | `X0` | `BOOL` | `new.csv:3` |\n| `N1` | `X1` | `BOOL` | `new.csv:4` |\n");
  CHECK(!contains(run_diff(table(""), table(many(10)), {"--format", "markdown"}).out, "<details>"));
  const std::string eleven = run_diff(table(""), table(many(11)), {"--format", "markdown"}).out;
  CHECK(contains(eleven, "\n<details><summary>11 symbols added</summary>\n\n| symbol"));
  CHECK(eleven.ends_with("|\n\n</details>\n"));
  const std::string sixty = run_diff(table(""), table(many(60)), {"--format", "markdown"}).out;
  CHECK(contains(sixty, "`N49`"));
  CHECK(!contains(sixty, "`N50`"));
  CHECK(contains(sixty, "\n\n10 more rows are not shown.\n\n</details>\n"));
}

TEST_CASE("diff: A name cannot break out of its cell in Markdown") {
  CHECK(diag::markdown_code("A_B") == "`A_B`");
  CHECK(diag::markdown_code("") == "");
  CHECK(diag::markdown_code("*_x_* <b> @user #1 [a](b)") == "`*_x_* <b> @user #1 [a](b)`");
  CHECK(diag::markdown_code("a|b") == "<code>a&#124;b</code>");
  CHECK(diag::markdown_code("a`b") == "<code>a&#96;b</code>");
  CHECK(diag::markdown_code("a\\") == "<code>a&#92;</code>");
  CHECK(diag::markdown_code(" a") == "<code>&#32;a</code>");
  CHECK(diag::markdown_code("</code>|") == "<code>&#60;&#47;code&#62;&#124;</code>");
  CHECK(diag::markdown_code("a\nb") == "`a<U+000A>b`");
  const std::string out = run_diff(table(""), table("\"x|y`</details>\",X0,BOOL,\n"), {"--format", "markdown"}).out;
  CHECK(contains(out, "| <code>x&#124;y&#96;&#60;&#47;details&#62;</code> | `X0` |"));
}

TEST_CASE("diff: Control characters do not reach a terminal") {
  const ToolRun run = run_diff(table(""), table("A\x1B[31m,X0,BOOL,\n"));
  CHECK(!contains(run.out, "\x1B"));
  CHECK(contains(run.out, "<U+001B>"));
}

TEST_CASE("diff: The result goes to a file, never over an input") {
  MemoryFileSystem files;
  files.files["old.csv"] = table("");
  files.files["new.csv"] = table("A,X0,BOOL,\n");
  const ToolRun run = run_tool({"diff", "old.csv", "new.csv", "-o", "diff.txt"}, files);
  CHECK(run.code == 1);
  CHECK(run.out.empty());
  CHECK(contains(files.files["diff.txt"], "1 symbol added"));
  files.faults["denied.txt"] = "permission denied";
  CHECK(run_tool({"diff", "old.csv", "new.csv", "-o", "denied.txt"}, files).code == 3);
}

TEST_CASE("diff: The options of lists apply to both plants") {
  const std::string list = "Ort;Tag;T\nX0;L_P_K_O_RUN;BOOL\n";
  const ToolRun run = run_diff(list, list, {"--columns", "name=Tag,address=Ort,type=T"});
  CHECK(run.code == 0);
}

}  // namespace
}  // namespace symplant::test
