// The rules that the project sets for its source files: layers, third parties, headers, lengths.
#pragma once

#include <string>
#include <vector>

namespace symplant::arch {

struct File {
  std::string path;  ///< relative to the project root, with `/`
  std::string text;
};

/// Sources by path. A value, so that tests can build trees that break the rules.
using Tree = std::vector<File>;

/// Each fault as `path:line: what`, in the order of the tree.
using Faults = std::vector<std::string>;

/// The .hpp and .cpp files below the given folders, sorted by path.
Tree read_tree(const std::string& root, const std::vector<std::string>& folders);

/// "generator/model" of "generator/model/derive.cpp", and of "generator/elements/link/resolve.cpp": the folder of an
/// element has files of several layers.
std::string layer_of(const std::string& path);

/// Includes of a higher layer: a layer may include itself and the layers below it; a generator layer may include only
/// the runtime layers that the rules allow. Checks generator/ and runtime/ only.
Faults climbing_includes(const Tree& tree);

/// Units (a header and its source of one name) that include each other in a circle, each circle once, its units sorted.
Faults include_loops(const Tree& tree);

/// The layers of generator/ and runtime/ as a Mermaid chart. An arrow means "includes"; arrows that follow from others
/// are left out.
std::string layer_chart(const Tree& tree);

/// Includes of a third party in layers that must not use it. Checks generator/ and runtime/ only.
Faults stray_third_parties(const Tree& tree);

/// Files whose first line is not a comment that states their purpose.
Faults missing_heads(const Tree& tree);

/// Pipes of shell scripts into a command that may end before it has read everything (`grep -q`, `head`). The command in
/// front may then fail on its closed pipe, and with `pipefail` the script, now and then.
Faults closed_pipes(const Tree& scripts);

/// Files of more than 500 lines.
Faults long_files(const Tree& tree);

}  // namespace symplant::arch
