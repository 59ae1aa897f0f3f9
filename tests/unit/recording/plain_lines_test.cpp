// The fast reader of usual lines and the JSON reader agree, also on damaged lines.
#include <random>

#include "../compare/compare_support.hpp"

namespace symplant::test {
namespace {

/// All that was read, as a text.
std::string shown(const std::string& text) {
  std::istringstream file(text);
  const recording::ReadRecording read = recording::read_recording(file, "t.jsonl");
  std::ostringstream all;
  all.precision(17);
  all << read.error << "|" << read.recording.end;
  for (const std::string& warning : read.warnings) all << "|" << warning;
  for (const recording::Series& series : read.recording.series) {
    all << "|" << series.name << (series.kind == recording::Series::Kind::boolean ? " bool" : " number");
    for (const auto& change : series.changes)
      all << " " << change.time << "=" << change.value << std::signbit(change.value);
  }
  for (const std::uint32_t of : read.recording.order) all << " " << of;
  return all.str();
}

const std::string kBegin = "{\"symplant-trace\":1}\n{\"t\":3,\"symbol\":\"A_I_B\",\"value\":true}\n";

/// A blank before a line makes no difference to a JSON reader, and the fast reader leaves such lines to it.
void check_agreement(const std::string& line) {
  INFO(line);
  for (const char* const end : {"\n", "", "\n{\"t\":4000000000,\"symbol\":\"A_O_B\",\"value\":1}\n"}) {
    CHECK(shown(kBegin + line + end) == shown(kBegin + " " + line + end));
  }
}

TEST_CASE("Values and times are read as a JSON reader reads them") {
  for (const char* const value : {"true",
                                  "false",
                                  "0",
                                  "-0",
                                  "-0.0",
                                  "-0e5",
                                  "1",
                                  "-1",
                                  "007",
                                  "1.",
                                  ".5",
                                  "+1",
                                  "1.5",
                                  "-1.5e3",
                                  "1E-5",
                                  "1e",
                                  "1e+",
                                  "12345678901234567890",
                                  "18446744073709551615",
                                  "18446744073709551616",
                                  "-9223372036854775808",
                                  "-9223372036854775809",
                                  "9007199254740993",
                                  "0.1",
                                  "1e308",
                                  "1e309",
                                  "-1e309",
                                  "4e-324",
                                  "1e-400",
                                  "123e-10",
                                  "\"nan\"",
                                  "\"12\"",
                                  "\"x\"",
                                  "null",
                                  "nan",
                                  "inf",
                                  "tru",
                                  "truee",
                                  "[1]",
                                  "{}",
                                  "1}",
                                  "true }",
                                  ""}) {
    check_agreement(std::string("{\"t\":5,\"symbol\":\"N\",\"value\":") + value + "}");
  }
  for (const char* const time : {"3", "0", "2", "03", "-5", "5.0", "1e3", "999999999999999999", "1000000000000000000",
                                 "2305843009213693951", "2305843009213693952", "9223372036854775807", "", "x"}) {
    check_agreement(std::string("{\"t\":") + time + ",\"symbol\":\"N\",\"value\":1}");
  }
  for (const char* const name :
       {"", "A_I_B", "x y", "\\u0041", "\\\"", "\xC3\xBC", "\xFF", "\x7F", "\t", "a\\", "{}"}) {
    check_agreement(std::string("{\"t\":5,\"symbol\":\"") + name + "\",\"value\":1}");
  }
}

TEST_CASE("Damaged lines give the same result or error as with a JSON reader") {
  std::mt19937 random(45);
  const std::vector<std::string> seeds = {"{\"t\":5,\"symbol\":\"A_I_B\",\"value\":true}",
                                          "{\"t\":1000000,\"symbol\":\"N\",\"value\":-12.5e1}",
                                          "{\"t\":7,\"symbol\":\"A_I_B\",\"value\":1}"};
  const std::string bytes = "{}[]\",:.-+eE0159tfnu \\\x01\xC3\xBC";
  const auto pick = [&](std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random); };
  for (int i = 0; i < 3000; ++i) {
    std::string line = seeds[pick(seeds.size())];
    for (std::size_t edits = 1 + pick(2); edits != 0; --edits) {
      const std::size_t at = pick(line.size());
      const char byte = bytes[pick(bytes.size())];
      const std::size_t kind = pick(4);
      if (kind == 0) line[at] = byte;
      if (kind == 1) line.insert(at, 1, byte);
      if (kind == 2) line.erase(at, 1);
      if (kind == 3) line.resize(at);
      if (line.empty()) line = byte;
    }
    check_agreement(line);
  }
}

}  // namespace
}  // namespace symplant::test
