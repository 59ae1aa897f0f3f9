// Reads symbols by a naming rule.
#include "name/symbol_reader.hpp"

#include <array>
#include <string>
#include <unordered_map>
#include <utility>

#include "name/naming_parts.hpp"
#include "name/task_reader.hpp"
#include "name/text_store.hpp"
#include "text/ascii.hpp"
#include "text/folding.hpp"
#include "text/pattern.hpp"

namespace symplant::name {
namespace {

constexpr std::size_t kSources = 3;  // name, comment, parent and comment

std::size_t slot_of(Source source) {
  switch (source) {
    case Source::name_then_comment:
    case Source::name:
      return 0;
    case Source::comment:
      return 1;
    case Source::parent_and_comment:
      return 2;
  }
  return 0;
}

}  // namespace

struct SymbolReader::Work {
  /// A text of the symbol that is read, normalised when it is first wanted.
  struct SourceText {
    bool made = false;
    std::string normal;
    PreparedText prepared;
  };

  /// A match of one pattern: captures and the text that they are of.
  struct MatchedText {
    const PreparedText* text = nullptr;
    Captures captures{};
  };

  explicit Work(std::shared_ptr<const CompiledNaming> of)
      : naming(std::move(of)),
        parts(naming->parts()),
        matched(parts.rules.size()),
        replaced(parts.rules.size() + parts.rest.size()) {}

  PreparedText& source(const SymbolText& symbol, std::size_t slot);
  const PreparedText& text_for(const SymbolText& symbol, const CompiledRule& rule, std::size_t slot);
  bool match(const SymbolText& symbol, const SymbolRule& given, const CompiledRule& rule);
  bool match(const SymbolText& symbol, std::size_t rule) {
    return match(symbol, naming->naming().rules[rule], parts.rules[rule]);
  }
  void read_rest(const SymbolText& symbol, RuleReading& reading);
  bool match(const SymbolText& symbol, const CompiledRule& rule, const CompiledPattern& pattern, MatchedText& match);
  bool is_ignored(const SymbolText& symbol);
  void forget_texts() {
    for (SourceText& source : sources) source.made = false;
  }
  std::string field(Field field, char joint) const;
  RuleReading reading_by(std::size_t rule, const SymbolText& symbol);
  void read_levels(RuleReading& reading);
  void read_side(const SymbolText& symbol, std::size_t rule, RuleReading& reading);
  void read_task(std::size_t rule, RuleReading& reading);

