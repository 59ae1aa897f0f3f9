// The renames that findings propose, as a file.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "base/text_source.hpp"
#include "diag/diagnostic.hpp"
#include "model/plant_model.hpp"

namespace symplant::app {

/// Collects renames of all plants of a check.
class RenameMap {
 public:
  /// Adds the renames that the findings of a plant propose. Of two proposals for one symbol the first counts. A
  /// proposal is left out if a row or another proposal already has the new name. O(rows + renames), O(findings) without
  /// a rename.
  void add(const model::PlantModel& plant, const diag::Diagnostics& findings);

  /// CSV with the columns `old`, `new`, `address`, `safe` (yes or no) and `why` (the rule).
  base::TextSource text() const;
  std::size_t size() const { return rows_.size(); }
  std::size_t safe() const;
  /// Proposals whose new name is taken.
  std::size_t taken() const { return taken_; }

 private:
  struct Row {
    diag::Rename rename;
    std::string_view why;
  };

  std::vector<Row> rows_;
  std::size_t taken_ = 0;
};

}  // namespace symplant::app
