// Random programs with the interface symplant/program.h: compiled once; their slot decides what they do.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "property/lock_step/reactions.hpp"
#include "symplant/program/lock_step.hpp"

namespace symplant::property {

/// The programs of one plant; at most one exists at a time.
class EnginePrograms {
 public:
  static constexpr std::size_t kMost = 3;

  EnginePrograms(std::vector<ProgramTable> tables, const model::PlantModel& model);
  EnginePrograms(const EnginePrograms&) = delete;
  EnginePrograms& operator=(const EnginePrograms&) = delete;

  /// Adds them all, in this order or in the reverse; an error, or empty.
  std::string add_to(program::LockStep& steps, bool reversed) const;

 private:
  struct One {
    ProgramTable table;
    std::vector<std::string> names;
    std::vector<symplant_variable> variables;
    symplant_program program{};
  };
  std::vector<std::unique_ptr<One>> programs_;
};

}  // namespace symplant::property
