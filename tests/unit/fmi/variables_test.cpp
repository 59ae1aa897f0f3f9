// The variables of an FMU: references that stay, names that differ.
#include "symplant/fmi/variables.hpp"

#include <set>

#include "simulation.hpp"

namespace symplant::test {
namespace {

TEST_CASE("A value reference stays when other symbols come, go and move") {
  const Simulation one({{"L_P_A_O_ON"}, {"L_P_A_I_ON"}}, R"("name": "t")");
  const Simulation other({{"L_P_B_I_ON"}, {"L_P_A_I_ON"}, {"L_P_B_O_ON"}, {"L_P_A_O_ON"}}, R"("name": "t")");
  for (const fmi::Variable& variable : one.variables.all()) {
    INFO(variable.name);
    CHECK(other.variable(variable.name).reference == variable.reference);
  }
}

TEST_CASE("The malfunction of a new device does not take the reference of a symbol") {
  const Simulation one({{"L17_P15_D15_O_ON"}, {"L17_P15_D15_I_ON"}}, R"("name": "t")");
  const Simulation both({{"L0_P3_D18_O_ON"}, {"L0_P3_D18_I_ON"}, {"L17_P15_D15_O_ON"}, {"L17_P15_D15_I_ON"}},
                        R"("name": "t")");
  const std::uint32_t reference = one.variable("L17_P15_D15_O_ON").reference;
  const Simulation other({{"L0_P3_D18_O_ON"}, {"L0_P3_D18_I_ON"}}, R"("name": "t")");
  REQUIRE(other.variable("L0_P3_D18 stuck").reference == reference);  // the same digest
  CHECK(both.variable("L17_P15_D15_O_ON").reference == reference);
  CHECK(both.variable("L0_P3_D18 stuck").reference != reference);
}

TEST_CASE("Each variable has its own reference of 31 bits, and is found by it") {
  std::vector<Row> rows;
  for (int i = 0; i < 3000; ++i) rows.push_back({"L_P" + std::to_string(i) + "_A_I_ON"});
  const Simulation plant(rows, R"("name": "t")");
  std::set<std::uint32_t> references;
  for (std::uint32_t v = 0; v < plant.variables.all().size(); ++v) {
    const std::uint32_t reference = plant.variables.all()[v].reference;
    references.insert(reference);
    REQUIRE(plant.variables.find(reference) == v);
  }
  CHECK(references.size() == plant.variables.all().size());
  CHECK(*references.rbegin() < 0x8000'0000U);
  std::uint32_t free = 0;
  while (references.count(free) != 0) ++free;
  CHECK_FALSE(plant.variables.find(free).has_value());
}

TEST_CASE("A name that two variables would have is reported") {
  const Simulation plant({{"L_P_A_O_ON"}, {"L_P_A_I_ON"}},
                         R"("malfunctions": [{"name": "L_P_A_I_ON", "of": "L_P_A", "stuck": true}])");
  CHECK(plant.variables.repeated_name() == "L_P_A_I_ON");
}

TEST_CASE("The GUID is that of the model and of the variables") {
  const Simulation one({{"L_P_A_O_ON"}, {"L_P_A_I_ON"}}, R"("name": "t")");
  const Simulation same({{"L_P_A_O_ON"}, {"L_P_A_I_ON"}}, R"("name": "t")");
  const Simulation other(
      {{"L_P_A_O_ON"}, {"L_P_A_I_ON"}},
      R"("name": "t", "devices": {"L_P_A": {"transitions": [{"from": "*", "to": "ON", "takes": "2s"}]}})");
  const auto guid = [](const Simulation& of) { return fmi::guid_of(of.described.rows, of.variables); };
  CHECK(guid(one) == guid(same));
  CHECK(guid(one) != guid(other));
  CHECK(guid(one).size() == 38);
}

}  // namespace
}  // namespace symplant::test
