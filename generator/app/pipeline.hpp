// The whole road of the tool.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "address/address.hpp"
#include "app/progress.hpp"
#include "base/file_system.hpp"
#include "diag/diagnostic.hpp"
#include "findings/selection.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"
#include "read/readers.hpp"

namespace symplant::app {

struct CompileOptions {
  std::string plant;                   ///< a plant.json, or a symbol list
  read::ReadOptions read;              ///< of lists of which plant.json says nothing else
  std::optional<address::Radix> xy;    ///< likewise
  std::string today = {};              ///< YYYY-MM-DD, for findings ignored until a day; empty: none is over
  findings::Selection selection = {};  ///< of the findings that are told
};

struct Compiled {
  model::PlantModel plant;
  lower::EngineTables tables;
};

/// Reads a plant.json and its lists, or a bare list, derives the model and checks it. Nothing where a file cannot be
/// read or does not fit its format; findings are in `diagnostics`.
std::optional<model::PlantModel> analyse(const CompileOptions& options, const base::FileSystem& files,
                                         Progress& progress, diag::Diagnostics& diagnostics);

/// analyse(), then the engine's tables. Nothing where an error stands. O(rows).
std::optional<Compiled> compile(const CompileOptions& options, const base::FileSystem& files, Progress& progress,
                                diag::Diagnostics& diagnostics);

}  // namespace symplant::app
