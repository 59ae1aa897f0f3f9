// The C functions of an FMU: what an importer may do wrong, instances that do not know each other, states as bytes.
#include <filesystem>
#include <fstream>

#include "fmu/importer.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::test {
namespace {

/// The FMU of the example `cell`.
class Cell {
 public:
  Cell() { REQUIRE(std::system(generate().c_str()) == 0); }
  std::string file() const { return folder_ / "cell.fmu"; }
  std::string unpacked() const { return folder_ / "fmu"; }

 private:
  std::string generate() const {
    return "'" SYMPLANT_TOOL "' generate '" SYMPLANT_SOURCE "/examples/cell/plant.json' --fmu '" + file() +
           "' > /dev/null";
  }
  TemporaryFolder folder_;
};

fmi2ValueReference reference(const Fmu& fmu, const std::string& name) { return fmu.variables().at(name).reference; }

void keep_error(fmi2ComponentEnvironment environment, fmi2String, fmi2Status status, fmi2String, fmi2String text, ...) {
  CHECK(status == fmi2Error);
  *static_cast<std::string*>(environment) += text;
}

/// Null, and the messages of a failed instantiation.
fmi2Component instantiate(const Fmu& fmu, const std::string& guid, const std::string& resources, fmi2Type type,
                          std::string& messages) {
  const fmi2CallbackFunctions functions{keep_error, nullptr, nullptr, nullptr, &messages};
  return fmu.functions().instantiate("x", type, guid.c_str(), resources.c_str(), &functions, 0, 0);
}

TEST_CASE("An FMU is not instantiated for model exchange, with another GUID, and without its resources") {
  const Cell cell;
  const Fmu fmu(cell.file(), cell.unpacked());
  std::string text;
  CHECK(instantiate(fmu, fmu.guid(), fmu.resources(), fmi2ModelExchange, text) == nullptr);
  CHECK(text == "this FMU is for co-simulation, not for model exchange");
  text.clear();
  CHECK(instantiate(fmu, "{other}", fmu.resources(), fmi2CoSimulation, text) == nullptr);
  CHECK(text == "the GUID {other} is that of another FMU; this one has " + fmu.guid());
  text.clear();
  CHECK(instantiate(fmu, fmu.guid(), "file:///nowhere", fmi2CoSimulation, text) == nullptr);
  CHECK(text == "cannot read `/nowhere/plant.bin`: the importer must unpack the whole FMU");
  text.clear();
  const std::string tables = cell.unpacked() + "/resources/plant.bin";
  std::filesystem::resize_file(tables, std::filesystem::file_size(tables) - 1);
  CHECK(instantiate(fmu, fmu.guid(), fmu.resources(), fmi2CoSimulation, text) == nullptr);
  CHECK(text == "`" + tables + "`: it is damaged");
}

TEST_CASE("A library without the user's C++ refuses a plant that needs it") {
  const Cell cell;
  const Fmu generic(cell.file(), cell.unpacked());
  const TemporaryFolder folder;
  const std::string library = cell.unpacked() + "/binaries/" SYMPLANT_FMI_PLATFORM "/cell.so";
  const std::string command = "'" SYMPLANT_TOOL "' generate '" SYMPLANT_SOURCE "/examples/scale/plant.json' --fmu '" +
                              (folder / "scale.fmu") + "' --fmu-library '" SYMPLANT_FMI_PLATFORM "=" + library +
                              "' > /dev/null";
  REQUIRE(std::system(command.c_str()) == 0);
  const Fmu scale(folder / "scale.fmu", folder / "fmu");
  std::string text;
  CHECK(instantiate(scale, scale.guid(), scale.resources(), fmi2CoSimulation, text) == nullptr);
  CHECK(text ==
        "the plant has custom behaviors, which are C++: this library does not have them; make the FMU with "
        "symplant_add_fmu()");
}

TEST_CASE("A function that is called too early or too late is an error, and says when it is possible") {
  const Cell cell;
  const Fmu fmu(cell.file(), cell.unpacked());
  FmuInstance instance(fmu, "a");
  const FmuFunctions& call = fmu.functions();
  CHECK(call.do_step(instance.component(), 0, 1, 0) == fmi2Error);
  CHECK(instance.messages().back() == "fmi2DoStep is only possible after fmi2ExitInitializationMode");
  CHECK(call.exit_initialization(instance.component()) == fmi2Error);
  CHECK(call.terminate(instance.component()) == fmi2Error);
  instance.initialize(0);
  CHECK(call.setup_experiment(instance.component(), 0, 0, 0, 0, 0) == fmi2Error);
  instance.step(0, 1);
  CHECK(call.do_step(instance.component(), 5, 1, 0) == fmi2Error);
  CHECK(instance.messages().back() == "the step begins at 5 s, but the last one ended at 1 s");
  REQUIRE(call.terminate(instance.component()) == fmi2OK);
  CHECK(call.do_step(instance.component(), 1, 1, 0) == fmi2Error);
  CHECK(instance.get("EXLINE_MB_AGV_I_P1") == 1);  // results may still be read
  const fmi2ValueReference input = reference(fmu, "EXLINE_MB_AGV_O_P2");
  const int on = 1;
  CHECK(call.set_boolean(instance.component(), &input, 1, &on) == fmi2Error);
  CHECK(instance.messages().back() == "after fmi2Terminate, variables can only be read");
  REQUIRE(call.reset(instance.component()) == fmi2OK);
  instance.initialize(0);
  instance.step(0, 1);
}

TEST_CASE("An unknown reference, another type and a variable that cannot be set are errors") {
  const Cell cell;
  const Fmu fmu(cell.file(), cell.unpacked());
  FmuInstance instance(fmu, "a");
  const FmuFunctions& call = fmu.functions();
  instance.initialize(0);
  int value = 1;
  double real = 1;
  const fmi2ValueReference unknown = 0xFFFF'FFFF;
  CHECK(call.get_boolean(instance.component(), &unknown, 1, &value) == fmi2Error);
  CHECK(instance.messages().back() == "no variable has the value reference 4294967295");
  const fmi2ValueReference event = reference(fmu, "EXLINE_MB_AGV_I_P1");
  CHECK(call.get_real(instance.component(), &event, 1, &real) == fmi2Error);
  CHECK(instance.messages().back() == "`EXLINE_MB_AGV_I_P1` is boolean, not real");
  CHECK(call.set_boolean(instance.component(), &event, 1, &value) == fmi2Error);
  CHECK(instance.messages().back() == "`EXLINE_MB_AGV_I_P1` cannot be set: it is neither an input nor a parameter");
  CHECK(call.get_boolean(instance.component(), nullptr, 0, nullptr) == fmi2OK);
}

TEST_CASE("Two instances of one FMU are independent") {
  const Cell cell;
  const Fmu fmu(cell.file(), cell.unpacked());
  FmuInstance one(fmu, "one");
  FmuInstance other(fmu, "other");
  one.initialize(0);
  other.initialize(0);
  one.set("EXLINE_MB_AGV_O_P2", 1);
  one.step(0, 3);
  other.step(0, 3);
  CHECK(one.get("EXLINE_MB_AGV_I_P2") == 1);
  CHECK(other.get("EXLINE_MB_AGV_I_P2") == 0);
  CHECK(other.get("EXLINE_MB_AGV_O_P2") == 0);
}

TEST_CASE("A state as bytes restores another instance, but no other plant and no damaged bytes") {
  const Cell cell;
  const Fmu fmu(cell.file(), cell.unpacked());
  FmuInstance one(fmu, "one");
  one.initialize(0);
  one.set("EXLINE_MB_AGV_O_P2", 1);
  one.step(0, 1);
  std::vector<char> bytes = one.save();
  FmuInstance other(fmu, "other");
  other.restore(bytes);
  CHECK(other.get("EXLINE_MB_AGV.moving") == 1);
  other.step(1, 2);
  CHECK(other.get("EXLINE_MB_AGV_I_P2") == 1);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  fmi2FMUstate state = nullptr;
  CHECK(fmu.functions().deserialize(other.component(), bytes.data(), bytes.size(), &state) == fmi2Error);
  CHECK(state == nullptr);
  CHECK(other.messages().back() == "the FMU state is damaged, or that of another plant or version of symplant");
}

TEST_CASE("A step that holds a pulse logs its event") {
  const Cell cell;
  const Fmu fmu(cell.file(), cell.unpacked());
  FmuInstance instance(fmu, "a");
  instance.initialize(0);
  instance.set("EXLINE_MB_AGV_O_P2", 1);
  instance.step(0, 3);
  CHECK(instance.get("EXLINE_MB_AGV_I_P2") == 1);
  CHECK(instance.messages().empty());
  instance.set("EXLINE_MB_MC_O_RUN2", 1);
  instance.step(3, 20);  // the machine runs and is idle again
  CHECK(instance.get("short pulses") == 3);
  REQUIRE(instance.messages().size() == 1);
  CHECK(
      instance.messages()[0] ==
      "pulses shorter than the step, held to its end: EXLINE_MB_MC_I_IDLE1, EXLINE_MB_MC_I_RUN2, EXLINE_MB_MC_I_BUSY");
}

}  // namespace
}  // namespace symplant::test
