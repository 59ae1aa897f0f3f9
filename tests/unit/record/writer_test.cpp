// The file of a recording: first values, changes, gaps, triggers, its length, parts, and a disk that is full.
#include "record/writer.hpp"

#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>

#include "recording/read.hpp"
#include "support/catch.hpp"
#include "symplant/trace/trace_lines.hpp"
#include "unit/record/record_support.hpp"

using namespace symplant;
using Catch::Matchers::ContainsSubstring;
using test::kI;
using test::kMillisecond;
using test::kN;
using test::kO;
using test::kSecond;
using test::WriterBench;
using Lines = std::vector<std::string>;

namespace {

std::string line(std::int64_t ms, const std::string& symbol, const std::string& value) {
  return "{\"t\":" + std::to_string(ms * kMillisecond) + ",\"symbol\":\"" + symbol + "\",\"value\":" + value + "}";
}
std::string gap(std::int64_t ms, std::int64_t length_ms) {
  return "{\"t\":" + std::to_string(ms * kMillisecond) + ",\"gap\":" + std::to_string(length_ms * kMillisecond) + "}";
}
std::string end(std::int64_t ms) { return "{\"t\":" + std::to_string(ms * kMillisecond) + ",\"end\":true}"; }

record::What started_by(const char* start, test::Time before = 0, const char* stop = "") {
  const test::SymbolList list = test::three_symbols();
  const tables::PlantTables tables = list.tables();
  const trace::PlantNames names(tables);
  record::What what;
  what.start = WriterBench::trigger_of(start, names);
  if (*stop != '\0') what.stop = WriterBench::trigger_of(stop, names);
  what.before = before;
  return what;
}

record::What of_length(test::Time until) {
  record::What what;
  what.until = until;
  return what;
}

/// Files of this process end at a size while it lives, as on a full disk.
class FileLimit {
 public:
  explicit FileLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    REQUIRE(setrlimit(RLIMIT_FSIZE, &limit) == 0);
  }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;
  ~FileLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

}  // namespace

TEST_CASE("A recording begins with a header and one line a symbol, then it has changes") {
  WriterBench bench;
  bench.image(0, {{kO, 0}, {kI, 1}, {kN, static_cast<std::uint64_t>(-5)}});
  bench.image(50);
  bench.image(100, {{kO, 1}, {kI, 0}});
  bench.writer().finish(WriterBench::at(120));
  const auto header = nlohmann::json::parse(bench.header());
  CHECK(header["symplant-trace"] == 1);
  CHECK(header["plant"] == "list");
  CHECK(header["model_hash"] == "0000000000000000");
  CHECK(header["recorded"] == true);
  CHECK(header["link"] == "fake:");
  CHECK(header["every"] == 50 * kMillisecond);
  CHECK(header["utc"] == "at 1000000000");
  CHECK(bench.lines() == Lines{line(0, "O", "false"), line(0, "I", "true"), line(0, "N", "-5"), line(100, "O", "true"),
                               line(100, "I", "false"), end(100)});
  CHECK(bench.writer().state().changes == 2);
  CHECK(bench.writer().state().symbols == 3);
}

TEST_CASE("Symbols of one image have the times of their requests") {
  WriterBench bench;
  record::Batch batch;
  batch.first = WriterBench::at(0);
  batch.last = WriterBench::at(4);
  batch.lines = {{WriterBench::at(0), 1, kO}, {WriterBench::at(4), 1, kI}};
  bench.writer().take(batch);
  bench.writer().flush();
  CHECK(bench.lines() == Lines{line(0, "O", "true"), line(4, "I", "true")});
}

TEST_CASE("A lost connection is a gap, from the last image to the next") {
  WriterBench bench;
  bench.image(0, {{kO, 0}});
  bench.image(50);
  bench.writer().lost();
  bench.image(110, {{kO, 1}}, true);
  bench.image(160, {{kO, 0}});
  bench.writer().finish(WriterBench::at(170));
  CHECK(bench.lines() ==
        Lines{line(0, "O", "false"), gap(50, 60), line(110, "O", "true"), line(160, "O", "false"), end(160)});
  CHECK(bench.writer().state().gaps == 1);
  CHECK(bench.writer().state().gap_time == 60 * kMillisecond);
}

