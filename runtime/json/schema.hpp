// Validates values with a JSON Schema (draft-07), with messages in the style of symplant.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "symplant/json/location.hpp"

namespace symplant::json {

/// A built-in schema. Such schemas use only type, enum, const, properties, additionalProperties, required, items, the
/// lengths and bounds, anyOf and $ref within the schema; `title` has the words for what is expected ("a duration
/// such as `1s`"). Immutable; several threads may use it.
class Schema {
 public:
  /// Aborts if the text is no JSON or has other keywords, as it is part of the program.
  explicit Schema(std::string_view schema);
  Schema(Schema&&) noexcept;
  Schema& operator=(Schema&&) noexcept;
  ~Schema();

  /// The first 100 faults of a value; empty if it is valid. O(value).
  std::vector<Fault> check(const nlohmann::json& value) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace symplant::json
