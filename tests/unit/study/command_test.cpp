// symplant compare RECORDING --plant PLANT.
#include <nlohmann/json.hpp>
#include <string>

#include "base/file_system.hpp"
#include "study/formats.hpp"
#include "study_support.hpp"
#include "support/strings.hpp"
#include "support/temporary_folder.hpp"
#include "support/tool.hpp"

namespace symplant::test {
namespace {

constexpr const char* kList =
    "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n"
    "VAR_GLOBAL,L_P_CL_I_OPEN,,%IX0,BOOL,FALSE\nVAR_GLOBAL,L_P_CL_I_CLOSED,,%IX1,BOOL,FALSE\n"
    "VAR_GLOBAL,L_P_CL_O_OPEN,,%QX0,BOOL,FALSE\nVAR_GLOBAL,L_P_CL_O_CLOSED,,%QX1,BOOL,FALSE\n";

/// The clamp opens in 2 s and closes in 1 s; the model says 1 s for both.
constexpr const char* kRecording =
    "0 L_P_CL_I_OPEN on; 0 L_P_CL_I_CLOSED off; 0 L_P_CL_O_OPEN off; 0 L_P_CL_O_CLOSED off; 0 SPARE off; "
    "1000 L_P_CL_O_CLOSED on; 1000 L_P_CL_I_OPEN off; 2000 L_P_CL_I_CLOSED on; 3000 L_P_CL_O_CLOSED off; "
    "4000 L_P_CL_O_OPEN on; 4000 L_P_CL_I_CLOSED off; 6000 L_P_CL_I_OPEN on; 10000";

class Command {
 public:
  Command() {
    folder_.write("symbols.csv", kList);
    folder_.write("recording.jsonl", recording_text(kRecording, ",\"recorded\":true,\"every\":50000000"));
  }

  ToolRun run(std::vector<std::string> options) { return run_of("recording.jsonl", std::move(options)); }
  ToolRun run_of(const std::string& recording, std::vector<std::string> options) {
    options.insert(options.begin(), {"compare", path(recording)});
    base::DiskFileSystem files;
    return run_tool(options, files);
  }
  std::string path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) { folder_.write(name, text); }

