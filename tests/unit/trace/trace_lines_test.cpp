// What all lines of a trace have in common.
#include "symplant/trace/trace_lines.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

#include "support/catch.hpp"

namespace symplant::trace {
namespace {

struct Read {
  std::vector<tables::Time> times;
  std::size_t number;
  std::string error;
  bool cut_off;
};

Read read(const std::string& text) {
  std::istringstream file(text);
  TraceLines lines(file);
  Read read{};
  nlohmann::json line;
  while (lines.next(line)) read.times.push_back(lines.time());
  read.number = lines.number();
  read.error = lines.error();
  read.cut_off = lines.cut_off();
  return read;
}

const std::string kHeader = "{\"symplant-trace\":1}\n";

TEST_CASE("Lines are read in order, empty ones and ends of line of Windows are no matter") {
  const Read well = read(kHeader + "{\"t\":5}\r\n\n{\"t\":5}\n{\"t\":7}\n");
  CHECK(well.error == "");
  CHECK(well.times == std::vector<tables::Time>{0, 5, 5, 7});
  CHECK(well.number == 5);
  CHECK_FALSE(well.cut_off);
}

TEST_CASE("A last line that is cut off is left out, another one is an error") {
  const Read cut = read(kHeader + "{\"t\":5}\n{\"t\":7");
  CHECK(cut.error == "");
  CHECK(cut.cut_off);
  CHECK(cut.times == std::vector<tables::Time>{0, 5});
  const Read broken = read(kHeader + "{\"t\":5\n{\"t\":7}\n");
  CHECK(broken.error == "this is not a line of a trace");
  CHECK(broken.number == 2);
  CHECK(read("{\"symplant-tr").error == "the file ends within its first line, so it has no changes");
  CHECK(read("symplant-tr").error == "this is not a line of a trace");
}

TEST_CASE("Times do not go back, except where the plant was set back") {
  CHECK(read(kHeader + "{\"t\":5}\n{\"t\":4}\n").error == "this time is before that of the line above");
  CHECK(read(kHeader + "{\"t\":5}\n{\"t\":0,\"reset\":\"\"}\n{\"t\":1}\n").error == "");
  CHECK(read(kHeader + "{\"t\":5}\n{\"t\":2,\"restored\":\"a\"}\n").times == std::vector<tables::Time>{0, 5, 2});
  for (const char* time : {"-1", "1.5", "\"1\"", "9223372036854775807", "18446744073709551616", "null"}) {
    INFO(time);
    CHECK(read(kHeader + "{\"t\":" + time + "}\n").error == "the key `t` is not a time in ns");
  }
  CHECK(read(kHeader + "{\"symbol\":\"X\"}\n").error == "the key `t` is not a time in ns");
}

TEST_CASE("A trace begins with a header of version 1, and has parts, but no second trace") {
  CHECK(read("").error == "the file is empty");
  CHECK(read("{\"t\":5}\n").error == "a trace begins with a line with `symplant-trace`");
  CHECK(read("{\"symplant-trace\":2}\n").error == "this symplant reads version 1 of traces");
  CHECK(read(kHeader + "{\"t\":5}\n{\"symplant-trace\":1,\"part\":2,\"t\":6}\n{\"t\":6}\n").error == "");
  CHECK(read(kHeader + kHeader).error == "another trace begins here: read one at a time");
}

}  // namespace
}  // namespace symplant::trace
