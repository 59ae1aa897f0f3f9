// A file written line by line and fast, with a size at which it is begun anew; its end is not the plant's.
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

/// One writer; not thread-safe. A write that fails (a full disk) ends the file and is told once: see error().
class OutputFile {
 public:
  /// Opens a file; what it is called in messages is `what` ("trace"). `limit` in bytes is when full() holds.
  OutputFile(std::string what, std::string path, std::uint64_t limit = kNoLimit);
  /// Writes into a stream, which is never full and must outlive this.
  OutputFile(std::string what, std::ostream& stream);
  OutputFile(OutputFile&&) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  void put(std::string_view text) {
    buffer_.append(text);
    if (buffer_.size() >= kBuffer) write_out();
  }
  /// Gives everything written so far to the system.
  void flush();

  /// Whether it holds `limit` bytes or more, and can be begun anew.
  bool full() const noexcept { return written_ + buffer_.size() >= limit_; }
  /// The file so far becomes `PATH.1`, in place of an older one, and an empty one is begun.
  void begin_again();

  bool is_open() const noexcept { return file_ != nullptr || stream_ != nullptr; }
  /// Empty while all is well; else what the system said, once and for all.
  const std::string& error() const noexcept { return error_; }

 private:
  static constexpr std::size_t kBuffer = std::size_t{1} << 16;
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void open();
  void write_out();
  void fail();

  std::string what_;
  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::ostream* stream_ = nullptr;
  std::string buffer_;
  std::uint64_t limit_ = kNoLimit;
  std::uint64_t written_ = 0;
  std::string error_;
};

}  // namespace symplant::trace
