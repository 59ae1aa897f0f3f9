// Which of the entries of `devices` a device has which key from: a second resolver, as plain as can be.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "property/files/said.hpp"

namespace symplant::property::files {

/// An entry of `devices`: a name or a pattern, and what it says.
struct Entry {
  std::string name;
  Keys keys;

  bool exact() const { return name.find_first_of("*?") == name.npos; }
};

/// A device and what it should come to.
struct Wish {
  std::string path;
  std::set<std::string> tasks;  ///< of all its symbols and added states, in upper case
  Keys keys;
};

/// What a device has of one key.
struct Resolved {
  std::optional<std::size_t> entry;  ///< that the key came from, if any
  bool clash = false;                ///< two equally specific patterns say different things
  long beaten = 0;                   ///< entries that say the key in vain
  long agreeing = 0;                 ///< further ones, equally specific, that say the same
  std::set<std::size_t> best;        ///< the entry, and patterns as specific as it
  nlohmann::json value;              ///< without what the device lacks; null where nothing is said
  long left_out = 0;                 ///< parts that the device lacks
};

Resolved resolve(const std::vector<Entry>& entries, const Wish& device, const std::string& key);

/// Takes what the device lacks out of a key's value; where nothing is left of it, it is null. Gives how many parts.
long leave_out(nlohmann::json& value, const Wish& device, const std::string& key);

/// The value that says nothing, of a key that has one; else null.
nlohmann::json neutral(const std::string& key);
/// Whether both mean the same; null means nothing said.
bool same_meaning(const std::string& key, const nlohmann::json& a, const nlohmann::json& b);

}  // namespace symplant::property::files
