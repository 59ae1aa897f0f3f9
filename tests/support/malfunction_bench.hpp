// Plants with malfunctions, used by names.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "description/plant_file.hpp"
#include "support/plant_bench.hpp"

namespace symplant::test {

/// The description with malfunctions: the elements of the array of a plant.json.
inline Reported with_malfunctions(const std::string& json, Reported reported = {}) {
  auto reading =
      description::read_plant_file(R"({"symplant":1,"symbols":["a.csv"],"malfunctions":[)" + json + "]}", "stem");
  for (const json::Placed& fault : reading.syntax) FAIL_CHECK(fault.message);
  for (const description::DescriptionFault& fault : reading.faults) FAIL_CHECK(fault.pointer << ": " << fault.message);
  REQUIRE(reading.file);
  reported.description.malfunctions = std::move(reading.file->description.malfunctions);
  return reported;
}

/// Tables of a list's names, or of a list, with malfunctions.
class FaultyTables : public BenchTables {
 public:
  FaultyTables(const std::vector<std::string>& names, const std::string& json, const Reported& reported = {})
      : BenchTables(names, with_malfunctions(json, reported)) {}
  FaultyTables(const std::vector<Row>& list, const std::string& json, const Reported& reported = {})
      : BenchTables(with_malfunctions(json, reported), list) {}
};

}  // namespace symplant::test
