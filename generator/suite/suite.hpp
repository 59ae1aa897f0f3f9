// A test suite: a folder with suite.json, a scenario for each case, and reference traces.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/difference.hpp"
#include "symplant/tables/duration.hpp"

namespace symplant::suite {

/// Plants on which each case runs.
enum class Speed : std::uint8_t {
  normal,  ///< as described
  fast,    ///< every travel time is a fifth
  slow,    ///< every travel time is three times as long
};
/// `fast`
std::string_view speed_name(Speed speed);
/// The speed of a name; nothing for any other text.
std::optional<Speed> speed_of(std::string_view name);

struct Suite {
  std::string folder;                 ///< as the user gave it
  std::string plant;                  ///< a path
  std::vector<std::string> programs;  ///< FILE or CONTROLLER=FILE
  compare::Options how;               ///< without patterns in `only`: operations only
  tables::Time limit = 600 * tables::kSecond;
  std::string before;              ///< a path; empty: none
  std::vector<std::string> cases;  ///< their names, ascending

  /// `suite/start.json`
  std::string scenario(const std::string& name) const;
  /// `suite/start.reference.jsonl`, `suite/start.fast.reference.jsonl`
  std::string reference(const std::string& name, Speed speed) const;
};

struct ReadSuite {
  std::optional<Suite> suite;
  std::vector<std::string> errors;  ///< `suite/suite.json:3:5: ...`; none: there is a suite
  std::vector<std::string> warnings;
};

/// Reads the suite of a folder. A case is each JSON file directly in it that has the key `symplant-scenario`, except
/// `before`. O(bytes of the JSON files).
ReadSuite read_suite(const std::string& folder);

/// The JSON Schema of suite.json, generator/suite/suite.schema.json.
std::string_view suite_schema();

}  // namespace symplant::suite
