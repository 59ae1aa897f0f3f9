// Gives names of a recording those of its symbols.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "recording/recording.hpp"
#include "recording/renames.hpp"

namespace symplant::recording {

class Renamer {
 public:
  explicit Renamer(const Renames& renames) : renames_(renames) {
    for (const auto& [from, to] : renames) symbols_.emplace(from, to);
  }

  /// The symbol of a name; the name itself if it is not renamed.
  std::string_view symbol_of(std::string_view name) const {
    const auto found = symbols_.find(name);
    return found == symbols_.end() ? name : found->second;
  }

  /// A warning for each renamed name that is not among `names`, with the nearest of them; at most 10. None if another
  /// name of its symbol is. One warning if `names` are the symbols of renames. O(names) for each of these 10.
  std::vector<std::string> not_found(const std::string& file, const std::vector<std::string>& names) const;
  /// What is wrong if two of `names` are renamed to one symbol; empty: nothing. O(names).
  std::string same_symbol(const std::vector<std::string>& names) const;

 private:
  const Renames& renames_;
  std::unordered_map<std::string_view, std::string_view> symbols_;
};

/// Gives the series of a recording the names of their symbols. The error, if two are the same symbol; empty: none.
std::string rename_series(const Renames& renames, Recording& recording);

}  // namespace symplant::recording
