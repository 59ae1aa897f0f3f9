// A plant with the malfunctions of campaigns.
#include "app/with_faults.hpp"

#include <fmt/format.h>

#include <fstream>

#include "campaign/fault.hpp"
#include "lower/lower.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::app {

std::vector<std::string> add_fault_malfunctions(Compiled& compiled) {
  std::vector<std::string> already = campaign::add_malfunctions(compiled.plant, compiled.own_malfunctions);
  compiled.tables = lower::lower(compiled.plant);
  return already;
}

bool is_of_fault_run(const std::string& trace, const Compiled& compiled) {
  if (trace.empty()) return false;
  std::ifstream file(trace, std::ios::binary);
  std::string header;
  std::getline(file, header);
  const auto has_hash_of = [&](const lower::EngineTables& tables) {
    return header.find(fmt::format("\"{:016x}\"", tables::model_hash(tables.tables()))) != header.npos;
  };
  if (has_hash_of(compiled.tables)) return false;
  model::PlantModel plant = compiled.plant;
  campaign::add_malfunctions(plant, compiled.own_malfunctions);
  return has_hash_of(lower::lower(plant));
}

}  // namespace symplant::app
