// Reads values of a naming.json that the schema has checked: a value of the wrong type counts as missing.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "description/faults.hpp"
#include "description/json_entry.hpp"
#include "name/naming.hpp"

namespace symplant::naming {

using Json = nlohmann::json;

/// What "operation", "event" or "internal" says; nothing for another word.
std::optional<name::Said> said_of(std::string_view word);
/// The words of an object, each with what it says.
std::vector<name::DirectionWord> direction_words_of(const Json& object);
/// The texts of a member that is an array; none if it is missing.
std::vector<std::string> texts_of(const Json& object, std::string_view key);
/// The pairs of texts of a member that is an array of pairs; none if it is missing.
std::vector<std::pair<std::string, std::string>> pairs_of(const Json& object, std::string_view key);
std::vector<name::Replacement> replacements_of(const Json& object);
/// A member that is true or false; nothing if it is missing.
std::optional<bool> optional_flag(const Json& object, std::string_view key);

/// An entry of `rules`.
name::SymbolRule rule_entry(const Json& entry, const description::Pointer& here, description::ShapeFaults& faults);
/// An entry of `archetypes`.
name::Archetype archetype_entry(const Json& entry, const description::Pointer& here, description::ShapeFaults& faults);

}  // namespace symplant::naming