  std::shared_ptr<const CompiledNaming> naming;
  const NamingParts& parts;
  std::vector<std::size_t> matched;
  TextStore texts;
  TextStore devices;                                   // folded levels
  TextStore processes;                                 // folded levels
  std::unordered_map<std::string, TaskReading> tasks;  // by side and text
  std::array<SourceText, kSources> sources;
  std::vector<PreparedText> replaced;  // texts to which a rule's replacements were applied
  std::array<MatchedText, kSources> matches;
  std::size_t match_count = 0;
};

PreparedText& SymbolReader::Work::source(const SymbolText& symbol, std::size_t slot) {
  SourceText& source = sources[slot];
  if (source.made) return source.prepared;
  source.made = true;
  const Normalise& rules = naming->naming().normalise;
  if (slot == 2) {
    std::string both(symbol.parent_comment);
    both.append(both.empty() || symbol.comment.empty() ? "" : " ").append(symbol.comment);
    source.normal = normalised(both, rules, parts.vocabulary, parts.separators);
  } else {
    source.normal = normalised(slot == 0 ? symbol.name : symbol.comment, rules, parts.vocabulary, parts.separators);
  }
  parts.replace.apply(source.normal);
  source.prepared.prepare(source.normal, parts.separators);
  return source.prepared;
}

const PreparedText& SymbolReader::Work::text_for(const SymbolText& symbol, const CompiledRule& rule, std::size_t slot) {
  const PreparedText& text = source(symbol, slot);
  if (rule.replace.empty()) return text;
  std::string replaced_text = sources[slot].normal;
  rule.replace.apply(replaced_text);
  const bool in_rest = !parts.rest.empty() && &rule >= parts.rest.data() && &rule <= &parts.rest.back();
  PreparedText& own = replaced[in_rest ? parts.rules.size() + static_cast<std::size_t>(&rule - parts.rest.data())
                                       : static_cast<std::size_t>(&rule - parts.rules.data())];
  own.prepare(replaced_text, parts.separators);
  return own;
}

bool SymbolReader::Work::match(const SymbolText& symbol, const CompiledRule& rule, const CompiledPattern& pattern,
                               MatchedText& found) {
  const auto attempt = [&](std::size_t slot) {
    found.text = &text_for(symbol, rule, slot);
    return found.text->size() != 0 && pattern.pattern.match(*found.text, rule.fields, found.captures);
  };
  return attempt(slot_of(pattern.source)) || (pattern.source == Source::name_then_comment && attempt(1));
}

bool SymbolReader::Work::match(const SymbolText& symbol, const SymbolRule& given, const CompiledRule& rule) {
  if (given.side && symbol.address != given.side) return false;
  match_count = 0;
  for (const CompiledPattern& pattern : rule.patterns) {
    if (match_count == matches.size() || !match(symbol, rule, pattern, matches[match_count])) return false;
    ++match_count;
  }
  return match_count != 0 && (rule.has.empty() || rule.has.are_in(*matches[0].text, parts.vocabulary));
}

void SymbolReader::Work::read_rest(const SymbolText& symbol, RuleReading& reading) {
  const std::vector<SymbolRule>& rest = naming->naming().rest;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (!match(symbol, rest[i], parts.rest[i])) continue;
    reading.rest = rest[i].role;
    reading.rest_value = rest[i].value.value_or(true);
    return;
  }
}

bool SymbolReader::Work::is_ignored(const SymbolText& symbol) {
  if (parts.ignore.empty()) return false;
  for (const std::size_t slot : {std::size_t{0}, std::size_t{1}}) {
    const PreparedText& text = source(symbol, slot);
    for (const std::string& pattern : parts.ignore) {
      if (text.size() != 0 && text::matches_pattern(text.folded(), pattern)) return true;
    }
  }
  return false;
}

/// The words of a field, as written; empty if no pattern has it.
std::string SymbolReader::Work::field(Field field, char joint) const {
  for (std::size_t i = 0; i < match_count; ++i) {
    const Capture& capture = matches[i].captures[static_cast<std::size_t>(field)];
    if (capture.set) return joined_words(*matches[i].text, capture.begin, capture.end, joint);
  }
  return {};
}

void SymbolReader::Work::read_levels(RuleReading& reading) {
  std::array<std::string, 3> levels;
  constexpr std::array kLevelFields = {Field::line, Field::process, Field::device};
  std::string path;
  std::string key;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels[i] = field(kLevelFields[i], '_');
    if (levels[i].empty()) levels[i] = parts.fixed[i];
    if (!path.empty() && !levels[i].empty()) path += '_';
    path += levels[i];
    if (i == 2) reading.process_id = processes.number(key);
    key.append(text::folded(levels[i])).append(1, '\0');
  }
  reading.line = texts.keep(levels[0]);
  reading.process = texts.keep(levels[1]);
  reading.device = texts.keep(levels[2]);
  reading.path = texts.keep(path);
  reading.device_id = devices.number(key);
}

