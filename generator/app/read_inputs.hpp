// The files of a plant: plant.json and its symbol lists, or a bare list.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/compile_options.hpp"
#include "app/progress.hpp"
#include "base/file_system.hpp"
#include "description/plant_file.hpp"
#include "diag/diagnostic.hpp"
#include "naming/load.hpp"

namespace symplant::app {

/// A symbol list as it was read.
struct ReadList {
  std::shared_ptr<read::SymbolTable> table;
  std::string controller;            ///< the controller that it belongs to; empty: the default one
  std::string prefix;                ///< put before the names of its symbols and the lines of its devices
  std::optional<address::Radix> xy;  ///< without a value: what the rows prove, else hexadecimal
};

struct Inputs {
  std::string name;                                             ///< the plant's
  std::shared_ptr<const description::PlantSource> source;       ///< the plant.json; null: a bare list
  std::shared_ptr<const description::Description> description;  ///< null: a bare list
  std::vector<description::DescriptionFault> faults;            ///< where the description does not fit its format
  std::shared_ptr<const text::SourceFile> malfunctions;         ///< the file with more malfunctions; null: none
  std::size_t own_malfunctions = 0;                             ///< those before it in the description
  bool readable = true;  ///< everything was read and fits its format; otherwise the inputs serve to find faults only
  std::vector<ReadList> lists;
  name::IoRows io;  ///< rows that are I/O although their address is internal or missing
  std::shared_ptr<const name::CompiledNaming> naming = naming::strict_naming();
  std::shared_ptr<const symplant::naming::LoadedNaming> naming_parts;  ///< locations of its parts; null: default rule
};

/// Reads all files of a plant. Nothing if there is no list, or if the naming rule has a fault. Adds findings to
/// `diagnostics`, except those in `faults`.
std::optional<Inputs> read_inputs(const CompileOptions& options, const base::FileSystem& files, Progress& progress,
                                  diag::Diagnostics& diagnostics);

}  // namespace symplant::app
