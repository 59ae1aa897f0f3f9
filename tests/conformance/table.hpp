// The expectation table as read from its file.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace symplant::conformance {

/// A row with steps, or a line of a matrix with cells.
struct Row {
  std::string part;
  std::string id;
  std::string source;  ///< section of a specification
  std::string what;
  std::vector<std::string> steps;

  int function = 0;         ///< of a matrix; 0: steps
  bool write_part = false;  ///< of function 23: the written part varies, not the read part
  std::string address;
  std::vector<std::pair<std::uint32_t, std::string>> cells;  ///< a quantity or value, and the expected answer
};

/// Throws std::runtime_error, with the line number, if the text is not a table.
std::vector<Row> read_table(const std::string& text);

}  // namespace symplant::conformance
