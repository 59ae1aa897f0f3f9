// Reads symbols by a naming rule.
#include "name/symbol_reader.hpp"

#include <array>
#include <string>
#include <utility>

#include "name/device_store.hpp"
#include "name/naming_parts.hpp"
#include "name/task_reader.hpp"
#include "name/task_store.hpp"
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
        devices(naming->naming().units == Units::device ? DeviceStore::Case::ascii : DeviceStore::Case::unicode),
        replaced(parts.rules.size() + parts.rest.size()) {}

  PreparedText& source(const SymbolText& symbol, std::size_t slot);
  const PreparedText& text_for(const SymbolText& symbol, const CompiledRule& rule, std::size_t slot);
  bool match(const SymbolText& symbol, const SymbolRule& given, const CompiledRule& rule);
  bool match_levels(const SymbolText& symbol, const CompiledRule& rule);
  bool match(const SymbolText& symbol, std::size_t rule) {
    return match(symbol, naming->naming().rules[rule], parts.rules[rule]);
  }
  void read_rest(const SymbolText& symbol, Reading& reading);
  bool match(const SymbolText& symbol, const CompiledRule& rule, const CompiledPattern& pattern, MatchedText& match);
  bool is_ignored(const SymbolText& symbol);
  RuleTrial try_rule(const SymbolText& symbol, std::size_t rule);
  void forget_texts() {
    for (SourceText& source : sources) source.made = false;
  }
  std::string field(Field field, char joint) const;
  Reading reading_by(std::size_t rule, const SymbolText& symbol);
  void read_device(std::string_view prefix, const CompiledRule& rule, Reading& reading);
  void read_direction(const SymbolText& symbol, const CompiledRule& rule, Reading& reading);
  void read_task(const SymbolRule& given, const CompiledRule& rule, Reading& reading);
  void read_words(std::string_view text, Direction side, TaskReading& task);

  std::shared_ptr<const CompiledNaming> naming;
  const NamingParts& parts;
  std::vector<std::size_t> matched;
  TextStore texts;
  DeviceStore devices;
  TaskStore tasks;
  std::array<SourceText, kSources> sources;
  std::vector<PreparedText> replaced;  // texts to which a rule's replacements were applied
  std::array<MatchedText, kSources> matches;
  std::size_t match_count = 0;
  LevelReading levels;  // of an exact rule that matches
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

bool SymbolReader::Work::match_levels(const SymbolText& symbol, const CompiledRule& rule) {
  levels = name::read_levels(*rule.levels, symbol.name);
  return levels.fault == NameFault::none;
}

bool SymbolReader::Work::match(const SymbolText& symbol, const SymbolRule& given, const CompiledRule& rule) {
  if (given.side && symbol.address != given.side) return false;
  match_count = 0;
  if (rule.levels) return match_levels(symbol, rule);
  for (const CompiledPattern& pattern : rule.patterns) {
    if (match_count == matches.size() || !match(symbol, rule, pattern, matches[match_count])) return false;
    ++match_count;
  }
  return match_count != 0 && (rule.has.empty() || rule.has.are_in(*matches[0].text, parts.vocabulary));
}

void SymbolReader::Work::read_rest(const SymbolText& symbol, Reading& reading) {
  const std::vector<SymbolRule>& rest = naming->naming().rest;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (!match(symbol, rest[i], parts.rest[i])) continue;
    reading.rest = rest[i].role;
    reading.rest_value = rest[i].value.value_or(true);
    return;
  }
}

