// Sequences, devices with similar names, and forms of one word: what is reported and what is accepted.
#include "check/rule.hpp"
#include "check/words.hpp"
#include "check_support.hpp"

namespace symplant::test {
namespace {

/// A device whose tasks each have an operation and an event.
std::vector<Row> device_with(const std::vector<std::string>& tasks) {
  std::vector<std::string> names;
  for (const std::string& task : tasks) {
    names.push_back("L_P_D_O_" + task);
    names.push_back("L_P_D_I_" + task);
  }
  return bits(names);
}

std::vector<std::string> names_of(const diag::Diagnostic& finding) {
  std::vector<std::string> names;
  for (const diag::Subject& subject : finding.subjects.about) names.push_back(subject.name);
  return names;
}

std::size_t subject(const std::vector<Row>& rows, std::string_view slug) { return analyse_rows(rows).count(slug); }

TEST_CASE("A gap is one or a few missing numbers among regular steps") {
  CHECK(subject(device_with({"P1", "P2", "P4"}), "sequence-gap") == 1);
  CHECK(subject(device_with({"P1", "P3", "P4"}), "sequence-gap") == 1);
  CHECK(subject(device_with({"P1", "P2", "P3", "P6"}), "sequence-gap") == 1);
  CHECK(subject(device_with({"P10", "P20", "P40"}), "sequence-gap") == 1);
  CHECK(subject(device_with({"P1", "P2", "P4", "P5", "P7"}), "sequence-gap") == 1);  // P3 and P6, rolled up
  CHECK(subject(device_with({"P1", "P2", "P3"}), "sequence-gap") == 0);
  CHECK(subject(device_with({"P10", "P20", "P30"}), "sequence-gap") == 0);
  CHECK(subject(device_with({"P1", "P3"}), "sequence-gap") == 0);
  CHECK(subject(device_with({"P1", "P2", "P100"}), "sequence-gap") == 0);
  CHECK(subject(device_with({"P3", "P4", "P5"}), "sequence-gap") == 0);
  CHECK(subject(device_with({"P1", "P2", "P99999999999999999999999999"}), "sequence-gap") == 0);
}

TEST_CASE("A number repeats if one pair has it, more pairs count sensors") {
  CHECK(subject(device_with({"HOME1", "JOB2", "DONE2"}), "sequence-repeated") == 1);
  CHECK(subject(device_with({"HOME1", "JOB1", "DONE2"}), "sequence-repeated") == 1);
  CHECK(subject(device_with({"HOME1", "JOB2", "DONE3"}), "sequence-repeated") == 0);
  CHECK(subject(device_with({"ADV1", "RET1", "ADV2", "RET2"}), "sequence-repeated") == 0);
  CHECK(subject(device_with({"A1", "B1", "C1"}), "sequence-repeated") == 0);
  CHECK(subject(device_with({"ADV1", "RET1"}), "sequence-repeated") == 0);
}

/// `whole` clamps of two tasks, then `single` clamps with only the coil OPEN.
std::vector<Row> clamps(int whole, int single) {
  std::vector<std::string> names;
  for (int i = 1; i <= whole + single; ++i) {
    const std::string device = "L_P_CLAMP" + std::to_string(i);
    names.push_back(device + "_O_OPEN");
    if (i <= whole) names.push_back(device + "_O_CLOSE");
    names.push_back(device + "_I_OPEN*");
    names.push_back(device + "_I_CLOSE");
  }
  return bits(names);
}

TEST_CASE("A missing symbol is reported if three other devices and three quarters of them have it") {
  CHECK(subject(clamps(3, 1), "shape-lacks-symbol") == 1);
  CHECK(subject(clamps(2, 1), "shape-lacks-symbol") == 0);
  CHECK(subject(clamps(14, 2), "shape-lacks-symbol") == 2);
  CHECK(subject(clamps(9, 3), "shape-lacks-symbol") == 0);  // three of them: single solenoids
  CHECK(subject(clamps(5, 0), "shape-lacks-symbol") == 0);
}

TEST_CASE("Names alike differ only in digits, in any case, process and line") {
  std::vector<std::string> names;
  for (const std::string device : {"L_P_CLAMP1", "L_P_Clamp2", "L_Q_clamp03", "M_P_CLAMP4"}) {
    for (const char* part : {"_O_OPEN", "_O_Close", "_I_OPEN*", "_I_CLOSE"}) names.push_back(device + part);
  }
  for (const char* part : {"_O_OPEN", "_I_OPEN*", "_I_CLOSE"}) names.push_back(std::string("M_P_CLAMP5") + part);
  CHECK(subject(bits(names), "shape-lacks-symbol") == 1);
  CHECK(check::class_name("S1Clamp02B") == "S#CLAMP#B");
}

TEST_CASE("The finding names the missing symbol, and is at the other symbol of its task") {
  const Analysed list = analyse_rows(clamps(4, 1));
  REQUIRE(list.fired() == "shape-lacks-symbol");
  const diag::Diagnostic& finding = list.diagnostics.all()[0];
  CHECK(finding.message.find("`L_P_CLAMP5` has no operation `CLOSE`: 4 of 5 devices") == 0);
  CHECK(names_of(finding) == std::vector<std::string>{"L_P_CLAMP5", "L_P_CLAMP5_O_CLOSE"});
  CHECK(finding.location.source->line_at(finding.location.span.begin).find("L_P_CLAMP5_I_CLOSE") !=
        std::string_view::npos);
}

TEST_CASE("A missing number is reported like a missing bit, also for devices with numbers only") {
  std::vector<std::string> names;
  for (const std::string i : {"1", "2", "3", "4", "5"}) {
    for (const char* part : {"_O_RUN", "_I_RUN", "_O_STOP", "_I_STOP*"}) names.push_back("L_P_DRIVE" + i + part);
  }
  std::vector<Row> rows = bits(names);
  const auto number = [&](const std::string& name, std::size_t location) {
    rows.push_back({name, "", "INT", "0", "%IW" + std::to_string(100 + location)});
  };
  for (std::size_t i = 1; i <= 5; ++i) {
    if (i != 2) number("L_P_DRIVE" + std::to_string(i) + "_I_SPEED", 10 * i);
    number("L_P_TANK" + std::to_string(i) + "_I_LEVEL", 10 * i + 1);
    if (i != 4) number("L_P_TANK" + std::to_string(i) + "_I_HEAT", 10 * i + 2);
  }
  const Analysed list = analyse_rows(rows);
  REQUIRE(list.fired() == "shape-lacks-symbol shape-lacks-symbol");
  CHECK_THAT(list.diagnostics.all()[0].message,
             Catch::Matchers::StartsWith("`L_P_DRIVE2` has no event `SPEED`: 4 of 5 devices"));
  CHECK_THAT(list.diagnostics.all()[1].message,
             Catch::Matchers::StartsWith("`L_P_TANK4` has no event `HEAT`: 4 of 5 devices"));
  CHECK(names_of(list.diagnostics.all()[1]) == std::vector<std::string>{"L_P_TANK4", "L_P_TANK4_I_HEAT"});
}

TEST_CASE("A device with too many bits is not reported to lack them if it has numbers") {
  std::vector<std::string> names;
  for (int i = 1; i <= 5; ++i) names.push_back("L_P_WELDER" + std::to_string(i) + "_I_ON");
  for (int i = 101; i <= 180; ++i) names.push_back("L_P_WELDER3_I_ON" + std::to_string(i));
  std::vector<Row> rows = bits(names);
  for (int i = 1; i <= 5; ++i)
    rows.push_back({"L_P_WELDER" + std::to_string(i) + "_I_HEAT", "", "INT", "0", "%IW" + std::to_string(100 + i)});
  const Analysed list = analyse_rows(rows);
  CHECK(list.count("unit-too-large") == 1);
  CHECK(list.count("shape-lacks-symbol") == 0);
}

TEST_CASE("Forms of one word match, other words and other numbers do not") {
  for (const auto& [a, b] : {std::pair{"CLAMP", "CLAMPED"},
                             {"CLOSE", "CLOSED"},
                             {"CLOSE", "CLOSING"},
                             {"GRIP", "GRIPPED"},
                             {"ADV", "ADVANCED"},
                             {"run2", "RUNNING2"},
                             {"RISE", "RISEN"}}) {
    INFO(a << " " << b);
    CHECK(check::bent_alike(a, b));
    CHECK(check::bent_alike(b, a));
  }
  for (const auto& [a, b] : {std::pair{"CLAMP", "CLAMP"},
                             {"CLAMP1", "CLAMPED2"},
                             {"OPEN", "CLOSE"},
                             {"UP", "UPPER"},
                             {"P1", "P2"},
                             {"", "ED"},
                             {"HOME", "HOT"}}) {
    INFO(a << " " << b);
    CHECK_FALSE(check::bent_alike(a, b));
  }
}

TEST_CASE("Two forms of one word are reported for a device with further tasks, too") {
  const auto reported = [](const std::vector<std::string>& names) {
    return analyse_rows(bits(names)).fired(diag::Severity::warning);
  };
  CHECK(reported({"L_P_D_O_OPEN", "L_P_D_I_OPEN", "L_P_D_O_CLAMP", "L_P_D_I_CLAMPED"}) == "two-words-one-state");
  CHECK(reported({"L_P_D_O_HOME1", "L_P_D_I_HOME1", "L_P_D_O_WELD2", "L_P_D_I_WELDED2"}) == "two-words-one-state");
  CHECK(reported({"L_P_D_O_CLAMP", "L_P_D_I_CLAMPED"}) == "two-words-one-state");
}

TEST_CASE("Two words of one state explain nothing of the device's other tasks") {
  const Analysed list =
      analyse_rows(bits({"L_P_D_O_START", "L_P_D_I_STARTED", "L_P_D_I_HOME", "L_P_D_I_FAULT", "L_P_D_O_RESET"}));
  REQUIRE(list.fired(diag::Severity::warning) == "two-words-one-state event-without-operation event-without-operation");
  for (const diag::Related& related : list.diagnostics.all()[0].related) {
    INFO(related.message);
    for (const char* other : {"HOME", "FAULT", "RESET"}) CHECK(related.message.find(other) == std::string::npos);
  }
  // The only two tasks of a device may be unrelated words, too.
  CHECK(analyse_rows(bits({"L_P_D_O_RUN", "L_P_D_I_FAULT"})).count("two-words-one-state") == 0);
  CHECK(analyse_rows(bits({"L_P_D_O_RUN", "L_P_D_I_FAULT"})).fired(diag::Severity::warning) ==
        "operation-without-event");
  CHECK(analyse_rows(bits({"L_P_D_O_RESET", "L_P_D_I_FAULT"})).fired(diag::Severity::warning) ==
        "event-without-operation");
}

/// `count` clamps with a coil and three sensors of the position ADV, a second one of RET, and a command `more`.
Analysed clamps_with(int count, const std::string& more) {
  std::vector<std::string> names;
  for (int i = 1; i <= count; ++i) {
    const std::string device = "L_P_CLAMP" + std::to_string(i);
    for (const char* part : {"_O_ADV", "_I_ADV*", "_I_ADVL", "_I_ADVR", "_O_RET", "_I_RET", "_I_RETL"}) {
      names.push_back(device + part);
    }
    names.push_back(device + "_O_" + more);
  }
  return analyse_rows(bits(names));
}

TEST_CASE("Alike findings in devices named alike are one finding with their number and three examples") {
  const Analysed list = clamps_with(4, "BLOW");
  REQUIRE(list.fired(diag::Severity::warning) == "event-without-operation operation-without-event");
  const diag::Diagnostic& events = list.diagnostics.all()[0];
  CHECK_THAT(events.message, Catch::Matchers::StartsWith("`L_P_CLAMP1_I_ADVL` reports `ADVL` of `L_P_CLAMP1`"));
  CHECK_THAT(events.message, Catch::Matchers::EndsWith("; 11 more like `CLAMP#`: `L_P_CLAMP1_I_ADVR`, "
                                                       "`L_P_CLAMP1_I_RETL`, `L_P_CLAMP2_I_ADVL` and 8 more"));
  REQUIRE(events.related.size() == 11);
  CHECK_THAT(events.related[10].message, Catch::Matchers::StartsWith("also: `L_P_CLAMP4_I_RETL` reports"));
  const diag::Diagnostic& commands = list.diagnostics.all()[1];
  CHECK_THAT(commands.message, Catch::Matchers::EndsWith("; 3 more like `CLAMP#`: `L_P_CLAMP2_O_BLOW`, "
                                                         "`L_P_CLAMP3_O_BLOW`, `L_P_CLAMP4_O_BLOW`"));
}

TEST_CASE("Each symbol of alike findings is ignored by itself") {
  std::vector<std::string> names{"L_P_C1_O_A", "L_P_C1_I_A*", "L_P_C1_O_B", "L_P_C1_I_B", "L_P_C1_O_X",
                                 "L_P_C2_O_A", "L_P_C2_I_A*", "L_P_C2_O_B", "L_P_C2_I_B", "L_P_C2_O_X"};
  description::Description description;
  description.check.ignore = {{"SP401", "L_P_C1_O_X", "blows", ""}};
  const Analysed list = analyse_lists({{"symbols.csv", list_text(bits(names))}}, std::move(description));
  REQUIRE(list.count("operation-without-event") == 1);
  CHECK(list.diagnostics.ignored().size() == 1);
  CHECK_THAT(list.diagnostics.all()[0].message, Catch::Matchers::StartsWith("`L_P_C2_O_X` commands"));
  CHECK(list.diagnostics.all()[0].related.empty());
}

TEST_CASE("A command without feedback by nature has no finding") {
  for (const char* word : {"RESET", "reset", "RST", "ACK", "BYPASS", "LAMP", "LAMP2"}) {
    INFO(word);
    CHECK(clamps_with(1, word).count("operation-without-event") == 0);
  }
  for (const char* word : {"PRESET", "BLOW", "START", "RESETTING"}) {
    INFO(word);
    CHECK(clamps_with(1, word).count("operation-without-event") == 1);
  }
}

}  // namespace
}  // namespace symplant::test
