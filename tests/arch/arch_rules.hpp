// The rules of the house on its sources: floors, third parties, heads, lengths.
#pragma once

#include <string>
#include <vector>

namespace symplant::arch {

struct File {
  std::string path;  ///< from the project's root, with `/`
  std::string text;
};

/// Sources by path. A value, so that tests can make trees that break the rules.
using Tree = std::vector<File>;

/// Each fault as `path:line: what`, in the order of the tree.
using Faults = std::vector<std::string>;

/// The .hpp and .cpp files below the folders named, sorted by path.
Tree read_tree(const std::string& root, const std::vector<std::string>& folders);

/// Includes that climb: a floor may include itself and the floors below it, the generator's floors of the runtime only
/// what the house lets them. Looks at generator/ and runtime/ only.
Faults climbing_includes(const Tree& tree);

/// Includes of a third party outside the floors that may see it. Looks at generator/ and runtime/ only.
Faults stray_third_parties(const Tree& tree);

/// Files whose first line is no comment that says what they are for.
Faults missing_heads(const Tree& tree);

/// Files of more than 400 lines.
Faults long_files(const Tree& tree);

}  // namespace symplant::arch
