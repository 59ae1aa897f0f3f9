// Recordings of each format in the tool.
#include "support/tool.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "recording/write_json_lines.hpp"
#include "recording_support.hpp"

namespace symplant::test {
namespace {

namespace fs = std::filesystem;

/// A folder that is removed again.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("symplant-recording-" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code unknown;
    fs::remove_all(path_, unknown);
  }

  std::string path(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

 private:
  fs::path path_;
};

ToolRun run_on_disk(const std::vector<std::string>& arguments) {
  base::DiskFileSystem files;
  return run_tool(arguments, files);
}

recording::Recording read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  recording::ReadRecording read = recording::read_recording(file, path);
  INFO(read.error);
  REQUIRE(read.error.empty());
  return std::move(read.recording);
}

/// Without parts, which only a trace has.
void check_same(const recording::Recording& a, const recording::Recording& b) {
  const auto parts = std::count_if(a.series.begin(), a.series.end(), [](const recording::Series& series) {
    return series.kind == recording::Series::Kind::parts;
  });
  REQUIRE(a.series.size() == b.series.size() + static_cast<std::size_t>(parts));
  for (std::size_t s = 0; s < a.series.size(); ++s) {
    if (a.series[s].kind == recording::Series::Kind::parts) continue;
    INFO(a.series[s].name);
    const recording::Series* const other = b.find(a.series[s]);
    REQUIRE(other != nullptr);
    CHECK(other->kind == a.series[s].kind);
    REQUIRE(other->changes.size() == a.series[s].changes.size());
    for (std::size_t i = 0; i < other->changes.size(); ++i) {
      CHECK(other->changes[i].time == a.series[s].changes[i].time);
      CHECK(other->changes[i].value == Catch::Approx(a.series[s].changes[i].value));  // a trace has REAL in short
    }
  }
}

