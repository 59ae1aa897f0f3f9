// SP106: the option `--input-format` names no format that is known.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kUnknownInputFormat{
    .id = "SP106",
    .slug = "unknown-input-format",
    .severity = diag::Severity::error,
    .summary = "--input-format names no known format",
    .page = R"page(The name after `--input-format` is none of the formats that can be read. The message lists them.

**What the model loses**: everything: the file was not even opened, and nothing is written.

**How to mend it**: use one of the names listed, or leave the option out: the format is then recognised by
the content of the file.
)page"};

}  // namespace symplant::read
