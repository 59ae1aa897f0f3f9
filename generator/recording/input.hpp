// A file that is read once, of which the beginning can be looked at before.
#pragma once

#include <cstddef>
#include <istream>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

namespace symplant::recording {

/// Reads a stream in large parts, the first of which can be looked at. Not thread-safe.
class Input final : private std::streambuf {
 public:
  /// `source` must outlive this object.
  explicit Input(std::istream& source);

  /// The first bytes of the file: all, or at least some thousands. Only before anything is read.
  std::string_view head();
  std::istream& stream() { return stream_; }

 private:
  int_type underflow() override;

  std::istream& source_;
  std::vector<char> buffer_;
  std::istream stream_;
};

/// All bytes that a stream still has. O(bytes).
std::string whole_text(std::istream& file);

}  // namespace symplant::recording
