// Makes a user's text safe to show on a terminal.
#include "diag/visible_text.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "text/utf8.hpp"

namespace symplant::diag {

namespace {

struct Range {
  char32_t first;
  char32_t last;
};

// After Unicode's EastAsianWidth.txt (W and F), in coarse ranges.
constexpr std::array kWide{Range{0x1100, 0x115F},   Range{0x231A, 0x231B},   Range{0x2329, 0x232A},
                           Range{0x2E80, 0x303E},   Range{0x3041, 0x3098},   Range{0x309B, 0x4DBF},
                           Range{0x4E00, 0xA4CF},   Range{0xA960, 0xA97F},   Range{0xAC00, 0xD7A3},
                           Range{0xF900, 0xFAFF},   Range{0xFE30, 0xFE6F},   Range{0xFF00, 0xFF60},
                           Range{0xFFE0, 0xFFE6},   Range{0x1F300, 0x1F64F}, Range{0x1F680, 0x1F6FF},
                           Range{0x1F900, 0x1F9FF}, Range{0x20000, 0x3FFFD}};

// The combining marks that industrial names and comments may hold.
constexpr std::array kCombining{Range{0x0300, 0x036F}, Range{0x0483, 0x0489}, Range{0x0591, 0x05BD},
                                Range{0x064B, 0x065F}, Range{0x0E34, 0x0E3A}, Range{0x0E47, 0x0E4E},
                                Range{0x1AB0, 0x1AFF}, Range{0x1DC0, 0x1DFF}, Range{0x20D0, 0x20FF},
                                Range{0x3099, 0x309A}, Range{0xFE00, 0xFE0F}, Range{0xFE20, 0xFE2F}};

// C0, C1, and characters that are invisible or change the direction of text.
constexpr std::array kUnsafe{Range{0x0000, 0x001F}, Range{0x007F, 0x009F},  Range{0x00AD, 0x00AD},
                             Range{0x061C, 0x061C}, Range{0x180E, 0x180E},  Range{0x200B, 0x200F},
                             Range{0x2028, 0x202E}, Range{0x2060, 0x206F},  Range{0xFEFF, 0xFEFF},
                             Range{0xFFF9, 0xFFFB}, Range{0xE0000, 0xE007F}};

template <std::size_t N>
bool within(const std::array<Range, N>& ranges, char32_t point) {
  const auto after =
      std::upper_bound(ranges.begin(), ranges.end(), point, [](char32_t p, const Range& r) { return p < r.first; });
  return after != ranges.begin() && point <= (after - 1)->last;
}

}  // namespace

int display_width(char32_t point) {
  if (point < 0x300) return 1;
  if (within(kCombining, point)) return 0;
  return within(kWide, point) ? 2 : 1;
}

bool is_unsafe(char32_t point) { return within(kUnsafe, point); }

std::string escaped(char32_t point) {
  char buffer[16];
  std::snprintf(buffer, sizeof buffer, "<U+%04X>", static_cast<unsigned>(point));
  return buffer;
}

std::string visible(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const text::CodePoint point = text::code_point_at(text, at);
    at += point.length;
    if (is_unsafe(point.value)) {
      shown += escaped(point.value);
    } else {
      text::append_utf8(shown, point.value);
    }
  }
  return shown;
}

}  // namespace symplant::diag
