// Encoders for a user's text in output that other programs show: one for each context.
//
// All of them first write unsafe characters (diag::visible) as `<U+XXXX>`. emit/encode.hpp has the encoders for C++.
#pragma once

#include <string>
#include <string_view>

namespace symplant::diag {

/// For text and for quoted attribute values in HTML, SVG and XML.
std::string markup_text(std::string_view utf8);

/// A JSON document for the inside of a `<script>` element: the same document, but nothing in it can end the element or
/// begin a comment. `json` must be valid. Unsafe characters are not changed: the caller makes the texts visible().
std::string script_json(std::string_view json);

/// A double-quoted string of Graphviz, with its quotes; a line end in `utf8` does not end a line of the label.
std::string dot_string(std::string_view utf8);
/// The inside of a double-quoted string of Graphviz.
std::string dot_text(std::string_view utf8);

/// For a plain message of SARIF, not yet quoted for JSON. The first characters of `](`, which makes a link, and of
/// `{0}`, which inserts an argument, are also written as `<U+XXXX>`.
std::string sarif_text(std::string_view utf8);

/// For descriptions and notes of Mermaid, in quotes or after a colon. All characters except letters, digits, blanks and
/// a few harmless ones are written as `#NN;`.
std::string mermaid_text(std::string_view utf8);

/// A code span of Markdown, which is also safe in a cell of a table; empty for an empty text. A text with a back-tick,
/// a bar or a backslash becomes an HTML element `<code>` in which all but ASCII letters and digits is written as
/// `&#NN;`.
std::string markdown_code(std::string_view utf8);

}  // namespace symplant::diag
