// A small importer of FMUs for co-simulation (FMI 2.0). It uses only the standard.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "symplant/fmi/fmi2.hpp"

namespace symplant::test {

/// The functions that an importer finds in the library.
struct FmuFunctions {
  decltype(&fmi2GetVersion) get_version;
  decltype(&fmi2Instantiate) instantiate;
  decltype(&fmi2FreeInstance) free_instance;
  decltype(&fmi2SetupExperiment) setup_experiment;
  decltype(&fmi2EnterInitializationMode) enter_initialization;
  decltype(&fmi2ExitInitializationMode) exit_initialization;
  decltype(&fmi2Terminate) terminate;
  decltype(&fmi2Reset) reset;
  decltype(&fmi2GetReal) get_real;
  decltype(&fmi2GetInteger) get_integer;
  decltype(&fmi2GetBoolean) get_boolean;
  decltype(&fmi2SetReal) set_real;
  decltype(&fmi2SetInteger) set_integer;
  decltype(&fmi2SetBoolean) set_boolean;
  decltype(&fmi2GetFMUstate) get_state;
  decltype(&fmi2SetFMUstate) set_state;
  decltype(&fmi2FreeFMUstate) free_state;
  decltype(&fmi2SerializedFMUstateSize) serialized_size;
  decltype(&fmi2SerializeFMUstate) serialize;
  decltype(&fmi2DeSerializeFMUstate) deserialize;
  decltype(&fmi2DoStep) do_step;
};

struct FmuVariable {
  fmi2ValueReference reference = 0;
  std::string causality;  ///< "input"
  std::string type;       ///< the element: "Boolean"
  double least = 0;       ///< of an Integer or Real; both 0: no range
  double greatest = 0;
};

/// An FMU, unpacked, with its library loaded.
class Fmu {
 public:
  /// Unpacks `file` to `folder`. A fault fails the test.
  Fmu(const std::string& file, const std::string& folder);
  ~Fmu();
  Fmu(const Fmu&) = delete;
  Fmu& operator=(const Fmu&) = delete;

  const std::map<std::string, FmuVariable>& variables() const { return variables_; }
  const FmuFunctions& functions() const { return functions_; }
  const std::string& guid() const { return guid_; }
  std::string resources() const { return "file://" + folder_ + "/resources"; }

 private:
  std::string folder_;
  std::string guid_;
  std::map<std::string, FmuVariable> variables_;
  void* library_ = nullptr;
  FmuFunctions functions_{};
};

/// An instance of an FMU. A function that does not return fmi2OK fails the test.
class FmuInstance {
 public:
  FmuInstance(const Fmu& fmu, const std::string& name);
  ~FmuInstance();
  FmuInstance(const FmuInstance&) = delete;
  FmuInstance& operator=(const FmuInstance&) = delete;

  /// From instantiation to the first step.
  void initialize(int seed, double start = 0);
  void step(double time, double duration);
  /// A BOOL is 0 or 1.
  double get(const std::string& variable) const;
  void set(const std::string& variable, double number);
  std::vector<char> save() const;
  void restore(const std::vector<char>& bytes);
  fmi2Component component() const { return component_; }
  /// What the FMU logged.
  const std::vector<std::string>& messages() const { return messages_; }

 private:
  static void log(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status, fmi2String category,
                  fmi2String message, ...);
  const FmuVariable& variable(const std::string& name) const;
  void check(fmi2Status status, const std::string& what) const;

  const Fmu& fmu_;
  std::vector<std::string> messages_;
  fmi2CallbackFunctions callbacks_;
  fmi2Component component_;
};

}  // namespace symplant::test
