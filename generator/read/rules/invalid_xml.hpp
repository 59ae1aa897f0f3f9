// SP112: an XML file is not well-formed, or would need too much memory.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kInvalidXml{
    .id = "SP112",
    .slug = "invalid-xml",
    .severity = diag::Severity::error,
    .summary = "an XML file is not well-formed or too large",
    .page =
        R"page(A list in XML is read as a whole: tags must match, attributes have values in quotes, and comments and CDATA sections
are closed. Here the file breaks these rules, most often because an export or a transfer was interrupted, or because the
file was edited. The location is that of the first fault. A file that would need more than 256 MiB of memory is rejected too.

**What the model loses.** It cannot be built: it is not known which symbols are meant. Nothing is written.

**How to fix it.** Export the list again. If the file was edited, write `&lt;` for `<`, `&amp;` for `&` and `&quot;` for `"` in
texts and attributes. If it is too large, export the symbols without the program.
)page"};

}  // namespace symplant::read
