// The lines of a trace file, one by one.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "symplant/tables/time.hpp"
#include "symplant/trace/plain_change.hpp"

namespace symplant::trace {

/// Reads a trace line by line and checks what all lines have in common: the file begins with a header, each other line
/// is a JSON object with a time `t`, and times do not go back except where the plant was set back. Parts of one trace
/// may follow each other. A last line that is cut off is left out. Not thread-safe.
class TraceLines {
 public:
  /// The file must outlive this object.
  explicit TraceLines(std::istream& file) : file_(file) {}

  /// Reads the next line; false at the end and after an error. O(line).
  bool next(nlohmann::json& line);
  /// The same, but a line that is only a change of a symbol is read to `change`, and `line` is left as it is. Ten times
  /// as fast for such lines. `change` refers to text().
  bool next(nlohmann::json& line, std::optional<PlainChange>& change);

  /// The number of the last line, from 1.
  std::size_t number() const { return number_; }
  /// The last line as it is in the file.
  const std::string& text() const { return text_; }
  /// Whether the last line is a header.
  bool is_header() const { return is_header_; }
  /// Whether the last line sets the plant back: a reset, or a restored state.
  bool is_set_back() const { return is_set_back_; }
  /// The `t` of the last line; of a header 0 or the time at which its part begins.
  tables::Time time() const { return time_; }

  /// What is wrong with the last line; empty: nothing.
  const std::string& error() const { return error_; }
  /// Whether the file ends within a line, which was left out.
  bool cut_off() const { return cut_off_; }

 private:
  /// Reads the next line with a text; false at the end and after an error.
  bool next_text();
  bool parse(nlohmann::json& line);
  std::string check(const nlohmann::json& line);
  std::string check_time(tables::Time time);

  std::istream& file_;
  std::string text_;
  std::string error_;
  std::size_t number_ = 0;
  tables::Time time_ = 0;
  bool is_header_ = false;
  bool is_set_back_ = false;
  bool begun_ = false;
  bool cut_off_ = false;
};

}  // namespace symplant::trace
