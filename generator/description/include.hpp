// Reads a plant.json and the files that it includes.
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "description/description.hpp"
#include "description/plant_source.hpp"
#include "symplant/json/location.hpp"

namespace symplant::description {

/// A file that a description includes.
struct OpenedFile {
  std::shared_ptr<const text::SourceFile> source;  ///< null if it cannot be read
  std::string why;                                 ///< then why not; empty: already reported
};
/// Opens a file by its path.
using OpenFile = std::function<OpenedFile(const std::string& path)>;

/// The faults of one file, by pointers into it.
struct FileFaults {
  std::shared_ptr<const text::SourceFile> file;
  std::vector<json::Placed> syntax;      ///< faults of the JSON syntax
  std::vector<DescriptionFault> faults;  ///< where it does not fit the format
  bool sound() const { return syntax.empty() && faults.empty(); }
};

/// A description as JSON: the plant.json with all that it includes.
struct WholeDescription {
  std::unique_ptr<nlohmann::json> root;  ///< null if the plant.json is not a plant description of this version
  std::shared_ptr<const PlantSource> source;
  std::vector<FileFaults> files;  ///< as the files of `source`
  bool complete = true;           ///< all included files could be read

  WholeDescription();
  WholeDescription(WholeDescription&&) noexcept;
  ~WholeDescription();
};

/// Reads a plant.json and the files that it includes. Their form is checked with the schema, file by file. What a file
/// gives wins over what it includes, and of the included files the last one wins. Each file is read once. O(texts).
WholeDescription read_whole(std::shared_ptr<const text::SourceFile> plant, const OpenFile& open);

}  // namespace symplant::description
