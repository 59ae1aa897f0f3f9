// A buffered output file with an optional size limit.
#include "symplant/trace/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <ostream>
#include <system_error>
#include <utility>

namespace symplant::trace {

OutputFile::OutputFile(std::string what, std::string path, std::uint64_t limit, Old old)
    : what_(std::move(what)), path_(std::move(path)), limit_(limit) {
  open(old == Old::kept ? "ab" : "wb");
  // A pipe or a device has no size to limit, and cannot be renamed.
  std::error_code unknown;
  if (file_ && !std::filesystem::is_regular_file(path_, unknown)) limit_ = kNoLimit;
  // A pipe has nothing to keep, and its reader would see its end.
  keeps_ = old == Old::kept && std::filesystem::is_regular_file(path_, unknown);
}

void OutputFile::replace() {
  if (std::exchange(keeps_, false)) open("wb");
}

OutputFile::OutputFile(std::string what, std::ostream& stream) : what_(std::move(what)), stream_(&stream) {
  buffer_.reserve(kBuffer);
}

OutputFile::OutputFile(OutputFile&&) noexcept = default;

OutputFile::~OutputFile() { flush(); }

void OutputFile::open(const char* mode) {
  file_.reset(std::fopen(path_.c_str(), mode));
  written_ = whole_ = 0;
  if (!file_) {
    fail();
    return;
  }
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);  // buffer_ is the buffer
  buffer_.reserve(kBuffer);
}

void OutputFile::fail() {
  error_ = "cannot write the " + what_ + " `" + path_ + "`: " + std::strerror(errno);
  file_.reset();
}

/// Passes on the whole lines; all of a line that is longer than the buffer.
void OutputFile::write_lines() {
  const std::size_t end = buffer_.rfind('\n');
  write_out(end == std::string::npos ? buffer_.size() : end + 1);
}

void OutputFile::write_out(std::size_t size) {
  const auto lines_in = [this](std::size_t bytes) {  // the end of the last line of the first bytes, in the file
    const std::size_t end = std::string_view(buffer_).substr(0, bytes).rfind('\n');
    return end == std::string_view::npos ? whole_ : written_ + end + 1;
  };
  if (stream_ != nullptr) {
    stream_->write(buffer_.data(), static_cast<std::streamsize>(size));
    if (!stream_->good()) {
      error_ = "cannot write the " + what_ + " to standard output";
      stream_ = nullptr;
    }
  } else if (file_) {
    errno = 0;
    const std::size_t done = std::fwrite(buffer_.data(), 1, size, file_.get());
    if (done != size) {
      fail();
      std::error_code ignored;
      if (std::filesystem::is_regular_file(path_, ignored)) {
        std::filesystem::resize_file(path_, lines_in(done), ignored);
      }
    }
  }
  whole_ = lines_in(size);
  written_ += size;
  buffer_.erase(0, size);
}

void OutputFile::flush() {
  if (!buffer_.empty()) write_out(buffer_.size());
  if (stream_ != nullptr) stream_->flush();
}

void OutputFile::begin_again() {
  flush();
  if (!file_) return;
  file_.reset();
  std::error_code failed;
  std::filesystem::rename(path_, path_ + ".1", failed);
  if (failed) {
    error_ = "cannot move the " + what_ + " `" + path_ + "` to `" + path_ + ".1`: " + failed.message();
    return;
  }
  open("wb");
}

}  // namespace symplant::trace
