// Comments and pragmas around declarations in Structured Text.
#pragma once

#include <cstddef>
#include <string_view>

#include "read/st/tokens.hpp"

namespace symplant::read::st {

/// A comment without its delimiters and the stars and slashes of frames.
std::string_view comment_text(std::string_view comment);

/// What is before a declaration, and whether a comment is on the line of the declaration before it. O(text) over all
/// calls.
class Surroundings {
 public:
  explicit Surroundings(std::string_view text) : text_(text) {}

  /// The next declaration's surroundings begin here: after a `;`, or after the head of a block.
  void begin(std::size_t offset);
  /// Takes note of the next token. Returns whether it is on the line of begin().
  bool pass(const Token& token);
  /// Takes note of a comment above. If a line of it ends with `;`, it is code, not a text about the next declaration.
  void take_above(std::string_view comment);
  void take_link(std::string_view pragma);

  /// The comment directly above the last token, without blank lines between.
  std::string_view above() const { return above_; }
  /// The text of the pragma attribute TcLinkTo.
  std::string_view link() const { return link_; }

 private:
  std::size_t line_breaks(std::size_t begin, std::size_t end) const;

  std::string_view text_;
  std::size_t last_end_ = 0;
  bool on_line_ = false;
  std::string_view above_;
  std::string_view link_;
};

}  // namespace symplant::read::st
