// The only ways in which a user's text gets into what other programs show: one encoder a context.
//
// All of them write characters that are unsafe to show (diag::visible) as `<U+XXXX>` first. What goes into C++ has
// encoders of its own (emit/encode.hpp).
#pragma once

#include <string>
#include <string_view>

namespace symplant::diag {

/// For text and for values of attributes in quotes, in HTML, SVG and XML alike.
std::string markup_text(std::string_view utf8);

/// A JSON document for the inside of a `<script>` element: still the same document, but nothing in it can end the
/// element or begin a comment. `json` must be valid. Unsafe characters are left as they are: who fills the document
/// makes its texts visible().
std::string script_json(std::string_view json);

/// A double-quoted string of Graphviz, its quotes included; line ends in `utf8` are no line ends of the label.
std::string dot_string(std::string_view utf8);
/// The inside of one.
std::string dot_text(std::string_view utf8);

/// For a plain message of SARIF, not yet in the quotes of JSON: `](` would make a link there, `{0}` takes an argument's
/// place; their first signs come as `<U+XXXX>` too.
std::string sarif_text(std::string_view utf8);

/// For descriptions and notes of Mermaid, in quotes or behind a colon: all but letters, digits, blanks and a few
/// harmless signs as `#NN;`.
std::string mermaid_text(std::string_view utf8);

}  // namespace symplant::diag
