// Merges the descriptions of files.
#include "description/merge.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "description/json_entry.hpp"
#include "text/ascii.hpp"

namespace symplant::description {
namespace {

using Json = nlohmann::json;

/// An array whose entries have names.
struct NamedEntries {
  std::string_view key;
  std::string_view name;  ///< the key of an entry that is its name
};
constexpr std::array kNamedEntries{NamedEntries{"requirements", "name"}, NamedEntries{"malfunctions", "name"},
                                   NamedEntries{"links", "controller"}, NamedEntries{"programs", "controller"}};

/// A key as it is in a pointer.
std::string token(std::string_view key) { return json::child("", key).substr(1); }

class Merger {
 public:
  explicit Merger(const Json& schema) : schema_(schema) {}

  void root(Written into, const Json& other, const Origin& origin) {
    for (const auto& [key, value] : other.items()) {
      const auto* const entries = std::find_if(kNamedEntries.begin(), kNamedEntries.end(),
                                               [&, &name = key](const auto& one) { return one.key == name; });
      if (entries != kNamedEntries.end() && into.value.contains(key)) {
        arrays(member(into, key), value, origin.member(key), schema_of_member(&schema_, key), entries->name);
      } else {
        add(into, key, value, origin, &schema_);
      }
    }
  }

 private:
  /// The member of an object. Its origin is written out, so that it can have members that are elsewhere.
  static Written member(Written of, const std::string& key) {
    const std::string name = token(key);
    return {of.value[key], of.origin.members.try_emplace(name, of.origin.member(name)).first->second};
  }

  void objects(Written into, const Json& other, const Origin& origin, const Json* schema) {
    if (!into.value.is_object() || !other.is_object() || !is_object(schema)) return;
    for (const auto& [key, value] : other.items()) add(into, key, value, origin, schema);
  }

  void add(Written into, const std::string& key, const Json& value, const Origin& origin, const Json* schema) {
    if (into.value.contains(key)) {
      objects(member(into, key), value, origin.member(token(key)), schema_of_member(schema, key));
    } else {
      into.value[key] = value;
      into.origin.members.insert_or_assign(token(key), origin.member(token(key)));
    }
  }

  void arrays(Written into, const Json& other, const Origin& origin, const Json* schema, std::string_view name) {
    if (!into.value.is_array() || !other.is_array()) return;
    const auto name_of = [&](const Json& entry) { return text_or_empty(entry, name); };
    text::ByName<std::size_t> known;
    std::vector<std::string> names;  // which the keys of `known` view
    names.reserve(into.value.size());
    for (std::size_t i = 0; i < into.value.size(); ++i) {
      known.try_emplace(names.emplace_back(name_of(into.value[i])), i);
    }
    const Json* const entries =
        schema != nullptr && schema->contains("items") ? resolved(&(*schema)["items"]) : nullptr;
    for (std::size_t i = 0; i < other.size(); ++i) {
      const auto found = known.find(name_of(other[i]));
      const Origin from = origin.member(std::to_string(i));
      const std::string at = std::to_string(found == known.end() ? into.value.size() : found->second);
      if (found == known.end()) {
        into.value.push_back(other[i]);
        into.origin.members.insert_or_assign(at, from);
      } else {
        Origin& own = into.origin.members.try_emplace(at, into.origin.member(at)).first->second;
        objects({into.value[found->second], own}, other[i], from, entries);
      }
    }
  }

  const Json* resolved(const Json* schema) const {
    while (schema != nullptr && schema->is_object() && schema->contains("$ref")) {
      schema = &schema_.at(Json::json_pointer((*schema)["$ref"].get<std::string>().substr(1)));
    }
    return schema;
  }

  /// Whether a schema is of an object; false if it is of one of several forms.
  static bool is_object(const Json* schema) { return schema != nullptr && text_or_empty(*schema, "type") == "object"; }

  const Json* schema_of_member(const Json* schema, const std::string& key) const {
    if (!is_object(schema)) return nullptr;
    const Json* const properties = description::member(*schema, "properties");
    if (properties != nullptr && properties->contains(key)) return resolved(&(*properties)[key]);
    return resolved(description::member(*schema, "additionalProperties"));
  }

  const Json& schema_;
};

}  // namespace

void merge(Written into, const Json& other, const Origin& other_origin, const Json& schema) {
  Merger(schema).root(into, other, other_origin);
}

}  // namespace symplant::description
