// The rules of naming.json.
#include "naming/rules.hpp"

#include <array>

#include "naming/rules/naming_contradiction.hpp"
#include "naming/rules/naming_matches_nothing.hpp"
#include "naming/rules/naming_schema.hpp"

namespace symplant::naming {
namespace {

constexpr std::array<const diag::RuleInfo*, 3> kNamingRules{&kNamingSchema, &kNamingContradiction,
                                                            &kNamingMatchesNothing};

}  // namespace

std::span<const diag::RuleInfo* const> rules() { return kNamingRules; }

}  // namespace symplant::naming
