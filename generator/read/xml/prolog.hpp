// What an XML text shows before its content: its root element and a document type.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace symplant::read::xml {

struct Prolog {
  std::string_view root;               ///< the root's name without prefix; empty if the beginning has no element
  std::string_view head;               ///< the beginning of the text, from the root's `<` on
  std::optional<std::size_t> doctype;  ///< the offset of a document type declaration
};

/// Looks at the first 64 KiB of the text only.
Prolog read_prolog(std::string_view text);

}  // namespace symplant::read::xml
