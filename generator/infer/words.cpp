// Cuts the texts of samples into words.
#include "infer/words.hpp"

#include <algorithm>

#include "name/normaliser.hpp"
#include "name/prepared_text.hpp"
#include "name/required_words.hpp"
#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::infer {

namespace {

std::string text_of(const Sample& sample, name::Source source) {
  if (source == name::Source::comment) return std::string(sample.text.comment);
  if (source != name::Source::parent_and_comment) return std::string(sample.text.name);
  std::string both(sample.text.parent_comment);
  both.append(both.empty() || sample.text.comment.empty() ? "" : " ").append(sample.text.comment);
  return both;
}

}  // namespace

std::vector<SampleWords> words_of(std::span<const Sample> samples, name::Source source, const name::Naming& naming,
                                  const name::Vocabulary& vocabulary) {
  const name::Separators separators(naming.separators);
  std::vector<std::pair<std::size_t, std::string>> faults;
  const name::Replacements replacements(naming.normalise.replace, faults);
  name::PreparedText text;
  std::vector<SampleWords> all;
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    if (!samples[i].boolean) continue;
    std::string normal = name::normalised(text_of(samples[i], source), naming.normalise, vocabulary, separators);
    replacements.apply(normal);
    text.prepare(normal, separators);
    if (text.words().empty()) continue;
    SampleWords& words = all.emplace_back();
    words.sample = i;
    words.operation = samples[i].side == name::Direction::operation;
    for (const name::Word& word : text.words()) {
      words.words.emplace_back(text.folded().substr(word.begin, word.end - word.begin));
    }
  }
  return all;
}

namespace {
constexpr std::string_view kSideLetters = "i o x y q e a";  ///< that are words
}  // namespace

std::vector<SampleWords> without_sides(std::vector<SampleWords> texts, const name::Vocabulary& vocabulary) {
  for (SampleWords& text : texts) {
    std::erase_if(text.words, [&](const std::string& word) {
      return kSideLetters.find(word) != std::string_view::npos || vocabulary.class_said(word) ||
             vocabulary.is_affix(word, name::Direction::event) || vocabulary.is_affix(word, name::Direction::operation);
    });
  }
  return texts;
}

std::string joined_words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : " ").append(word);
  return text;
}

std::string shape_of(std::string_view word) {
  std::string shape;
  for (const char c : word) {
    if (!text::is_digit(c)) {
      shape += c;
    } else if (shape.empty() || shape.back() != '#') {
      shape += '#';
    }
  }
  return shape;
}

std::string expression_of_shape(std::string_view shape) {
  constexpr std::string_view kSyntax = R"(\^$.|?*+()[]{})";
  std::string expression;
  for (const char c : shape) {
    if (c == '#') {
      expression += "[0-9]+";
      continue;
    }
    if (kSyntax.find(c) != std::string_view::npos) expression += '\\';
    expression += c;
  }
  return expression;
}

std::string quoted(std::string_view text) {
  constexpr std::string_view kSyntax = R"(\{}()|*)";
  std::string quoted;
  for (const char c : text) {
    if (kSyntax.find(c) != std::string_view::npos) quoted += '\\';
    quoted += c;
  }
  return quoted;
}

bool contains(const std::vector<std::string>& words, std::string_view known, const name::Vocabulary& vocabulary) {
  const auto stem = [](std::string_view word) { return word.substr(0, word.find_last_not_of("0123456789") + 1); };
  if (known.find(' ') != known.npos) {
    std::string text = " ";
    for (const std::string& word : words) text.append(stem(word)).append(" ");
    return text.find(" " + std::string(known) + " ") != std::string::npos;
  }
  const bool within = text::code_point_at(known, 0).value >= name::kFirstWithoutBlanks;
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return within ? word.find(known) != std::string::npos && !vocabulary.motion(word) : stem(word) == known;
  });
}

bool is_number(std::string_view word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) { return text::is_digit(c); });
}

}  // namespace symplant::infer
