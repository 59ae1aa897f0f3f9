// What is read of VCD files.
#include "recording_support.hpp"

namespace symplant::test {
namespace {

std::string vcd(const std::string& variables, const std::string& changes) {
  return "$version symplant 0.1.0 $end\n$timescale 1 ns $end\n" + variables + "$enddefinitions $end\n#0\n$dumpvars\n" +
         changes;
}

const std::string kVariables =
    "$comment signed \" $end\n$scope module plant $end\n$scope module L $end\n$var string 1 $ L_A $end\n"
    "$var wire 1 ! L_A_I_X $end\n$upscope $end\n$var wire 16 \" N $end\n$var real 64 # R $end\n"
    "$var integer 32 % BELT $end\n$scope module malfunctions $end\n$var wire 1 & jam $end\n$upscope $end\n"
    "$var real 64 ' level $end\n$upscope $end\n";

TEST_CASE("Symbols of a VCD file are read, states, contents, malfunctions and values are not") {
  CHECK(csv(vcd(kVariables,
                "0!\nb0 \"\nr2.5 #\nsP1 $\nb1 %\n1&\nr7 '\n$end\n#5000000\n1!\nb1111111111111101 \"\nsP1->P2 $\n0&\n"
                "#7000000\n0!\nr-inf #\n")) ==
        "R number 0=2.5 7=-inf\nL_A_I_X bool 5=1 7=0\nN number 5=-3\nend 7, resolution 0\n");
}

TEST_CASE("A VCD file is of a plant, and a last line that is cut off is left out") {
  const recording::ReadRecording read = read_csv_text(vcd(kVariables, "0!\n$end\n#5000000\n1!\n#70"));
  CHECK(read.recording.of_plant);
  CHECK(read.recording.end == 5 * tables::kMillisecond);
  CHECK(read.warnings == std::vector<std::string>{"t.csv:24: the last line is cut off, and is left out"});
}

TEST_CASE("A last line of a VCD file without a line end is read if it is complete") {
  const std::string variables =
      "$scope module plant $end\n$var wire 1 ! A $end\n$var wire 1 \" B $end\n"
      "$var wire 1 \"! C $end\n$upscope $end\n";
  CHECK(csv(vcd(variables, "$end\n#5000000\n1!")) == "A bool 5=1\nend 5, resolution 0\n");
  CHECK(csv(vcd(variables, "$end\n#5000000\n1!\n#7000000")) == "A bool 5=1\nend 7, resolution 0\n");
  const std::string warning = ": the last line is cut off, and is left out\n";
  CHECK(csv(vcd(variables, "$end\n#5000000\n1\"")) == "end 5, resolution 0\nt.csv:13" + warning);
  CHECK(csv(vcd(variables, "$end\n#5000000\n1")) == "end 5, resolution 0\nt.csv:13" + warning);
}

TEST_CASE("What cannot be read of a VCD file is reported with its line") {
  const auto error = [](const std::string& changes) { return read_csv_text(vcd(kVariables, changes)).error; };
  CHECK(error("#5\n#4\n") == "t.csv:21: this time is before that above");
  CHECK(error("#x\n") == "t.csv:20: the time `#x` is not a number of ns up to 2305843009213693951");
  CHECK(error("1z\n") == "t.csv:20: there is no variable with the identifier `z`");
  CHECK(error("b12 \"\n") == "t.csv:20: `N` cannot have the value `12`");
  CHECK(error("b1\n") == "t.csv:20: the change `b1` has no identifier");
  CHECK(error("x!\n") == "t.csv:20: `x!` is not a time or a change as symplant writes them");
  CHECK(error("$version symplant 0.1.0 $end\n") == "t.csv:20: another VCD file begins here: read one at a time");
  CHECK(read_csv_text("$timescale 1 ps $end\n").error ==
        "t.csv:1: the time scale is not `1 ns`; only VCD files that symplant wrote are read");
  CHECK(read_csv_text("$version x $end\n").error ==
        "t.csv:1: the header is not complete: `$enddefinitions $end` is missing");
  CHECK(read_csv_text("$var wire 65 ! A $end\n").error == "t.csv:1: the size `65` is not a number from 1 to 64");
  CHECK(read_csv_text("$var wire 1 ! A $end\n$var wire 1 ! B $end\n").error ==
        "t.csv:2: two variables have the identifier `!`");
  CHECK(read_csv_text("$var wire\n").error == "t.csv:1: a variable has a type, a size, an identifier and a name");
}

}  // namespace
}  // namespace symplant::test
