// A small importer of FMUs.
#include "fmu/importer.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <pugixml.hpp>

#include "support/catch.hpp"

namespace symplant::test {
namespace {

template <class Function>
void find(void* library, const char* name, Function& function) {
  void* const found = dlsym(library, name);
  INFO("function " << name);
  REQUIRE(found != nullptr);
  function = reinterpret_cast<Function>(found);
}

}  // namespace

Fmu::Fmu(const std::string& file, const std::string& folder) : folder_(folder) {
  std::filesystem::create_directories(folder);
  const std::string unpack = "cd '" + folder + "' && '" SYMPLANT_CMAKE "' -E tar xf '" + file + "'";
  REQUIRE(std::system(unpack.c_str()) == 0);
  pugi::xml_document document;
  REQUIRE(document.load_file((folder + "/modelDescription.xml").c_str()));
  const pugi::xml_node root = document.child("fmiModelDescription");
  REQUIRE(root.attribute("fmiVersion").as_string() == std::string("2.0"));
  guid_ = root.attribute("guid").as_string();
  for (const pugi::xml_node node : root.child("ModelVariables").children("ScalarVariable")) {
    const pugi::xml_node type = node.first_child();
    const FmuVariable variable{node.attribute("valueReference").as_uint(), node.attribute("causality").as_string(),
                               type.name(), type.attribute("min").as_double(), type.attribute("max").as_double()};
    REQUIRE(variables_.emplace(node.attribute("name").as_string(), variable).second);
  }
  const std::string identifier = root.child("CoSimulation").attribute("modelIdentifier").as_string();
  library_ =
      dlopen((folder + "/binaries/" SYMPLANT_FMI_PLATFORM "/" + identifier + ".so").c_str(), RTLD_NOW | RTLD_LOCAL);
  INFO((library_ == nullptr ? dlerror() : ""));
  REQUIRE(library_ != nullptr);
  find(library_, "fmi2GetVersion", functions_.get_version);
  find(library_, "fmi2Instantiate", functions_.instantiate);
  find(library_, "fmi2FreeInstance", functions_.free_instance);
  find(library_, "fmi2SetupExperiment", functions_.setup_experiment);
  find(library_, "fmi2EnterInitializationMode", functions_.enter_initialization);
  find(library_, "fmi2ExitInitializationMode", functions_.exit_initialization);
  find(library_, "fmi2Terminate", functions_.terminate);
  find(library_, "fmi2Reset", functions_.reset);
  find(library_, "fmi2GetReal", functions_.get_real);
  find(library_, "fmi2GetInteger", functions_.get_integer);
  find(library_, "fmi2GetBoolean", functions_.get_boolean);
  find(library_, "fmi2SetReal", functions_.set_real);
  find(library_, "fmi2SetInteger", functions_.set_integer);
  find(library_, "fmi2SetBoolean", functions_.set_boolean);
  find(library_, "fmi2GetFMUstate", functions_.get_state);
  find(library_, "fmi2SetFMUstate", functions_.set_state);
  find(library_, "fmi2FreeFMUstate", functions_.free_state);
  find(library_, "fmi2SerializedFMUstateSize", functions_.serialized_size);
  find(library_, "fmi2SerializeFMUstate", functions_.serialize);
  find(library_, "fmi2DeSerializeFMUstate", functions_.deserialize);
  find(library_, "fmi2DoStep", functions_.do_step);
  REQUIRE(functions_.get_version() == std::string("2.0"));
}

Fmu::~Fmu() {
  if (library_ != nullptr) dlclose(library_);
}

FmuInstance::FmuInstance(const Fmu& fmu, const std::string& name)
    : fmu_(fmu),
      callbacks_{log, nullptr, nullptr, nullptr, this},
      component_(fmu.functions().instantiate(name.c_str(), fmi2CoSimulation, fmu.guid().c_str(),
                                             fmu.resources().c_str(), &callbacks_, 0, 1)) {
  for (const std::string& message : messages_) UNSCOPED_INFO(message);
  REQUIRE(component_ != nullptr);
}

FmuInstance::~FmuInstance() { fmu_.functions().free_instance(component_); }

void FmuInstance::log(fmi2ComponentEnvironment environment, fmi2String, fmi2Status, fmi2String, fmi2String message,
                      ...) {
  static_cast<FmuInstance*>(environment)->messages_.emplace_back(message);
}

void FmuInstance::check(fmi2Status status, const std::string& what) const {
  INFO(what << (messages_.empty() ? "" : ": " + messages_.back()));
  REQUIRE(status == fmi2OK);
}

const FmuVariable& FmuInstance::variable(const std::string& name) const {
  INFO("variable " << name);
  const auto found = fmu_.variables().find(name);
  REQUIRE(found != fmu_.variables().end());
  return found->second;
}

void FmuInstance::initialize(int seed, double start) {
  const FmuFunctions& call = fmu_.functions();
  check(call.setup_experiment(component_, 0, 0, start, 0, 0), "fmi2SetupExperiment");
  set("seed", seed);
  check(call.enter_initialization(component_), "fmi2EnterInitializationMode");
  check(call.exit_initialization(component_), "fmi2ExitInitializationMode");
}

void FmuInstance::step(double time, double duration) {
  check(fmu_.functions().do_step(component_, time, duration, 0), "fmi2DoStep");
}

double FmuInstance::get(const std::string& name) const {
  const FmuVariable& of = variable(name);
  const FmuFunctions& call = fmu_.functions();
  double real = 0;
  int whole = 0;
  if (of.type == "Real") {
    check(call.get_real(component_, &of.reference, 1, &real), name);
    return real;
  }
  const auto function = of.type == "Boolean" ? call.get_boolean : call.get_integer;
  check(function(component_, &of.reference, 1, &whole), name);
  return whole;
}

void FmuInstance::set(const std::string& name, double number) {
  const FmuVariable& of = variable(name);
  const FmuFunctions& call = fmu_.functions();
  const int whole = static_cast<int>(number);
  if (of.type == "Real") {
    check(call.set_real(component_, &of.reference, 1, &number), name);
  } else {
    const auto function = of.type == "Boolean" ? call.set_boolean : call.set_integer;
    check(function(component_, &of.reference, 1, &whole), name);
  }
}

std::vector<char> FmuInstance::save() const {
  const FmuFunctions& call = fmu_.functions();
  fmi2FMUstate state = nullptr;
  check(call.get_state(component_, &state), "fmi2GetFMUstate");
  std::size_t size = 0;
  check(call.serialized_size(component_, state, &size), "fmi2SerializedFMUstateSize");
  std::vector<char> bytes(size);
  check(call.serialize(component_, state, bytes.data(), size), "fmi2SerializeFMUstate");
  check(call.free_state(component_, &state), "fmi2FreeFMUstate");
  REQUIRE(state == nullptr);
  return bytes;
}

void FmuInstance::restore(const std::vector<char>& bytes) {
  const FmuFunctions& call = fmu_.functions();
  fmi2FMUstate state = nullptr;
  check(call.deserialize(component_, bytes.data(), bytes.size(), &state), "fmi2DeSerializeFMUstate");
  check(call.set_state(component_, state), "fmi2SetFMUstate");
  check(call.free_state(component_, &state), "fmi2FreeFMUstate");
}

}  // namespace symplant::test
