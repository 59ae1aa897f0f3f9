// Decides which entry of `devices` gives a device each key: a second resolver, as simple as possible.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "property/files/braces.hpp"
#include "property/files/said.hpp"

namespace symplant::property::files {

/// An entry of `devices`: a name or a pattern, and its keys.
struct Entry {
  std::string name;
  Keys keys;

  bool exact() const { return name.find_first_of("*?") == name.npos; }
};

/// A device and its wanted description.
struct Wish {
  std::string path;
  std::set<std::string> tasks;  ///< of all its symbols and added states, in upper case
  Keys keys;
  const KnownNames* known;  ///< of the plant
};

/// Parts that a device lacks.
struct LeftOut {
  long parts = 0;
  long made = 0;  ///< of these: only due to names that braces make
};

/// How a device gets one key.
struct Resolved {
  std::optional<std::size_t> entry;  ///< the source of the key, if any
  bool clash = false;                ///< two equally specific patterns have different values
  long beaten = 0;                   ///< entries with the key that have no effect
  long agreeing = 0;                 ///< further entries, equally specific, with the same value
  std::set<std::size_t> best;        ///< the entry, and patterns as specific as it
  nlohmann::json value;              ///< made(), without the parts that the device lacks; null if no part is left
  LeftOut left_out;                  ///< parts that the device lacks
};

Resolved resolve(const std::vector<Entry>& entries, const Wish& device, const std::string& key);

/// The value of a key of an entry with names for those in braces.
nlohmann::json made(const Entry& entry, const Wish& device, const std::string& key);

/// Replaces braces in a key's value in a pattern's entry, and removes the parts that the device lacks; null if no part
/// is left.
LeftOut leave_out(nlohmann::json& value, const Wish& device, const std::string& key, const std::string& pattern);

/// The neutral value of a key, if there is one; else null.
nlohmann::json neutral(const std::string& key);
/// Whether both mean the same; null is equal to the neutral value.
bool same_meaning(const std::string& key, const nlohmann::json& a, const nlohmann::json& b);

}  // namespace symplant::property::files
