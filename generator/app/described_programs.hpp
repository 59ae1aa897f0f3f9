// The PLC programs of a plant's description, as the host takes them.
#pragma once

#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/plant_model.hpp"
#include "symplant/host/plant_program.hpp"

namespace symplant::app {

/// Rows for host::PlantProgram::programs. Files are relative to the folder of plant.json. The description must outlive
/// this object.
class DescribedPrograms {
 public:
  DescribedPrograms(const description::Description& description, const std::string& plant_file);
  DescribedPrograms(const DescribedPrograms&) = delete;
  DescribedPrograms& operator=(const DescribedPrograms&) = delete;

  std::span<const host::DefaultProgram> rows() const { return rows_; }

 private:
  std::deque<std::string> files_;
  std::deque<std::vector<std::string_view>> ignored_;
  std::vector<host::DefaultProgram> rows_;
};

}  // namespace symplant::app
