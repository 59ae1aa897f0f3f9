// Names that differ by a slip from the intended ones.
#include "support/catch.hpp"
#include "support/compile.hpp"

namespace symplant::test {
namespace {

/// The messages of SP205.
std::vector<std::string> slips_of(const std::vector<std::string>& names) {
  std::vector<std::string> messages;
  const Analysed list = analyse_rows(bits(names));
  for (const diag::Diagnostic& finding : list.diagnostics.all()) {
    if (finding.rule->id == "SP205") messages.push_back(finding.message);
  }
  return messages;
}

std::vector<std::string> clamps(int count) {
  std::vector<std::string> names;
  for (int i = 1; i <= count; ++i) {
    for (const char* part : {"O_ADV", "O_RET", "I_ADV", "I_RET"}) {
      names.push_back("L_ST" + std::to_string(i) + "_CLAMP1_" + part);
    }
  }
  return names;
}

TEST_CASE("A symbol that another device lacks belongs to it") {
  std::vector<std::string> names = clamps(5);
  names[9] = "L_ST3_CLAPM1_O_RET";
  CHECK(slips_of(names) ==
        std::vector<std::string>{"`CLAPM1` looks like a typo of `CLAMP1`, and `L_ST3_CLAMP1` lacks just "
                                 "this symbol; write `CLAMP1` if that is meant"});
}

TEST_CASE("A task that no sibling has is the missing one of its device") {
  std::vector<std::string> names = clamps(5);
  names[6] = "L_ST2_CLAMP1_I_AVD";
  CHECK(slips_of(names) ==
        std::vector<std::string>{"`AVD` looks like a typo of `ADV`, and `L_ST2_CLAMP1` lacks just this "
                                 "symbol; write `ADV` if that is meant"});
}

TEST_CASE("A word of two letters is reported if a device lacks this symbol, not because it is rare") {
  std::vector<std::string> names = clamps(9);
  for (std::string& name : names) name.replace(name.find("CLAMP"), 5, "PIN");
  names[9].replace(names[9].find("PIN"), 3, "PN");
  CHECK(slips_of(names).size() == 1);
  std::vector<std::string> whole = clamps(9);
  for (std::string& name : whole) name.replace(name.find("CLAMP"), 5, "PIN");
  for (std::size_t i = 8; i < 12; ++i) whole[i].replace(whole[i].find("PIN"), 3, "PN");
  CHECK(slips_of(whole).empty());
}

TEST_CASE("Without siblings the other direction confirms a slip") {
  const auto slips = slips_of({"L_P_TABLE_O_WORK", "L_P_TABLE_I_WORK", "L_P_TABLE_O_LOAD", "L_P_TABEL_I_LOAD"});
  REQUIRE(slips.size() == 1);
  CHECK_THAT(slips[0], Catch::Matchers::StartsWith(
                           "`TABEL` looks like a typo of `TABLE`, and `L_P_TABLE` lacks just this symbol"));
}

TEST_CASE("A device misspelled in all rows is reported once, by its rare word") {
  std::vector<std::string> names = clamps(9);
  for (std::size_t i = 8; i < 12; ++i) names[i].replace(names[i].find("CLAMP"), 5, "CLMP");
  CHECK(slips_of(names) == std::vector<std::string>{"`CLMP1` looks like a typo of `CLAMP1`, which 8 symbols have "
                                                    "if digits are ignored; write `CLAMP1` if that is meant"});
}

TEST_CASE("A line and a process are reported by their rare words") {
  std::vector<std::string> names = clamps(9);
  for (std::string& name : names) name.replace(0, 4, "BODY_CELL");
  names.push_back("BDOY_CELL1_LAMP_O_ON");
  names.push_back("BODY_CLEL1_HORN_O_ON");
  const auto slips = slips_of(names);
  REQUIRE(slips.size() == 2);
  CHECK_THAT(slips[0], Catch::Matchers::StartsWith("`BDOY` looks like a typo of `BODY`, which 37 symbols have"));
  CHECK_THAT(slips[1], Catch::Matchers::StartsWith("`CLEL1` looks like a typo of `CELL1`, which 37 symbols have"));
}

TEST_CASE("Two lines, two words of one unit, and near words of different devices are no slips") {
  CHECK(slips_of(clamps(9)).empty());
  std::vector<std::string> lines = clamps(3);
  for (const std::string& name : clamps(3)) lines.push_back("LINEA" + name.substr(1));
  for (const std::string& name : clamps(3)) lines.push_back("LINEB" + name.substr(1));
  CHECK(slips_of(lines).empty());
  // FWD and BWD differ by a letter, LAMP and CLAMP too; CLOSE and CLOSED are two words (SP405).
  std::vector<std::string> names = clamps(9);
  names.push_back("L_ST1_LAMP1_O_ON");
  for (const char* task : {"O_FWD", "O_BWD", "I_FWD", "I_BWD"}) names.push_back(std::string("L_ST1_CONV_") + task);
  for (const char* task : {"O_CLOSE", "I_CLOSED"}) names.push_back(std::string("L_ST1_DOOR_") + task);
  CHECK(slips_of(names).empty());
}

TEST_CASE("A lamp and a button, two axes and two types of one code are no slips") {
  std::vector<std::string> panel;
  for (const char* n : {"1", "2", "3", "4", "5", "6", "7", "8", "9"}) {
    panel.push_back("L_P_PB" + std::string(n) + "_I_START");
    panel.push_back("L_P_PL" + std::string(n) + "_O_START");
  }
  panel.push_back("L_P_PL10_O_START");  // its button is elsewhere
  panel.push_back("L_P_PB11_I_START");
  CHECK(slips_of(panel).empty());
  CHECK(slips_of({"L_P_PB1_I_START", "L_P_PL1_O_START"}).empty());
  CHECK(slips_of({"L_P_PBLX_I_ON", "L_P_PBLX_O_OFF", "L_P_PBLY_O_ON", "L_P_PBLY_I_OFF"}).empty());
  CHECK(slips_of({"L_P_AXISX_O_HOME", "L_P_AXISX_O_WORK", "L_P_AXISX_I_WORK", "L_P_AXISY_I_HOME"}).empty());
  CHECK(slips_of({"L_P_4P303A_O_ON", "L_P_4U303A_I_ON", "L_P_4P304A_I_ON", "L_P_4U304A_O_ON"}).empty());
  // In long words, too, an operation has no event's word: no LIGHT is commanded, no NIGHT is reported.
  CHECK(slips_of({"L_P_NIGHT1_O_ON", "L_P_LIGHT1_I_ON", "L_P_LIGHT2_I_ON"}).empty());
}

TEST_CASE("Two devices that differ in their line and complement each other are one warning with both spellings") {
  const auto messages = [](const std::vector<std::string>& names) {
    std::vector<std::string> found;
    const Analysed list = analyse_rows(bits(names));
    for (const diag::Diagnostic& finding : list.diagnostics.all()) {
      if (finding.severity != diag::Severity::note) found.push_back(finding.message);
    }
    return found;
  };
  CHECK(messages({"EXCELL_MB_AGV_I_P1", "EXCELL_MB_AGV_I_P2", "EXLINE_MB_AGV_O_P1", "EXLINE_MB_AGV_O_P2"}) ==
        std::vector<std::string>{"`EXLINE` looks like a typo of `EXCELL`, or the reverse: `EXLINE_MB_AGV` has just "
                                 "what `EXCELL_MB_AGV` lacks; write `EXCELL` if that is meant"});
  CHECK(
      messages({"EXCELL_MB_AGV_I_P1", "EXLINE_MB_AGV_I_P2", "EXLINE_MB_AGV_O_P1", "EXLINE_MB_AGV_O_P2"}) ==
      std::vector<std::string>{"`EXCELL` looks like a typo of `EXLINE`, or the reverse: `EXCELL_MB_AGV` has just what "
                               "`EXLINE_MB_AGV` lacks; write `EXLINE` if that is meant"});
  // A process, too, but not one with another number; not a device, since `PB` and `PL` are a button and its lamp.
  CHECK(slips_of({"L_MB_AGV_I_P1", "L_MB_AGV_I_P2", "L_MAIN_AGV_O_P1", "L_MAIN_AGV_O_P2"}).size() == 1);
  CHECK(slips_of({"L_ST1_AGV_I_P1", "L_ST1_AGV_I_P2", "L_ST2_AGV_O_P1", "L_ST2_AGV_O_P2"}).empty());
  CHECK(slips_of({"L_P_PB_I_START", "L_P_PB_I_STOP", "L_P_PL_O_START", "L_P_PL_O_STOP"}).empty());
  // One task each is no evidence, nor are other tasks, and of three lines it is not known which belong together.
  CHECK(slips_of({"A_P_PB_I_ON", "B_P_PB_O_ON"}).empty());
  CHECK(slips_of({"A_P_D_I_P1", "A_P_D_I_P2", "B_P_D_O_P1", "B_P_D_O_P3"}).empty());
  CHECK(slips_of({"A_P_D_I_P1", "A_P_D_I_P2", "B_P_D_O_P1", "B_P_D_O_P2", "C_P_D_O_P1", "C_P_D_O_P2"}).empty());
}

TEST_CASE("A single symbol with another letter in a short code is still a slip") {
  std::vector<std::string> names = clamps(9);
  for (std::string& name : names) name.replace(name.find("CLAMP"), 5, "PIN");
  names[9].replace(names[9].find("PIN"), 3, "PUN");
  CHECK(slips_of(names).size() == 1);
}

TEST_CASE("Complete devices that differ in a letter are no slips") {
  CHECK(slips_of({"L_P_VALVEA_O_OPEN", "L_P_VALVEA_I_OPEN", "L_P_VALVEB_O_OPEN", "L_P_VALVEB_I_OPEN"}).empty());
}

}  // namespace
}  // namespace symplant::test
