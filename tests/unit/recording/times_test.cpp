// How the times of tables are read.
#include "recording_support.hpp"

namespace symplant::test {
namespace {

/// The times of the rows in ms from the first one, or the error.
std::string times(const std::string& header, const std::string& first, const std::string& second,
                  const std::string& unit = "") {
  const recording::ReadRecording read =
      read_csv_text(header + ";X\n" + first + ";0\n" + second + ";1\n", {"", unit, {}});
  if (!read.error.empty()) return read.error;
  std::ostringstream text;
  text.precision(12);
  text << static_cast<double>(read.recording.end) / 1e6;
  return text.str();
}

TEST_CASE("Units are those of the header") {
  for (const char* const header : {"Time [ms]", "time (ms)", "t/ms", "time_ms", "Time ms", "TIMESTAMP [ ms ]",
                                   "timestamp_ms", "Zeit [ms]", "time in ms", "Elapsed Time (milliseconds)"}) {
    INFO(header);
    CHECK(times(header, "5", "7.5") == "2.5");
  }
  CHECK(times("t [s]", "5", "7,5") == "2500");
  CHECK(times("t [us]", "5", "7500") == "7.495");
  CHECK(times("t [\xC2\xB5s]", "5", "7500") == "7.495");
  CHECK(times("t [ns]", "5", "7500000") == "7.499995");
}

TEST_CASE("A unit that is given counts more than that of the header") {
  CHECK(times("t [ms]", "5", "7", "s") == "2000");
  CHECK(times("t", "5", "7", "us") == "0.002");
  CHECK(times("t", "5", "7", "filetime") == "0.0002");
}

TEST_CASE("A unit that is given and is not that of the header is a warning") {
  const auto warnings = [](const std::string& header, const std::string& cell, const std::string& unit) {
    const recording::ReadRecording read = read_csv_text("X;" + header + "\n0;" + cell + "\n", {"", unit, {}});
    CHECK(read.error == "");
    return read.warnings;
  };
  const auto ms = warnings("t [ms]", "5", "s");
  REQUIRE(ms.size() == 1);
  CHECK(ms[0] == "t.csv:1:2: the times in column `t [ms]` are in ms by the header, and --time-unit is s, which counts");
  CHECK(warnings("t [ms]", "5", "ms").empty());
  CHECK(warnings("t [ms]", "5", "").empty());
  CHECK(warnings("t", "5", "s").empty());
  CHECK(warnings("t [ms]", "2024-05-01T23:59:59Z", "iso").empty());
}

TEST_CASE("Times of clocks show their unit by their size, and a number with decimals is in s") {
  CHECK(times("t", "1714550400", "1714550401") == "1000");
  CHECK(times("t", "1714550400000", "1714550400001") == "1");
  CHECK(times("t", "1714550400000000", "1714550400001000") == "1");
  CHECK(times("t", "1714550400000000000", "1714550400001000000") == "1");
  CHECK(times("t", "133590240000000000", "133590240000010000") == "1");
  CHECK(times("t", "0", "0.25") == "250");
  CHECK(times("t", "0", "2.5E-01") == "250");
}

TEST_CASE("Times are exact to 1 ns") {
  CHECK(times("t/s", "1714550400.123456789", "1714550400.123456790") == "1e-06");
  CHECK(times("t/ms", "-0.5", "0.5") == "1");
}

TEST_CASE("Dates and times of day are read") {
  CHECK(times("t", "2024-05-01T23:59:59.5Z", "2024-05-02T00:00:00Z") == "500");
  CHECK(times("t", "2024-05-01 10:00:00,25", "2024-05-01 10:00:00,5") == "250");
  CHECK(times("t", "2024-05-01T10:00:00+02:00", "2024-05-01T08:00:01Z") == "1000");
  CHECK(times("t", "2024-05-01T10:00:00 -0330", "2024-05-01T13:30:01 UTC") == "1000");
  CHECK(times("t", "2009/1/20 10:15:20", "2009/1/20 10:15:21.5") == "1500");
  CHECK(times("t", "28.02.2024 23:59:59", "29.02.2024 00:00:00") == "1000");
  CHECK(times("t", "01.04.98 11:59:59 AM", "01.04.98 12:00:00 PM") == "1000");
  CHECK(times("t", "10:00:00.5", "10:00:01") == "500");
  CHECK(times("t", "23:59:59.9", "00:00:00.1") == "200");
  CHECK(times("t [ms]", "10:00:00.5", "10:00:01") == "500");
}

TEST_CASE("Which number of a date is the month is decided by the dates") {
  CHECK(times("t", "01/02/2024 23:59:59", "01/02/2024 23:59:59.5") == "500");
  CHECK(times("t", "31/01/2024 23:59:59", "01/02/2024 00:00:00") == "1000");
  CHECK(times("t", "01/31/2024 23:59:59", "02/01/2024 00:00:00") == "1000");
  CHECK(times("t", "03/04/2024 23:59:59", "04/04/2024 00:00:00") == "1000");
  CHECK(times("t", "03/04/2024 23:59:59", "03/05/2024 00:00:00") == "1000");
  CHECK(csv("t;X\n03/04/2024 00:00:00;0\n04/04/2024 00:00:00;1\n06/04/2024 00:00:00;0\n") ==
        "X bool 0=0 8.64e+07=1 2.592e+08=0\nend 2.592e+08, resolution 8.64e+07\n");
  CHECK(times("t", "03/04/2024 00:00:00", "05/06/2024 00:00:00") ==
        "t.csv:3:1: `05/06/2024 00:00:00` is not a time; it is not known which number is the month; write "
        "dates such as 2024-12-31");
}

TEST_CASE("Wrong times are reported") {
  CHECK(times("t", "2024-05-01 10:00", "2024-02-30 10:00") ==
        "t.csv:3:1: `2024-02-30 10:00` is not a time; there is no such day; write a time such as "
        "2024-12-31T23:59:59.5");
  for (const char* const wrong : {"2024-05-01 24:00:00", "2024-05-01 10:60:00", "2024-05-01 10:00:00 XX", "2024-05",
                                  "2024-05-01 13:00:00 PM", "2024-05-01 10:00:00+1", "x", "2024-05-01T"}) {
    INFO(wrong);
    CHECK(contains(times("t", "2024-05-01 10:00:00", wrong), "is not a time; write a time such as 20"));
  }
  CHECK(contains(times("t/s", "0", "99999999999999999999"), "is not a time; write a number"));
  CHECK(contains(times("t/s", "0", "99999999999"), "is not a time; write a number"));
  CHECK(contains(times("t/s", "0", "1e99"), "is not a time; write a number"));
}

TEST_CASE("A date and a time of day may have a column each") {
  const std::string wanted = "X bool 0=0 500=1\nend 500, resolution 500\n";
  CHECK(csv("Date;Time;X\n2024-05-01;23:59:59.5;0\n2024-05-02;00:00:00;1\n") == wanted);
  CHECK(csv("Date;Time;X\n2024-05-01;2024-05-01 10:00:00;0\n2024-05-01;2024-05-01 10:00:00.5;1\n") == wanted);
  CHECK(csv("Date;Time [s];X\n2024-05-01;7,5;0\n2024-05-01;8;1\n") == wanted);
}

TEST_CASE("The column of times can be given by its header or number") {
  const std::string text = "no;moment;X\n1;0;0\n2;10;1\n";
  CHECK(csv(text, {"moment", "ms", {}}) == "no number 0=1 10=2\nX bool 0=0 10=1\nend 10, resolution 10\n");
  CHECK(csv(text, {"2", "ms", {}}) == csv(text, {"Moment", "ms", {}}));
}

}  // namespace
}  // namespace symplant::test
