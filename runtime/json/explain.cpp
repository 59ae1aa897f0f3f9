// Explains why a value does not match a schema.
#include "symplant/json/explain.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "symplant/json/compiled_schema.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::json {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostFaults = 100;
constexpr std::size_t kMostNamed = 12;
constexpr std::size_t kLongestShown = 60;

std::string in_ticks(std::string_view text) {
  std::string shown(text.substr(0, kLongestShown));
  if (shown.size() < text.size()) {  // do not cut within a character
    while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0xC0) == 0x80) shown.pop_back();
    if (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0x80) != 0) shown.pop_back();
    shown += "...";
  }
  return "`" + shown + "`";
}

/// The words for a type of a schema: "a text" for "string".
std::string_view type_words(std::string_view type) {
  struct Words {
    std::string_view type;
    std::string_view words;
  };
  static constexpr Words kWords[] = {{"string", "a text"},    {"number", "a number"}, {"integer", "a whole number"},
                                     {"object", "an object"}, {"array", "an array"},  {"boolean", "true or false"},
                                     {"null", "null"}};
  const auto* found =
      std::find_if(std::begin(kWords), std::end(kWords), [&](const Words& words) { return words.type == type; });
  return found == std::end(kWords) ? type : found->words;
}

bool has_type(const Json& value, std::string_view type) {
  if (type == "string") return value.is_string();
  if (type == "number") return value.is_number();
  if (type == "integer") return value.is_number_integer();
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "boolean") return value.is_boolean();
  return type == "null" && value.is_null();
}

std::string what_is_there(const Json& value) {
  if (value.is_string()) return "the text " + in_ticks(value.get_ref<const std::string&>());
  if (value.is_number()) return "the number " + in_ticks(value.dump());
  if (value.is_boolean() || value.is_null()) return in_ticks(value.dump());
  return value.is_object() ? "an object" : "an array";
}

class Explainer {
 public:
  explicit Explainer(const Json& root) : root_(root) {}

  void walk(const Json& schema, const Json& value, const std::string& pointer) {
    if (faults.size() >= kMostFaults) return;
    const Json& own = resolved(schema);
    if (!own.is_object()) {
      if (own == false) add(pointer, "no value is allowed here; remove it");
      return;
    }
    if (own.contains("anyOf")) return walk_best(own, own["anyOf"], value, pointer);
    if (!type_fits(own, value)) return wrong_type(own, value, pointer);
    if (own.contains("const") && own["const"] != value) {
      return add(pointer, "expected " + wanted(own, own["const"].dump()) + ", but found " + what_is_there(value));
    }
    if (own.contains("enum")) not_one_of(own, value, pointer);
    if (value.is_object()) members(own, value, pointer);
    if (value.is_array()) items(own, value, pointer);
    bounds(own, value, pointer);
  }

  std::vector<Fault> faults;

 private:
  void add(const std::string& pointer, std::string message, bool at_key = false) {
    faults.push_back({pointer, std::move(message), 0, at_key});
  }

  const Json& resolved(const Json& schema) const {
    const Json* own = &schema;
    while (own->is_object() && own->contains("$ref")) {
      own = &root_.at(Json::json_pointer((*own)["$ref"].get_ref<const std::string&>().substr(1)));
    }
    return *own;
  }

  static std::string wanted(const Json& schema, std::string_view otherwise) {
    return schema.contains("title") ? schema["title"].get<std::string>() : std::string(otherwise);
  }

  static bool type_fits(const Json& schema, const Json& value) {
    if (!schema.contains("type")) return true;
    const Json& type = schema["type"];
    if (type.is_string()) return has_type(value, type.get_ref<const std::string&>());
    return std::any_of(type.begin(), type.end(),
                       [&](const Json& one) { return has_type(value, one.get_ref<const std::string&>()); });
  }

  void wrong_type(const Json& schema, const Json& value, const std::string& pointer) {
    std::string types;
    const Json& type = schema["type"];
    if (type.is_string()) {
      types = type_words(type.get_ref<const std::string&>());
    } else {
      for (const Json& one : type) {
        types += (types.empty() ? "" : " or ") + std::string(type_words(one.get_ref<const std::string&>()));
      }
    }
    // Not for a number that is a float only because it exceeds all integers.
    const bool spelt = type == "integer" && schema.contains("minimum") && value.is_number_float() &&
                       std::abs(value.get<double>()) < 1e15;
    add(pointer, "expected " + wanted(schema, types) + ", but found " + what_is_there(value) +
                     (spelt ? "; write a whole number without a decimal point or exponent" : ""));
  }

  void not_one_of(const Json& schema, const Json& value, const std::string& pointer) {
    const Json& values = schema["enum"];
    if (std::find(values.begin(), values.end(), value) != values.end()) return;
    std::string known;
    for (const Json& one : values) {
      known += (known.empty() ? "" : ", ") + in_ticks(one.is_string() ? one.get<std::string>() : one.dump());
    }
    std::string nearest;
    if (value.is_string()) nearest = nearest_of(value.get_ref<const std::string&>(), values);
    add(pointer, "expected one of " + known + ", but found " + what_is_there(value) +
                     (nearest.empty() ? "" : "; did you mean " + in_ticks(nearest) + "?"));
  }

