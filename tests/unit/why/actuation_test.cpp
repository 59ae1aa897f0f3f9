// Why a moving device moves, has stopped midway, or is held by a command.
#include <array>

#include "why_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("A move names the command that started it, and when it arrives") {
  const DescribedPlant cell(with_prefix(kCell), "\"name\": \"x\"");
  Asked asked(cell);
  asked.set("AGV_O_P2").to(500).set("AGV_O_P2", 0).to(700);
  CHECK(asked.why("AGV") ==
        "L_P_AGV has been in P1->P2 since 0.5 s, %QX3 (operation P2, symbols.csv:5) was on from 0.5 s to 0.7 s, and "
        "arrives in 0.8 s\n");
  CHECK(asked.why("AGV", false) ==
        "L_P_AGV has been in P1->P2 since 0.5 s, %QX3 (operation P2, symbols.csv:5) was on from 0.5 s to 0.7 s\n");
}

TEST_CASE("A held device stops without a command") {
  const DescribedPlant cell(with_prefix(kCell), R"("devices": {"L_P_AGV": {"actuation": "held"}})");
  Asked asked(cell);
  asked.set("AGV_O_P2").to(500).set("AGV_O_P2", 0).to(700);
  CHECK(asked.why("AGV") ==
        "L_P_AGV has been in P1->P2, stopped midway since 0.7 s: %QX3 (operation P2, symbols.csv:5) has been off since "
        "0.7 s\n");
}

TEST_CASE("A held device with commands in both directions does not move") {
  const DescribedPlant cell(with_prefix(kCell), R"("devices": {"L_P_AGV": {"actuation": "held"}})");
  Asked asked(cell);
  asked.set("AGV_O_P2").to(500).set("AGV_O_P1").to(700);
  CHECK(asked.why("AGV") ==
        "L_P_AGV has been in P1->P2, stopped midway since 0.7 s: it has commands in both directions\n"
        "    %QX2 (operation P1, symbols.csv:4) has been on since 0.7 s\n"
        "    %QX3 (operation P2, symbols.csv:5) has been on since 0.5 s\n");
}

TEST_CASE("A move whose `while` does not hold names what it needs") {
  const DescribedPlant cell(with_prefix({"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AIR_I_OK"}),
                            R"("devices": {"L_P_AGV": {"transitions": [
      {"from": "P1", "to": "P2", "while": "L_P_AIR_I_OK"}]}})");
  Asked asked(cell);
  asked.set("AGV_O_P2").to(500);
  CHECK(asked.why("AGV") ==
        "L_P_AGV has been in P1->P2, stopped midway since 0.5 s: `while` needs L_P_AIR_I_OK\n"
        "    L_P_AIR_I_OK has been off since the start, PLC input %IX3, event OK of L_P_AIR (symbols.csv:5): no device "
        "drives it\n");
}

TEST_CASE("A spring is held by its command") {
  const DescribedPlant plant(with_prefix({"CYL_I_ADV", "CYL_I_RET", "CYL_O_ADV"}), "\"name\": \"x\"");
  Asked asked(plant);
  CHECK(asked.why("CYL") ==
        "L_P_CYL has been in RET since the start: %QX2 (operation ADV, symbols.csv:4) has never been on\n");
  asked.set("CYL_O_ADV").to(500).to(1500);
  CHECK(asked.why("CYL") ==
        "L_P_CYL has been in ADV since 1.5 s: %QX2 (operation ADV, symbols.csv:4) has been on since 0.5 s, and goes to "
        "RET when it is off\n");
}

TEST_CASE("A spring reaches its rest state without a command") {
  const DescribedPlant plant(
      with_prefix({"CYL_I_ADV", "CYL_I_RET", "CYL_O_ADV", "GATE_I_SHUT", "GATE_O_OPEN"}),
      R"("devices": {"L_P_GATE": {"transitions": [{"from": "SHUT", "to": "OPEN", "when": "L_P_CYL.RET"}]}})");
  Asked asked(plant);
  asked.set("CYL_O_ADV").to(500).to(1500).set("GATE_O_OPEN").to(2000);
  CHECK(contains(asked.why("GATE"),
                 "\n    L_P_CYL has been in ADV since 1.5 s: %QX2 (operation ADV, symbols.csv:4) has "
                 "been on since 0.5 s, and goes to RET when it is off\n"));
}

TEST_CASE("A custom behavior that asks for states is named") {
  const DescribedPlant plant(with_prefix({"ARM_I_A1", "ARM_I_B2", "ARM_O_B2"}),
                             R"("devices": {"L_P_ARM": {"behaviour": "Picker"}})");
  const std::array<engine::Behaviour, 1> code{
      engine::Behaviour{.wanted = [](engine::BehaviourView&) noexcept { return tables::kNoState; }}};
  CHECK(contains(Asked(plant, code).why("ARM"), "\n    the custom behavior `Picker` asks for no other state\n"));
  CHECK_FALSE(contains(Asked(plant).why("ARM"), "Picker"));
}

}  // namespace
}  // namespace symplant::test
