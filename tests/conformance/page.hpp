// Writes docs/modbus-conformance.md from the results.
#pragma once

#include <string>
#include <vector>

#include "player.hpp"

namespace symplant::conformance {

/// The results of all rows with one server.
struct Column {
  std::string name;
  std::string version;
  std::vector<Result> results;
};

/// The whole page. It contains no data that depend on one machine.
std::string page(const std::vector<Row>& rows, const std::vector<Column>& columns);

}  // namespace symplant::conformance
