// The word check: which texts of a file a person reads, and which words must not be in them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "arch/arch_rules.hpp"

namespace symplant::arch {

struct BannedWord {
  std::string words;    ///< lower case, single blanks
  std::string instead;  ///< for the message
};

/// A line's comments, messages or prose, without text in back-ticks.
struct ReadText {
  std::size_t line;
  std::string text;
};

/// Reads `words | instead` lines; empty lines and lines that begin with `#` do not count.
std::vector<BannedWord> read_banned_words(std::string_view text);

/// What a person reads of a file: the prose of Markdown; the comments of sources, in generator and runtime also the
/// string literals, in tests the names of test cases; a template whole; the comments of CMake and shell files.
std::vector<ReadText> texts_of(const File& file);

/// Every banned word in a text, as `file:line: ...`. An exception is the beginning of a path, a blank, and a part of
/// the line in which the word may be.
Faults banned_words(const Tree& tree, const std::vector<BannedWord>& words, const std::vector<std::string>& exceptions);

}  // namespace symplant::arch
