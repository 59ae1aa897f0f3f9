// A plant whose malfunctions are started and stopped by name.
#pragma once

#include <cstdint>

#include "symplant/plant/plant.hpp"

namespace symplant::plant {

/// A plant with written malfunctions. `Base` is the plant without them; `Malfunction` enumerates them.
template <class Base, class Malfunction>
class MalfunctionsPlant : public Base {
 public:
  using Base::Base;

  /// Starts a malfunction by hand, or ends it (Plant::start_malfunction).
  void start(Malfunction malfunction) noexcept { this->start_malfunction(static_cast<std::uint32_t>(malfunction)); }
  void stop(Malfunction malfunction) noexcept { this->stop_malfunction(static_cast<std::uint32_t>(malfunction)); }
  bool is_active(Malfunction malfunction) const noexcept {
    return this->malfunction(static_cast<std::uint32_t>(malfunction)).active;
  }
};

}  // namespace symplant::plant