TEST_CASE("The trace and the VCD file of a run are the same recording") {
  const Folder folder;
  const std::string examples = std::string(SYMPLANT_SOURCE_DIR) + "/examples/";
  const std::vector<std::vector<std::string>> runs = {
      {examples + "excell/excell.csv", "--scenario", examples + "excell/figure6.json"},
      {examples + "body-shop/plant.json", "--until", "20s"},
      {examples + "dosing/plant.json", "--until", "20s"},
      {examples + "oven/plant.json", "--until", "20s"},
      {examples + "sorting/plant.json", "--until", "20s"}};
  for (const std::vector<std::string>& options : runs) {
    INFO(options[0]);
    std::vector<std::string> arguments = {"run"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    for (const char* const more : {"--trace", "t.jsonl", "--vcd", "t.vcd"}) {
      arguments.push_back(more[0] == '-' ? more : folder.path(more));
    }
    REQUIRE(run_on_disk(arguments).code == 0);
    const recording::Recording trace = read_file(folder.path("t.jsonl"));
    CHECK(!trace.order.empty());
    check_same(trace, read_file(folder.path("t.vcd")));
  }
}

std::string names_in_order(const recording::Recording& recording) {
  std::string names;
  for (const std::uint32_t s : recording.order) names += recording.series[s].name + " ";
  return names;
}

TEST_CASE("A recording that is written as JSON lines is the same") {
  const recording::Recording recording =
      read_csv_text("t/ms,a \"b\",X_O_A,N\n0,0,1,-0.1\n50,1,1,1e300\n100,1,0,9007199254740993\n").recording;
  std::ostringstream text;
  class Sink final : public base::TextSink {
   public:
    explicit Sink(std::ostream& out) : out_(out) {}
    void put(std::string_view part) override { out_ << part; }

   private:
    std::ostream& out_;
  } sink(text);
  recording::write_json_lines(recording, sink);
  const recording::ReadRecording again = read_csv_text(text.str());
  CHECK(again.error == "");
  check_same(recording, again.recording);
  CHECK(names_in_order(again.recording) == names_in_order(recording));
  CHECK(again.recording.end == recording.end);
  CHECK(again.recording.resolution == recording.resolution);
  CHECK_FALSE(again.recording.of_plant);
}

const std::string kTrace =
    "{\"symplant-trace\":1}\n{\"t\":10000000,\"symbol\":\"A\",\"value\":true}\n"
    "{\"t\":20000000,\"symbol\":\"N\",\"value\":1}\n{\"t\":20000000,\"symbol\":\"A\",\"value\":false}\n";

TEST_CASE("compare reads tables with the options for their names and times") {
  const Folder folder;
  const std::string trace = folder.write("good.jsonl", kTrace);
  const std::string table = folder.write("scope.csv", "moment;\"MAIN\".a;N\n0;0;0\n10;1;0\n20;0;1\n");
  const std::string names = folder.write("names.csv", "\"MAIN\".a;A\n");
  const std::vector<std::string> options = {"--rename", names, "--time-column", "moment", "--time-unit", "ms"};
  std::vector<std::string> arguments = {"compare", trace, table};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const ToolRun run = run_on_disk(arguments);
  CHECK(run.err == "");
  CHECK(run.code == 0);
  CHECK(contains(run.out, "no difference: 3 changes of 2 elements agree"));
  std::swap(arguments[1], arguments[2]);
  CHECK(run_on_disk(arguments).code == 0);
}

TEST_CASE("A name of the renames is reported if no file has it, once") {
  const Folder folder;
  const std::string trace = folder.write("good.jsonl", kTrace);
  const std::string table = folder.write("scope.csv", "t/ms;\"MAIN\".a;N\n0;0;0\n10;1;0\n20;0;1\n");
  const std::string names = folder.write("names.csv", "\"MAIN\".a;A\nother;B\n");
  CHECK(run_on_disk({"compare", trace, table, "--rename", names}).err ==
        "warning: " + names + ": `other` is not in the recordings\n");
}

TEST_CASE("compare reports what it cannot read of a table and of the renames") {
  const Folder folder;
  const std::string trace = folder.write("good.jsonl", kTrace);
  const std::string table = folder.write("scope.csv", "t/ms;A\n0;0\nx;1\n30;0\n");
  const ToolRun unreadable = run_on_disk({"compare", trace, table});
  CHECK(unreadable.code == 2);
  CHECK(unreadable.err == "error: " + table + ":3:1: `x` is not a time; write a number\n");
  const std::string names = folder.write("names.csv", "a,A\na,B\n");
  const ToolRun renames = run_on_disk({"compare", trace, trace, "--rename", names});
  CHECK(renames.code == 2);
  CHECK(renames.err == "error: " + names + ":2:1: `a` is in line 1, too; delete one row\n");
  const ToolRun missing = run_on_disk({"compare", trace, trace, "--rename", folder.path("none.csv")});
  CHECK(missing.code == 2);
  CHECK(contains(missing.err, "none.csv"));
  CHECK(run_on_disk({"compare", trace, table, "--time-unit", "h"}).code == 2);
  CHECK(run_on_disk({"compare", trace, folder.path("none.csv")}).code == 2);
}

TEST_CASE("A recording that begins with a value of each symbol does not differ by values that are off") {
  const Folder folder;
  const std::string trace = folder.write("good.jsonl", kTrace);
  const std::string table = folder.write("r.csv", "t/ms;A;B;N\n0;0;0;0\n10;1;0;0\n20;0;0;1\n");
  const ToolRun run = run_on_disk({"compare", trace, table});
  CHECK(run.code == 0);
  CHECK(contains(run.out, "no difference"));
}

TEST_CASE("A table with addresses is a recording of a plant") {
  const Folder folder;
  const std::string list = folder.write("list.csv",
                                        "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n"
                                        "VAR_GLOBAL,L_P_CL_O_OPEN,Y0001,,BOOL,FALSE\n"
                                        "VAR_GLOBAL,L_P_CL_I_OPEN,X0001,,BOOL,FALSE\n");
  const std::string table = folder.write("a.csv", "t/ms;X0001;Y0001\n0;0;0\n1000;0;255\n2000;1;255\n3000;1;255\n");
  const ToolRun watch = run_on_disk({"watch", list, table});
  INFO(watch.err);
  CHECK(watch.code != 2);
  CHECK_FALSE(contains(watch.err, "no symbol"));
  const ToolRun compare = run_on_disk({"compare", table, "--plant", list});
  INFO(compare.out + compare.err);
  CHECK(compare.code == 0);
  CHECK(compare.err == "");
}

TEST_CASE("show reads tables, and reports what it cannot read") {
  const Folder folder;
  const std::string list = std::string(SYMPLANT_SOURCE_DIR) + "/examples/excell/excell.csv";
  const ToolRun other = run_on_disk({"show", folder.write("a.csv", "t/ms;A\n0;0\n10;1\n"), list});
  CHECK(other.code == 2);
  CHECK(contains(other.err, "is of another plant: it has no symbol of this one, such as `A`"));
  const ToolRun unreadable = run_on_disk({"show", folder.write("b.csv", "t;A\n0;0\n10;1\n"), list});
  CHECK(unreadable.code == 2);
  CHECK(contains(unreadable.err, "b.csv:1:1: the unit of the times in column `t` is not known"));
  const ToolRun missing = run_on_disk({"show", folder.path("none.jsonl"), list});
  CHECK(missing.code == 2);
  CHECK(contains(missing.err, "cannot read the trace"));
}

}  // namespace
}  // namespace symplant::test
