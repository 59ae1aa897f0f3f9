// What the rules that were found on real lists report, and what they must not.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/compile.hpp"

namespace symplant::test {
namespace {

/// A list of device comments: addresses from X10 on.
std::string comments(const std::vector<std::string>& texts) {
  std::string list = "Device Name,Comment\n";
  for (std::size_t i = 0; i < texts.size(); ++i) list += fmt::format("X{:X},{}\n", 0x10 + i, texts[i]);
  return list;
}

std::size_t reported(const std::vector<std::string>& texts, std::string_view rule) {
  return analyse_text(comments(texts)).count(rule);
}

TEST_CASE("Two spellings differ within the word, and one of them is used twice") {
  const auto found = [](const std::vector<std::string>& texts) { return reported(texts, "two-spellings"); };
  CHECK(found({"SAFETY A", "SAFETY B", "SAFTY C"}) == 1);
  CHECK(found({"signal a", "SIGNAL B", "SINGAL C"}) == 1);
  CHECK(found({"SAFETY A", "SAFTY C"}) == 0);             // which one is the word?
  CHECK(found({"PULSE A", "PULSE B", "PULSES C"}) == 0);  // another form
  CHECK(found({"START A", "START B", "TART C"}) == 0);
  CHECK(found({"TOWER A", "TOWER B", "POWER C"}) == 0);  // another word
  CHECK(found({"GATE A", "GATE B", "GTE C"}) == 0);      // too short
  CHECK(found({"SAFETY A", "SAFETY B", "한SAFTY C"}) == 0);
  CHECK(found({"tankLevel", "siloLevel", "tankLevelL"}) == 0);  // low
  CHECK(found({"OvenBlower", "PressBlower", "BBlower"}) == 0);  // a prefix of the type
  CHECK(found({"tankLevel", "siloLevel", "tankLveel"}) == 1);
}

TEST_CASE("Structures as types are one finding, a misspelled type is one for each row") {
  const Analysed list = analyse_text(
      "Name,Data Type,Logical Address\nA_In,PD_TEL1_IN,%I256.0\nA_Out,PD_TEL1_OUT,%Q256.0\nB_In,PD_TEL1_IN,%I260.0\n"
      "S1_Q_X,Bool,%Q0.0\nS1_I_X,Bol,%I0.0\nT1,Time,%ID300\n");
  CHECK(list.count("type-of-no-io") == 3);
  std::string messages;
  for (const diag::Diagnostic& finding : list.diagnostics.all()) messages += finding.message + "\n";
  CHECK(messages.find("`A_In` on `%I256.0` and 2 more have a structure as type (`PD_TEL1_IN` and 1 more), and are left "
                      "out; list the elements, each with its address") != std::string::npos);
  CHECK(messages.find("`Bol` is no type of an input or output") != std::string::npos);
  CHECK(messages.find("`Time` is no type of an input or output") != std::string::npos);
}

TEST_CASE("Comments are cut if several of the longest end within a word that the list has") {
  const auto found = [](const std::vector<std::string>& texts) { return reported(texts, "text-cut"); };
  const std::vector<std::string> cut{"GATE 1 IS OPEN AND LOC", "GATE 2 IS OPEN AND LOC", "GATE 3 IS OPEN AND LOC"};
  const auto with = [&](const std::string& text) {
    std::vector<std::string> texts = cut;
    texts.push_back(text);
    return texts;
  };
  CHECK(found(with("GATE LOCKED")) == 1);
  CHECK(found(with("GATE CLOSED")) == 0);                          // no word begins so
  CHECK(found(with("LOC LOCKED")) == 0);                           // it is one
  CHECK(found(with("GATE 4 IS OPEN AND LOCKED")) == 0);            // longer
  CHECK(found({cut[0], cut[1], "GATE LOCKED"}) == 0);              // too few
  CHECK(found({"A 1 LOC", "A 2 LOC", "A 3 LOC", "LOCKED"}) == 0);  // shorter than any field
}

std::vector<std::string> numbers(const std::vector<int>& values) {
  std::vector<std::string> texts;
  for (const int value : values) texts.push_back(fmt::format("ECHO {} OF ROBOT", value));
  return texts;
}

TEST_CASE("A series is broken by one member, where all others rise by one or double") {
  const auto found = [](const std::vector<int>& values) { return reported(numbers(values), "series-broken"); };
  CHECK(found({1, 2, 4, 8, 16, 32, 64, 12}) == 1);
  CHECK(found({1, 2, 3, 4, 4, 6, 7}) == 1);
  CHECK(found({1, 2, 4, 8, 16, 32, 64, 128}) == 0);
  CHECK(found({1, 2, 3, 4, 5, 6, 7}) == 0);
  CHECK(found({1, 2, 3, 4, 9}) == 0);           // too short
  CHECK(found({1, 2, 3, 7, 8, 9, 10}) == 0);    // two series
  CHECK(found({1, 1, 2, 2, 3, 3, 4, 4}) == 0);  // pairs
  CHECK(found({5, 2, 3, 4, 5, 6, 7}) == 0);     // the first numbers say what the series is
}

TEST_CASE("A comment of two points is reported where nearly all others are unique") {
  std::vector<std::string> unique;
  for (char c = 'A'; c <= 'Y'; ++c) unique.push_back(std::string("SENSOR ") + c + c + c);
  const auto found = [&](std::vector<std::string> texts) {
    texts.insert(texts.begin(), unique.begin(), unique.end());
    return reported(texts, "comment-twice");
  };
  CHECK(found({"GATE IS OPEN", "GATE IS OPEN"}) == 1);
  CHECK(found({"GATE IS OPEN", "GATE IS OPEN", "GATE IS OPEN"}) == 0);  // means one thing, or is a spare
  CHECK(found({"SPARE", "SPARE"}) == 0);                                // too short
  CHECK(found({"GATE IS OPEN", "GATE IS OPEN", "DOOR IS OPEN", "DOOR IS OPEN"}) == 0);  // two of 27
}

TEST_CASE("A name of an input or output in memory is reported in lists that have devices") {
  std::vector<Row> rows = bits({"L_P_D_O_ON1", "L_P_D_I_ON1"});
  rows.push_back({"L_P_D_I_OFF2", "M100"});
  CHECK(analyse_rows(rows).count("io-name-in-memory") == 1);
  rows.back().name = "COUNTER_READY";
  CHECK(analyse_rows(rows).count("io-name-in-memory") == 0);
  CHECK(analyse_rows({{"L_P_D_I_OFF2", "M100"}}).count("io-name-in-memory") == 0);
}

TEST_CASE("Names are compared with the limit of the list's tool, and with the words of IEC 61131-3") {
  const std::string device = "L_P_" + std::string(24, 'D');
  CHECK(analyse_rows(bits({device + "_O_A", device + "_I_A"})).count("name-too-long") == 0);  // 32 characters
  CHECK(analyse_rows(bits({device + "_O_AB", device + "_I_A"})).count("name-too-long") == 1);
  CHECK(analyse_rows(bits({"STEP", "RUN", "L_P_D_O_STEP"})).count("reserved-word") == 1);
}

}  // namespace
}  // namespace symplant::test
