// Proposes the code page of a text. The only file that uses libuchardet.
#include "text/encoding_guess.hpp"

#include <uchardet.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "text/code_page.hpp"
#include "text/source_file.hpp"
#include "text/utf8.hpp"

namespace symplant::text {
namespace {

constexpr std::size_t kMostJudged = 64 * 1024;
constexpr std::size_t kMostWord = 4096;  // bytes; anything longer is not a word
constexpr std::size_t kMostShown = 40;   // characters of a sample
constexpr std::size_t kEnoughWords = 5;  // with fewer, libuchardet is wrong too often
constexpr std::size_t kMostGuesses = 5;

/// The order of the proposals.
constexpr std::array kCandidates{
    Encoding::cp1252, Encoding::cp932,  Encoding::cp949,  Encoding::gb18030, Encoding::cp950,  Encoding::cp1250,
    Encoding::cp1251, Encoding::cp1254, Encoding::cp1253, Encoding::cp850,   Encoding::cp866,  Encoding::cp852,
    Encoding::cp437,  Encoding::cp1255, Encoding::cp1256, Encoding::cp1257,  Encoding::cp1258, Encoding::cp874};

bool is_high(char c) { return static_cast<unsigned char>(c) >= 0x80; }

/// True between words. None of these bytes is part of a character in any of the code pages.
bool parts_words(char c) { return static_cast<unsigned char>(c) < 0x30 || c == ';'; }

/// The first word at or after `offset` that is not ASCII; empty if not found.
Span next_word(std::string_view bytes, std::size_t offset) {
  const auto high = std::find_if(bytes.begin() + static_cast<std::ptrdiff_t>(offset), bytes.end(), is_high);
  const auto at = static_cast<std::size_t>(high - bytes.begin());
  Span word{at, at};
  if (high == bytes.end()) return word;
  while (word.begin > 0 && !parts_words(bytes[word.begin - 1])) --word.begin;
  while (word.end < bytes.size() && !parts_words(bytes[word.end])) ++word.end;
  return word;
}

struct Words {
  std::string text;  ///< one on each line
  std::size_t count = 0;
};

Words words_to_judge(std::string_view bytes) {
  Words words;
  for (std::size_t at = 0; words.text.size() < kMostJudged;) {
    const Span word = next_word(bytes, at);
    if (word.begin == word.end) break;
    at = word.end;
    if (word.end - word.begin > kMostWord) continue;
    words.text.append(bytes, word.begin, word.end - word.begin).append("\n");
    ++words.count;
  }
  return words;
}

std::optional<Encoding> recognized(const std::string& words) {
  const std::unique_ptr<uchardet, decltype(&uchardet_delete)> detector(uchardet_new(), &uchardet_delete);
  if (uchardet_handle_data(detector.get(), words.data(), words.size()) != 0) return std::nullopt;
  uchardet_data_end(detector.get());
  const std::string_view name = uchardet_get_charset(detector.get());
  if (name == "ISO-8859-7") return Encoding::cp1253;  // nearly the same, and the one that Windows writes
  const auto encoding = encoding_of_name(name);
  return encoding && is_code_page(*encoding) ? encoding : std::nullopt;
}

/// Nothing if the encoding cannot decode all of `bytes`, or reads the word as an earlier guess does.
void add_guess(std::vector<EncodingGuess>& guesses, Encoding encoding, std::string_view bytes, std::string_view word) {
  const auto read = decode_code_page(word, encoding);
  if (!read) return;
  std::string sample = as_sample(*read);
  const auto reads_same = [&](const EncodingGuess& guess) { return guess.sample == sample; };
  if (std::any_of(guesses.begin(), guesses.end(), reads_same) || !decode_code_page(bytes, encoding)) return;
  guesses.push_back({encoding, std::move(sample)});
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

std::vector<EncodingGuess> guess_encoding(std::string_view bytes, std::size_t offset) {
  const Span shown = next_word(bytes, offset);
  const std::string_view word = bytes.substr(shown.begin, shown.end - shown.begin);
  std::vector<EncodingGuess> guesses;
  if (word.empty()) return guesses;
  const Words words = words_to_judge(bytes);
  const std::optional<Encoding> likely = recognized(words.text);
  if (likely) add_guess(guesses, *likely, bytes, word);
  if (!guesses.empty()) guesses.front().recognized = true;
  if (!guesses.empty() && words.count >= kEnoughWords) return guesses;
  for (const Encoding encoding : kCandidates) {
    if (guesses.size() == kMostGuesses) break;
    add_guess(guesses, encoding, bytes, word);
  }
  return guesses;
}

}  // namespace symplant::text
