// What is read of a trace for a comparison.
#include "../compare/compare_support.hpp"

namespace symplant::test {
namespace {

recording::ReadRecording read(const std::string& text) {
  std::istringstream file(text);
  return recording::read_recording(file, "t.jsonl");
}

TEST_CASE("Changes have their symbol, and operations of one time come first") {
  const recording::Recording trace = recorded(trace_text("10 X_I_A 1; 10 Y_O_B 1; 20 X_I_A 0"));
  REQUIRE(trace.series.size() == 2);
  CHECK(trace.series[0].name == "X_I_A");
  CHECK(trace.series[0].changes.size() == 2);
  CHECK(trace.order == std::vector<std::uint32_t>{1, 0, 0});
  CHECK(trace.end == 20 * tables::kMillisecond);
}

TEST_CASE("What a program of the header writes is an operation, whatever its name") {
  const recording::Recording trace =
      recorded(trace_text("10 X 1; 10 Y 1", R"(,"programs":[{"name":"cell","writes":["Y"]}])"));
  CHECK(trace.order == std::vector<std::uint32_t>{1, 0});
}

TEST_CASE("Numbers are read as text, too") {
  const recording::Recording trace = recorded(trace_text("10 N \"18446744073709551615\"; 20 N \"-inf\"; 30 N -5"));
  REQUIRE(trace.series[0].changes.size() == 3);
  CHECK(trace.series[0].changes[0].value == 18446744073709551615.0);
  CHECK(std::isinf(trace.series[0].changes[1].value));
  CHECK(trace.series[0].changes[2].value == -5);
}

TEST_CASE("What was before the plant was set back does not count") {
  const std::string text = trace_text("10 X 1") + "{\"t\":0,\"reset\":\"\",\"values\":{\"Y\":true}}\n{\"t\":5000000}\n";
  const recording::ReadRecording reset = read(text);
  CHECK(reset.error == "");
  CHECK(reset.warnings == std::vector<std::string>{"t.jsonl:3: the plant was set back here: only what follows counts"});
  REQUIRE(reset.recording.series.size() == 1);
  CHECK(reset.recording.series[0].name == "Y");
}

TEST_CASE("Times in which nothing was read are gaps") {
  const recording::ReadRecording gaps = read(trace_text("10 X 1", ",\"recorded\":true,\"every\":50000000") +
                                             "{\"t\":20000000,\"gap\":5000000}\n{\"t\":30000000}\n");
  CHECK(gaps.error == "");
  CHECK_FALSE(gaps.recording.of_plant);
  CHECK(gaps.recording.resolution == 50 * tables::kMillisecond);
  REQUIRE(gaps.recording.gaps.size() == 1);
  CHECK(gaps.recording.gaps[0].begin == 20 * tables::kMillisecond);
  CHECK(gaps.recording.gaps[0].length == 5 * tables::kMillisecond);
  CHECK(read(trace_text("10 X 1") + "{\"t\":20000000,\"gap\":-1}\n").error ==
        "t.jsonl:3: the key `gap` is not a time in ns up to 2305843009213693951");
}

std::string part_text(const std::string& header, const std::string& changes) {
  return trace_text(changes, ",\"recorded\":true,\"every\":5000000" + header);
}

TEST_CASE("A later part of a recording begins with the values of its header, at its time") {
  const recording::ReadRecording part =
      read(part_text(R"(,"part":3,"t":40000000,"values":{"X":true,"N":7,"Y_O_A":false})", "50 X 0; 60"));
  CHECK(part.error == "");
  CHECK_FALSE(part.recording.of_plant);
  REQUIRE(part.recording.series.size() == 3);
  for (const recording::Series& series : part.recording.series) {
    INFO(series.name);
    CHECK(series.changes.front().time == 40 * tables::kMillisecond);
  }
  CHECK(part.recording.series[part.recording.index.at("N")].changes.front().value == 7);
  CHECK(part.recording.series[part.recording.index.at("X")].changes.size() == 2);
  CHECK(part.recording.series[part.recording.order.front()].name == "Y_O_A");
  CHECK(part.recording.end == 60 * tables::kMillisecond);
  CHECK(part.recording.resolution == 5 * tables::kMillisecond);
  CHECK(read(part_text(R"(,"part":2,"t":9000000000000000000)", "")).error ==
        "t.jsonl:1: the time 9000000000000000000 is out of range: at most 2305843009213693951 ns");
}

TEST_CASE("Parts of a recording in one file are one recording, and a part that is missing is a gap") {
  const std::string first = part_text("", "10 X 1; 20 N 5");
  const std::string second = part_text(R"(,"part":2,"t":20000000,"values":{"X":true,"N":5})", "30 X 0");
  const std::string fourth = part_text(R"(,"part":4,"t":80000000,"values":{"X":true,"N":5})", "90 N 6");
  const recording::ReadRecording both = read(first + second);
  CHECK(both.error == "");
  CHECK(both.recording.order.size() == 3);
  CHECK(both.recording.gaps.empty());
  const recording::ReadRecording all = read(first + second + fourth);
  CHECK(all.error == "");
  CHECK(all.recording.order.size() == 5);
  REQUIRE(all.recording.gaps.size() == 1);
  CHECK(all.recording.gaps[0].begin == 30 * tables::kMillisecond);
  CHECK(all.recording.gaps[0].length == 50 * tables::kMillisecond);
}

TEST_CASE("What cannot be read is reported with its line") {
  CHECK(read(trace_text("10 X 1", ",\"part\":2,\"t\":0")).error ==
        "t.jsonl:1: this is a later part of a trace: record it without `--trace-limit`, so that it has its beginning");
  CHECK(read(trace_text("10 N \"high\"")).error == "t.jsonl:2: `N` cannot have the value \"high\"");
  CHECK(read(trace_text("10 N 1; 20 N true")).error ==
        "t.jsonl:3: the value of `N` is TRUE or FALSE, but a number in the lines above; write one kind of values");
  CHECK(read(trace_text("10 X 1") + "{\"t\":1,").warnings ==
        std::vector<std::string>{"t.jsonl:3: the last line is cut off, and is left out"});
  const char* const no_writes = "t.jsonl:1: an entry of `programs` is not an object with an array `writes`";
  CHECK(read(trace_text("10 X 1", R"(,"programs":["cell"])")).error == no_writes);
  CHECK(read(trace_text("10 X 1", R"(,"programs":[{"writes":"X"}])")).error == no_writes);
  CHECK(read(trace_text("10 X 1", ",\"cycle\":9223372036854775807")).error ==
        "t.jsonl:1: the key `cycle` is not a time in ns up to 2305843009213693951");
  CHECK(read(trace_text("10 X 1") + "{\"t\":9223372036854775806}\n").error ==
        "t.jsonl:3: the time 9223372036854775806 is out of range: at most 2305843009213693951 ns");
  CHECK(read(trace_text("10 X 1") + "{\"t\":1}\n").error == "t.jsonl:3: this time is before that of the line above");
}

}  // namespace
}  // namespace symplant::test
