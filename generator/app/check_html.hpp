// The result of a check as one HTML page, for readers without the tool.
#pragma once

#include <string>
#include <vector>

#include "diag/diagnostic.hpp"
#include "model/plant_model.hpp"
#include "score/score.hpp"

namespace symplant::app {

/// The page of one or several plants: what each list is, its score, its stations by how much of them is modelled, the
/// ten repairs that concern the most symbols, and all findings by rule. One file without scripts and references.
class CheckPage {
 public:
  /// A plant that could be read. O(symbols + findings).
  void add(const std::string& file, const model::PlantModel& plant, const score::PlantScore& score,
           const diag::Diagnostics& findings);
  /// One that could not.
  void add(const std::string& file, const diag::Diagnostics& findings);

  std::string take() const;

 private:
  std::string body_;
};

}  // namespace symplant::app
