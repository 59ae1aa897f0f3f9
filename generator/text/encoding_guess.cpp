// Which code page a text is likely to be in.
#include "text/encoding_guess.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "text/code_page.hpp"
#include "text/script_weights.hpp"
#include "text/source_file.hpp"
#include "text/utf8.hpp"

namespace symplant::text {
namespace {

constexpr std::size_t kMostJudged = 64 * 1024;
constexpr std::size_t kMostWord = 4096;  // bytes; what is longer is no word
constexpr std::size_t kMostShown = 40;   // characters of a sample
constexpr double kLeast = 0.6;           // of script_weight: less is noise
constexpr double kNearlyAsLikely = 0.15;

/// Of two that are alike the first.
constexpr std::array kCandidates{Encoding::cp949,  Encoding::cp932,  Encoding::gb18030,
                                 Encoding::cp950,  Encoding::cp1252, Encoding::cp1250,
                                 Encoding::cp1251, Encoding::cp1254, Encoding::cp1253};

constexpr std::array kUsualEncodings{UsualEncoding{Encoding::cp1252, "Western Europe"},
                                     UsualEncoding{Encoding::cp932, "Japan"}, UsualEncoding{Encoding::cp949, "Korea"},
                                     UsualEncoding{Encoding::gb18030, "China"}};

bool is_high(char c) { return static_cast<unsigned char>(c) >= 0x80; }

/// What stands between cells. None of these bytes is part of a character in any of the code pages.
bool parts_words(char c) { return static_cast<unsigned char>(c) < 0x30 || c == ';'; }

Span word_around(std::string_view bytes, std::size_t offset) {
  Span word{offset, offset};
  while (word.begin > 0 && !parts_words(bytes[word.begin - 1])) --word.begin;
  while (word.end < bytes.size() && !parts_words(bytes[word.end])) ++word.end;
  return word;
}

/// The words that are not all ASCII, a line each, as far as there is room.
std::string words_to_judge(std::string_view bytes) {
  std::string words;
  for (std::size_t at = 0; at < bytes.size() && words.size() < kMostJudged;) {
    const auto high = std::find_if(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.end(), is_high);
    if (high == bytes.end()) break;
    const Span word = word_around(bytes, static_cast<std::size_t>(high - bytes.begin()));
    if (word.end - word.begin <= kMostWord) words.append(bytes, word.begin, word.end - word.begin).append("\n");
    at = word.end;
  }
  return words;
}

struct Candidate {
  Encoding encoding;
  double weight;
};

/// script_weight() of the words that the encoding can read, times the share that they are.
double weight_of(Encoding encoding, std::string_view words) {
  constexpr std::size_t kMostBad = 20;
  const auto all = static_cast<double>(std::count(words.begin(), words.end(), '\n'));
  std::string good;
  std::string text;
  std::size_t bad = 0;
  while (!words.empty() && bad <= kMostBad) {
    const auto read = decode_code_page(words, encoding);
    if (read) {
      good += words;
      text += *read;
      break;
    }
    const CodePageFault& fault = read.error();
    good.append(words, 0, words.rfind('\n', fault.offset) + 1);
    text.append(fault.before, 0, fault.before.rfind('\n') + 1);
    words.remove_prefix(std::min(words.find('\n', fault.offset), words.size() - 1) + 1);
    ++bad;
  }
  if (bad > kMostBad || all == 0) return 0;
  return script_weight(encoding, good, text) * (all - static_cast<double>(bad)) / all;
}

std::vector<Candidate> likely(std::string_view words, Encoding tried) {
  std::vector<Candidate> candidates;
  for (const Encoding encoding : kCandidates) {
    if (encoding == tried) continue;
    const double weight = weight_of(encoding, words);
    if (weight >= kLeast) candidates.push_back({encoding, weight});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.weight > b.weight; });
  return candidates;
}

}  // namespace

std::string as_sample(std::string_view utf8) {
  std::size_t at = 0;
  for (std::size_t shown = 0; at < utf8.size(); ++shown) {
    if (shown == kMostShown) return std::string(utf8.substr(0, at)) + "…";
    at += code_point_at(utf8, at).length;
  }
  return std::string(utf8);
}

std::vector<EncodingGuess> guess_encoding(std::string_view bytes, std::size_t offset, Encoding tried) {
  const auto high = std::find_if(bytes.begin() + static_cast<std::ptrdiff_t>(offset), bytes.end(), is_high);
  if (high == bytes.end()) return {};
  const Span shown = word_around(bytes, static_cast<std::size_t>(high - bytes.begin()));
  const std::string_view word = bytes.substr(shown.begin, shown.end - shown.begin);
  std::vector<EncodingGuess> guesses;
  const std::vector<Candidate> candidates = likely(words_to_judge(bytes), tried);
  for (const Candidate& candidate : candidates) {
    if (guesses.size() == 2 || candidate.weight < candidates.front().weight - kNearlyAsLikely) break;
    const auto sample = decode_code_page(word, candidate.encoding);
    if (!sample || !decode_code_page(bytes, candidate.encoding)) continue;
    std::string text = as_sample(*sample);
    if (!guesses.empty() && guesses.front().sample == text) continue;
    guesses.push_back({candidate.encoding, std::move(text)});
  }
  return guesses;
}

std::vector<UsualEncoding> possible_encodings(std::string_view bytes) {
  std::vector<UsualEncoding> possible;
  for (const UsualEncoding& usual : kUsualEncodings) {
    if (decode_code_page(bytes, usual.encoding)) possible.push_back(usual);
  }
  return possible;
}

}  // namespace symplant::text
