// The nearest of some names.
#include "symplant/tables/nearest.hpp"

#include "unit/condition/condition_support.hpp"

namespace symplant::test {
namespace {

std::string nearest(std::string_view wanted, const std::vector<std::string_view>& names) {
  tables::NearestName nearest(wanted);
  for (const std::string_view name : names) nearest.offer(name);
  return std::string(nearest.name());
}

TEST_CASE("The name with the fewest slips is the nearest, the first of several") {
  CHECK(nearest("RUN2", {"IDLE1", "RUN3", "RUN1"}) == "RUN3");
  CHECK(nearest("L_P_STOPER1", {"L_P_STOPPER2", "L_P_STOPPER1"}) == "L_P_STOPPER1");
  CHECK(nearest("AVD", {"RET", "ADV"}) == "ADV");
  CHECK(nearest("clamp", {"CLAMPED", "CLAMP"}) == "CLAMP");
}

TEST_CASE("A name that is too different is not the nearest") {
  CHECK(nearest("RUN2", {"IDLE1"}) == "");
  CHECK(nearest("AB", {"CD"}) == "");
  CHECK(nearest("", {"ABC"}) == "");
  CHECK(nearest("A", {"B"}) == "B");
  const std::string long_name(5000, 'A');
  CHECK(nearest(long_name, {long_name}) == "");
}

}  // namespace
}  // namespace symplant::test
