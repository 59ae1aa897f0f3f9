// Files that are known and not read: what they are, and which export of the same tool is read.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace symplant::read {

struct RecognizedFile {
  std::string_view what;    ///< "a Rockwell project (ACD, binary)"
  std::string_view advice;  ///< "export the tags: in Logix Designer, ..."
};

/// Whether the bytes begin as those of an archive, a document or a picture do.
bool has_magic(std::string_view bytes);

/// Recognizes a file whose bytes are not text by its content, or, if the content does not decide, by the end of its
/// path. O(bytes).
std::optional<RecognizedFile> recognize_bytes(std::string_view path, std::string_view bytes);

/// Recognizes a text that is not a symbol list by its beginning.
std::optional<RecognizedFile> recognize_text(std::string_view text);

/// Recognizes, by its header, a table that no reader may take though it has names or addresses: read as another one it
/// would lose them.
std::optional<RecognizedFile> recognize_table(std::string_view text);

}  // namespace symplant::read
