// The files of a plant: plant.json and its symbol lists, or a bare list.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/pipeline.hpp"
#include "description/plant_file.hpp"
#include "model/build_plant.hpp"

namespace symplant::app {

struct Inputs {
  std::string name;                                             ///< the plant's
  std::shared_ptr<const text::SourceFile> source;               ///< the plant.json; null: a bare list
  std::shared_ptr<const description::Description> description;  ///< null: a bare list
  std::vector<description::DescriptionFault> faults;            ///< of the description's form
  bool readable = true;  ///< all of it could be read and fits its format; else the plant is made to find faults only
  std::vector<model::ListInput> lists;
};

/// Reads them all. Nothing where there is no list to make a plant of; findings but for `faults` are in `diagnostics`.
std::optional<Inputs> read_inputs(const CompileOptions& options, const base::FileSystem& files, Progress& progress,
                                  diag::Diagnostics& diagnostics);

}  // namespace symplant::app
