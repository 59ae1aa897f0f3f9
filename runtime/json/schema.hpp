// JSON Schema (draft-07): whether a value has the shape that is wanted, told in the house's words.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "symplant/json/location.hpp"

namespace symplant::json {

/// A schema of the tool's own, ready to be asked. Such schemas keep to type, enum, const, properties,
/// additionalProperties, required, items, the lengths and bounds, anyOf, oneOf and $ref within the schema, and say in
/// `title` what is wanted ("a duration such as `1s`"). Immutable; may be asked by several threads.
class Schema {
 public:
  /// Ends the program where the text is no schema: it is part of the tool.
  explicit Schema(std::string_view schema);
  Schema(Schema&&) noexcept;
  Schema& operator=(Schema&&) noexcept;
  ~Schema();

  /// What is wrong with a value, the first 100 faults; nothing where it fits. O(value).
  std::vector<Fault> check(const nlohmann::json& value) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace symplant::json
