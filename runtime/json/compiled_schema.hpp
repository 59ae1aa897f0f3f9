// A schema in a form that validates values without a store.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <utility>
#include <vector>

namespace symplant::json {

/// How many characters a UTF-8 text has.
std::size_t length(std::string_view text);

/// A schema of the keywords listed at class Schema. Its text must outlive it.
class CompiledSchema {
 public:
  /// Throws std::invalid_argument for other keywords, and for `anyOf` next to keywords that restrict the value.
  explicit CompiledSchema(const nlohmann::json& root);
  /// As draft-07 defines it, but that 1.0 is no integer. O(value).
  bool fits(const nlohmann::json& value) const { return fits(root_, value); }

 private:
  using Json = nlohmann::json;
  using Index = std::uint32_t;
  static constexpr Index kAny = std::numeric_limits<Index>::max();  ///< fits every value
  static constexpr Index kNone = kAny - 1;                          ///< fits no value

  struct Node {
    std::vector<const Json*> types;  ///< their names; empty: all
    const Json* values = nullptr;    ///< of `enum`
    const Json* constant = nullptr;
    std::vector<std::pair<std::string_view, Index>> properties;  ///< ascending
    Index others = kAny;                                         ///< of properties that are not listed
    const Json* required = nullptr;
    Index items = kAny;
    std::size_t least_length = 0;
    std::size_t most_length = std::numeric_limits<std::size_t>::max();
    std::size_t least_items = 0;
    std::size_t most_items = std::numeric_limits<std::size_t>::max();
    const Json* minimum = nullptr;
    const Json* maximum = nullptr;
    std::vector<Index> choices;  ///< of `anyOf`; empty: the schema has no `anyOf`
  };

  Index node_of(const Json& schema);
  void take(Node& node, std::string_view keyword, const Json& value);
  bool fits(Index schema, const Json& value) const;
  bool members_fit(const Node& node, const Json& value) const;

  const Json& text_;
  std::vector<Node> nodes_;
  std::map<const Json*, Index> known_;  ///< of the targets of `$ref`, too
  Index root_;
};

}  // namespace symplant::json
