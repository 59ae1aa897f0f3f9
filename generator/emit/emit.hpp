// The plant as C++ files.
#pragma once

#include <string>
#include <vector>

#include "base/file_system.hpp"
#include "base/text_source.hpp"
#include "diag/diagnostic.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

struct EmittedFile {
  std::string name;  ///< within the output folder
  base::TextSource content;
};

/// A file of the user's own, as it is first written.
struct OwnFile {
  std::string behaviour;  ///< his class
  std::string name;       ///< within the folder of his behaviours
  std::string content;
};

struct EmitOptions {
  std::string templates_folder;  ///< --templates: a file NAME.mustache in it takes the place of the tool's own
};

struct EmitResult {
  std::vector<EmittedFile> files;
  std::vector<OwnFile> own_files;   ///< a behaviour each; to be written where they are missing
  std::vector<std::string> inputs;  ///< templates read from disk, for the depfile
  std::vector<std::string>
      errors;  ///< faults of templates, in words that name file and line; nothing is to be written then
};

/// Nothing is written. Files are made when their content is asked for, which may be as long as `plant` and `tables` are
/// there. Equal inputs give equal bytes. O(symbols + devices + types' structure), each time.
EmitResult emit(const model::PlantModel& plant, const lower::EngineTables& tables, const EmitOptions& options,
                const base::FileSystem& files);

/// The plant's name as the namespace of its code.
std::string namespace_of(const std::string& plant_name);

}  // namespace symplant::emit
