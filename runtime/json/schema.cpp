// Validates JSON with a compiled schema; explain.cpp explains the faults.
#include "symplant/json/schema.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>

#include "symplant/json/compiled_schema.hpp"
#include "symplant/json/explain.hpp"

namespace symplant::json {

struct Schema::Parts {
  explicit Parts(std::string_view schema) : text(nlohmann::json::parse(schema)), compiled(text) {}

  nlohmann::json text;
  CompiledSchema compiled;
};

Schema::Schema(std::string_view schema) {
  try {
    parts_ = std::make_unique<Parts>(schema);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "a built-in schema is invalid: %s\n", error.what());
    std::abort();
  }
}
Schema::Schema(Schema&&) noexcept = default;
Schema& Schema::operator=(Schema&&) noexcept = default;
Schema::~Schema() = default;

std::vector<Fault> Schema::check(const nlohmann::json& value) const {
  if (parts_->compiled.fits(value)) return {};
  return explain(parts_->text, value);
}

}  // namespace symplant::json
