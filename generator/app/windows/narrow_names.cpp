// The C library's conversion of narrow text, by which std::filesystem makes wide names of files.
//
// That of mingw-w64 knows no UTF-8, which the manifest of symplant.exe makes the code page of everything else. A
// definition in the program itself comes before the one of the library.
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cwchar>

namespace {

constexpr std::size_t kInvalid = static_cast<std::size_t>(-1);
constexpr std::size_t kIncomplete = static_cast<std::size_t>(-2);

std::size_t fail() {
  errno = EILSEQ;
  return kInvalid;
}

/// The number of bytes of a character, by its first one; 0 if that is invalid.
std::size_t length(std::uint8_t first) {
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  return first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
}

bool is_continuation(char byte) { return (static_cast<std::uint8_t>(byte) & 0xC0U) == 0x80; }

}  // namespace

/// UTF-8 to UTF-16. Of a character beyond U+FFFF, the first call takes three bytes and gives the first unit, the second
/// call takes the last byte and gives the second unit, which `state` keeps meanwhile.
extern "C" std::size_t mbrtowc(wchar_t* to, const char* from, std::size_t size, std::mbstate_t* state) {
  static thread_local std::mbstate_t own{};
  if (state == nullptr) state = &own;
  if (from == nullptr) {
    *state = {};
    return 0;
  }
  if (size == 0) return kIncomplete;
  if (*state != 0) {
    if (to != nullptr) *to = static_cast<wchar_t>(*state);
    *state = {};
    return 1;
  }
  const auto first = static_cast<std::uint8_t>(from[0]);
  const std::size_t bytes = length(first);
  if (bytes == 0) return fail();
  if (bytes > size) return kIncomplete;
  std::uint32_t value = bytes == 1 ? first : first & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if (!is_continuation(from[i])) return fail();
    value = value << 6U | (static_cast<std::uint8_t>(from[i]) & 0x3FU);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};  // of a character by its number of bytes
  if (value < kLeast[bytes] || value > 0x10FFFF || (value >= 0xD800 && value < 0xE000)) return fail();
  if (value < 0x10000) {
    if (to != nullptr) *to = static_cast<wchar_t>(value);
    return value == 0 ? 0 : bytes;
  }
  value -= 0x10000;
  if (to != nullptr) *to = static_cast<wchar_t>(0xD800 + (value >> 10U));
  *state = static_cast<std::mbstate_t>(0xDC00 + (value & 0x3FFU));
  return 3;
}