bool SymbolReader::Work::is_ignored(const SymbolText& symbol) {
  for (const std::string& pattern : parts.ignore_written) {
    for (const std::string_view text : {symbol.name, symbol.comment}) {
      if (!text.empty() && text::matches_pattern(text::folded(text), pattern)) return true;
    }
  }
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

void SymbolReader::Work::read_device(std::string_view prefix, const CompiledRule& rule, Reading& reading) {
  constexpr std::array kFieldOf = {Field::line, Field::process, Field::device};
  constexpr std::array kLevelOf = {Level::line, Level::process, Level::device};
  if (rule.levels && rule.levels->has_path && prefix.empty()) {  // nothing is copied
    const DeviceStore::Texts own = {levels.of(Level::line), levels.of(Level::process), levels.of(Level::device)};
    const char* const end = own[2].data() + own[2].size();
    reading.levels = devices.find_or_add(own, {own[0].data(), static_cast<std::size_t>(end - own[0].data())});
    return;
  }
  std::array<std::string, 3> texts_of;
  for (std::size_t i = 0; i < texts_of.size(); ++i) {
    texts_of[i] = rule.levels ? std::string(levels.of(kLevelOf[i])) : field(kFieldOf[i], '_');
    if (texts_of[i].empty()) texts_of[i] = parts.fixed[i];
  }
  if (!prefix.empty()) {
    const bool has_line = !texts_of[0].empty();
    texts_of[0].insert(0, prefix);
    if (!has_line && texts_of[0].ends_with('_')) texts_of[0].pop_back();  // a path has `_` between two levels
  }
  reading.levels = devices.find_or_add({texts_of[0], texts_of[1], texts_of[2]}, {});
}

void SymbolReader::Work::read_direction(const SymbolText& symbol, const CompiledRule& rule, Reading& reading) {
  std::array<std::optional<Said>, 4> said;  // by Evidence
  if (symbol.address) said[static_cast<std::size_t>(Evidence::address)] = symbol.address;
  if (rule.levels && levels.direction != nullptr) {
    said[static_cast<std::size_t>(Evidence::field)] = levels.direction->says;
  }
  for (std::size_t i = 0; i < match_count; ++i) {
    const auto& [text, captures] = matches[i];
    if (const Capture& found = captures[static_cast<std::size_t>(Field::direction)]; found.set) {
      const auto says =
          rule.fields.direction_said(text->shown().substr(found.begin, found.end - found.begin),
                                     text->folded().substr(found.begin, found.end - found.begin), found.fused);
      said[static_cast<std::size_t>(found.fused ? Evidence::prefix : Evidence::field)] = says;
    }
    if (const Capture& found = captures[static_cast<std::size_t>(Field::klass)]; found.set) {
      reading.klass = texts.keep(text->shown().substr(found.begin, found.end - found.begin));
      said[static_cast<std::size_t>(Evidence::klass)] =
          rule.fields.class_said(text->folded().substr(found.begin, found.end - found.begin));
    }
  }
  reading.account = Account::no_direction;
  for (const Evidence evidence : naming->naming().direction.evidence) {
    const std::optional<Said>& says = said[static_cast<std::size_t>(evidence)];
    if (!says) continue;
    if (evidence != Evidence::address && !reading.direction_of_name) reading.direction_of_name = *says;
    if (reading.account != Account::no_direction) continue;
    reading.account = *says ? Account::modelled : Account::named_internal;
    reading.direction = *says;
    reading.direction_by = evidence;
  }
}

/// Reads the words of a task, which is kept.
void SymbolReader::Work::read_words(std::string_view text, Direction side, TaskReading& task) {
  if (naming->naming().units == Units::device) {  // nothing pairs tasks by their words
    task = {text, text, {}, text, text, kNoPair, false};
    return;
  }
  PreparedText words;
  words.prepare(text, parts.separators);
  std::vector<std::string_view> shown;
  std::vector<std::string_view> folded;
  for (const Word& word : words.words()) {
    shown.push_back(words.shown().substr(word.begin, word.end - word.begin));
    folded.push_back(words.folded().substr(word.begin, word.end - word.begin));
  }
  const ReadTask read = name::read_task(shown, folded, side, naming->naming().tasks, parts.vocabulary);
  task = {text,
          texts.keep(read.canonical),
          texts.keep(read.index),
          texts.keep(read.group),
          texts.keep(read.numbered_group),
          read.pair,
          read.rest};
}

void SymbolReader::Work::read_task(const SymbolRule& given, const CompiledRule& rule, Reading& reading) {
  const Direction side = reading.direction.value_or(Direction::event);
  const auto of = [&](std::string_view text) {
    return tasks.find_or_add(text, side, [&](TaskReading& task) { read_words(texts.keep(text), side, task); });
  };
  if (given.task) {
    reading.task = of(*given.task);
  } else if (rule.levels) {
    reading.task = of(levels.of(Level::task));
  } else {
    reading.task = of(field(Field::task, ' '));
  }
}

SymbolReader::SymbolReader(std::shared_ptr<const CompiledNaming> naming)
    : work_(std::make_unique<Work>(std::move(naming))) {}
SymbolReader::~SymbolReader() = default;

/// The reading of a symbol that the rule has just matched.
Reading SymbolReader::Work::reading_by(std::size_t rule, const SymbolText& symbol) {
  const SymbolRule& given = naming->naming().rules[rule];
  Reading reading;
  reading.rule = static_cast<std::uint16_t>(rule);
  reading.role = given.role;
  read_direction(symbol, parts.rules[rule], reading);
  read_device(symbol.prefix, parts.rules[rule], reading);
  read_task(given, parts.rules[rule], reading);
  return reading;
}

Reading SymbolReader::read(const SymbolText& symbol) {
  Work& work = *work_;
  work.forget_texts();
  Reading reading;
  reading.direction = symbol.address;
  if (work.is_ignored(symbol)) {
    reading.account = Account::ignored;
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

Reading SymbolReader::read_by(std::size_t rule, const SymbolText& symbol) {
  work_->forget_texts();
  if (work_->match(symbol, rule)) return work_->reading_by(rule, symbol);
  Reading reading;
  reading.direction = symbol.address;
  return reading;
}

RuleTrial SymbolReader::Work::try_rule(const SymbolText& symbol, std::size_t rule) {
  const SymbolRule& given = naming->naming().rules[rule];
  const CompiledRule& compiled = parts.rules[rule];
  if (match(symbol, rule)) return {RuleTrial::End::reads, 0};
  if (given.side && symbol.address != given.side) return {RuleTrial::End::other_side, 0};
  if (compiled.levels || match_count < compiled.patterns.size()) return {RuleTrial::End::pattern, match_count};
  return {RuleTrial::End::word_absent, 0};
}

std::vector<RuleTrial> SymbolReader::trials(const SymbolText& symbol) {
  work_->forget_texts();
  std::vector<RuleTrial> all;
  for (std::size_t rule = 0; rule < work_->parts.rules.size(); ++rule) {
    all.push_back(work_->try_rule(symbol, rule));
    if (all.back().end == RuleTrial::End::reads) break;
  }
  return all;
}

std::string SymbolReader::normal_text(const SymbolText& symbol, Source source) {
  work_->forget_texts();
  return std::string(work_->source(symbol, source == Source::comment ? 1 : 0).shown());
}

const CompiledNaming& SymbolReader::naming() const { return *work_->naming; }
const std::vector<std::size_t>& SymbolReader::matched() const { return work_->matched; }
std::uint32_t SymbolReader::devices() const { return work_->devices.size(); }

}  // namespace symplant::name
