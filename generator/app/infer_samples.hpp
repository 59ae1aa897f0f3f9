// The symbols of lists as samples, from which a naming rule is inferred.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options.hpp"
#include "infer/evaluate.hpp"
#include "model/derived.hpp"
#include "name/naming.hpp"

namespace symplant::app {

struct InferInputs {
  model::Derived derived;              ///< holds the texts of the samples
  std::vector<infer::Sample> samples;  ///< its I/O symbols, in list order
  std::vector<name::Naming> given;     ///< naming rules of --naming or of a plant.json
  std::vector<std::string> files;      ///< the files that were read
  std::vector<std::string> plant;      ///< those that are the plant: the given ones, with the lists in folders
};

/// Reads lists, the lists in folders, or those of a plant.json, as one plant. Messages and exit code are those of
/// read_for().
std::optional<InferInputs> read_samples(Context& context, const std::vector<std::string>& files,
                                        const PlantOptions& options);

}  // namespace symplant::app
