// Looks at how the texts of a list are written.
#include "infer/frame.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "infer/differences.hpp"
#include "infer/words.hpp"
#include "name/vocabulary.hpp"
#include "text/ascii.hpp"
#include "text/folding.hpp"

namespace symplant::infer {
namespace {

constexpr std::size_t kLeastFused = 3;  ///< texts in which a motion is written together with another word
constexpr std::string_view kSeparators = " _.:/&(),[]\"'#";

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }

bool has_hump(std::string_view text) {
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (is_lower(text[i - 1]) && is_upper(text[i])) return true;
  }
  return false;
}

/// Counts texts with something, over names and comments.
template <class Test>
std::size_t count_texts(std::span<const Sample> samples, const Test& test) {
  std::size_t count = 0;
  for (const Sample& sample : samples) {
    if (test(sample.text.name) || test(sample.text.comment)) ++count;
  }
  return count;
}

/// A hyphen parts words unless most are between digits and letters without blanks (`S441-2`).
bool hyphen_separates(std::span<const Sample> samples) {
  std::size_t within = 0;
  std::size_t between = 0;
  for (const Sample& sample : samples) {
    for (const std::string_view text : {sample.text.name, sample.text.comment}) {
      for (std::size_t at = text.find('-'); at != text.npos; at = text.find('-', at + 1)) {
        const bool digits = at > 0 && at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9';
        ++(digits ? within : between);
      }
    }
  }
  return between > within;
}

bool is_separator(char c) { return c == '-' || kSeparators.find(c) != std::string_view::npos; }

/// The motions that follow another word without a separator, as one expression; empty if there are few.
std::string fused_motions(std::span<const Sample> samples) {
  std::string expression;
  std::size_t texts = 0;
  std::vector<std::string_view> motions(name::built_in_words().fused_motions.begin(),
                                        name::built_in_words().fused_motions.end());
  std::stable_sort(motions.begin(), motions.end(),
                   [](std::string_view a, std::string_view b) { return a.size() > b.size(); });
  for (const std::string_view motion : motions) {
    const std::size_t found = count_texts(samples, [&](std::string_view text) {
      const std::size_t at = text.find(motion);
      return at != text.npos && at > 0 && !is_separator(text[at - 1]);
    });
    if (found == 0) continue;
    texts += found;
    expression.append(expression.empty() ? "" : "|").append(motion);
  }
  return texts < kLeastFused ? std::string() : expression;
}

/// `ADV [1,2]` of a valve, `ADV [1]` and `ADV [2]` of its sensors.
bool ends_in_numbers(std::string_view text) {
  const std::size_t open = text.rfind('[');
  if (open == text.npos || !text.ends_with(']')) return false;
  const std::string_view numbers = text.substr(open + 1, text.size() - open - 2);
  return !numbers.empty() && numbers.find_first_not_of("0123456789, ") == numbers.npos;
}

bool is_spare(std::string_view word) {
  const auto spare = name::built_in_words().spare;
  const std::string_view stem = word.substr(0, word.find_last_not_of("0123456789") + 1);
  return std::find(spare.begin(), spare.end(), stem) != spare.end();
}

/// What means no text: no letter and no digit, or one or two letters in brackets: `-`, `[T]`, `[DT]`.
bool is_placeholder(std::string_view text) {
  if (text.empty()) return false;
  const auto is_word = [](char c) {
    return text::is_digit(c) || is_lower(c) || is_upper(c) || static_cast<unsigned char>(c) >= 0x80;
  };
  if (text.size() <= 4 && text.front() == '[' && text.back() == ']') {
    return std::all_of(text.begin() + 1, text.end() - 1, [](char c) { return is_lower(c) || is_upper(c); });
  }
  return std::none_of(text.begin(), text.end(), is_word);
}

/// Texts that mean no text, as patterns.
void ignore_placeholders(std::span<const Sample> samples, name::Naming& naming) {
  std::set<std::string> found;
  for (const Sample& sample : samples) {
    for (const std::string_view text : {sample.text.name, sample.text.comment}) {
      const bool is_pattern = text.find_first_of("*?") != text.npos;  // which would match other texts
      if (is_placeholder(text) && !is_pattern) found.insert(text::folded(text));
    }
  }
  naming.ignore.insert(naming.ignore.end(), found.begin(), found.end());
}

void ignore_spares(std::span<const Sample> samples, name::Naming& naming, const name::Vocabulary& vocabulary) {
  std::vector<std::string> found;
  for (const name::Source source : {name::Source::name, name::Source::comment}) {
    for (const SampleWords& text : words_of(samples, source, naming, vocabulary)) {
      for (const std::string& word : text.words) {
        const std::string stem = word.substr(0, word.find_last_not_of("0123456789") + 1);
        if (is_spare(word) && std::find(found.begin(), found.end(), stem) == found.end()) found.push_back(stem);
      }
    }
  }
  for (const std::string& word : found) {
    if (word.size() > 3) {
      naming.ignore.push_back("*" + word + "*");
    } else {
      naming.ignore.insert(naming.ignore.end(), {word, "*_" + word, "* " + word});
    }
  }
}

}  // namespace

name::Naming frame_of(std::span<const Sample> samples) {
  name::Naming naming;
  naming.name = "inferred";
  naming.separators = kSeparators;
  if (hyphen_separates(samples)) naming.separators += '-';
  naming.normalise.camel_case = count_texts(samples, has_hump) * 2 > samples.size();
  if (count_texts(samples, [](std::string_view text) { return text.find("$N") != text.npos; }) != 0) {
    naming.normalise.line_break = "$N";
  }
  if (count_texts(samples, ends_in_numbers) >= kLeastFused) {
    naming.normalise.replace.push_back({" *\\[([0-9]+)\\]$", "$1"});
    naming.normalise.replace.push_back({" *\\[[0-9]+(, *[0-9]+)+\\]$", ""});
  }
  const std::string fused = fused_motions(samples);
  if (!fused.empty()) {
    naming.normalise.replace.push_back({"(" + fused + ")", " $1"});
    naming.normalise.replace.push_back({"([0-9]호)", "$1 "});
    naming.normalise.replace.push_back({"([A-Za-z][0-9]*)([가-힣]{2,})", "$1 $2"});
    naming.normalise.replace.push_back({"([가-힣]{2,})([A-Za-z]{2,})", "$1 $2"});
  }
  const name::Vocabulary vocabulary(naming.tasks, {});
  ignore_spares(samples, naming, vocabulary);
  ignore_placeholders(samples, naming);
  return naming;
}

void add_abbreviations(name::Naming& frame, std::span<const Sample> samples) {
  const name::Vocabulary vocabulary(frame.tasks, {});
  DifferenceLimits limits;
  limits.least_common = 3;
  limits.most_words = 1;
  for (const name::Source source : {name::Source::name, name::Source::comment}) {
    for (const Difference& difference :
         differences_of(without_sides(words_of(samples, source, frame, vocabulary), vocabulary), vocabulary, limits)) {
      if (difference.operation.size() != 1 || difference.event.size() != 1) continue;
      std::string longer = difference.operation.front();
      std::string shorter = difference.event.front();
      if (longer.size() < shorter.size()) std::swap(longer, shorter);
      if (shorter.empty() || !longer.starts_with(shorter) || longer.size() < shorter.size() + 2) continue;
      frame.normalise.replace.push_back({"(?i)\\b" + longer + "\\b", shorter});
    }
  }
}

}  // namespace symplant::infer
