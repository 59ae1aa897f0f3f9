// The declarations of variables in Structured Text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "text/source_file.hpp"

namespace symplant::read {

/// A block VAR ... END_VAR.
struct VariableBlock {
  enum class Kind : std::uint8_t { global, local, config };

  Kind kind = Kind::local;
  std::string klass;       ///< VAR_GLOBAL, VAR_GLOBAL_CONSTANT, VAR_INPUT ...
  std::string_view scope;  ///< the program, function block, configuration or resource
};

/// One or more variables of a block. Views point into the text.
struct Declaration {
  std::vector<std::string_view> names;  ///< without quotes; instance paths in VAR_CONFIG
  std::string_view address;             ///< %IX0.0, %I*; empty if it has none
  std::string_view type;
  std::string_view initial;
  std::string_view comment;  ///< without delimiters; may have line ends
  std::string_view link;     ///< of the pragma attribute TcLinkTo
  text::Span whole;          ///< with its `;`
};

class DeclarationVisitor {
 public:
  virtual ~DeclarationVisitor() = default;
  /// In the order of the text.
  virtual void declared(const VariableBlock& block, const Declaration& declaration) = 0;
  /// A declaration that cannot be read, or a block that is not closed; `fault` ends with what to do.
  virtual void faulty(text::Span where, std::string fault) = 0;
  virtual void unclosed_comment(text::Span where) = 0;
};

/// Reads all blocks of variables in a range of a text, and skips all code. A block VAR_EXTERNAL or VAR_ACCESS declares
/// nothing. The comment of a variable is the first one after it on the line of its `;`, else the first one in its
/// declaration, else the one that ends on the line before it, or on its line. Pragmas may be between them, blank lines
/// may not, and a comment above with a line that ends with `;` is code. O(range).
void read_declarations(std::string_view text, text::Span range, DeclarationVisitor& visitor);

/// How certainly a text is Structured Text with variables, 0 to 100. Looks at its beginning only.
int declarations_likelihood(std::string_view text);

}  // namespace symplant::read