TEST_CASE("A gap at the end is written at the end") {
  WriterBench bench;
  bench.image(0, {{kO, 0}});
  bench.writer().lost();
  bench.writer().finish(WriterBench::at(2'000));
  CHECK(bench.lines() == Lines{line(0, "O", "false"), gap(0, 2'000), end(2'000)});
}

TEST_CASE("More than three intervals without an image are a gap, three are not") {
  WriterBench bench;
  bench.image(0, {{kO, 0}});
  bench.quiet(50, 300);
  bench.image(450);
  bench.image(601, {{kO, 1}});
  bench.writer().finish(WriterBench::at(601));
  CHECK(bench.lines() == Lines{line(0, "O", "false"), gap(450, 151), line(601, "O", "true"), end(601)});
}

TEST_CASE("A PLC that is always slower than the interval has no gaps") {
  WriterBench bench;
  bench.image(0, {{kO, 0}});
  for (std::int64_t ms = 400; ms < 4'000; ms += 400) bench.image(ms);
  CHECK(bench.writer().state().gaps == 0);
  bench.image(4'000 + 801);
  CHECK(bench.writer().state().gaps == 1);
}

TEST_CASE("A slow PLC that answers some images fast has no gaps, and the file has its interval") {
  constexpr std::int64_t kSlow = 222;
  WriterBench bench;
  std::int64_t ms = 0;
  bench.image(ms, {{kO, 0}});
  const auto slow = [&](int images) {
    for (; images > 0; --images) bench.image(ms += kSlow);
  };
  slow(15);
  for (int i = 0; i < 3; ++i) bench.image(ms += 10);
  slow(4);
  bench.writer().flush();  // what a killed process leaves
  std::ifstream killed(bench.path());
  CHECK(recording::read_recording(killed, "r").recording.resolution / kMillisecond >= kSlow);
  slow(20);
  bench.writer().finish(WriterBench::at(ms));
  CHECK(bench.writer().state().gaps == 0);
  CHECK(bench.writer().state().resolution / kMillisecond >= kSlow);
  CHECK_THAT(bench.lines().back(), ContainsSubstring("\"end\":true,\"every\":22"));
  std::ifstream file(bench.path());
  const auto read = recording::read_recording(file, "r");
  CHECK(read.error.empty());
  CHECK(read.recording.resolution == bench.writer().state().resolution);
}

TEST_CASE("A recording with a wrong interval is an error") {
  std::istringstream file(
      "{\"symplant-trace\":1,\"recorded\":true,\"every\":50}\n{\"t\":1,\"symbol\":\"O\",\"value\":true}\n"
      "{\"t\":5,\"every\":-1}\n");
  CHECK_THAT(recording::read_recording(file, "r").error, ContainsSubstring("r:3: the key `every` is not a time"));
}

TEST_CASE("A recording of a length ends there, whatever comes later") {
  WriterBench bench(of_length(120 * kMillisecond));
  bench.image(0, {{kO, 0}});
  bench.image(50, {{kO, 1}});
  CHECK_FALSE(bench.writer().has_ended());
  bench.image(100);
  bench.image(150, {{kO, 0}});
  CHECK(bench.writer().has_ended());
  bench.image(200, {{kO, 1}});
  bench.writer().finish(WriterBench::at(500));
  CHECK(bench.lines() == Lines{line(0, "O", "false"), line(50, "O", "true"), end(120)});
}

TEST_CASE("A recording of a length ends also while the connection is lost") {
  WriterBench bench(of_length(kSecond));
  bench.image(0, {{kO, 0}});
  bench.writer().lost();
  bench.writer().look(WriterBench::at(1'900));
  CHECK_FALSE(bench.writer().has_ended());
  bench.writer().look(WriterBench::at(2'100));
  CHECK(bench.writer().has_ended());
  CHECK(bench.lines() == Lines{line(0, "O", "false"), gap(0, 1'000), end(1'000)});
}

TEST_CASE("A gap over the end of a recording ends with it") {
  WriterBench bench(of_length(kSecond));
  bench.image(0, {{kO, 0}});
  bench.writer().lost();
  bench.image(1'400, {{kO, 1}}, true);
  CHECK(bench.lines().empty());  // not passed on yet
  bench.writer().finish(WriterBench::at(1'400));
  CHECK(bench.lines() == Lines{line(0, "O", "false"), gap(0, 1'000), end(1'000)});
}

TEST_CASE("A start condition waits, and t = 0 is the image in which it holds") {
  WriterBench bench(started_by("I"));
  bench.image(0, {{kO, 1}, {kI, 0}});
  bench.image(50, {{kO, 0}});
  CHECK_FALSE(bench.writer().state().has_started);
  bench.image(100, {{kI, 1}});
  bench.image(150, {{kI, 0}});
  bench.writer().finish(WriterBench::at(150));
  CHECK_THAT(bench.header(), ContainsSubstring("\"utc\":\"at 1100000000\""));
  CHECK(bench.lines() == Lines{line(0, "O", "false"), line(0, "I", "true"), line(50, "I", "false"), end(50)});
}

TEST_CASE("What was kept comes first, and t = 0 is its beginning") {
  WriterBench bench(started_by("I", 200 * kMillisecond));
  bench.image(0, {{kO, 0}, {kI, 0}});
  bench.quiet(50, 250);
  bench.image(300, {{kO, 1}});
  bench.quiet(350, 450);
  bench.image(500, {{kO, 0}});
  bench.image(550);
  bench.image(600, {{kI, 1}});
  bench.image(650, {{kI, 0}});
  bench.writer().finish(WriterBench::at(650));
  CHECK_THAT(bench.header(), ContainsSubstring("\"utc\":\"at 1400000000\""));
  CHECK(bench.lines() == Lines{line(0, "O", "true"), line(0, "I", "false"), line(100, "O", "false"),
                               line(200, "I", "true"), line(250, "I", "false"), end(250)});
  CHECK(bench.writer().state().kept == 200 * kMillisecond);
}

TEST_CASE("The length counts from the start, not from what was kept") {
  record::What what = started_by("I", 200 * kMillisecond);
  what.until = 100 * kMillisecond;
  WriterBench bench(std::move(what));
  bench.image(0, {{kO, 0}, {kI, 0}});
  bench.quiet(50, 450);
  bench.image(500, {{kI, 1}});
  bench.image(550);
  CHECK_FALSE(bench.writer().has_ended());
  bench.image(600);
  CHECK(bench.writer().has_ended());
  CHECK(bench.writer().state().length == 300 * kMillisecond);
}

TEST_CASE("A gap in the kept part is written, cut at its beginning") {
  WriterBench bench(started_by("I", 300 * kMillisecond));
  bench.image(0, {{kO, 0}, {kI, 0}});
  bench.writer().lost();
  bench.image(400, {{kO, 1}}, true);
  bench.quiet(450, 550);
  bench.image(600, {{kI, 1}});
  bench.writer().finish(WriterBench::at(600));
  CHECK(bench.lines() == Lines{line(0, "O", "false"), line(0, "I", "false"), gap(0, 100), line(100, "O", "true"),
                               line(300, "I", "true"), end(300)});
}

TEST_CASE("A stop condition ends the recording with the image in which it holds") {
  WriterBench bench(started_by("O", 0, "N > 2"));
  bench.image(0, {{kO, 0}, {kN, 9}});  // it does not count before the start
  bench.image(50, {{kO, 1}, {kN, 0}});
  bench.image(100, {{kN, 2}});
  CHECK_FALSE(bench.writer().has_ended());
  bench.image(150, {{kN, 3}});
  CHECK(bench.writer().has_ended());
  bench.writer().finish(WriterBench::at(500));
  CHECK(bench.lines() ==
        Lines{line(0, "O", "true"), line(0, "N", "0"), line(50, "N", "2"), line(100, "N", "3"), end(100)});
}

TEST_CASE("A recording that never started has no lines") {
  WriterBench bench(started_by("I"));
  bench.image(0, {{kO, 1}, {kI, 0}});
  bench.writer().finish(WriterBench::at(100));
  CHECK(test::read_bytes(bench.path()).empty());
  CHECK_FALSE(bench.writer().state().has_started);
  CHECK(bench.writer().state().has_images);
}

TEST_CASE("A full part is renamed, and the next one can be read alone") {
  WriterBench bench({}, 1'024);
  bench.image(0, {{kO, 0}, {kI, 1}});
  std::int64_t ms = 50;
  for (; ms < 1'500; ms += 50) bench.image(ms, {{kO, static_cast<std::uint64_t>(ms / 50 % 2)}});
  bench.writer().finish(WriterBench::at(ms));
  const std::string first = test::read_bytes(bench.path() + ".1");
  CHECK(first.size() >= 1'024);
  CHECK(first.back() == '\n');
  const auto header = nlohmann::json::parse(bench.header());
  CHECK(header["part"] > 1);
  CHECK(header["recorded"] == true);
  CHECK(header["utc"] == "at 1000000000");
  CHECK(header["values"].size() == 2);  // also those that are off: only what has a value was recorded
  CHECK(header["values"]["I"] == true);
  CHECK(bench.lines().back() == end(ms - 50));
}

TEST_CASE("Every part has the interval of a slow PLC") {
  WriterBench bench({}, 1'024);
  bench.image(0, {{kO, 0}});
  std::int64_t ms = 200;
  for (std::uint64_t i = 1; i <= 60; ++i, ms += 200) bench.image(ms, {{kO, i % 2}});
  bench.writer().flush();
  CHECK(nlohmann::json::parse(bench.header()).contains("part"));
  CHECK_THAT(bench.lines().front(), ContainsSubstring("\"every\":2"));
}

TEST_CASE("A failed write ends a file after its last whole line, also if a part of a line was passed on before") {
  const test::TemporaryFolder folder;
  const std::string path = folder / "x";
  trace::OutputFile file("trace", path);
  file.put("one\ntwo");
  file.flush();
  {
    const FileLimit full(10);
    file.put(" and more\nthree\n");
    file.flush();
  }
  CHECK_FALSE(file.error().empty());
  CHECK(test::read_bytes(path) == "one\n");
}

TEST_CASE("A file is kept until it is replaced") {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("x", "old\n");
  trace::OutputFile file("trace", path, trace::kNoLimit, trace::OutputFile::Old::kept);
  CHECK(file.is_open());
  CHECK(test::read_bytes(path) == "old\n");
  file.replace();
  file.put("new\n");
  file.replace();  // once only
  file.flush();
  CHECK(test::read_bytes(path) == "new\n");
}

TEST_CASE("A full disk ends the recording after its last whole line") {
  WriterBench bench;
  bench.image(0, {{kO, 0}});
  bench.writer().flush();
  std::int64_t ms = 50;
  {
    const FileLimit full(1'000);
    for (; !bench.writer().has_ended() && ms < 10'000; ms += 50) {
      bench.image(ms, {{kO, static_cast<std::uint64_t>(ms / 50 % 2)}});
      if (ms % 500 == 0) bench.writer().flush();  // ten lines at once
    }
  }
  CHECK_THAT(bench.writer().error(),
             ContainsSubstring("cannot write the recording `") && ContainsSubstring("File too large"));
  bench.writer().finish(WriterBench::at(ms));
  const std::string text = test::read_bytes(bench.path());
  CHECK(text.size() <= 1'000);
  CHECK(text.size() > 900);
  CHECK(text.back() == '\n');
  std::ifstream file(bench.path());
  const auto read = recording::read_recording(file, "r");
  CHECK(read.error.empty());
  CHECK(read.warnings.empty());
}

TEST_CASE("A recording reads as one") {
  WriterBench bench;
  bench.image(0, {{kO, 0}, {kI, 1}, {kN, 3}});
  bench.image(50, {{kO, 1}});
  bench.quiet(100, 900);
  bench.writer().finish(WriterBench::at(900));
  std::ifstream file(bench.path());
  const auto read = recording::read_recording(file, "r");
  CHECK(read.error.empty());
  CHECK(read.recording.series.size() == 3);
  CHECK(read.recording.resolution == 50 * kMillisecond);
  CHECK_FALSE(read.recording.of_plant);
  CHECK(read.recording.end == 900 * kMillisecond);
}
