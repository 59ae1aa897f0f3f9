// The C functions of an FMU.
#include <algorithm>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "symplant/fmi/fmi2.hpp"
#include "symplant/fmi/instance.hpp"
#include "symplant/fmi/library_plant.hpp"
#include "symplant/fmi/state_bytes.hpp"
#include "symplant/tables/names.hpp"

#ifdef __GLIBCXX__
namespace __gnu_cxx {
void __freeres();  // NOLINT(bugprone-reserved-identifier): the C++ library has it
}
#endif

namespace {

using symplant::fmi::BaseType;
using symplant::fmi::Fault;
using symplant::fmi::Instance;
using symplant::fmi::InstanceState;
using symplant::fmi::LibraryPlant;
using symplant::fmi::Variables;

constexpr const char* kErrors = "logStatusError";
constexpr const char* kPulses = "logShortPulses";
constexpr std::size_t kMostNames = 8;  ///< of events, in a message

enum class Phase : std::uint8_t { instantiated, initializing, stepping, terminated };

/// The message argument of a logger is a format of printf, in which `#` begins a value reference.
std::string escaped(std::string_view text) {
  std::string format;
  for (const char c : text) {
    if (c == '%' || c == '#') format.push_back(c);
    format.push_back(c);
  }
  return format;
}

class Log {
 public:
  Log(fmi2String name, const fmi2CallbackFunctions& functions)
      : name_(name != nullptr ? name : ""), functions_(functions) {}

  void write(fmi2Status status, const char* category, std::string_view text) const {
    if (functions_.logger == nullptr) return;
    functions_.logger(functions_.componentEnvironment, name_.c_str(), status, category, escaped(text).c_str());
  }
  fmi2Status error(std::string_view text) const {
    write(fmi2Error, kErrors, text);
    return fmi2Error;
  }

 private:
  std::string name_;
  fmi2CallbackFunctions functions_;
};

struct Component {
  Component(Log to, LibraryPlant&& from)
      : log(std::move(to)),
        plant(std::move(from)),
        variables(plant.tables()),
        instance({plant.tables(), plant.behaviours(), variables}),
        symbol_names(symplant::tables::split_names(plant.tables().symbol_names)) {}

  Log log;
  LibraryPlant plant;
  Variables variables;
  Instance instance;
  std::vector<std::string_view> symbol_names;  ///< name and address of each
  Phase phase = Phase::instantiated;
  bool logs_pulses = false;
};

/// An FMU state: that of the instance, and what the importer may call next.
struct State {
  InstanceState instance;
  Phase phase = Phase::instantiated;
};

/// Calls `function` with the component; an exception, such as one of no memory, is an error.
template <class Function>
fmi2Status with(fmi2Component component, Function function) noexcept {
  if (component == nullptr) return fmi2Error;
  auto& c = *static_cast<Component*>(component);
  try {
    return function(c);
  } catch (const std::exception& error) {
    try {
      return c.log.error(error.what());
    } catch (...) {
      return fmi2Error;
    }
  }
}

fmi2Status result(const Component& component, const Fault& fault) {
  return fault.empty() ? fmi2OK : component.log.error(fault);
}

/// Whether the function of this name may be called now; logs an error if not.
bool is_phase(const Component& component, Phase needed, const char* function) {
  constexpr const char* kWhen[] = {"after fmi2Instantiate or fmi2Reset", "in the initialization mode",
                                   "after fmi2ExitInitializationMode", "after fmi2Terminate"};
  if (component.phase == needed) return true;
  component.log.error(std::string(function) + " is only possible " + kWhen[static_cast<std::size_t>(needed)]);
  return false;
}

bool has_type(BaseType variable, BaseType function) {
  return variable == function || (variable == BaseType::enumeration && function == BaseType::integer);
}

constexpr const char* type_name(BaseType type) {
  constexpr const char* kNames[] = {"real", "integer", "boolean", "enumeration"};
  return kNames[static_cast<std::size_t>(type)];
}

/// Calls `function` with the index in `references` and the index of each variable, until it returns a fault.
template <class Function>
fmi2Status each(fmi2Component component, const fmi2ValueReference references[], std::size_t count, BaseType type,
                Function function) noexcept {
  return with(component, [&](Component& c) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto variable = c.variables.find(references[i]);
      if (!variable) return c.log.error("no variable has the value reference " + std::to_string(references[i]));
      const auto& found = c.variables.all()[*variable];
      if (!has_type(found.type, type)) {
        return c.log.error("`" + found.name + "` is " + type_name(found.type) + ", not " + type_name(type));
      }
      if (const Fault fault = function(c.instance, i, *variable); !fault.empty()) return c.log.error(fault);
    }
    return fmi2OK;
  });
}

