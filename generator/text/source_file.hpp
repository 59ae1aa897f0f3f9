// A text of the user as UTF-8, with line and column for every offset in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace symplant::text {

/// Bytes of a text, from `begin` up to but not including `end`.
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// What a column number counts: characters (code points), or the cells of a sheet that TABs separate.
enum class Counted : std::uint8_t { characters, cells };

/// Both counted from 1.
struct Position {
  std::size_t line;
  std::size_t column;
};

/// Immutable. Lines end at LF, CRLF or CR; they are found when first needed.
class SourceFile {
 public:
  /// `text` must be UTF-8.
  SourceFile(std::string path, std::string text, Counted columns = Counted::characters);

  const std::string& path() const { return path_; }
  std::string_view text() const { return text_; }

  /// At least 1; the text after the last line end counts as a line, even if it is empty. The first call of
  /// line_count(), position() or line_at() is O(text).
  std::size_t line_count() const { return line_begins().size(); }

  /// O(log lines + length of the line).
  Position position(std::size_t offset) const;
  /// The line that holds `offset`, without its line end.
  std::string_view line_at(std::size_t offset) const;

  /// The span of a view into text(); `fallback` if the view does not point into text().
  Span span_of(std::string_view view, Span fallback = {}) const;

 private:
  const std::vector<std::size_t>& line_begins() const;

  std::string path_;
  std::string text_;
  Counted columns_;
  mutable std::once_flag lines_known_;
  mutable std::vector<std::size_t> line_begins_;
};

}  // namespace symplant::text
