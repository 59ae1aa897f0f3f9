// Validates JSON with a compiled schema; explain.cpp explains the faults.
#include "symplant/json/schema.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>

#include "symplant/json/compiled_schema.hpp"
#include "symplant/json/explain.hpp"

namespace symplant::json {

struct Schema::Parts {
  nlohmann::json text;
  std::optional<CompiledSchema> compiled;
};

Schema::Schema(std::string_view schema) : parts_(std::make_unique<Parts>()) {
  try {
    parts_->text = nlohmann::json::parse(schema);
    parts_->compiled.emplace(parts_->text);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "a built-in schema is invalid: %s\n", error.what());
    std::abort();
  }
}
Schema::Schema(Schema&&) noexcept = default;
Schema& Schema::operator=(Schema&&) noexcept = default;
Schema::~Schema() = default;

std::vector<Fault> Schema::check(const nlohmann::json& value) const {
  if (parts_->compiled->fits(value)) return {};
  return explain(parts_->text, value);
}

}  // namespace symplant::json
