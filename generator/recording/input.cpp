// A file that is read once, of which the beginning can be looked at before.
#include "recording/input.hpp"

namespace symplant::recording {
namespace {

constexpr std::size_t kPart = std::size_t{1} << 16U;

}  // namespace

Input::Input(std::istream& source) : source_(source), buffer_(kPart), stream_(this) {}

std::string_view Input::head() {
  if (gptr() == egptr() && underflow() == traits_type::eof()) return {};
  return {gptr(), static_cast<std::size_t>(egptr() - gptr())};
}

Input::int_type Input::underflow() {
  if (gptr() != egptr()) return traits_type::to_int_type(*gptr());
  const std::streamsize read = source_.rdbuf()->sgetn(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  setg(buffer_.data(), buffer_.data(), buffer_.data() + read);
  return read == 0 ? traits_type::eof() : traits_type::to_int_type(*gptr());
}

std::string whole_text(std::istream& file) {
  std::string text;
  std::vector<char> part(kPart);
  for (;;) {
    const std::streamsize read = file.rdbuf()->sgetn(part.data(), static_cast<std::streamsize>(part.size()));
    if (read == 0) return text;
    text.append(part.data(), static_cast<std::size_t>(read));
  }
}

}  // namespace symplant::recording
