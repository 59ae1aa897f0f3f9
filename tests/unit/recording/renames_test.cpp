// Names of recordings and their symbols.
#include "recording/renames.hpp"

#include "recording/renamer.hpp"
#include "recording_support.hpp"

namespace symplant::test {
namespace {

std::string error_of(const std::string& text) { return recording::read_renames(text, "names.csv").error; }

TEST_CASE("A file of renames has two columns, comments and perhaps a header") {
  const recording::ReadRenames read =
      recording::read_renames("# of line 2\nin the file;symbol\n\"DB1\".x;X_I_A\n\n MAIN.y ;Y_O_B;\n", "names.csv");
  CHECK(read.error == "");
  CHECK(read.renames == recording::Renames{{"\"DB1\".x", "X_I_A"}, {"MAIN.y", "Y_O_B"}});
  CHECK(recording::read_renames("\"\"\"DB1\"\".x\",A\n", "names.csv").renames ==
        recording::Renames{{"\"DB1\".x", "A"}});
}

TEST_CASE("What is wrong with a file of renames has row and column") {
  CHECK(error_of("a,A\nb\n") ==
        "names.csv:2:2: there is one cell; write two: the name in the recording, and the symbol");
  CHECK(error_of("a,A\n,B\n") == "names.csv:2:1: the name is empty; write it, or delete the row");
  CHECK(error_of("a,A\nb,\n") == "names.csv:2:2: the name is empty; write it, or delete the row");
  CHECK(error_of("a,A,1\n") ==
        "names.csv:1:3: there is `1`; a row has two cells: the name in the recording, and the symbol");
  CHECK(error_of("a,A\na,B\n") == "names.csv:2:1: `a` is in line 1, too; delete one row");
  CHECK(error_of("Symbol,Name\nA,a\n") ==
        "names.csv:1:1: the columns are swapped; write the name in the recording first, then the symbol");
  CHECK(error_of("a,A\n\"b,B\n") == "names.csv:2: a quote is never closed; close it");
  CHECK(contains(error_of(std::string("a,\0\n", 4)), "names.csv:1:3: "));
}

TEST_CASE("A recording has the names of the symbols, in each format") {
  const recording::ReadOptions options{"", "", {{"x", "LINE_O_RUN"}}};
  const recording::ReadRecording table = read_csv_text("t/ms,y,x\n0,0,0\n10,1,1\n", options);
  CHECK(table.recording.index.contains("LINE_O_RUN"));
  CHECK(table.recording.order == std::vector<std::uint32_t>{1, 0, 1, 0});  // it is an operation
  const recording::ReadRecording trace =
      read_csv_text("{\"symplant-trace\":1}\n{\"t\":1,\"symbol\":\"x\",\"value\":true}\n", options);
  CHECK(trace.recording.series[0].name == "LINE_O_RUN");
  CHECK(trace.recording.index.contains("LINE_O_RUN"));
}

TEST_CASE("A name that no recording has is reported with the nearest one") {
  const recording::Renames renames{{"MAIN.bClose", "A"}, {"nothing", "B"}, {"x", "C_O_D"}};
  const auto names = [&](const std::string& text) { return read_csv_text(text, {"", "", renames}).names; };
  CHECK(names("t/ms,MAIN.bClosed,x\n0,1,1\n") == std::vector<std::string>{"MAIN.bClosed", "x"});
  CHECK(names("{\"symplant-trace\":1}\n{\"t\":1,\"symbol\":\"x\",\"value\":true}\n") == std::vector<std::string>{"x"});
  CHECK(recording::not_found(renames, "names.csv", {"x", "MAIN.bClosed"}) ==
        std::vector<std::string>{"names.csv: `MAIN.bClose` is not in the recordings; did you mean `MAIN.bClosed`?",
                                 "names.csv: `nothing` is not in the recordings"});
  recording::Renames many;
  for (int i = 0; i < 12; ++i) many.emplace_back("long name " + std::to_string(i), std::to_string(i));
  const auto warnings = recording::not_found(many, "names.csv", {"x"});
  REQUIRE(warnings.size() == 11);
  CHECK(warnings.back() == "names.csv: 2 more names are not in the recordings");
}

TEST_CASE("A series that is renamed to an operation comes first at its time") {
  const std::string trace =
      "{\"symplant-trace\":1}\n{\"t\":1,\"symbol\":\"y\",\"value\":true}\n"
      "{\"t\":1,\"symbol\":\"x\",\"value\":true}\n";
  CHECK(read_csv_text(trace, {"", "", {{"x", "LINE_O_RUN"}}}).recording.order == std::vector<std::uint32_t>{1, 0});
}

TEST_CASE("A file of renames serves recordings that have different names for a symbol") {
  CHECK(error_of("a,A\nb,A\n") == "");
  const recording::ReadOptions options{"", "", {{"a", "A"}, {"b", "A"}, {"other", "C"}}};
  CHECK(csv("t/ms,a\n0,1\n", options) == "A bool 0=1\nend 0, resolution 0\n");
  CHECK(recording::not_found(options.renames, "n.csv", {"a"}) ==
        std::vector<std::string>{"n.csv: `other` is not in the recordings"});
  CHECK(csv("t/ms,b,other\n0,1,0\n", options) == "A bool 0=1\nC bool 0=0\nend 0, resolution 0\n");
  CHECK(csv("t/ms,a,b\n0,1,0\n", options) == "t.csv: `a` and `b` are both the symbol `A`; correct the file of renames");
  CHECK(csv("t/ms,name,value\n0,a,1\n1,b,0\n2,a,0\n", options) ==
        "t.csv: `a` and `b` are both the symbol `A`; correct the file of renames");
  CHECK(read_csv_text("{\"symplant-trace\":1}\n{\"t\":1,\"symbol\":\"a\",\"value\":true}\n"
                      "{\"t\":1,\"symbol\":\"b\",\"value\":true}\n",
                      options)
            .error == "t.csv: `a` and `b` are both the symbol `A`; correct the file of renames");
}

TEST_CASE("Swapped columns of a file of renames are one warning") {
  const auto warnings = [](const recording::Renames& renames) {
    std::string text;
    for (const std::string& warning : recording::not_found(renames, "n.csv", {"a", "b"})) text += warning + "\n";
    return text;
  };
  CHECK(warnings({{"A", "a"}, {"B", "b"}, {"C", "c"}}) ==
        "n.csv: the columns of the file of renames are swapped; write the name in the recording first, then the "
        "symbol\n");
  // The names of this recording are symbols, the renames are for another one.
  CHECK_FALSE(contains(warnings({{"A", "a"}, {"B", "y"}, {"C", "z"}}), "swapped"));
  CHECK_FALSE(contains(warnings({{"a", "b2"}, {"B", "b"}}), "swapped"));
}

TEST_CASE("Two names of one symbol are reported") {
  CHECK(contains(csv("t/ms,a,A\n0,1,0\n", {"", "", {{"a", "A"}}}), "`A` is in column 2, too; this one is left out"));
  CHECK(read_csv_text("{\"symplant-trace\":1}\n{\"t\":1,\"symbol\":\"a\",\"value\":true}\n"
                      "{\"t\":1,\"symbol\":\"A\",\"value\":true}\n",
                      {"", "", {{"a", "A"}}})
            .error == "t.csv: two names are the symbol `A`; correct the file of renames");
}

}  // namespace
}  // namespace symplant::test
