// The result of a check as one HTML page, for readers without the tool.
#pragma once

#include <string>
#include <vector>

#include "diag/diagnostic.hpp"
#include "model/plant_model.hpp"
#include "score/score.hpp"

namespace symplant::app {

/// The page of one or several plants. It shows for each plant its lists, its score, its stations by the share of
/// symbols that is modelled, the ten repairs that concern the most symbols, and all findings by rule. The page is one
/// file without scripts and references.
class CheckPage {
 public:
  /// Adds a plant that could be read. O(symbols + findings).
  void add(const std::string& file, const model::PlantModel& plant, const score::PlantScore& score,
           const diag::Diagnostics& findings);
  /// Adds a plant that could not be read.
  void add(const std::string& file, const diag::Diagnostics& findings);

  std::string take() const;

 private:
  std::string body_;
};

}  // namespace symplant::app
