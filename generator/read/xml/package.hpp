// Packages of AutomationML (.amlx): zip archives with a document, libraries and drawings.
#pragma once

#include <string>
#include <string_view>

#include "base/result.hpp"
#include "read/archive.hpp"

namespace symplant::read::xml {

/// The document of a package, unpacked.
struct PackedDocument {
  std::string path;  ///< in the package
  std::string bytes;
};

/// Whether the bytes are those of a package with an AutomationML document.
bool is_automationml_package(std::string_view bytes);

/// The document that the relations of the package name as its root, else the only one. O(unpacked bytes).
base::Result<PackedDocument, ArchiveFault> read_automationml_package(std::string_view bytes);

}  // namespace symplant::read::xml
