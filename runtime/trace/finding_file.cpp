// Writes findings to a file.
#include "symplant/trace/finding_file.hpp"

#include <fmt/format.h>

#include "symplant/trace/value_text.hpp"

namespace symplant::trace {
namespace {

constexpr std::size_t kOperations = 8;  ///< at most, for each unit

std::string index_json(std::uint32_t symbol, const PlantNames& names) {
  return fmt::format(R"("address":{},"list":{},"row":{})", json_string(names.address(symbol)),
                     json_string(names.list(symbol)), names.tables().symbols[symbol].row);
}

std::string operations_json(const FoundThing& found, const PlantNames& names, const History& history) {
  std::string text;
  for (const std::uint32_t unit : units_of(found, names.tables())) {
    for (const std::uint32_t symbol : history.last_operations(unit, kOperations)) {
      text += fmt::format(R"({}{{"symbol":{},{},"on":{},"since":{}}})", text.empty() ? "" : ",",
                          json_string(names.symbol(symbol)), index_json(symbol, names), history.commands(symbol),
                          history.since(symbol));
    }
  }
  return text;
}

/// The active malfunctions, for a violated requirement: `,"malfunctions":["eye blind"]`; empty if there are none.
std::string malfunctions_json(const FoundThing& found, const PlantNames& names, const History& history) {
  if (found.kind != tables::FindingKind::requirement_violated || history.malfunctions().empty()) return {};
  std::string text;
  for (const History::Malfunction& one : history.malfunctions()) {
    text += fmt::format("{}{}", text.empty() ? "" : ",", json_string(names.malfunction(one.number)));
  }
  return fmt::format(R"(,"malfunctions":[{}])", text);
}

}  // namespace

void FindingFile::write(const FoundThing& found, const std::string& words, const History& history) {
  std::string line = fmt::format(R"({{"t":{},"finding":"{}","of":{})", found.time, finding_name(found.kind),
                                 json_string(name_of(found, names_)));
  if (is_of_symbol(found.kind)) line += "," + index_json(found.of.front(), names_);
  line += fmt::format(R"(,"operations":[{}]{},"words":{}}})", operations_json(found, names_, history),
                      malfunctions_json(found, names_, history), json_string(words));
  file_.put(line);
  file_.put("\n");
}

}  // namespace symplant::trace
