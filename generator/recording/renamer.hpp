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
  explicit Renamer(const Renames& renames) {
    for (const auto& [from, to] : renames) symbols_.emplace(from, to);
  }

  /// The symbol of a name; the name itself if it is not renamed.
  std::string_view symbol_of(std::string_view name) const {
    const auto found = symbols_.find(name);
    return found == symbols_.end() ? name : found->second;
  }

  /// What is wrong if two of `names` are renamed to one symbol; empty: nothing. O(names).
  std::string same_symbol(const std::vector<std::string>& names) const;

 private:
  std::unordered_map<std::string_view, std::string_view> symbols_;
};

/// A warning for each name of the file of renames `file` that is not among `names`, with the nearest of them; at most
/// 10, then their number. None if another name of its symbol is there. One warning if `names` are the symbols of
/// renames. O(names) for each of these 10.
std::vector<std::string> not_found(const Renames& renames, const std::string& file,
                                   const std::vector<std::string>& names);

/// Gives the series of a recording the names of their symbols. Those that get one are operations by it. The error,
/// if two are the same symbol; empty: none. O(changes).
std::string rename_series(const Renames& renames, Recording& recording);

}  // namespace symplant::recording
