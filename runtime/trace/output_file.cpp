// A buffered output file with an optional size limit.
#include "symplant/trace/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <ostream>
#include <system_error>
#include <utility>

namespace symplant::trace {

OutputFile::OutputFile(std::string what, std::string path, std::uint64_t limit)
    : what_(std::move(what)), path_(std::move(path)), limit_(limit) {
  open();
  // A pipe or a device has no size to limit, and cannot be renamed.
  std::error_code unknown;
  if (file_ && !std::filesystem::is_regular_file(path_, unknown)) limit_ = kNoLimit;
}

OutputFile::OutputFile(std::string what, std::ostream& stream) : what_(std::move(what)), stream_(&stream) {
  buffer_.reserve(kBuffer);
}

OutputFile::OutputFile(OutputFile&&) noexcept = default;

OutputFile::~OutputFile() { flush(); }

void OutputFile::open() {
  file_.reset(std::fopen(path_.c_str(), "wb"));
  written_ = 0;
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

void OutputFile::write_out() {
  if (stream_ != nullptr) {
    stream_->write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  } else if (file_) {
    errno = 0;
    if (std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) != buffer_.size()) fail();
  }
  written_ += buffer_.size();
  buffer_.clear();
}

void OutputFile::flush() {
  if (!buffer_.empty()) write_out();
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
  open();
}

}  // namespace symplant::trace
