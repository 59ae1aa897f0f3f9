// A buffered output file with an optional size limit, at which it starts a new file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>

namespace symplant::trace {

inline constexpr std::uint64_t kNoLimit = ~std::uint64_t{0};

/// One writer; not thread-safe. It is passed to the system in whole lines, so that a killed process leaves no line cut
/// off, except one that is longer than the buffer or that flush() cuts. A failed write (a full disk) ends the file
/// after its last whole line; error() has the reason.
class OutputFile {
 public:
  enum class Old : bool {
    replaced,  ///< at once
    kept,      ///< until replace(): until then it is only proved that the file can be written
  };
  /// Opens a file. `what` is its name in messages ("trace"). full() is true from `limit` bytes on. `old`: what the file
  /// has.
  OutputFile(std::string what, std::string path, std::uint64_t limit = kNoLimit, Old old = Old::replaced);
  /// Writes to a stream, which is never full and must outlive this.
  OutputFile(std::string what, std::ostream& stream);
  OutputFile(OutputFile&&) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  void put(std::string_view text) {
    buffer_.append(text);
    if (buffer_.size() >= kBuffer) write_lines();
  }
  /// Empties a file whose contents were kept. To be called before the first put().
  void replace();
  /// Passes everything written so far to the system.
  void flush();

  /// Whether it has `limit` bytes or more, so that begin_again() is due.
  bool full() const noexcept { return written_ + buffer_.size() >= limit_; }
  /// Renames the file to `PATH.1`, which replaces an older one, and starts an empty file.
  void begin_again();

  bool is_open() const noexcept { return file_ != nullptr || stream_ != nullptr; }
  /// The message of the first error; empty if there was no error.
  const std::string& error() const noexcept { return error_; }

 private:
  static constexpr std::size_t kBuffer = std::size_t{1} << 16;
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void open(const char* mode);
  void write_lines();
  void write_out(std::size_t size);
  void fail();

  std::string what_;
  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::ostream* stream_ = nullptr;
  std::string buffer_;
  std::uint64_t limit_ = kNoLimit;
  std::uint64_t written_ = 0;
  std::uint64_t whole_ = 0;  ///< of these, up to the end of the last line
  bool keeps_ = false;       ///< what the file had
  std::string error_;
};

}  // namespace symplant::trace
