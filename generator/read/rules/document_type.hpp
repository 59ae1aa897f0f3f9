// SP113: an XML file has a document type.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kDocumentType{
    .id = "SP113",
    .slug = "document-type",
    .severity = diag::Severity::error,
    .summary = "an XML file has a document type",
    .page =
        R"page(The XML file has a declaration `<!DOCTYPE ...>`. It may define entities that read other files or grow without
bound. No PLC tool writes one into its exports, so symplant does not read such a file.

**What the model loses.** It cannot be built, and nothing is written.

**How to fix it.** Export the list again. If another program added the declaration, delete it.
)page"};

}  // namespace symplant::read
