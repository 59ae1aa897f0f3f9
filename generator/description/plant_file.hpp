// plant.json: the plant description as a file.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "address/address.hpp"
#include "address/notation.hpp"
#include "description/description.hpp"
#include "description/include.hpp"
#include "description/plant_source.hpp"
#include "read/cells/column_map.hpp"
#include "symplant/json/location.hpp"
#include "text/encoding.hpp"

namespace symplant::description {

/// A symbol list of the plant.
struct ListReference {
  std::string file;                        ///< as written: relative to the plant.json; `*` and `?` name several files
  std::string format;                      ///< of a known reader; empty: recognized by content
  std::optional<text::Encoding> encoding;  ///< nothing: recognized by content
  read::ColumnMap columns;                 ///< of a table; empty: recognized
  address::IoRanges io_words;              ///< which words of CIO are inputs or outputs; empty: none
  std::string prefix;                      ///< put before the names of its symbols and the lines of its devices
  std::size_t part = 0;                    ///< which of several lists in one file; 0: all of it
  std::string controller;                  ///< the PLC it belongs to; empty: the only one
  std::optional<address::Radix> xy;        ///< how X and Y count if no row proves it
};

struct PlantFile {
  std::string name;
  std::vector<ListReference> symbols;
  std::string naming;       ///< the file of the naming rule, relative to the plant.json, or `@PROFILE`; empty: none
  std::string naming_text;  ///< a naming rule that is written in the plant.json, as JSON; empty: none
  Description description;
};

struct PlantFileReading {
  /// The readable part, even with faults; nothing if it is not a plant description of this version.
  std::optional<PlantFile> file;
  std::vector<json::Placed> syntax;      ///< faults of the JSON syntax of the plant.json
  std::vector<DescriptionFault> faults;  ///< where it does not fit the format; pointers into the whole description
  std::shared_ptr<const PlantSource> source;
  std::vector<FileFaults> included;  ///< faults of included files by themselves
  bool complete = true;              ///< all included files could be read

  bool sound() const { return complete && syntax.empty() && faults.empty() && included.empty(); }
};

/// Reads a plant.json and what it includes. Without `name` the name of the plant is `stem`. Names of devices, states
/// and symbols are not resolved here but by the derivation of the plant (model). O(texts).
PlantFileReading read_plant_file(std::shared_ptr<const text::SourceFile> plant, std::string_view stem,
                                 const OpenFile& open);
/// Reads the text of a plant.json that includes no files.
PlantFileReading read_plant_file(std::string_view text, std::string_view stem);

struct ConventionsReading {
  std::vector<GivenCheck::Convention> conventions;
  std::vector<json::Placed> syntax;      ///< faults of the JSON syntax
  std::vector<DescriptionFault> faults;  ///< where it does not fit the format; pointers into this file
};

/// Reads a file with naming conventions: an array, as `conventions` in the section `check` of plant.json. O(text).
ConventionsReading read_conventions(std::string_view text);

/// Whether a file is read as plant.json: its name ends in .json or .jsonc, or its text begins with `{`.
bool is_plant_file(std::string_view path, std::string_view bytes);

/// For a message: that this encoding is unknown, the known encodings, and the nearest one.
std::string no_such_encoding(std::string_view name);

}  // namespace symplant::description
