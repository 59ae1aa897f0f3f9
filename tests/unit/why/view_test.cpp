// What a view adds: a standstill, links, and things that the records do not have.
#include "why_support.hpp"

namespace symplant::test {
namespace {

class Phrases final : public why::RecordedView {
 public:
  using RecordedView::RecordedView;
  std::string unwritten(std::uint32_t) const override { return "no link carries it"; }
  std::string violated(std::uint32_t) const override { return "was violated at 3 s"; }
  std::string standstill() const override { return "link slmp: is lost, and the plant is frozen"; }
};

TEST_CASE("The phrases of a view end the sentences that they are about") {
  const DescribedPlant cell(with_prefix(kCell), R"("requirements": [{"name": "one", "never": "L_P_AGV.P2"}])");
  const Asked asked(cell);
  const Phrases view(asked.history(), 0, &asked.plant);
  CHECK(asked.why("AGV", view) ==
        "L_P_AGV has been in P1 since the start: %QX3 (operation P2, symbols.csv:5) has "
        "never been on (no link carries it)\n"
        "    link slmp: is lost, and the plant is frozen\n");
  CHECK(contains(asked.why("AGV_O_P2", view),
                 "L_P_AGV_O_P2 has been off since the start, PLC output %QX3, operation P2 of L_P_AGV "
                 "(symbols.csv:5): no link carries it\n"));
  CHECK(contains(asked.why("one", view), "; it was violated at 3 s\n"));
}

TEST_CASE("A plant at another time is not asked") {
  const DescribedPlant cell(with_prefix(kCell), "\"name\": \"x\"");
  Asked asked(cell);
  asked.set("AGV_O_P2").to(500);
  CHECK(contains(asked.why("AGV", why::RecordedView(asked.history(), 500 * kMs, &asked.plant)), "arrives in 1 s"));
  CHECK_FALSE(contains(asked.why("AGV", why::RecordedView(asked.history(), 400 * kMs, &asked.plant)), "arrives"));
}

}  // namespace
}  // namespace symplant::test
