// Reads a scenario file against a plant.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/json/location.hpp"
#include "symplant/scenario/scenario.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::scenario {

/// The faults of one file.
struct FileFaults {
  std::string path;                  ///< as given to `open`; empty: the scenario's own file
  std::string text;                  ///< of an included file
  std::vector<json::Placed> faults;  ///< in the order of the text
};

struct ReadScenario {
  std::optional<Scenario> scenario;  ///< present if there are no faults
  std::vector<FileFaults> faults;    ///< by file, in the order of reading
};

struct OpenedFile {
  std::optional<std::string> text;
  std::string error;  ///< why it cannot be read
};
/// Opens an included file; `path` is relative to the scenario's own file. Null: there are no other files.
using OpenFile = std::function<OpenedFile(const std::string& path)>;

/// `carried`: for each symbol, whether it is an operation that a link to a PLC writes, which a scenario cannot set;
/// empty if there is no such operation. O(texts + plant).
ReadScenario read_scenario(std::string_view text, const trace::PlantNames& names, const std::vector<bool>& carried,
                           const OpenFile& open = nullptr);

/// The JSON Schema of the format (draft-07), as `symplant schema scenario` prints it.
std::string_view scenario_schema();

}  // namespace symplant::scenario
