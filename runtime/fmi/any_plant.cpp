// The library in FMUs of plants without the user's C++: it reads the plant from the FMU.
#include "symplant/fmi/library_plant.hpp"

namespace symplant::fmi {

const CompiledPlant* compiled_plant() { return nullptr; }

}  // namespace symplant::fmi
