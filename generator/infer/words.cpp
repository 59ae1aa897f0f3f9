// Cuts the texts of samples into words.
#include "infer/words.hpp"

#include <algorithm>

#include "name/normaliser.hpp"
#include "name/prepared_text.hpp"
#include "text/ascii.hpp"

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
  name::PreparedText text;
  std::vector<SampleWords> all;
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    if (!samples[i].boolean) continue;
    text.prepare(name::normalised(text_of(samples[i], source), naming.normalise, vocabulary, separators), separators);
    if (text.words().empty()) continue;
    SampleWords& words = all.emplace_back();
    words.sample = i;
    words.operation = samples[i].side == name::Side::operation;
    for (const name::Word& word : text.words()) {
      words.words.emplace_back(text.folded().substr(word.begin, word.end - word.begin));
    }
  }
  return all;
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

bool is_number(std::string_view word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) { return text::is_digit(c); });
}

}  // namespace symplant::infer
