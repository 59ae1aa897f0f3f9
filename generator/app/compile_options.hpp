// The options of a command for the plant that it compiles.
#pragma once

#include <optional>
#include <string>

#include "address/address.hpp"
#include "findings/finish.hpp"
#include "name/io_rows.hpp"
#include "read/readers.hpp"

namespace symplant::app {

struct CompileOptions {
  std::string plant;                   ///< a plant.json, or a symbol list
  read::ReadOptions read;              ///< for lists whose entry in plant.json does not say otherwise
  std::optional<address::Radix> xy;    ///< how X and Y count in such lists
  std::string today = {};              ///< YYYY-MM-DD, for findings ignored until a day; empty: no entry has expired
  bool tables = true;                  ///< false: only checks follow, and the plant is lowered only if they need it
  findings::Selection selection = {};  ///< which findings are reported
  findings::Known known = {};          ///< findings that are not reported again
  name::IoRows io = {};                ///< rows that are I/O; none: those of the plant.json
  std::string malfunctions = {};       ///< a file with more malfunctions; empty: none
  std::string conventions = {};        ///< a file with more naming conventions; empty: none
  std::string times = {};              ///< a description that wins over the plant, such as learned times; empty: none
  std::string naming = {};             ///< a naming.json or `@PROFILE`; empty: what the plant.json gives
};

}  // namespace symplant::app
