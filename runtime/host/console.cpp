// The output of a run to its user.
#include "symplant/host/console.hpp"

#include <iostream>

#include "symplant/host/terminal.hpp"

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
  if (&out_ == &std::cout) return would_take(Stream::output);
  return &out_ != &std::cerr || would_take(Stream::error);
}

}  // namespace symplant::host
