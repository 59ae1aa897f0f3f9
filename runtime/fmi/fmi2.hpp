// The C interface of an FMU for co-simulation: FMI 2.0.4 (Modelica Association, fmi-standard.org), sections 2.1
// and 4.2.
//
// Names and types are the standard's. An importer finds the functions by name in the library.
#pragma once

#include <cstddef>

#ifdef _WIN32
#define SYMPLANT_FMI_FUNCTION extern "C" __declspec(dllexport)
#else
#define SYMPLANT_FMI_FUNCTION extern "C" __attribute__((visibility("default")))
#endif

using fmi2Component = void*;
using fmi2ComponentEnvironment = void*;
using fmi2FMUstate = void*;
using fmi2ValueReference = unsigned int;
using fmi2Real = double;
using fmi2Integer = int;
using fmi2Boolean = int;
using fmi2Char = char;
using fmi2String = const fmi2Char*;
using fmi2Byte = char;

enum fmi2Status { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending };
enum fmi2Type { fmi2ModelExchange, fmi2CoSimulation };
enum fmi2StatusKind { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated };

struct fmi2CallbackFunctions {
  void (*logger)(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status, fmi2String category,
                 fmi2String message, ...);
  void* (*allocateMemory)(std::size_t count, std::size_t size);  ///< not used
  void (*freeMemory)(void* memory);                              ///< not used
  void (*stepFinished)(fmi2ComponentEnvironment environment, fmi2Status status);
  fmi2ComponentEnvironment componentEnvironment;
};

// An instance is for one thread at a time. Unless noted, a function returns fmi2OK, or fmi2Error with a message to the
// logger.

SYMPLANT_FMI_FUNCTION const char* fmi2GetTypesPlatform();
SYMPLANT_FMI_FUNCTION const char* fmi2GetVersion();
SYMPLANT_FMI_FUNCTION fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean on, std::size_t count,
                                                     const fmi2String categories[]);

/// Null, with a message to the logger, if the plant cannot be read or the GUID is that of another one.
SYMPLANT_FMI_FUNCTION fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid,
                                                    fmi2String resources, const fmi2CallbackFunctions* functions,
                                                    fmi2Boolean visible, fmi2Boolean logging);
SYMPLANT_FMI_FUNCTION void fmi2FreeInstance(fmi2Component component);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean tolerance_defined,
                                                     fmi2Real tolerance, fmi2Real start, fmi2Boolean stop_defined,
                                                     fmi2Real stop);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2EnterInitializationMode(fmi2Component component);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2ExitInitializationMode(fmi2Component component);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2Terminate(fmi2Component component);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2Reset(fmi2Component component);

SYMPLANT_FMI_FUNCTION fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference references[],
                                             std::size_t count, fmi2Real values[]);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2GetInteger(fmi2Component component, const fmi2ValueReference references[],
                                                std::size_t count, fmi2Integer values[]);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2GetBoolean(fmi2Component component, const fmi2ValueReference references[],
                                                std::size_t count, fmi2Boolean values[]);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2GetString(fmi2Component component, const fmi2ValueReference references[],
                                               std::size_t count, fmi2String values[]);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference references[],
                                             std::size_t count, const fmi2Real values[]);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2SetInteger(fmi2Component component, const fmi2ValueReference references[],
                                                std::size_t count, const fmi2Integer values[]);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2SetBoolean(fmi2Component component, const fmi2ValueReference references[],
                                                std::size_t count, const fmi2Boolean values[]);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2SetString(fmi2Component component, const fmi2ValueReference references[],
                                               std::size_t count, const fmi2String values[]);

SYMPLANT_FMI_FUNCTION fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate* state);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate* state);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state,
                                                            std::size_t* size);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[],
                                                       std::size_t size);
/// Refuses a state of another plant, of another version of the library, and a damaged one.
SYMPLANT_FMI_FUNCTION fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[],
                                                         std::size_t size, fmi2FMUstate* state);

SYMPLANT_FMI_FUNCTION fmi2Status fmi2DoStep(fmi2Component component, fmi2Real time, fmi2Real duration,
                                            fmi2Boolean no_state_before);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2CancelStep(fmi2Component component);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2GetStatus(fmi2Component component, fmi2StatusKind kind, fmi2Status* value);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2GetRealStatus(fmi2Component component, fmi2StatusKind kind, fmi2Real* value);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2GetIntegerStatus(fmi2Component component, fmi2StatusKind kind, fmi2Integer* value);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2GetBooleanStatus(fmi2Component component, fmi2StatusKind kind, fmi2Boolean* value);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2GetStringStatus(fmi2Component component, fmi2StatusKind kind, fmi2String* value);

// A plant has no derivatives: these refuse any variable.
SYMPLANT_FMI_FUNCTION fmi2Status fmi2SetRealInputDerivatives(fmi2Component component,
                                                             const fmi2ValueReference references[], std::size_t count,
                                                             const fmi2Integer orders[], const fmi2Real values[]);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2GetRealOutputDerivatives(fmi2Component component,
                                                              const fmi2ValueReference references[], std::size_t count,
                                                              const fmi2Integer orders[], fmi2Real values[]);
SYMPLANT_FMI_FUNCTION fmi2Status fmi2GetDirectionalDerivative(
    fmi2Component component, const fmi2ValueReference unknowns[], std::size_t unknown_count,
    const fmi2ValueReference knowns[], std::size_t known_count, const fmi2Real seeds[], fmi2Real values[]);