 private:
  TemporaryFolder folder_;
};

TEST_CASE("A recording is compared with the run of a plant, and each movement has an accuracy") {
  Command command;
  const ToolRun ran = command.run({"--plant", command.path("symbols.csv")});
  INFO(ran.out << ran.err);
  CHECK(ran.code == 1);  // the clamp opens early
  CHECK(contains(ran.err, "has the name `SPARE`"));
  CHECK(contains(ran.out, "The run begins at 0 s as recorded: 0 devices in other states"));
  CHECK(contains(ran.out, "at 6 s: `L_P_CL_I_OPEN` early by 1 s: on"));
  CHECK(contains(ran.out, "accuracy of 2 movements, times of the recording are exact to 0.05 s:"));
  CHECK(contains(ran.out, "  L_P_CL CLOSED -> OPEN     1    50.0 %    50.0 %    50.0 %\n"));
  CHECK(contains(ran.out, "  L_P_CL OPEN -> CLOSED     1   100.0 %   100.0 %   100.0 %\n"));
  CHECK(contains(ran.out, "  total                     2    50.0 %    66.6 %   100.0 %\n"));  // 1 s and 2 s
}

TEST_CASE("The accuracy is in every format but JUnit, with the options of compare") {
  Command command;
  const std::string plant = command.path("symbols.csv");
  const auto json = nlohmann::json::parse(command.run({"--plant", plant, "--format", "json"}).out);
  CHECK(json["actual"]["file"] == "run of " + plant);
  CHECK(json["accuracy"]["resolution"] == 50000000);
  CHECK(json["accuracy"]["movements"].size() == 2);
  CHECK(json["accuracy"]["movements"][1]["accuracy"] == 0.5);
  CHECK(json["accuracy"]["movements"][1]["begin"] == 4000000000);
  CHECK(json["accuracy"]["rows"].size() == 2);
  CHECK(json["accuracy"]["total"]["count"] == 2);
  const ToolRun html = command.run({"--plant", plant, "--format", "html"});
  CHECK(contains(html.out, "<td>L_P_CL CLOSED -&gt; OPEN</td><td>1</td><td>50.0 %</td>"));
  CHECK(contains(command.run({"--plant", plant, "--format", "junit"}).out, " name=\"L_P_CL_I_OPEN\""));
  const ToolRun wide = command.run({"--plant", plant, "--window", "2s", "--only", "L_P_CL_I_CLOSED"});
  CHECK(wide.code == 0);
  const ToolRun none = command.run({"--plant", plant, "--only", "L_P_CL_O_OPEN"});
  CHECK(contains(none.out, "no movement: after no change of an operation"));
  CHECK(nlohmann::json::parse(
            command.run({"--plant", plant, "--only", "SPARE", "--format", "json"}).out)["accuracy"]["total"]
            .is_null());
}

TEST_CASE("A recording without a symbol of the plant cannot be compared with its run") {
  Command command;
  const std::string plant = command.path("symbols.csv");
  command.write("scope.csv", "t/ms,L_P_CL_I_OPENED,b\n0,1,0\n10,0,1\n");
  const ToolRun names = command.run_of("scope.csv", {"--plant", plant});
  INFO(names.out << names.err);
  CHECK(names.code == 2);
  CHECK(names.out == "");
  CHECK(contains(names.err, "error: no name in `" + command.path("scope.csv") + "` is a symbol of `" + plant +
                                "`: `L_P_CL_I_OPENED` (did you mean `L_P_CL_I_OPEN`?), `b`; give `--rename FILE`, "
                                "with the symbol of each name\n"));
  command.write("names.csv", "b,L_P_CL_O_OPEN\n");
  CHECK(command.run_of("scope.csv", {"--plant", plant, "--rename", command.path("names.csv")}).code != 2);

  command.write("empty.jsonl", recording_text("10", ",\"recorded\":true"));
  const ToolRun empty = command.run_of("empty.jsonl", {"--plant", plant});
  CHECK(empty.code == 2);
  CHECK(contains(empty.err, "error: `" + command.path("empty.jsonl") + "` has no change of a symbol\n"));
}

TEST_CASE("A trace of another plant is reported") {
  Command command;
  const std::string plant = command.path("symbols.csv");
  const std::string header = ",\"plant\":\"harbour\",\"model_hash\":\"0123456789abcdef\"";
  const std::string of_other = " is a trace of another plant: of `harbour`, not of `symbols`";
  command.write("other.jsonl", recording_text("0 SPARE on; 10", header));
  const ToolRun other = command.run_of("other.jsonl", {"--plant", plant});
  INFO(other.out << other.err);
  CHECK(other.code == 2);
  CHECK(contains(other.err, "error: `" + command.path("other.jsonl") + "`" + of_other + "; no name in "));

  command.write("some.jsonl", recording_text("0 L_P_CL_I_OPEN on; 10", header));
  const ToolRun some = command.run_of("some.jsonl", {"--plant", plant});
  CHECK(some.code == 0);
  CHECK(contains(some.err, "warning: `" + command.path("some.jsonl") + "`" + of_other + "\n"));
  // A recording may be made with a list, and compared with its description.
  command.write("recorded.jsonl", recording_text("0 L_P_CL_I_OPEN on; 10", header + ",\"recorded\":true"));
  CHECK_FALSE(contains(command.run_of("recorded.jsonl", {"--plant", plant}).err, "another plant"));
  // Another model of the same plant is what is compared.
  const std::string same = ",\"plant\":\"symbols\",\"model_hash\":\"0123456789abcdef\"";
  command.write("same.jsonl", recording_text("0 L_P_CL_I_OPEN on; 10", same));
  CHECK(command.run_of("same.jsonl", {"--plant", plant}).err == "");
}

TEST_CASE("Numbers of a recording that are BOOL in the plant are compared as such") {
  Command command;
  std::string text = recording_text(kRecording, ",\"recorded\":true,\"every\":50000000");
  for (std::size_t at = 0; (at = text.find("\"value\":true")) != text.npos;) text.replace(at, 12, "\"value\":1");
  for (std::size_t at = 0; (at = text.find("\"value\":false")) != text.npos;) text.replace(at, 13, "\"value\":0");
  command.write("numbers.jsonl", text);
  const ToolRun ran = command.run_of("numbers.jsonl", {"--plant", command.path("symbols.csv")});
  INFO(ran.out << ran.err);
  CHECK(contains(ran.out, "at 6 s: `L_P_CL_I_OPEN` early by 1 s: on"));
  CHECK(contains(ran.out, "  total                     2    50.0 %    66.6 %   100.0 %\n"));
}

TEST_CASE("compare takes a second trace or a plant") {
  Command command;
  const ToolRun neither = command.run({});
  CHECK(neither.code == 2);
  CHECK(contains(neither.err, "error: give the second trace, or a plant to run with `--plant`"));
  const ToolRun both = command.run({command.path("recording.jsonl"), "--plant", command.path("symbols.csv")});
  CHECK(both.code == 2);
  CHECK(contains(both.err, "error: `--plant` replaces the second trace: give one of them"));
  CHECK(command.run({command.path("recording.jsonl")}).code == 0);
  const ToolRun without = command.run({command.path("recording.jsonl"), "--verbose"});
  CHECK(without.code == 2);
  CHECK(contains(without.err, "--plant"));
  const ToolRun missing = command.run({"--plant", command.path("no.csv")});
  CHECK(missing.code == 2);
  CHECK(contains(missing.err, "no.csv"));
}

TEST_CASE("A long table shows the least accurate rows") {
  study::Study study;
  for (int i = 0; i < 50; ++i) study.movements.push_back({"M" + std::to_string(10 + i), 0, 10, 0.99 - i * 0.01});
  study.rows = study::rows_of(study.movements);
  study.total = study::total_of(study.movements);
  recording::Recording trace;
  const compare::Comparison comparison = compare::compare(trace, trace, {});
  const std::string text = base::text_of([&](base::TextSink& sink) { study::write_text(study, comparison, sink); });
  INFO(text);
  CHECK(text.find("  M59 ") < text.find("  M58 "));
  CHECK(contains(text, "  M20 "));
  CHECK_FALSE(contains(text, "  M19 "));
  CHECK(contains(text, "\n  ... and 10 rows of 89.0 % or more; `--format json` has all\n  total    50 "));
}

TEST_CASE("A result does not overwrite the plant") {
  Command command;
  const std::string plant = command.path("symbols.csv");
  CHECK(command.run({"--plant", plant, "-o", plant}).code == 2);
}

}  // namespace
}  // namespace symplant::test
