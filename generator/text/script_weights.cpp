// How much a text, read in a code page, looks like a language that the code page is for.
#include "text/script_weights.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include "text/alphabet_weights.hpp"

namespace symplant::text {
namespace {

/// A character of one or two bytes; 0 where there is none.
struct Character {
  unsigned char first = 0;
  unsigned char second = 0;
};

constexpr bool between(unsigned char byte, unsigned char least, unsigned char most) {
  return byte >= least && byte <= most;
}

/// Weights of a text character by character.
class Mean {
 public:
  void add(double weight) {
    sum_ += weight;
    ++count_;
  }
  std::size_t count() const { return count_; }
  double value() const { return count_ == 0 ? 0 : sum_ / static_cast<double>(count_); }

 private:
  double sum_ = 0;
  std::size_t count_ = 0;
};

/// Calls `take` for each character beyond ASCII; `is_single` tells those of one byte.
template <class IsSingle, class Take>
void for_each_character(std::string_view bytes, IsSingle is_single, Take take) {
  const auto byte = [&](std::size_t i) { return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0; };
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const auto first = static_cast<unsigned char>(byte(at));
    if (first < 0x80 || is_single(first)) {
      take(Character{first, 0});
    } else {
      take(Character{first, static_cast<unsigned char>(byte(++at))});
    }
  }
}

constexpr auto kNoneSingle = [](unsigned char) { return false; };

/// The 2,350 syllables of KS X 1001 are nearly all that is written; Hanja and the rest of UHC are rare.
double korean(std::string_view bytes) {
  Mean mean;
  for_each_character(bytes, kNoneSingle, [&](Character c) {
    if (c.second == 0) return;
    if (c.second >= 0xA1 && between(c.first, 0xB0, 0xC8)) return mean.add(1);
    if (c.second >= 0xA1 && between(c.first, 0xA1, 0xAC)) return mean.add(0.6);
    mean.add(0.1);
  });
  return mean.value();
}

/// Level 1 of GB2312 is in the order of pinyin: two fifths of a text stand in its last third, where Korean has none.
double simplified_chinese(std::string_view bytes) {
  constexpr std::size_t kEnough = 4;
  Mean mean;
  std::size_t usual = 0;
  std::size_t late = 0;
  for_each_character(bytes, kNoneSingle, [&](Character c) {
    if (c.second == 0) return;
    if (c.second >= 0xA1 && between(c.first, 0xB0, 0xD7)) {
      ++usual;
      late += c.first > 0xC8 ? 1U : 0U;
      return mean.add(1);
    }
    if (c.second >= 0xA1 && between(c.first, 0xD8, 0xF7)) return mean.add(0.35);
    if (c.second >= 0xA1 && between(c.first, 0xA1, 0xA3)) return mean.add(0.6);
    mean.add(0.1);
  });
  return usual >= kEnough && late * 10 < usual ? mean.value() * 0.7 : mean.value();
}

/// Level 1 of Big5 fills second bytes from 40 to 7E as densely as those from A1 on.
double traditional_chinese(std::string_view bytes) {
  constexpr std::size_t kEnough = 4;
  Mean mean;
  std::size_t low = 0;
  for_each_character(bytes, kNoneSingle, [&](Character c) {
    if (c.second == 0) return;
    low += c.second < 0x80 ? 1U : 0U;
    mean.add(between(c.first, 0xA4, 0xC6) ? 1 : between(c.first, 0xA1, 0xA3) ? 0.6 : 0.2);
  });
  return mean.count() >= kEnough && low * 10 < mean.count() ? mean.value() * 0.7 : mean.value();
}

bool is_half_width(unsigned char byte) { return between(byte, 0xA1, 0xDF); }

/// Whether katakana of half width may follow: sound marks only what takes them, small ones no beginning.
double half_width_weight(unsigned char byte, unsigned char before) {
  constexpr double kUsual = 0.8;
  const bool in_word = is_half_width(before) && before >= 0xA6;
  if (byte == 0xDE) return between(before, 0xB6, 0xC4) || between(before, 0xCA, 0xCE) || before == 0xB3 ? kUsual : 0;
  if (byte == 0xDF) return between(before, 0xCA, 0xCE) ? kUsual : 0;
  if (between(byte, 0xA7, 0xB0)) return in_word ? kUsual : 0;
  return byte >= 0xB1 ? kUsual : 0.1;
}

double japanese(std::string_view bytes) {
  Mean mean;
  unsigned char before = 0;
  for_each_character(bytes, is_half_width, [&](Character c) {
    const unsigned char previous = before;
    before = c.second == 0 ? c.first : 0;
    if (c.first < 0x80) return;
    if (c.second == 0) return mean.add(half_width_weight(c.first, previous));
    const bool kana = (c.first == 0x82 && c.second >= 0x9F) || (c.first == 0x83 && c.second <= 0x96);
    if (kana) return mean.add(1);
    if (between(c.first, 0x88, 0x97)) return mean.add(0.95);                         // kanji of level 1
    if (between(c.first, 0x81, 0x82)) return mean.add(c.first == 0x82 ? 0.8 : 0.7);  // signs, wide letters
    mean.add(c.first == 0x98 ? 0.6 : 0.15);
  });
  return mean.value();
}

}  // namespace

double script_weight(Encoding encoding, std::string_view bytes, std::string_view text) {
  switch (encoding) {
    case Encoding::cp932:
      return japanese(bytes);
    case Encoding::cp949:
      return korean(bytes);
    case Encoding::gb18030:
      return simplified_chinese(bytes);
    case Encoding::cp950:
      return traditional_chinese(bytes);
    default:
      return alphabet_weight(encoding, text);
  }
}

}  // namespace symplant::text
