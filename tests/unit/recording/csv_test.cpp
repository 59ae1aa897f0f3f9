// What is read of tables of other tools.
#include "recording_support.hpp"

namespace symplant::test {
namespace {

using recording::ReadOptions;

TEST_CASE("A wide table has a column for each symbol, and only changes count") {
  CHECK(csv("Time [ms];X_I_A;N\n0;FALSE;1,5\n10;TRUE;1,5\n20;TRUE;\n30;FALSE;2\n") ==
        "X_I_A bool 0=0 10=1 30=0\nN number 0=1.5 30=2\nend 30, resolution 10\n");
}

TEST_CASE("A long table has a symbol and a value in each row, in the order of times or of symbols") {
  const std::string wanted = "X bool 0=0 20=1\nY bool 5=1\nend 20, resolution 5\n";
  CHECK(csv("time,tag,value,quality\n1.000,X,0,192\n1.005,Y,1,192\n1.010,X,0,192\n1.020,X,1,192\n") == wanted);
  CHECK(csv("time,tag,value,quality\n1.000,X,0,192\n1.010,X,0,192\n1.020,X,1,192\n1.005,Y,1,192\n") == wanted);
}

TEST_CASE("Pairs have several columns of times, each for the columns to its right") {
  CHECK(csv("time (s)\tX\tY\ttime (s)\tZ\n0,01\t1\t0\t0,005\t0\n0,02\t0\t0\t0,015\t1\n\t\t\t0,025\t0\n") ==
        "Z bool 0=0 10=1 20=0\nX bool 5=1 15=0\nY bool 5=0\nend 20, resolution 10\n");
}

TEST_CASE("Lines before the header, units below it, comments and EOF are skipped") {
  CHECK(csv("Recorder;Line 2\nDate;2024-05-01\n\n# by hand\nTime;X;N\nms;;mm\n0;1;5\n# "
            "pause\n10;0;6\nEOF\nleft;over\n") == "X bool 0=1 10=0\nN number 0=5 10=6\nend 10, resolution 10\n");
}

TEST_CASE("What follows an empty line and is no row of the table is left out with a warning") {
  CHECK(csv("index,time,X\n0,2024-05-01 10:00:00.000,0\n1,2024-05-01 10:00:00.100,1\n\ncondition,VarX\n") ==
        "index bool 0=0 100=1\nX bool 0=0 100=1\nend 100, resolution 100\n"
        "t.csv:5: what follows the empty line is left out: it is no row with a time\n");
}

TEST_CASE("Separators, quotes and line ends of spreadsheets are read") {
  const std::string wanted = "A;B number 0=1.5 10=2.5\nX bool 0=1 10=0\nend 10, resolution 10\n";
  CHECK(csv("t/ms,\"A;B\",X\r\n0,\"1,5\",true\r\n10,2.5,False\r\n") == wanted);
  CHECK(csv("t/ms;\"A;B\";X\r0;1,5;WAHR\r10;2,5;FALSCH\r") == wanted);
  CHECK(csv("t/ms\tA;B\tX\n0\t 1.5 \tON\n10\t+2.5\tOFF\n") == wanted);
  CHECK(csv("t/ms,\"a \"\"b\"\"\"\n0,1\n") == "a \"b\" bool 0=1\nend 0, resolution 0\n");
}

TEST_CASE("A name of Siemens with quotes is one name, whatever the tool quotes") {
  const std::string wanted = "\"DB1\".x bool 0=1\nend 0, resolution 0\n";
  CHECK(csv("time [s],\"DB1\".x\n0,1\n") == wanted);
  CHECK(csv("time [s],\"\"\"DB1\"\".x\"\n0,1\n") == wanted);
  CHECK(csv("time [s],symbol,value\n0,\"DB1\".x,\"1\"\n") == wanted);
}

TEST_CASE("UTF-16 and UTF-8 with a mark are read, and code pages with a warning") {
  std::string wide = "\xFF\xFE";
  for (const char c : std::string("t/ms\tX\n0\t1\n")) wide += {c, '\0'};
  CHECK(csv(wide) == "X bool 0=1\nend 0, resolution 0\n");
  CHECK(csv("\xEF\xBB\xBFt/ms,X\n0,1\n") == "X bool 0=1\nend 0, resolution 0\n");
  const std::string text =
      csv("t/ms;T\xFCr zu;Gr\xF6\xDF"
          "e\n0;1;5\n10;0;6\n");
  CHECK(contains(text, "T\xC3\xBCr zu bool 0=1 10=0\n"));
  CHECK(contains(text, "t.csv:1:7: the file is read as cp125"));
}

TEST_CASE("Columns of texts and columns without a name are left out") {
  CHECK(csv("t/ms,X,program,\n0,1,MAIN,\n10,0,MAIN,\n") ==
        "X bool 0=1 10=0\nend 10, resolution 10\nt.csv:2:3: `program` has texts, such as `MAIN`, and is left out\n");
}

TEST_CASE("A symbol that has two columns is read from the first") {
  CHECK(csv("t/ms,X,X\n0,1,0\n") ==
        "X bool 0=1\nend 0, resolution 0\nt.csv:1:3: `X` is in column 2, too; this one is left out\n");
}

TEST_CASE("A column of 0 and 1 is of BOOLs, and may be of numbers") {
  const recording::Recording read = read_csv_text("t/ms,X,Y,Z\n0,1,TRUE,1\n10,0,FALSE,2\n").recording;
  CHECK(read.series[0].may_be_number);
  CHECK_FALSE(read.series[1].may_be_number);
  CHECK(read.series[2].kind == recording::Series::Kind::number);
  CHECK_FALSE(read.of_plant);
}

TEST_CASE("A last line that is cut off is left out with one warning") {
  const std::string wanted = "X bool 0=0\nY bool 0=1\nend 0, resolution 0\n";
  const std::string warning = "t.csv:3: the last line is cut off, and is left out\n";
  CHECK(csv("t/ms,X,Y\n0,0,1\n") == wanted);
  CHECK(csv("t/ms,X,Y\n0,0,1") == wanted);
  for (const char* const rest : {"1", "10,", "10", "10,0,TR", "10,\"0", "10,x", "5e", "\xC3"}) {
    INFO(rest);
    CHECK(csv(std::string("t/ms,X,Y\n0,0,1\n") + rest) == wanted + warning);
  }
}

TEST_CASE("Nothing of a last line that is cut off counts") {
  CHECK(csv("t/ms,X,Y\n0,0,1\n10,5,TR") ==
        "X bool 0=0\nY bool 0=1\nend 0, resolution 0\n"
        "t.csv:3: the last line is cut off, and is left out\n");
  CHECK(csv("t/s,X,t/s,Y\n0,0,0,1\n1,1,1,x") ==
        "X bool 0=0\nY bool 0=1\nend 0, resolution 0\n"
        "t.csv:3: the last line is cut off, and is left out\n");
}

TEST_CASE("Cells that say that a value is not known count as empty, with one warning") {
  CHECK(csv("t/ms,X,N\n0,0,NaN\n10,BAD,---\n20,1,5\n30,n/a,5\n40,1,null\n50,0,Bad\n") ==
        "X bool 0=0 20=1 50=0\nN number 20=5\nend 50, resolution 10\n"
        "t.csv:2:3: `NaN` says that the value is not known; such cells count as empty: 6\n");
  CHECK(csv("t/ms,X,Y\n0,0,1\n10,BAD,TR") ==
        "X bool 0=0\nY bool 0=1\nend 0, resolution 0\nt.csv:3: the last line is cut off, and is left out\n");
}

TEST_CASE("Regular rows that are missing are a gap") {
  std::string text = "t/ms,X\n";
  for (int i = 0; i < 100; ++i) text += std::to_string(i * 50 + (i > 60 ? 1000 : 0)) + ",0\n";
  const auto gaps = read_csv_text(text).recording.gaps;
  REQUIRE(gaps.size() == 1);
  CHECK(gaps[0].begin == 3000 * tables::kMillisecond);
  CHECK(gaps[0].length == 1050 * tables::kMillisecond);
  CHECK(read_csv_text("t/ms,X\n0,0\n10,1\n500,0\n").recording.gaps.empty());
}

TEST_CASE("What cannot be read is reported with row and column") {
  const auto error = [](const std::string& text, const ReadOptions& options = {}) {
    return read_csv_text(text, options).error;
  };
  CHECK(error("t/ms,X\n0,1\n10,maybe\n20,0\n") ==
        "t.csv:3:2: `maybe` is not a value; write TRUE, FALSE or a number, or nothing if the value did not "
        "change");
  CHECK(error("t/ms,X\n0,TRUE\n10,5\n") ==
        "t.csv:3:2: there is `5`, but `X` has TRUE or FALSE before; write one kind of values");
  CHECK(error("t/ms,X\n0,5\n10,ON\n") ==
        "t.csv:3:2: there is `ON`, but `X` has numbers before; write one kind of values");
  CHECK(error("t/ms,X\n10,1\n5,0\n") ==
        "t.csv:3:1: the time `5` is before that of the row above; sort the rows by time");
  CHECK(error("t/ms,X\n0,1\nsoon,0\n20,1\n") == "t.csv:3:1: `soon` is not a time; write a number");
  CHECK(error("t/ms,X\n0,1\n,0\n") == "t.csv:3:1: there are values and no time; write it, or delete the row");
  CHECK(
      error("t/ms,X\n0,1\n1,5,2\n") ==
      "t.csv:3:3: there is `2`, but the header has 2 columns; if numbers have a decimal comma, separate cells by `;`");
  CHECK(error("t,X\n0,1\n10,0\n") ==
        "t.csv:1:1: the unit of the times in column `t` is not known; give it, such as --time-unit ms");
  CHECK(error("t/ms,symbol,value\n0,,1\n") == "t.csv:2:2: there is no name of a symbol; write it, or delete the row");
  CHECK(error("t/ms,X\n") == "t.csv:1: no row with a time and values follows this header");
  CHECK(error("t/ms,X\nsoon,1\n") ==
        "t.csv:2:1: `soon` is not a time; write a number, or a time such as 2024-12-31T23:59:59.5");
  CHECK(error("t/ms,X\n0,\"1\n1,0\n") == "t.csv:2: a quote is never closed; close it");
  CHECK(
      error("A,B\n0,1\n") ==
      "t.csv:1: this is no trace, no VCD file and no table with a column of times; name that column in a header, such "
      "as `Time [ms]`, or with --time-column");
  CHECK(
      error("A,B\n0,1\n", {"C", "", {}}) ==
      "t.csv:1: no header has the column `C`; give --time-column as the header or the number of the column with times");
  CHECK(contains(error(std::string("t/ms,X\n0,\0\n", 11)), "t.csv:2:3: "));
  CHECK(error("t/ns,X\n0,1\n4000000000000000000,0\n") ==
        "t.csv:2: the times are over 73 years apart; correct the first or the last one");
}

TEST_CASE("Large tables and cells are no matter") {
  std::string header = "t/ms";
  std::string row = "0";
  for (int i = 0; i < 100'000; ++i) {
    header += ",X" + std::to_string(i);
    row += ",1";
  }
  CHECK(read_csv_text(header + "\n" + row + "\n").recording.series.size() == 100'000);
  CHECK(contains(read_csv_text("t/ms,X\n0,1\n5," + std::string(1'000'000, '9') + "\n9,1\n").error, "is not a value"));
  CHECK(contains(read_csv_text(std::string(3'000'000, ',')).error, "no table with a column of times"));
}

}  // namespace
}  // namespace symplant::test
