// The output of a run to its user.
#include "symplant/host/console.hpp"

#include <poll.h>
#include <unistd.h>

#include <iostream>

namespace symplant::host {
namespace {

constexpr const char* kClearLine = "\r\x1b[K";

}  // namespace

void Console::write(std::ostream& stream, std::string_view text) {
  if (!drawn_.empty()) out_ << kClearLine;
  out_.flush();
  stream << text << std::flush;
  if (!drawn_.empty()) out_ << drawn_ << "\r" << std::flush;
}

void Console::message(std::string_view text) {
  const std::scoped_lock lock(mutex_);
  write(err_, text);
}

void Console::line(std::string_view text) {
  const std::scoped_lock lock(mutex_);
  write(out_, text);
}

void Console::draw(std::string_view status) {
  const std::scoped_lock lock(mutex_);
  drawn_ = status;
  out_ << kClearLine << drawn_ << "\r" << std::flush;
}

void Console::clear() {
  const std::scoped_lock lock(mutex_);
  if (drawn_.empty()) return;
  drawn_.clear();
  out_ << kClearLine << std::flush;
}

bool Console::is_taken() const {
  const int file = &out_ == &std::cout ? STDOUT_FILENO : &out_ == &std::cerr ? STDERR_FILENO : -1;
  pollfd asked{file, POLLOUT, 0};
  return file < 0 || poll(&asked, 1, 0) != 0;  // poll() also reports a reader that is gone; it blocks nothing
}

}  // namespace symplant::host
