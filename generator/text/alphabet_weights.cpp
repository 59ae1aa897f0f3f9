// How much a text beyond ASCII looks like words in Latin, Cyrillic or Greek letters.
#include "text/alphabet_weights.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include "text/utf8.hpp"

namespace symplant::text {
namespace {

/// Letters that are usual in the languages of a code page; others of it are not.
struct Alphabet {
  Encoding encoding;
  std::u32string_view usual;
};
constexpr std::array kAlphabets{
    Alphabet{Encoding::cp1252, U"äöüßÄÖÜéèêëàâáãåçñíìîïóòôõøùúûæœÉÈÀÂÁÃÅÇÑÍÓÔÕØÚÆœŒšž"},
    Alphabet{Encoding::cp1250, U"äöüßÄÖÜąćęłńóśźżĄĆĘŁŃÓŚŹŻáčďéěíňřšťúůýžÁČĎÉĚÍŇŘŠŤÚŮÝŽőűŐŰăâîşţĂÂÎŞŢľĺŕôđĐ"},
    Alphabet{Encoding::cp1254, U"çğıöşüÇĞİÖŞÜâîû"},
};
constexpr std::u32string_view kSigns = U"°±²³µ§–—„“”’‘…€№®Ω×";
constexpr std::u32string_view kVowels = U"аеёиоуыэюяАЕЁИОУЫЭЮЯіїєІЇЄαεηιουωάέήίόύώΑΕΗΙΟΥΩΆΈΉΊΌΎΏ";

bool is_one_of(char32_t point, std::u32string_view points) { return points.find(point) != std::u32string_view::npos; }

bool is_ascii_letter(char32_t c) { return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z'); }

bool is_latin(char32_t c) { return c >= 0xC0 && c <= 0x24F && c != 0xD7 && c != 0xF7; }
bool is_cyrillic(char32_t c) { return c >= 0x400 && c <= 0x491; }
bool is_greek(char32_t c) { return c >= 0x386 && c <= 0x3CE && c != 0x387; }

bool is_upper(char32_t c) {
  if (c < 0x80) return c >= U'A' && c <= U'Z';
  if (c < 0x100) return c <= 0xDE;
  if (c < 0x139 || (c >= 0x14A && c < 0x178)) return c % 2 == 0;
  if (c < 0x250) return c % 2 == 1;
  if (c < 0x400) return c < 0x3AC && c != 0x390;
  return c < 0x430 || c == 0x490;
}

using Points = std::vector<char32_t>;

/// A Latin letter beyond ASCII stands among ASCII ones and in their case.
double latin_weight(char32_t c, char32_t before, char32_t after, std::u32string_view usual) {
  const bool word = is_ascii_letter(before) || is_ascii_letter(after);
  const int beside = (is_latin(before) ? 1 : 0) + (is_latin(after) ? 1 : 0);
  double weight = is_one_of(c, usual) ? 1 : 0.3;
  if (beside == 2 || (!word && beside == 1)) return weight * 0.2;
  if (beside == 1) weight *= 0.7;
  if (!word) return weight * 0.5;
  const bool lower_before = (is_ascii_letter(before) || is_latin(before)) && !is_upper(before);
  const bool upper_around = is_ascii_letter(before) && is_upper(before) && is_ascii_letter(after) && is_upper(after);
  if ((is_upper(c) && lower_before) || (!is_upper(c) && upper_around)) return weight * 0.1;
  return weight;
}

/// Letters of another script stand among their own, small ones behind great ones and not the other way.
template <class IsLetter>
double own_script_weight(char32_t c, char32_t before, char32_t after, IsLetter is_letter) {
  if (is_ascii_letter(before) || is_ascii_letter(after)) return 0.1;
  if (!is_letter(before) && !is_letter(after)) return 0.3;
  return is_letter(before) && is_upper(c) && !is_upper(before) ? 0.1 : 1;
}

double sign_weight(char32_t c, char32_t before, char32_t after) {
  const bool in_word = (is_ascii_letter(before) || is_latin(before)) && (is_ascii_letter(after) || is_latin(after));
  if (in_word) return 0.05;
  return is_one_of(c, kSigns) ? 0.6 : 0.1;
}

class AlphabetJudge {
 public:
  explicit AlphabetJudge(Encoding encoding) : encoding_(encoding) {
    for (const Alphabet& alphabet : kAlphabets) {
      if (alphabet.encoding == encoding) usual_ = alphabet.usual;
    }
  }

  double weight(const Points& points) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      if (points[i] < 0x80) continue;
      sum += weight_of(points[i], points[i - 1], points[i + 1]);
      ++count;
    }
    if (count == 0) return 0;
    constexpr std::size_t kEnough = 6;
    const bool other_script = encoding_ == Encoding::cp1251 || encoding_ == Encoding::cp1253;
    const bool no_language =
        other_script && letters_ >= kEnough && (vowels_ * 7 < letters_ || vowels_ * 4 > letters_ * 3);
    return sum / static_cast<double>(count) * (no_language ? 0.6 : 1);
  }

 private:
  double weight_of(char32_t c, char32_t before, char32_t after) {
    if (encoding_ == Encoding::cp1251 ? is_cyrillic(c) : encoding_ == Encoding::cp1253 && is_greek(c)) {
      ++letters_;
      vowels_ += is_one_of(c, kVowels) ? 1U : 0U;
      return encoding_ == Encoding::cp1251 ? own_script_weight(c, before, after, is_cyrillic)
                                           : own_script_weight(c, before, after, is_greek) * 0.9;
    }
    if (!usual_.empty() && is_latin(c)) return latin_weight(c, before, after, usual_);
    return sign_weight(c, before, after);
  }

  Encoding encoding_;
  std::u32string_view usual_;
  std::size_t letters_ = 0;
  std::size_t vowels_ = 0;
};

}  // namespace

double alphabet_weight(Encoding encoding, std::string_view text) {
  Points points{U'\n'};
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint point = code_point_at(text, at);
    points.push_back(point.value);
    at += point.length;
  }
  points.push_back(U'\n');
  return AlphabetJudge(encoding).weight(points);
}

}  // namespace symplant::text
