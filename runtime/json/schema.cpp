// Validates JSON with valijson, unless the quick form of the schema accepts it; explain.cpp explains the faults.
//
// Only this file includes valijson, which takes ten seconds to compile.
#include "symplant/json/schema.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "symplant/json/explain.hpp"
#include "symplant/json/quick_schema.hpp"

namespace symplant::json {
namespace {

using Adapter = valijson::adapters::NlohmannJsonAdapter;

/// "/devices/X/2" from "<root>", "[\"devices\"]", "[\"X\"]", "[2]".
std::string pointer_of(const std::vector<std::string>& context) {
  std::string pointer;
  for (std::size_t i = 1; i < context.size(); ++i) {
    std::string_view part = context[i];
    if (part.size() >= 2) part = part.substr(1, part.size() - 2);
    if (part.size() >= 2 && part.front() == '"') part = part.substr(1, part.size() - 2);
    pointer = child(pointer, part);
  }
  return pointer;
}

}  // namespace

struct Schema::Parts {
  nlohmann::json text;
  std::optional<QuickSchema> quick;
  valijson::Schema schema;
};

Schema::Schema(std::string_view schema) : parts_(std::make_unique<Parts>()) {
  try {
    parts_->text = nlohmann::json::parse(schema);
    parts_->quick.emplace(parts_->text);
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(parts_->text), parts_->schema);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "a built-in schema is invalid: %s\n", error.what());
    std::abort();
  }
}
Schema::Schema(Schema&&) noexcept = default;
Schema& Schema::operator=(Schema&&) noexcept = default;
Schema::~Schema() = default;

std::vector<Fault> Schema::check(const nlohmann::json& value) const {
  if (parts_->quick->surely_fits(value)) return {};
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  const Adapter adapter(value);
  if (validator.validate(parts_->schema, adapter, nullptr)) return {};
  std::vector<Fault> faults = explain(parts_->text, value);
  if (!faults.empty()) return faults;
  valijson::ValidationResults results;  // a keyword that explain() does not support
  validator.validate(parts_->schema, adapter, &results);
  for (const valijson::ValidationResults::Error& error : results) {
    faults.push_back({pointer_of(error.context), error.description, 0, false});
  }
  return faults;
}

}  // namespace symplant::json