/// The same, to set variables.
template <class Function>
fmi2Status set_each(fmi2Component component, const fmi2ValueReference references[], std::size_t count, BaseType type,
                    Function function) noexcept {
  const fmi2Status allowed = with(component, [](const Component& c) {
    return c.phase == Phase::terminated ? c.log.error("after fmi2Terminate, variables can only be read") : fmi2OK;
  });
  return allowed == fmi2OK ? each(component, references, count, type, function) : allowed;
}

fmi2Status get_integers(fmi2Component component, const fmi2ValueReference references[], std::size_t count,
                        BaseType type, int values[]) noexcept {
  return each(component, references, count, type, [&](const Instance& instance, std::size_t i, std::uint32_t variable) {
    values[i] = instance.integer(variable);
    return Fault();
  });
}

fmi2Status set_integers(fmi2Component component, const fmi2ValueReference references[], std::size_t count,
                        BaseType type, const int values[]) noexcept {
  return set_each(component, references, count, type, [&](Instance& instance, std::size_t i, std::uint32_t variable) {
    return instance.set_integer(variable, values[i]);
  });
}

void log_pulses(const Component& component) {
  const std::vector<std::uint32_t> held = component.instance.held_events();
  if (held.empty()) return;
  std::string text = "pulses shorter than the step, held to its end:";
  for (std::size_t i = 0; i < held.size() && i < kMostNames; ++i) {
    text.append(i == 0 ? " " : ", ").append(component.symbol_names[2 * std::size_t{held[i]}]);
  }
  if (held.size() > kMostNames) text += " and " + std::to_string(held.size() - kMostNames) + " more";
  component.log.write(fmi2OK, kPulses, text);
}

fmi2Status refuse_derivatives(fmi2Component component, std::size_t count) noexcept {
  return with(component, [&](const Component& c) {
    return count == 0 ? fmi2OK : c.log.error("the plant has no derivatives of inputs and outputs");
  });
}

/// Calls `function` with the bytes of an FMU state.
template <class Function>
fmi2Status with_bytes(fmi2Component component, fmi2FMUstate state, Function function) noexcept {
  return with(component, [&](const Component& c) {
    if (state == nullptr) return c.log.error("there is no FMU state to serialize");
    const auto& kept = *static_cast<const State*>(state);
    return function(c, symplant::fmi::state_bytes(kept.instance, static_cast<std::uint8_t>(kept.phase),
                                                  c.instance.plant().model_hash()));
  });
}

#ifdef __GLIBCXX__
/// The C++ library in this one allocates memory for exceptions when it is loaded, and gives it back only when it is
/// asked to: otherwise each importer that loads and unloads the FMU again would lose 72 kB.
[[gnu::destructor]] void free_memory_for_exceptions() { __gnu_cxx::__freeres(); }
#endif

}  // namespace

const char* fmi2GetTypesPlatform() { return "default"; }
const char* fmi2GetVersion() { return "2.0"; }

fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean on, std::size_t count,
                               const fmi2String categories[]) {
  return with(component, [&](Component& c) {
    c.logs_pulses = on != 0 && (count == 0 || std::any_of(categories, categories + count, [](fmi2String category) {
                                  return category != nullptr && std::string_view(category) == kPulses;
                                }));
    return fmi2OK;
  });
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions* functions, fmi2Boolean /*visible*/, fmi2Boolean logging) {
  if (functions == nullptr) return nullptr;
  const Log log(name, *functions);
  try {
    if (type != fmi2CoSimulation) return log.error("this FMU is for co-simulation, not for model exchange"), nullptr;
    auto loaded = LibraryPlant::load(resources != nullptr ? resources : "");
    if (const auto* const error = std::get_if<std::string>(&loaded)) return log.error(*error), nullptr;
    auto component = std::make_unique<Component>(log, std::get<LibraryPlant>(std::move(loaded)));
    const std::string own = symplant::fmi::guid_of(component->plant.tables(), component->variables);
    if (guid == nullptr || own != guid) {
      return log.error("the GUID " + std::string(guid != nullptr ? guid : "") +
                       " is that of another FMU; this one has " + own),
             nullptr;
    }
    component->logs_pulses = logging != 0;
    return component.release();
  } catch (const std::exception& error) {
    return log.error(error.what()), nullptr;
  }
}

void fmi2FreeInstance(fmi2Component component) { delete static_cast<Component*>(component); }

fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean /*tolerance_defined*/, fmi2Real /*tolerance*/,
                               fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop) {
  return with(component, [&](Component& c) {
    if (!is_phase(c, Phase::instantiated, "fmi2SetupExperiment")) return fmi2Error;
    return result(c, c.instance.begin_at(start, stop_defined != 0 ? stop : std::numeric_limits<double>::infinity()));
  });
}

fmi2Status fmi2EnterInitializationMode(fmi2Component component) {
  return with(component, [](Component& c) {
    if (!is_phase(c, Phase::instantiated, "fmi2EnterInitializationMode")) return fmi2Error;
    c.phase = Phase::initializing;
    return fmi2OK;
  });
}

fmi2Status fmi2ExitInitializationMode(fmi2Component component) {
  return with(component, [](Component& c) {
    if (!is_phase(c, Phase::initializing, "fmi2ExitInitializationMode")) return fmi2Error;
    c.instance.begin();
    c.phase = Phase::stepping;
    return fmi2OK;
  });
}

fmi2Status fmi2Terminate(fmi2Component component) {
  return with(component, [](Component& c) {
    if (!is_phase(c, Phase::stepping, "fmi2Terminate")) return fmi2Error;
    c.phase = Phase::terminated;
    return fmi2OK;
  });
}

fmi2Status fmi2Reset(fmi2Component component) {
  return with(component, [](Component& c) {
    c.instance.reset();
    c.phase = Phase::instantiated;
    return fmi2OK;
  });
}

fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference references[], std::size_t count,
                       fmi2Real values[]) {
  return each(component, references, count, BaseType::real,
              [&](const Instance& instance, std::size_t i, std::uint32_t variable) {
                values[i] = instance.real(variable);
                return Fault();
              });
}

fmi2Status fmi2GetInteger(fmi2Component component, const fmi2ValueReference references[], std::size_t count,
                          fmi2Integer values[]) {
  return get_integers(component, references, count, BaseType::integer, values);
}

fmi2Status fmi2GetBoolean(fmi2Component component, const fmi2ValueReference references[], std::size_t count,
                          fmi2Boolean values[]) {
  return get_integers(component, references, count, BaseType::boolean, values);
}

fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference references[], std::size_t count,
                       const fmi2Real values[]) {
  return set_each(component, references, count, BaseType::real,
                  [&](Instance& instance, std::size_t i, std::uint32_t variable) {
                    return instance.set_real(variable, values[i]);
                  });
}

fmi2Status fmi2SetInteger(fmi2Component component, const fmi2ValueReference references[], std::size_t count,
                          const fmi2Integer values[]) {
  return set_integers(component, references, count, BaseType::integer, values);
}

fmi2Status fmi2SetBoolean(fmi2Component component, const fmi2ValueReference references[], std::size_t count,
                          const fmi2Boolean values[]) {
  return set_integers(component, references, count, BaseType::boolean, values);
}

fmi2Status fmi2GetString(fmi2Component component, const fmi2ValueReference[], std::size_t count, fmi2String[]) {
  return with(component, [&](const Component& c) {
    return count == 0 ? fmi2OK : c.log.error("the plant has no variables that are texts");
  });
}