  static std::string nearest_of(std::string_view text, const Json& names) {
    tables::NearestName nearest(text);
    for (const Json& one : names) {
      if (one.is_string()) nearest.offer(one.get_ref<const std::string&>());
    }
    return std::string(nearest.name());
  }

  void members(const Json& schema, const Json& value, const std::string& pointer) {
    static const Json kNone = Json::object();
    const Json& properties = schema.contains("properties") ? schema["properties"] : kNone;
    if (schema.contains("required")) {
      for (const Json& name : schema["required"]) {
        const auto& key = name.get_ref<const std::string&>();
        if (value.contains(key)) continue;
        const bool titled = properties.contains(key) && resolved(properties[key]).contains("title");
        add(pointer,
            "the key " + in_ticks(key) + " is missing here" +
                (titled ? "; it holds " + resolved(properties[key])["title"].get<std::string>() : ""),
            true);
      }
    }
    for (const auto& [key, member] : value.items()) {
      const std::string here = child(pointer, key);
      if (const auto property = properties.find(key); property != properties.end()) {
        walk(*property, member, here);
      } else if (schema.contains("additionalProperties")) {
        const Json& others = schema["additionalProperties"];
        if (others.is_object()) {
          walk(others, member, here);
        } else if (others == false) {
          unknown(key, properties, here);
        }
      }
    }
  }

  void unknown(const std::string& key, const Json& properties, const std::string& pointer) {
    tables::NearestName nearest(key);
    std::string known;
    std::size_t count = 0;
    for (const auto& [name, member] : properties.items()) {
      nearest.offer(name);
      if (++count <= kMostNamed) known += (known.empty() ? "" : ", ") + in_ticks(name);
    }
    const std::string hint = !nearest.name().empty() ? "; did you mean " + in_ticks(nearest.name()) + "?"
                             : count > kMostNamed    ? ""
                                                     : "; the known keys are " + known;
    add(pointer, "the key " + in_ticks(key) + " is unknown here" + hint, true);
  }

  void items(const Json& schema, const Json& value, const std::string& pointer) {
    if (schema.contains("items")) {
      for (std::size_t i = 0; i < value.size(); ++i) walk(schema["items"], value[i], child(pointer, i));
    }
  }

  void bounds(const Json& schema, const Json& value, const std::string& pointer) {
    const auto size = [&]() -> std::size_t {
      return value.is_string() ? length(value.get_ref<const std::string&>()) : value.size();
    };
    const auto above = [&](const char* key) { return schema.contains(key) && size() > schema[key].get<std::size_t>(); };
    const auto below = [&](const char* key) { return schema.contains(key) && size() < schema[key].get<std::size_t>(); };
    const bool short_text = value.is_string() && below("minLength");
    const bool short_array = value.is_array() && below("minItems");
    if (short_text || short_array) {
      add(pointer, "expected " + wanted(schema, short_text ? "a longer text" : "more items") + ", but found " +
                       (value.is_array() ? (value.empty() ? "an empty array" : "an array of too few items")
                        : size() == 0    ? "an empty text"
                                         : what_is_there(value)));
    }
    if (value.is_array() && above("maxItems")) {
      add(pointer, "expected " + wanted(schema, "fewer items") + ", but found an array of too many items");
    }
    if (value.is_string() && above("maxLength")) {
      add(pointer, "expected " + wanted(schema, "a shorter text") + ", but found " + what_is_there(value));
    }
    if (!value.is_number()) return;
    if ((schema.contains("minimum") && value < schema["minimum"]) ||
        (schema.contains("maximum") && value > schema["maximum"])) {
      add(pointer, "expected " + wanted(schema, "a number within bounds") + ", but found " + what_is_there(value));
    }
  }

  /// Continues with the schema of the value's type; for objects with the one that shares most keys with the value.
  void walk_best(const Json& schema, const Json& choices, const Json& value, const std::string& pointer) {
    const Json* best = nullptr;
    std::size_t most = 0;
    std::string types;
    for (const Json& choice : choices) {
      const Json& own = resolved(choice);
      const std::string title = wanted(own, "");
      if (!title.empty()) types += (types.empty() ? "" : ", or ") + title;
      if (!type_fits(own, value)) continue;
      std::size_t shared = 1;
      if (value.is_object() && own.contains("properties")) {
        for (const auto& [key, member] : value.items()) shared += own["properties"].contains(key) ? 1U : 0U;
      }
      if (shared > most) {
        most = shared;
        best = &choice;
      }
    }
    if (best != nullptr) return walk(*best, value, pointer);
    add(pointer, "expected " + wanted(schema, types) + ", but found " + what_is_there(value));
  }

  const Json& root_;
};

}  // namespace

std::vector<Fault> explain(const nlohmann::json& schema, const nlohmann::json& value) {
  Explainer explainer(schema);
  explainer.walk(schema, value, "");
  return std::move(explainer.faults);
}

}  // namespace symplant::json
