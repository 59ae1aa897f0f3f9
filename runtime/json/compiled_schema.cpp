// A schema in a form that validates values without a store.
#include "symplant/json/compiled_schema.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace symplant::json {
namespace {

using Json = nlohmann::json;

bool is_a(const Json& value, std::string_view type) {
  switch (value.type()) {
    case Json::value_t::string:
      return type == "string";
    case Json::value_t::object:
      return type == "object";
    case Json::value_t::array:
      return type == "array";
    case Json::value_t::boolean:
      return type == "boolean";
    case Json::value_t::null:
      return type == "null";
    case Json::value_t::number_integer:
    case Json::value_t::number_unsigned:
      return type == "integer" || type == "number";
    default:
      return type == "number" && value.is_number_float();
  }
}

}  // namespace

std::size_t length(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80; }));
}

CompiledSchema::CompiledSchema(const Json& root) : text_(root), root_(node_of(root)) {}

CompiledSchema::Index CompiledSchema::node_of(const Json& schema) {
  if (schema.is_boolean()) return schema.get<bool>() ? kAny : kNone;
  if (const auto reference = schema.find("$ref"); reference != schema.end()) {
    return node_of(text_.at(Json::json_pointer(reference->get_ref<const std::string&>().substr(1))));
  }
  const auto [at, added] = known_.try_emplace(&schema, static_cast<Index>(nodes_.size()));
  if (!added) return at->second;
  const Index index = at->second;
  nodes_.emplace_back();
  Node node;
  for (const auto& [keyword, value] : schema.items()) take(node, keyword, value);
  if (!node.choices.empty() && (!node.types.empty() || !node.properties.empty() || node.required != nullptr)) {
    throw std::invalid_argument("`anyOf` with other keywords is not supported");
  }
  nodes_[index] = std::move(node);
  return index;
}

void CompiledSchema::take(Node& node, std::string_view keyword, const Json& value) {
  static constexpr std::array<std::string_view, 7> kWithoutMeaning{"$schema",     "$id",     "title",     "description",
                                                                   "definitions", "default", "deprecated"};
  if (keyword == "type") {
    if (value.is_string()) node.types = {&value};
    if (value.is_array())
      std::for_each(value.begin(), value.end(), [&](const Json& one) { node.types.push_back(&one); });
  } else if (keyword == "enum") {
    node.values = &value;
  } else if (keyword == "const") {
    node.constant = &value;
  } else if (keyword == "properties") {
    for (const auto& [key, property] : value.items()) {
      node.properties.emplace_back(key, node_of(property));
    }
  } else if (keyword == "additionalProperties") {
    node.others = node_of(value);
  } else if (keyword == "required") {
    node.required = &value;
  } else if (keyword == "items" && !value.is_array()) {
    node.items = node_of(value);
  } else if (keyword == "minLength") {
    node.least_length = value.get<std::size_t>();
  } else if (keyword == "maxLength") {
    node.most_length = value.get<std::size_t>();
  } else if (keyword == "minItems") {
    node.least_items = value.get<std::size_t>();
  } else if (keyword == "maxItems") {
    node.most_items = value.get<std::size_t>();
  } else if (keyword == "minimum") {
    node.minimum = &value;
  } else if (keyword == "maximum") {
    node.maximum = &value;
  } else if (keyword == "anyOf") {
    for (const Json& choice : value) node.choices.push_back(node_of(choice));
  } else if (std::find(kWithoutMeaning.begin(), kWithoutMeaning.end(), keyword) == kWithoutMeaning.end()) {
    throw std::invalid_argument("the keyword `" + std::string(keyword) + "` is not supported");
  }
}

bool CompiledSchema::fits(Index schema, const Json& value) const {
  if (schema >= kNone) return schema == kAny;
  const Node& node = nodes_[schema];
  const auto is_of = [&](const Json* type) { return is_a(value, type->get_ref<const std::string&>()); };
  if (!node.types.empty() && std::none_of(node.types.begin(), node.types.end(), is_of)) return false;
  if (node.constant != nullptr && value != *node.constant) return false;
  if (node.values != nullptr && std::find(node.values->begin(), node.values->end(), value) == node.values->end()) {
    return false;
  }
  const auto fits_choice = [&](Index choice) { return fits(choice, value); };
  if (!node.choices.empty() && std::none_of(node.choices.begin(), node.choices.end(), fits_choice)) return false;
  if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    if (node.least_length <= 1 && text.size() <= node.most_length) return text.size() >= node.least_length;
    return length(text) >= node.least_length && length(text) <= node.most_length;
  }
  if (value.is_object()) return members_fit(node, value);
  if (value.is_array()) {
    return value.size() >= node.least_items && value.size() <= node.most_items &&
           (node.items == kAny ||
            std::all_of(value.begin(), value.end(), [&](const Json& item) { return fits(node.items, item); }));
  }
  if (!value.is_number()) return true;
  return (node.minimum == nullptr || value >= *node.minimum) && (node.maximum == nullptr || value <= *node.maximum);
}

bool CompiledSchema::members_fit(const Node& node, const Json& value) const {
  if (node.required != nullptr) {
    const auto is_there = [&](const Json& key) { return value.contains(key.get_ref<const std::string&>()); };
    if (!std::all_of(node.required->begin(), node.required->end(), is_there)) return false;
  }
  const auto& members = value.get_ref<const Json::object_t&>();
  return std::all_of(members.begin(), members.end(), [&](const auto& member) {
    const auto property = std::lower_bound(node.properties.begin(), node.properties.end(), member.first,
                                           [](const auto& known, const std::string& key) { return known.first < key; });
    const bool listed = property != node.properties.end() && property->first == member.first;
    return fits(listed ? property->second : node.others, member.second);
  });
}

}  // namespace symplant::json
