// docs/modbus-conformance.md, made of what was played.
#pragma once

#include <string>
#include <vector>

#include "player.hpp"

namespace symplant::conformance {

/// What came of all rows with one server.
struct Column {
  std::string name;
  std::string version;
  std::vector<Result> results;
};

/// The whole page. Nothing in it is of one machine.
std::string page(const std::vector<Row>& rows, const std::vector<Column>& columns);

}  // namespace symplant::conformance
