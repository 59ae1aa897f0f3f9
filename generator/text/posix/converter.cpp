// Converts code pages by iconv.
#include "text/converter.hpp"

#include <iconv.h>

#include <array>
#include <cerrno>
#include <memory>
#include <type_traits>

namespace symplant::text {
namespace {

constexpr std::size_t kBlock = 64 * 1024;
constexpr char kControlLead = '\xC2';  // U+0080 to U+009F are C2 80 to C2 9F

/// libiconv may declare the second argument of iconv() const.
template <class Input>
std::size_t call(std::size_t (*function)(iconv_t, Input, std::size_t*, char**, std::size_t*), iconv_t converter,
                 const char** in, std::size_t* in_left, char** out, std::size_t* out_left) {
  if constexpr (std::is_same_v<Input, char**>) {
    char* bytes = const_cast<char*>(*in);  // NOLINT: iconv does not write there
    const std::size_t result = function(converter, &bytes, in_left, out, out_left);
    *in = bytes;
    return result;
  } else {
    return function(converter, in, in_left, out, out_left);
  }
}

std::size_t find_control(std::string_view text) {
  for (std::size_t at = text.find(kControlLead); at < text.size(); at = text.find(kControlLead, at + 1)) {
    if (at + 1 < text.size() && static_cast<unsigned char>(text[at + 1]) < 0xA0) return at;
  }
  return std::string_view::npos;
}

class Converter {
 public:
  explicit Converter(Encoding encoding) : converter_(iconv_open("UTF-8", name(encoding).c_str())) {}
  ~Converter() {
    if (is_open()) iconv_close(converter_);
  }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;

  bool is_open() const { return converter_ != reinterpret_cast<iconv_t>(-1); }  // NOLINT: iconv's error value

  std::string convert(std::string_view bytes, std::string_view& rest) {
    std::string text;
    text.reserve(bytes.size() + bytes.size() / 4 + 16);
    const auto block = std::make_unique<std::array<char, kBlock>>();
    for (rest = bytes;;) {
      const std::string_view begin = rest;
      std::size_t room = block->size();
      const bool more = step(rest, block->data(), room);
      const std::string_view made(block->data(), block->size() - room);
      const std::size_t control = find_control(made);
      text.append(made.substr(0, control));
      if (control != std::string_view::npos) {  // once more, with room for the part before it
        rest = begin;
        room = control;
        step(rest, block->data(), room);
        return text;
      }
      if (!more) return text;
    }
  }

 private:
  /// The names of encoding_name() are also iconv's, in glibc and in libiconv.
  static std::string name(Encoding encoding) {
    std::string upper(encoding_name(encoding));
    for (char& c : upper) {
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return upper;
  }

  /// Converts until `room` bytes are filled and returns true, or up to the end or a fault and returns false.
  bool step(std::string_view& rest, char* out, std::size_t& room) {
    const char* in = rest.data();
    std::size_t left = rest.size();
    std::size_t result = call(&iconv, converter_, &in, &left, &out, &room);
    rest = rest.substr(rest.size() - left);
    if (is_full(result)) return true;
    // In cp1255 and cp1258 a letter is kept until it is known that no tone follows.
    result = ::iconv(converter_, nullptr, nullptr, &out, &room);
    return is_full(result);
  }

  static bool is_full(std::size_t result) { return result == static_cast<std::size_t>(-1) && errno == E2BIG; }

  iconv_t converter_;
};

}  // namespace

bool can_convert(Encoding encoding) { return Converter(encoding).is_open(); }

std::string convert(Encoding encoding, std::string_view bytes, std::string_view& rest) {
  return Converter(encoding).convert(bytes, rest);
}

}  // namespace symplant::text