fmi2Status fmi2SetString(fmi2Component component, const fmi2ValueReference[], std::size_t count, const fmi2String[]) {
  return fmi2GetString(component, nullptr, count, nullptr);
}

fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate* state) {
  return with(component, [&](const Component& c) {
    if (*state == nullptr) *state = new State{};
    *static_cast<State*>(*state) = {c.instance.save(), c.phase};
    return fmi2OK;
  });
}

fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state) {
  return with(component, [&](Component& c) {
    if (state == nullptr) return c.log.error("there is no FMU state to set");
    const auto& kept = *static_cast<const State*>(state);
    if (!c.instance.restore(kept.instance)) return c.log.error("the FMU state is that of another plant");
    c.phase = kept.phase;
    return fmi2OK;
  });
}

fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate* state) {
  return with(component, [&](const Component&) {
    if (state == nullptr) return fmi2OK;
    delete static_cast<State*>(*state);
    *state = nullptr;
    return fmi2OK;
  });
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state, std::size_t* size) {
  return with_bytes(component, state, [&](const Component&, const std::string& bytes) {
    *size = bytes.size();
    return fmi2OK;
  });
}

fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[], std::size_t size) {
  return with_bytes(component, state, [&](const Component& c, const std::string& all) {
    if (size < all.size()) return c.log.error("the memory for the FMU state is too small");
    std::copy(all.begin(), all.end(), bytes);
    return fmi2OK;
  });
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[], std::size_t size,
                                   fmi2FMUstate* state) {
  return with(component, [&](const Component& c) {
    auto read = symplant::fmi::read_state({bytes, size}, c.instance.plant().model_hash());
    if (!read || read->extra > static_cast<std::uint8_t>(Phase::terminated)) {
      return c.log.error("the FMU state is damaged, or that of another plant or version of symplant");
    }
    if (*state == nullptr) *state = new State{};
    *static_cast<State*>(*state) = {std::move(read->state), static_cast<Phase>(read->extra)};
    return fmi2OK;
  });
}

fmi2Status fmi2DoStep(fmi2Component component, fmi2Real time, fmi2Real duration, fmi2Boolean /*no_state_before*/) {
  return with(component, [&](Component& c) {
    if (!is_phase(c, Phase::stepping, "fmi2DoStep")) return fmi2Error;
    const fmi2Status status = result(c, c.instance.step(time, duration));
    if (c.logs_pulses && status == fmi2OK) log_pulses(c);
    return status;
  });
}

fmi2Status fmi2CancelStep(fmi2Component component) {
  return with(component,
              [](const Component& c) { return c.log.error("no step is in progress: steps are synchronous"); });
}

fmi2Status fmi2GetStatus(fmi2Component, fmi2StatusKind, fmi2Status*) { return fmi2Discard; }

fmi2Status fmi2GetRealStatus(fmi2Component component, fmi2StatusKind kind, fmi2Real* value) {
  return with(component, [&](const Component& c) {
    if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
    *value = c.instance.time();
    return fmi2OK;
  });
}

fmi2Status fmi2GetIntegerStatus(fmi2Component, fmi2StatusKind, fmi2Integer*) { return fmi2Discard; }

fmi2Status fmi2GetBooleanStatus(fmi2Component, fmi2StatusKind kind, fmi2Boolean* value) {
  if (kind != fmi2Terminated) return fmi2Discard;
  *value = 0;  // a plant never ends by itself
  return fmi2OK;
}

fmi2Status fmi2GetStringStatus(fmi2Component, fmi2StatusKind, fmi2String*) { return fmi2Discard; }

fmi2Status fmi2SetRealInputDerivatives(fmi2Component component, const fmi2ValueReference[], std::size_t count,
                                       const fmi2Integer[], const fmi2Real[]) {
  return refuse_derivatives(component, count);
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component component, const fmi2ValueReference[], std::size_t count,
                                        const fmi2Integer[], fmi2Real[]) {
  return refuse_derivatives(component, count);
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component component, const fmi2ValueReference[], std::size_t unknown_count,
                                        const fmi2ValueReference[], std::size_t, const fmi2Real[], fmi2Real[]) {
  return refuse_derivatives(component, unknown_count);
}
