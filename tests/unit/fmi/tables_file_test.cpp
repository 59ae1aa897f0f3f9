// Tables as bytes.
#include "symplant/fmi/tables_file.hpp"

#include "simulation.hpp"
#include "symplant/fmi/library_plant.hpp"
#include "symplant/fmi/state_bytes.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::fmi {

const CompiledPlant* compiled_plant() { return nullptr; }

}  // namespace symplant::fmi

namespace symplant::test {
namespace {

const std::vector<Row> kBelt = {
    {"L_P_BELT_O_RUN"}, {"L_P_BELT_I_RUN"}, {"L_P_EYE_I_PART"}, {"L_P_T_I_RAW", "", "INT", "0", "%IW2"}};
const std::string kEverything = R"json("inverted": ["L_P_EYE_I_PART"],
  "devices": {"L_P_BELT": {"transitions": [{"from": "*", "to": "RUN", "takes": {"mean": "1s", "sigma": "100ms"}}]}},
  "values": {"load": {"unit": "kg", "start": 2, "min": 0, "max": 10}, "double": {"is": "curve(load, 0, 1, 10, 5)"
}
},
  "signals": {"L_P_T_I_RAW": {"of": "double", "noise": 1}},
  "material": {"kinds": {"box": {"length": "100 mm"}},
               "tracks": {"belt": {"length": "1 m", "drives": [{"forward": "L_P_BELT.RUN", "speed": "1 m/s"}],
                                   "sensors": [{"symbol": "L_P_EYE_I_PART", "at": "500 mm"}]}},
               "sources": [{"name": "s", "at": "belt", "kind": "box", "count": 1}]},
  "malfunctions": [{"name": "jam", "of": "L_P_BELT", "stuck": true, "chance": {"mean": "1h", "sigma": "1min"}}],
  "requirements": [{"name": "light", "never": "load > 5"}])json";

std::string error_of(std::string_view bytes) {
  const auto read = fmi::LoadedTables::read(bytes);
  const auto* const error = std::get_if<std::string>(&read);
  return error == nullptr ? "" : *error;
}

TEST_CASE("Tables read from bytes are those that were written") {
  const Simulation plant(kBelt, kEverything);
  const std::string bytes = fmi::write_tables(plant.described.rows);
  const auto read = fmi::LoadedTables::read(bytes);
  REQUIRE(std::holds_alternative<std::unique_ptr<const fmi::LoadedTables>>(read));
  const tables::PlantTables& tables = std::get<std::unique_ptr<const fmi::LoadedTables>>(read)->tables();
  CHECK(tables::model_hash(tables) == tables::model_hash(plant.described.rows));
  CHECK(tables.list_names == plant.described.rows.list_names);
  CHECK(tables.symbols[2].row == plant.described.rows.symbols[2].row);
  CHECK(fmi::write_tables(tables) == bytes);
}

TEST_CASE("Damaged and foreign bytes are refused, whatever is damaged") {
  const Simulation plant(kBelt, kEverything);
  const std::string bytes = fmi::write_tables(plant.described.rows);
  CHECK(error_of(bytes).empty());
  CHECK(error_of("") == "it is not a file of tables");
  for (std::size_t size = 0; size < bytes.size(); ++size) REQUIRE_FALSE(error_of(bytes.substr(0, size)).empty());
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    INFO("byte " << at);
    REQUIRE_FALSE(error_of(damaged).empty());
  }
  CHECK(error_of(bytes + "x") == "it is damaged");
}

TEST_CASE("The bytes of a state are refused if they are damaged, or of another plant") {
  Simulation plant(kBelt, kEverything);
  plant.instance.begin();
  plant.step(100);
  const std::uint64_t model = plant.instance.plant().model_hash();
  const std::string bytes = fmi::state_bytes(plant.instance.save(), 2, model);
  const auto read = fmi::read_state(bytes, model);
  REQUIRE(read.has_value());
  CHECK(read->extra == 2);
  CHECK(plant.instance.restore(read->state));
  CHECK_FALSE(fmi::read_state(bytes, model + 1).has_value());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    REQUIRE_FALSE(fmi::read_state(bytes.substr(0, size), model).has_value());
  }
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    REQUIRE_FALSE(fmi::read_state(damaged, model).has_value());
  }
}

TEST_CASE("The folder of resources is a URI") {
  using fmi::path_of_uri;
  CHECK(path_of_uri("file:///tmp/my%20cell/resources", false) == "/tmp/my cell/resources");
  CHECK(path_of_uri("file:/tmp/r", false) == "/tmp/r");
  CHECK(path_of_uri("file://localhost/tmp/r", false) == "/tmp/r");
  CHECK(path_of_uri("/tmp/r", false) == "/tmp/r");
  CHECK(path_of_uri("file:///C:/my%20cell/r", true) == "C:/my cell/r");
  CHECK(path_of_uri("file:///tmp/100%", false) == "/tmp/100%");
  CHECK(path_of_uri("file:", false).empty());
}

}  // namespace
}  // namespace symplant::test
