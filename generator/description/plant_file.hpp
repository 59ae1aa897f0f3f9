// plant.json: the plant description as a file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "address/address.hpp"
#include "description/description.hpp"
#include "symplant/json/location.hpp"
#include "text/encoding.hpp"

namespace symplant::description {

/// A symbol list that the plant is made from.
struct ListReference {
  std::string file;                        ///< as written: relative to the plant.json
  std::string format;                      ///< of a known reader; empty: sniffed
  std::optional<text::Encoding> encoding;  ///< nothing: sniffed
  std::string controller;                  ///< the PLC it belongs to; empty: the only one
  std::optional<address::Radix> xy;        ///< how X and Y count where no row proves it
};

struct PlantFile {
  std::string name;
  std::vector<ListReference> symbols;
  Description description;
};

struct PlantFileReading {
  /// What could be read of it, whatever its faults; nothing where it is no plant description of this version.
  std::optional<PlantFile> file;
  std::vector<json::Placed> syntax;      ///< why it is no JSON, or not quite
  std::vector<DescriptionFault> faults;  ///< where it does not fit the format
};

/// Reads the text of a plant.json. Without `name` in it the plant is called `stem`. What names of devices, states and
/// symbols mean is found out by build_plant. O(text).
PlantFileReading read_plant_file(std::string_view text, std::string_view stem);

/// Whether a file is to be read as plant.json: by its name's ending, or since its text begins like JSON.
bool is_plant_file(std::string_view path, std::string_view bytes);

/// For a message: that no encoding has this name, which there are, and the nearest one.
std::string no_such_encoding(std::string_view name);

/// The schema of plant.json, as `symplant schema plant` prints it.
std::string_view plant_schema();

}  // namespace symplant::description
