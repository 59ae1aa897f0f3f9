// Why a requirement is violated, and what it waits for.
#include "why_support.hpp"

namespace symplant::test {
namespace {

const std::string kRequirements = R"("requirements": [
    {"name": "apart", "never": "L_P_AGV.moving and L_P_MC.RUN2"},
    {"name": "soon", "after": "L_P_AGV_O_P2", "expect": "L_P_AGV.P2", "within": "500ms"},
    {"name": "in_time", "after": "L_P_AGV_O_P2", "expect": "L_P_AGV.P2", "within": {"min": "1.1s", "max": "2s"}}])";

std::string violation(const Asked& asked, std::uint32_t requirement) {
  return why::in_one_line(
      asked.explainer.violation(requirement, why::RecordedView(asked.history(), asked.plant.now(), nullptr)));
}

TEST_CASE("A violated requirement names the devices that it needs changed, the last to change first") {
  const DescribedPlant cell(with_prefix(kCell), kRequirements);
  Asked asked(cell);
  asked.set("MC_O_RUN2").to(100).to(1200).set("MC_O_RUN2", 0).to(1300).set("AGV_O_P2").to(1400);
  CHECK(violation(asked, 0) ==
        "requirement violated: `apart`, its condition must never hold and now holds; "
        "L_P_AGV has been in P1->P2 since 1.4 s, %QX3 (operation P2, symbols.csv:5) has been on since 1.4 s; "
        "L_P_MC has been in RUN2 since 1.1 s, %QX6 (operation RUN2, symbols.csv:8) was on from 0.1 s to 1.3 s");
  CHECK(contains(asked.why("apart"),
                 "requirement `apart` is violated: its condition must never hold and now holds\n"
                 "    L_P_AGV has been in P1->P2 since 1.4 s"));
}

TEST_CASE("A requirement whose expectation did not come names what that lacks") {
  const DescribedPlant cell(with_prefix(kCell), kRequirements);
  Asked asked(cell);
  asked.set("AGV_O_P2").to(200).to(700);
  CHECK(violation(asked, 1) ==
        "requirement violated: `soon`, the expected condition did not become true within 0.5 s; L_P_AGV has been in "
        "P1->P2 since 0.2 s, %QX3 (operation P2, symbols.csv:5) has been on since 0.2 s");
}

TEST_CASE("A requirement whose expectation came too early names what led to it") {
  const DescribedPlant cell(with_prefix(kCell), kRequirements);
  Asked asked(cell);
  asked.set("AGV_O_P2").to(200).to(1100);
  CHECK(contains(asked.why("in_time"), "waits for its expected condition within 1.1 s to 2 s, which needs L_P_AGV.P2"));
  asked.to(1300);
  CHECK(violation(asked, 2) ==
        "requirement violated: `in_time`, the expected condition became true before 1.1 s had passed; L_P_AGV has been "
        "in P2 since 1.2 s, %QX3 (operation P2, symbols.csv:5) has been on since 0.2 s");
}

TEST_CASE("A requirement that is not violated names what it waits for") {
  const DescribedPlant cell(with_prefix(kCell), kRequirements);
  Asked asked(cell);
  CHECK(asked.why("apart") == "requirement `apart` is not violated now: that needs L_P_AGV.moving and L_P_MC.RUN2\n");
  CHECK(asked.why("soon") ==
        "requirement `soon` expects nothing now: its `after` needs L_P_AGV_O_P2\n"
        "    L_P_AGV_O_P2 has been off since the start, PLC output %QX3, operation P2 of L_P_AGV (symbols.csv:5)\n");
  asked.set("AGV_O_P2").to(200);
  CHECK(contains(asked.why("soon"),
                 "requirement `soon` waits for its expected condition within 0.5 s, which needs "
                 "L_P_AGV.P2\n    L_P_AGV has been in P1->P2 since 0.2 s"));
}

TEST_CASE("A symbol and a place in a violated requirement are named with what led to them") {
  const DescribedPlant plant(with_prefix({"AGV_I_P1", "AGV_I_P2", "AGV_O_P2"}), R"(
      "material": {"kinds": {"raw": {"length": "1 m"}}, "tracks": {}, "places": {"BIN": {}}},
      "requirements": [{"name": "none", "never": "L_P_AGV_I_P2 and BIN.part"}])");
  Asked asked(plant);
  asked.put("BIN", -1).set("AGV_O_P2").to(500).to(1500);
  CHECK(violation(asked, 0) ==
        "requirement violated: `none`, its condition must never hold and now holds; L_P_AGV_I_P2 has been on since 1.5 "
        "s, PLC input %IX1, event P2 of L_P_AGV (symbols.csv:3); L_P_AGV has been in P2 since 1.5 s, %QX2 (operation "
        "P2, symbols.csv:4) has been on since 0.5 s; BIN has part 1 (raw) since the start");
}

}  // namespace
}  // namespace symplant::test
