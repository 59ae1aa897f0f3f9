// Units of values in OPC UA.
#pragma once

#include <cstdint>
#include <string_view>

namespace symplant::link::opc_ua {

struct EngineeringUnit {
  std::int32_t id = -1;          ///< the code of UN/CEFACT as a number; -1: a unit without a known code
  std::string_view description;  ///< "litre per second"; empty without a known code
};

/// The unit of a value by its text in plant.json: "l/s", "°C". O(known units).
EngineeringUnit engineering_unit(std::string_view text) noexcept;

}  // namespace symplant::link::opc_ua
