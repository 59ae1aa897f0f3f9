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

/// A file whose bytes are no text, by its content; the end of its path decides where the content does not. O(bytes).
std::optional<RecognizedFile> recognize_bytes(std::string_view path, std::string_view bytes);

/// A text that is no symbol list, by its beginning.
std::optional<RecognizedFile> recognize_text(std::string_view text);

}  // namespace symplant::read
