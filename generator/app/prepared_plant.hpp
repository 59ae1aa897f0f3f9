// The parts of a compiled plant that a running plant needs.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/described_programs.hpp"
#include "app/panel_view.hpp"
#include "app/pipeline.hpp"
#include "symplant/host/plant_program.hpp"

namespace symplant::app {

/// The parts of a compiled plant that are needed while it runs. The rest is freed before the start.
class PreparedPlant {
 public:
  PreparedPlant(Compiled compiled, const std::string& plant_file);
  PreparedPlant(const PreparedPlant&) = delete;
  PreparedPlant& operator=(const PreparedPlant&) = delete;

  /// The result refers to this object.
  host::PlantProgram program() const { return program(rows_); }
  /// The same plant with other tables, which must outlive the result.
  host::PlantProgram program(const tables::PlantTables& tables) const;
  const lower::EngineTables& tables() const { return tables_; }

 private:
  const lower::EngineTables tables_;
  const tables::PlantTables rows_;
  const std::shared_ptr<const description::Description> description_;  ///< links and settings point to its texts
  const PanelView view_;
  const DescribedPrograms programs_;
  const std::vector<model::ControllerLink> controllers_;
  const std::vector<std::string> more_;
  const std::vector<std::string> inputs_;
  const std::vector<std::string_view> more_views_;
  const std::vector<std::string_view> input_views_;
  std::vector<host::DefaultLink> links_;
  std::vector<link::LinkSettings> settings_;
  std::vector<host::IgnoredFinding> ignored_;
};

}  // namespace symplant::app
