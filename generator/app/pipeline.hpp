// The pipeline of the tool: from files to the model, the engine's tables and the findings.
#pragma once

#include <optional>
#include <vector>

#include "app/compile_options.hpp"
#include "app/progress.hpp"
#include "app/read_inputs.hpp"
#include "base/file_system.hpp"
#include "diag/diagnostic.hpp"
#include "lower/engine_tables.hpp"
#include "model/derived.hpp"
#include "model/list_input.hpp"
#include "name/symbol_reader.hpp"

namespace symplant::app {

struct Compiled {
  model::PlantModel plant;
  model::Evidence evidence;
  lower::EngineTables tables;        ///< empty if the description has errors, or if only checks follow
  std::size_t own_malfunctions = 0;  ///< those of the plant itself, before those of another file
};

/// Reads the names of the lists with `reader`, then puts the prefixes before them. `io` records which rows its patterns
/// match. O(rows).
std::vector<model::ListInput> parse_names(const std::vector<ReadList>& lists, name::SymbolReader& reader,
                                          name::IoRows& io);

/// Reads a plant.json and its lists, or a bare list, derives the model, lowers it and checks it. Each stage runs once.
/// The result has no value if a file cannot be read or does not fit its format. If `diagnostics` has a stopping error
/// (check::is_stopping), the result is fit for reports only, not for running or generating. O(rows).
std::optional<Compiled> compile(const CompileOptions& options, const base::FileSystem& files, Progress& progress,
                                diag::Diagnostics& diagnostics);

}  // namespace symplant::app
