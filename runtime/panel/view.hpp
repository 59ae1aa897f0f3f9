// What the panel shows of a plant that the engine does not need: layout, comments, alarms.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "symplant/tables/alarm_priority.hpp"
#include "symplant/tables/shape.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::panel {

inline constexpr std::int32_t kNotPlaced = -1;

struct DeviceView {
  std::uint32_t station = 0;    ///< index of a station
  std::int32_t x = kNotPlaced;  ///< in its station, in grid units from 0; kNotPlaced: the page chooses
  std::int32_t y = kNotPlaced;
};

struct SymbolView {
  std::string_view comment = {};  ///< of the symbol list; empty: none
  bool by_operator = false;       ///< a person operates it: a button, a selector (the role `operator` of naming.json)
};

/// One of `alarms` of the description.
struct AlarmView {
  std::uint32_t symbol = tables::kNone;  ///< an operation, or kNone
  std::uint32_t value = tables::kNone;   ///< then an output of a value
  tables::AlarmPriority priority = tables::AlarmPriority::high;
};

/// What names and the description give. Without a layout, stations follow from the devices' paths.
struct View {
  std::span<const DeviceView> devices = {};    ///< by unit; empty: none
  std::string_view stations = {};              ///< a station: its line, then its process, each ended by a NUL
  std::span<const SymbolView> symbols = {};    ///< by symbol; empty: no comments
  std::span<const AlarmView> alarms = {};      ///< in the order of the description
  std::span<const tables::Shape> shapes = {};  ///< by unit; empty: all are `device`
  std::string_view plan = {};                  ///< `plan` of the description, as JSON; empty: not given
  std::string_view view3d = {};                ///< `view3d`, the same
  std::string_view folder = {};  ///< where pictures and models are searched besides --panel-files; empty: nowhere
};

}  // namespace symplant::panel
