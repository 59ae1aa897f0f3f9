// Explanations name the malfunctions that are active.
#include "symplant/why/malfunction_words.hpp"

#include "why_support.hpp"

namespace symplant::test {
namespace {

/// The cell with a malfunction of each kind that changes a unit or a symbol.
DescribedPlant cell() {
  return {with_prefix(kCell), R"("malfunctions": [
    {"name": "jam", "of": "L_P_AGV", "stuck": true},
    {"name": "rust", "of": "L_P_AGV", "slower": 3},
    {"name": "wire", "force": {"L_P_AGV_I_P1": false}},
    {"name": "contact", "flicker": {"symbol": "L_P_MC_I_IDLE1", "every": "1 h", "for": "1 s"}}],
    "requirements": [{"name": "one", "never": "L_P_MC.RUN2"}])"};
}

void start(Asked& asked, std::uint32_t malfunction) {
  REQUIRE(asked.plant.start_malfunction(malfunction, engine::MalfunctionChange::By::hand));
}

TEST_CASE("A stuck device is disabled by its malfunction, a slow one is slowed by it") {
  const DescribedPlant plant = cell();
  Asked asked(plant);
  asked.to(100).set("AGV_O_P2");
  start(asked, 0);
  asked.to(150);
  CHECK(contains(asked.why("AGV"), "L_P_AGV has been in P1, disabled by malfunction `jam` since 0.1 s"));
  asked.to(160).plant.stop_malfunction(0, engine::MalfunctionChange::By::hand);
  start(asked, 1);
  asked.to(200);
  CHECK_FALSE(contains(asked.why("AGV"), "jam"));
  CHECK(contains(asked.why("AGV"), ", slowed by malfunction `rust`"));
  CHECK_FALSE(contains(asked.why("MC"), "malfunction"));
}

TEST_CASE("A symbol that a malfunction overrides says so, and ordinary malfunctions are named like others") {
  const DescribedPlant plant = cell();
  Asked asked(plant);
  asked.to(100);
  start(asked, 2);
  start(asked, 3);
  asked.to(150);
  CHECK(contains(asked.why("AGV_I_P1"),
                 "L_P_AGV_I_P1 has been off since 0.1 s, forced by malfunction `wire`, PLC input"));
  CHECK(contains(asked.why("MC_I_IDLE1"), ", forced by malfunction `contact`, PLC input"));
  CHECK_FALSE(contains(asked.why("AGV_I_P2"), "malfunction"));
  const tables::MalfunctionNumbers numbers(plant.rows);
  start(asked, numbers.stuck(plant.symbol("L_P_AGV_I_P1"), true));
  start(asked, numbers.slow(plant.unit("L_P_MC")));
  asked.to(200);
  CHECK(
      contains(asked.why("AGV_I_P1"), "has been on since 0.15 s, forced by malfunction `L_P_AGV_I_P1 stuck on`, PLC"));
  CHECK(contains(asked.why("MC"), ", slowed by malfunction `L_P_MC slow`"));
}

TEST_CASE("A violated requirement names the active malfunctions that no cause names") {
  const DescribedPlant plant = cell();
  Asked asked(plant);
  asked.to(100);
  start(asked, 0);
  start(asked, 1);
  asked.state("MC", "RUN2").to(150);
  const std::string words =
      why::in_one_line(asked.explainer.violation(0, why::RecordedView(asked.history(), 150 * kMs, &asked.plant)));
  CHECK(contains(words, "; malfunction `jam` is active since 0.1 s; malfunction `rust` is active since 0.1 s"));

  why::Explanation explanation{"L_P_AGV is disabled by malfunction `jam`", {}, {}};
  why::add_malfunctions(explanation, asked.names(), asked.history().malfunctions());
  REQUIRE(explanation.because.size() == 1);
  CHECK(explanation.because.front().sentence == "malfunction `rust` is active since 0.1 s");
}

}  // namespace
}  // namespace symplant::test
