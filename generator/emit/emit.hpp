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

/// A file that belongs to the user, as it is first written.
struct OwnFile {
  std::string behaviour;  ///< the user's class
  std::string name;       ///< within the folder of behaviors
  std::string content;
};

struct EmitOptions {
  /// --templates: a file NAME.mustache in it replaces the built-in template, or gives one more file NAME.
  std::string templates_folder;
};

struct EmitResult {
  std::vector<EmittedFile> files;
  std::vector<OwnFile> own_files;   ///< one for each behavior; to be written if missing
  std::vector<std::string> inputs;  ///< templates read from disk, for the depfile
  std::vector<std::string>
      errors;  ///< faults of templates, with file and line; if there are any, nothing is to be written
};

/// Writes nothing. The content of a file is made each time it is read; `plant` and `tables` must outlive the result.
/// Equal inputs give equal bytes. O(symbols + devices + structure of the types) each time.
EmitResult emit(const model::PlantModel& plant, const lower::EngineTables& tables, const EmitOptions& options,
                const base::FileSystem& files);

/// The namespace of the generated code, made from the plant's name.
std::string namespace_of(const std::string& plant_name);

}  // namespace symplant::emit