void SymbolReader::Work::read_side(const SymbolText& symbol, std::size_t rule, RuleReading& reading) {
  const RuleFields& fields = parts.rules[rule].fields;
  std::array<std::optional<Side>, 4> sides;  // by Evidence
  sides[static_cast<std::size_t>(Evidence::address)] = symbol.address;
  for (std::size_t i = 0; i < match_count; ++i) {
    const auto& [text, captures] = matches[i];
    if (const Capture& found = captures[static_cast<std::size_t>(Field::direction)]; found.set) {
      const auto side = fields.direction_side(text->shown().substr(found.begin, found.end - found.begin),
                                              text->folded().substr(found.begin, found.end - found.begin), found.fused);
      sides[static_cast<std::size_t>(found.fused ? Evidence::prefix : Evidence::field)] = side;
    }
    if (const Capture& found = captures[static_cast<std::size_t>(Field::klass)]; found.set) {
      reading.klass = texts.keep(text->shown().substr(found.begin, found.end - found.begin));
      sides[static_cast<std::size_t>(Evidence::klass)] =
          fields.class_side(text->folded().substr(found.begin, found.end - found.begin));
    }
  }
  for (const Evidence evidence : naming->naming().direction.evidence) {
    const std::optional<Side> side = sides[static_cast<std::size_t>(evidence)];
    if (!side) continue;
    if (evidence != Evidence::address && !reading.side_of_name) reading.side_of_name = side;
    if (reading.side) continue;
    reading.side = side;
    reading.side_by = evidence;
  }
}

void SymbolReader::Work::read_task(std::size_t rule, RuleReading& reading) {
  const SymbolRule& given = naming->naming().rules[rule];
  const std::string text = given.task ? *given.task : field(Field::task, ' ');
  const Side side = reading.side.value_or(Side::internal);
  std::string key(1, static_cast<char>('0' + static_cast<int>(side)));
  key += text;
  const auto [found, added] = tasks.try_emplace(std::move(key));
  if (added) {
    PreparedText words;
    words.prepare(text, parts.separators);
    std::vector<std::string_view> shown;
    std::vector<std::string_view> folded;
    for (const Word& word : words.words()) {
      shown.push_back(words.shown().substr(word.begin, word.end - word.begin));
      folded.push_back(words.folded().substr(word.begin, word.end - word.begin));
    }
    const ReadTask task = name::read_task(shown, folded, side, naming->naming().tasks, parts.vocabulary);
    found->second = {texts.keep(text),
                     texts.keep(task.canonical),
                     texts.keep(task.index),
                     texts.keep(task.group),
                     texts.keep(task.numbered_group),
                     task.pair,
                     task.rest};
  }
  reading.task = found->second;
}

SymbolReader::SymbolReader(std::shared_ptr<const CompiledNaming> naming)
    : work_(std::make_unique<Work>(std::move(naming))) {}
SymbolReader::~SymbolReader() = default;

/// The reading of a symbol that the rule has just matched.
RuleReading SymbolReader::Work::reading_by(std::size_t rule, const SymbolText& symbol) {
  RuleReading reading;
  reading.rule = static_cast<std::uint16_t>(rule);
  reading.role = naming->naming().rules[rule].role;
  read_side(symbol, rule, reading);
  read_levels(reading);
  read_task(rule, reading);
  reading.outcome = !reading.side                     ? Outcome::no_direction
                    : *reading.side == Side::internal ? Outcome::internal
                                                      : Outcome::read;
  return reading;
}

RuleReading SymbolReader::read(const SymbolText& symbol) {
  Work& work = *work_;
  work.forget_texts();
  RuleReading reading;
  reading.side = symbol.address;
  if (work.is_ignored(symbol)) {
    reading.outcome = Outcome::ignored;
    return reading;
  }
  for (std::size_t rule = 0; rule < work.parts.rules.size(); ++rule) {
    if (!work.match(symbol, rule)) continue;
    ++work.matched[rule];
    reading = work.reading_by(rule, symbol);
    break;
  }
  if (reading.role == Role::io) work.read_rest(symbol, reading);
  return reading;
}

RuleReading SymbolReader::read_by(std::size_t rule, const SymbolText& symbol) {
  work_->forget_texts();
  if (work_->match(symbol, rule)) return work_->reading_by(rule, symbol);
  RuleReading reading;
  reading.side = symbol.address;
  return reading;
}

const CompiledNaming& SymbolReader::naming() const { return *work_->naming; }
const std::vector<std::size_t>& SymbolReader::matched() const { return work_->matched; }

}  // namespace symplant::name
