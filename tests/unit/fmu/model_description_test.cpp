// The description of an FMU with each kind of variable, as a golden file.
#include "fmu/model_description.hpp"

#include "support/described_plant.hpp"
#include "support/golden.hpp"

namespace symplant::test {
namespace {

TEST_CASE("The description of an FMU has each kind of variable, with its type, role, unit, limits and start") {
  const DescribedPlant plant({{"L_P_BELT_O_RUN", "Y0"},
                              {"L_P_BELTLAMP_O_ON", "Y0"},
                              {"L_P_BELT_I_RUN", "X0"},
                              {"L_P_EYE_I_PART", "X1"},
                              {"L_P_START_I_PUSH", "X2", "BOOL", "TRUE"},
                              {"L_P_T_O_SPEED", "", "UDINT", "7", "%QD10"},
                              {"L_P_T_I_RAW", "", "INT", "0", "%IW20"}},
                             R"json("name": "belt & \"eye\"",
  "values": {"load": {"unit": "kg", "start": 2, "min": 0, "max": 10}, "double": {"unit": "kg", "is": "2 * load"},
             "n": {"changes": [{"when": "L_P_BELT.RUN", "to": "n + 1"}]}},
  "signals": {"L_P_T_I_RAW": {"of": "double"}},
  "material": {"kinds": {"box": {"length": "100 mm"}},
               "tracks": {"belt": {"length": "1 m", "drives": [{"forward": "L_P_BELT.RUN", "speed": "1 m/s"}],
                                   "sensors": [{"symbol": "L_P_EYE_I_PART", "at": "500 mm"}]}},
               "sources": [{"name": "s", "at": "belt", "kind": "box", "count": 1}]},
  "malfunctions": [{"name": "jam", "of": "L_P_BELT", "stuck": true}])json");
  const fmi::Variables variables(plant.rows);
  REQUIRE(variables.repeated_name().empty());
  check_golden(SYMPLANT_SOURCE_DIR "/tests/golden/fmu/modelDescription.xml",
               fmu::model_description(plant.compiled().plant, plant.rows, variables, "belt"));
}

}  // namespace
}  // namespace symplant::test
