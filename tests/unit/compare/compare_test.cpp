// What differs between two traces: one cause is one line.
#include "compare_support.hpp"

namespace symplant::test {
namespace {

using compare::Align;
using compare::Options;
using tables::kMillisecond;

Options with_window(long ms, Align align = Align::none) {
  Options options;
  options.window = ms * kMillisecond;
  options.align = align;
  return options;
}

TEST_CASE("Equal traces do not differ, whatever the order of their lines at one time") {
  CHECK(differences("10 X 1; 10 Y 1; 20 X 0", "10 Y 1; 10 X 1; 20 X 0") == "");
  CHECK(Compared("10 X 1; 20 X 0", "10 X 1; 20 X 0").comparison.changes == 2);
}

TEST_CASE("A change beyond the window is late or early by the difference") {
  CHECK(differences("10 X 1; 500 X 0", "40 X 1; 500 X 0") == "at 0.01 s: `X` late by 0.03 s: on");
  CHECK(differences("40 X 1; 500 X 0", "10 X 1; 500 X 0") == "at 0.04 s: `X` early by 0.03 s: on");
  CHECK(differences("10 X 1; 500 X 0", "40 X 1; 500 X 0", with_window(30)) == "");
  CHECK(differences("10 X 1; 500 X 0", "40 X 1; 500 X 0", with_window(29)) == "at 0.01 s: `X` late by 0.03 s: on");
}

TEST_CASE("A pulse that one trace does not have is one line") {
  CHECK(differences("10 X 1; 20 X 0; 100 X 1; 200 X 0", "100 X 1; 200 X 0") == "at 0.01 s: `X` missing: on for 0.01 s");
  CHECK(differences("100 X 1; 200 X 0", "10 X 1; 20 X 0; 100 X 1; 200 X 0") ==
        "at 0.01 s: `X` unexpected: on for 0.01 s");
  CHECK(differences("10 X 1; 200 X 0", "10 X 1; 50 X 0; 60 X 1; 200 X 0") ==
        "at 0.05 s: `X` unexpected: off for 0.01 s");
  CHECK(differences("10 X 1; 300 Y 1", "300 Y 1") == "at 0.01 s: `X` missing: on");
}

TEST_CASE("A symbol without any line is off all the time in a trace, and was not recorded in a recording") {
  CHECK(differences("10 X 1; 100 Y 1", "100 Y 1") == "at 0.01 s: `X` missing: on");
  CHECK(differences("100 Y 1", "10 X 1; 100 Y 1") == "at 0.01 s: `X` unexpected: on");
  const Compared recording("10 X 1; 100 Y 1", "100 Y 1", {}, "", ",\"recorded\":true,\"every\":1000000");
  CHECK(recording.lines() == "");
  REQUIRE(recording.comparison.not_recorded.size() == 1);
  CHECK(recording.comparison.not_recorded[0]->name == "X");
}

TEST_CASE("A change that comes only after the next one of its symbol is missing, not late") {
  CHECK(differences("10 X 1; 50 X 0; 500 Y 1", "60 X 1; 90 X 0; 500 Y 1") ==
        "at 0.01 s: `X` missing: on\n"
        "at 0.05 s: `X` late by 0.04 s: off\n"
        "at 0.06 s: `X` unexpected: on");
}

TEST_CASE("A pulse that a recording cannot have seen is no difference") {
  const std::string recorded = ",\"recorded\":true,\"every\":50000000";
  const std::string exact = "10 X 1; 10 X 0; 1000 X 1; 1090 X 0; 2000 X 1; 2100 X 0; 3000 X 1; 3500";
  const std::string read = "0 X 0; 3050 X 1; 3500";
  CHECK(Compared(exact, read, {}, "", recorded).lines() == "at 2 s: `X` missing: on for 0.1 s");
  CHECK(Compared(read, exact, {}, recorded).lines() == "at 2 s: `X` unexpected: on for 0.1 s");
  CHECK(Compared(exact, "3050 X 1; 3500", {}, "", ",\"cycle\":50000000").comparison.differences.size() ==
        3);  // a trace
  CHECK(Compared(read, exact, {}, recorded, "").comparison.differences.size() == 1);
  CHECK(Compared("0 X 0; 500 X 1; 550 X 0; 3000", "0 Y 1; 10 X 0; 3000", {}, recorded).lines() ==
        "at 0.5 s: `X` missing: on for 0.05 s");  // ACTUAL, a trace, would have it
  CHECK(Compared(exact, read, with_window(50), "", recorded).lines() ==
        "at 1 s: `X` missing: on for 0.09 s\nat 2 s: `X` missing: on for 0.1 s");
}

TEST_CASE("Words have the digits that times of a recording are exact to") {
  const auto words = [](tables::Time time, tables::Time by, tables::Time exact_to) {
    const recording::Series series{"X", recording::Series::Kind::boolean, {}, {}, {}};
    compare::Difference late{compare::Difference::Kind::late, &series, time, by, 1, 1};
    late.exact_to = exact_to;
    return compare::sentence(late);
  };
  CHECK(words(1'234'567'891, 250'000'001, 50 * kMillisecond) == "at 1.235 s: `X` late by 0.25 s: on");
  CHECK(words(1'234'567'891, 250'000'001, 0) == "at 1.234567891 s: `X` late by 0.250000001 s: on");
  CHECK(words(0, 250, 50 * kMillisecond) == "at 0 s: `X` late by 0.00000025 s: on");
  CHECK(Compared("0 X 1", "250 X 1; 300", {}, ",\"recorded\":true,\"every\":20000000")
            .comparison.differences.front()
            .exact_to == 20 * kMillisecond);
}

TEST_CASE("With follow what comes after a late change is not late again") {
  const std::string good = "10 X 1; 110 Y 1; 210 X 0; 310 Y 0; 400";
  const std::string late = "40 X 1; 140 Y 1; 240 X 0; 340 Y 0; 400";
  CHECK(differences(good, late).find("at 0.31 s") != std::string::npos);
  CHECK(differences(good, late, with_window(0, Align::follow)) == "at 0.01 s: `X` late by 0.03 s: on");
}

TEST_CASE("With follow a change of the same time that follows from a late one is not missing") {
  // Y goes on for 20 ms when X comes on, which is 30 ms late: without X's offset Y is missing.
  const std::string good = "5 Y 1; 10 X_O_GO 1; 10 Y 0; 30 Y 1; 400";
  const std::string late = "5 Y 1; 40 X_O_GO 1; 40 Y 0; 60 Y 1; 400";
  CHECK(differences(good, late, with_window(0, Align::follow)) == "at 0.01 s: `X_O_GO` late by 0.03 s: on");
}

TEST_CASE("With follow the offset of the symbol counts if it is the nearer one") {
  // X is 30 ms late from its first change on; Y, between, is not.
  CHECK(differences("10 X 1; 20 Y 1; 100 X 0; 110 Y 0; 400", "20 Y 1; 40 X 1; 110 Y 0; 130 X 0; 400",
                    with_window(0, Align::follow)) ==
        "at 0.01 s: `X` late by 0.03 s: on\n"
        "at 0.02 s: `Y` early by 0.03 s: on");
}

TEST_CASE("Aligned by a symbol, times count from its first change to on") {
  Options options;
  options.align = Align::symbol;
  options.align_symbol = "X";
  CHECK(differences("10 X 1; 30 Y 1", "510 X 1; 530 Y 1", options) == "");
  CHECK(differences("10 X 1; 30 Y 1", "510 X 1; 540 Y 1", options) == "at 0.03 s: `Y` late by 0.01 s: on");
  options.align_symbol = "Z";
  CHECK(Compared("10 X 1", "10 X 1", options).comparison.error == "good.jsonl has no change of `Z`; did you mean `X`?");
  options.align_symbol = "Y";
  CHECK(Compared("10 Y 1", "10 Y 0", options).comparison.error == "`Y` never comes on in run.jsonl");
}

TEST_CASE("What one trace has after the end of the other is one line") {
  CHECK(differences("10 X 1; 20 X 0; 30 X 1", "10 X 1") ==
        "at 0.01 s: ACTUAL ends here: 2 changes of EXPECTED are later");
  CHECK(differences("10 X 1", "10 X 1; 20 X 0") == "at 0.01 s: EXPECTED ends here: 1 change of ACTUAL is later");
  CHECK(differences("10 X 1; 30", "10 X 1; 20 X 0; 30") == "at 0.02 s: `X` unexpected: off");
}

TEST_CASE("Numbers differ above the tolerance, for longer than the window") {
  CHECK(differences("10 N 100; 50 N 0; 90", "10 N 100; 50 N 0; 90") == "");
  CHECK(differences("10 N 100; 50 N 0; 90", "10 N 101; 50 N 0; 90") == "");  // 1 % of the span
  CHECK(differences("10 N 100; 50 N 0; 90", "10 N 102; 50 N 0; 90") ==
        "at 0.01 s: `N` deviates for 0.04 s: 102, not 100");
  CHECK(differences("10 N 100; 50 N 0; 90", "20 N 100; 50 N 0; 90") ==
        "at 0.01 s: `N` deviates for 0.01 s: 0, not 100");
  CHECK(differences("10 N 100; 50 N 0; 90", "20 N 100; 50 N 0; 90", with_window(10)) == "");
  CHECK(differences("10 N 100", "10 N 0") == "at 0.01 s: `N` deviates for 0 s: 0, not 100");  // at the very end
  Options exact;
  exact.tolerance = 0;
  CHECK(differences("10 N 100; 90", "10 N 100.5; 90", exact) == "at 0.01 s: `N` deviates for 0.08 s: 100.5, not 100");
  CHECK(differences("10 N \"nan\"; 90", "10 N \"nan\"; 90", exact) == "");
  CHECK(differences("10 N \"nan\"; 90", "10 N 1; 90", exact) != "");
}

TEST_CASE("Numbers follow the offset, too") {
  CHECK(differences("10 X 1; 20 N 5; 60 N 0; 400", "40 X 1; 50 N 5; 90 N 0; 400", with_window(0, Align::follow)) ==
        "at 0.01 s: `X` late by 0.03 s: on");
}

TEST_CASE("A number that only one trace has is 0 in the other") {
  CHECK(differences("10 X 1; 20 N 5; 60", "10 X 1; 60") == "at 0.02 s: `N` deviates for 0.04 s: 0, not 5");
  CHECK(differences("10 X 1; 60", "10 X 1; 20 N 5; 60") == "at 0.02 s: `N` deviates for 0.04 s: 5, not 0");
}

TEST_CASE("Parts are compared where they arrive, if both traces have parts") {
  CHECK(differences("10 body@BELT; 50 body@OUT", "10 body@BELT; 50 body@OUT") == "");
  CHECK(differences("10 body@BELT; 50 body@OUT; 90", "10 body@BELT; 60 lid@OUT; 90") ==
        "at 0.05 s: `body at OUT` missing: arrives\n"
        "at 0.06 s: `lid at OUT` unexpected: arrives");
  CHECK(differences("10 X 1; 20 body@BELT", "10 X 1; 20") == "");
}

TEST_CASE("Patterns choose what is compared, and one that matches nothing may be a mistake") {
  Options only;
  only.only = {"X*"};
  CHECK(differences("10 X 1; 20 Y 1", "10 X 1; 15 Y 1; 20", only) == "");
  Options ignore;
  ignore.ignore = {"Y"};
  CHECK(differences("10 X 1; 20 Y 1", "10 X 1; 15 Y 1; 20", ignore) == "");
  only.only = {"Z*"};
  CHECK(Compared("10 X 1", "10 X 1", only).comparison.warning == "no symbol with a change matches `Z*`");
  CHECK(Compared("10 X 1", "10 X 1", only).comparison.error.empty());
  CHECK(differences("10 X 1", "10 X 1", only) == "");
  ignore.ignore = {"X"};
  CHECK(differences("10 X 1", "10 X 0", ignore) == "");
}

TEST_CASE("Traces without a change do not differ") { CHECK(differences("10", "20") == ""); }

TEST_CASE("A window of centuries is no window of nothing") {
  Options options;
  options.window = std::numeric_limits<tables::Time>::max();
  CHECK(differences("10 X 1; 20 X 0", "11 X 1; 22 X 0", options) == "");
}

TEST_CASE("Without a window times of a cycle or an interval are exact to twice the coarser one") {
  CHECK(Compared("10 X 1", "10 X 1").comparison.window == 0);
  CHECK(Compared("10 X 1", "10 X 1", {}, ",\"clock\":\"virtual\"", ",\"clock\":\"real\",\"cycle\":10000000")
            .comparison.window == 20 * kMillisecond);
  CHECK(Compared("10 X 1", "10 X 1", {}, ",\"recorded\":true,\"every\":50000000", ",\"cycle\":10000000")
            .comparison.window == 100 * kMillisecond);
}

}  // namespace
}  // namespace symplant::test
