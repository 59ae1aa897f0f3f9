// The word check.
#include "arch/word_rules.hpp"

#include <algorithm>
#include <cctype>

namespace symplant::arch {
namespace {

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; }

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return result;
}

/// Without what is between two back-ticks of the line.
std::string without_code(std::string_view line) {
  std::string result;
  bool code = false;
  for (const char c : line) {
    if (c == '`') {
      code = !code;
      result += ' ';
    } else if (!code) {
      result += c;
    }
  }
  return result;
}

/// Without the targets of links.
std::string without_targets(std::string_view line) {
  std::string result;
  for (std::size_t at = 0; at < line.size(); ++at) {
    result += line[at];
    if (line.substr(at, 2) != "](") continue;
    const std::size_t end = line.find(')', at);
    if (end != line.npos) at = end;
  }
  return result;
}

/// Collects texts line by line.
class Texts {
 public:
  /// `text` begins on `line` and may have several lines.
  void add(std::size_t line, std::string_view text) {
    while (true) {
      const std::size_t end = text.find('\n');
      found_.push_back({line, without_code(text.substr(0, end))});
      if (end == text.npos) return;
      text.remove_prefix(end + 1);
      ++line;
    }
  }
  std::vector<ReadText> take() { return std::move(found_); }

 private:
  std::vector<ReadText> found_;
};

std::vector<ReadText> texts_of_markdown(std::string_view text) {
  Texts texts;
  bool code = false;
  std::size_t number = 0;
  while (!text.empty()) {
    ++number;
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin != line.npos && line.substr(begin).starts_with("```")) {
      code = !code;
    } else if (!code) {
      texts.add(number, without_targets(line));
    }
    text.remove_prefix(std::min(text.size(), line.size() + 1));
  }
  return texts.take();
}

/// The comments of CMake, shell and the like.
std::vector<ReadText> texts_of_script(std::string_view text) {
  Texts texts;
  std::size_t number = 0;
  while (!text.empty()) {
    ++number;
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t mark = line.starts_with('#') ? 0 : line.find(" # ");
    if (mark != line.npos) texts.add(number, line.substr(mark));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
  }
  return texts.take();
}

enum class Strings { none, of_test_names, all };

/// Reads C++ as far as comments and literals go.
class SourceTexts {
 public:
  SourceTexts(std::string_view text, Strings strings) : text_(text), strings_(strings) {}

  std::vector<ReadText> read() {
    while (at_ < text_.size()) {
      const std::string_view rest = text_.substr(at_);
      if (rest.starts_with("//")) {
        take(rest.find('\n'), true);
      } else if (rest.starts_with("/*")) {
        take(end_of(rest, "*/", 2), true);
      } else if (rest.starts_with("R\"")) {
        take(end_of_raw(rest), strings_ == Strings::all);
      } else if (rest.front() == '"') {
        take(end_of_quoted(rest, '"'), is_message());
      } else if (rest.front() == '\'' && (at_ == 0 || std::isalnum(static_cast<unsigned char>(text_[at_ - 1])) == 0)) {
        take(end_of_quoted(rest, '\''), false);
      } else {
        take(1, false);
      }
    }
    return texts_.take();
  }

 private:
  static std::size_t end_of(std::string_view rest, std::string_view end, std::size_t from) {
    const std::size_t found = rest.find(end, from);
    return found == rest.npos ? rest.size() : found + end.size();
  }
  static std::size_t end_of_raw(std::string_view rest) {
    const std::size_t open = rest.find('(');
    if (open == rest.npos) return rest.size();
    return end_of(rest, ")" + std::string(rest.substr(2, open - 2)) + "\"", open);
  }
  static std::size_t end_of_quoted(std::string_view rest, char quote) {
    for (std::size_t i = 1; i < rest.size(); ++i) {
      if (rest[i] == '\\') {
        ++i;
      } else if (rest[i] == quote || rest[i] == '\n') {
        return i + 1;
      }
    }
    return rest.size();
  }

  bool is_message() const {
    const std::string_view before = text_.substr(0, at_);
    if (strings_ == Strings::none) return false;
    if (before.ends_with("#include ")) return false;
    return strings_ == Strings::all || before.ends_with("TEST_CASE(") || before.ends_with("SECTION(");
  }

  void take(std::size_t length, bool is_read) {
    const std::string_view taken = text_.substr(at_, length);
    if (is_read) texts_.add(line_, taken);
    line_ += static_cast<std::size_t>(std::count(taken.begin(), taken.end(), '\n'));
    at_ += taken.size();
  }

  std::string_view text_;
  Strings strings_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  Texts texts_;
};

bool has_word(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
    const bool begins = at == 0 || !is_letter(text[at - 1]);
    const std::size_t end = at + word.size();
    if (begins && (end == text.size() || !is_letter(text[end]))) return true;
  }
  return false;
}

}  // namespace

std::vector<BannedWord> read_banned_words(std::string_view text) {
  std::vector<BannedWord> words;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t bar = line.find(" | ");
    if (!line.starts_with('#') && bar != line.npos) {
      words.push_back({std::string(line.substr(0, bar)), std::string(line.substr(bar + 3))});
    }
    text.remove_prefix(std::min(text.size(), line.size() + 1));
  }
  return words;
}

std::vector<ReadText> texts_of(const File& file) {
  const std::string_view path = file.path;
  if (path.ends_with(".md")) return texts_of_markdown(file.text);
  if (path.ends_with(".cpp") || path.ends_with(".hpp")) {
    const bool product = path.starts_with("generator/") || path.starts_with("runtime/");
    return SourceTexts(file.text, product ? Strings::all : Strings::of_test_names).read();
  }
  if (path.ends_with(".mustache")) {
    Texts texts;
    texts.add(1, file.text);
    return texts.take();
  }
  return texts_of_script(file.text);
}

Faults banned_words(const Tree& tree, const std::vector<BannedWord>& words,
                    const std::vector<std::string>& exceptions) {
  const auto is_exception = [&](const File& file, std::string_view line) {
    return std::any_of(exceptions.begin(), exceptions.end(), [&](const std::string& exception) {
      const std::size_t blank = exception.find(' ');
      return file.path.starts_with(exception.substr(0, blank)) && line.find(exception.substr(blank + 1)) != line.npos;
    });
  };
  Faults faults;
  for (const File& file : tree) {
    for (const ReadText& text : texts_of(file)) {
      const std::string line = lower(text.text);
      for (const BannedWord& word : words) {
        if (!has_word(line, word.words) || is_exception(file, line)) continue;
        faults.push_back(file.path + ":" + std::to_string(text.line) + ": `" + word.words + "`: write " + word.instead);
      }
    }
  }
  return faults;
}

}  // namespace symplant::arch
