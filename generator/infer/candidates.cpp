// Looks for directions, classes, devices and motions in the words of a list.
#include "infer/candidates.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "infer/causes.hpp"
#include "infer/differences.hpp"

namespace symplant::infer {
namespace {

constexpr std::size_t kPositions = 4;   ///< words at the begin that may say direction, class or device
constexpr double kPure = 0.9;           ///< share of a word's samples on one side
constexpr double kLeastMarked = 0.05;   ///< share of samples with a direction word
constexpr std::size_t kLeastCount = 3;  ///< samples of a class word
constexpr double kLeastOfDevice = 6;    ///< symbols of a device that a shape names
constexpr double kLeastTwins = 0.3;     ///< share of a direction word's texts that the other side has, too
constexpr std::size_t kMostDifferences = 12;
/// Words that say a direction by themselves; all others may be the side of a machine or a class.
constexpr std::array<std::string_view, 14> kDirectionWords = {"i",  "o",  "q",  "x",  "y",  "e",  "a",
                                                              "di", "do", "dq", "in", "ai", "ao", "aq"};

struct Sides {
  std::size_t operations = 0;
  std::size_t events = 0;

  std::size_t total() const { return operations + events; }
  std::optional<name::Direction> pure() const {
    const auto share = static_cast<double>(std::max(operations, events)) / static_cast<double>(total());
    if (total() < kLeastCount || share < kPure) return std::nullopt;
    return operations > events ? name::Direction::operation : name::Direction::event;
  }
  void add(bool operation) { ++(operation ? operations : events); }
};

using WordSides = std::map<std::string, name::Direction>;

/// The fields before the word at a position.
std::string prefix(std::size_t position) {
  constexpr std::array<std::string_view, kPositions> kPrefixes = {"", "{process}_", "{line}_{process}_", ""};
  return std::string(kPrefixes[position]);
}

class CandidateFinder {
 public:
  CandidateFinder(const std::vector<SampleWords>& words, name::Source source, const name::Vocabulary& vocabulary)
      : words_(words), source_(source), vocabulary_(vocabulary) {}

  std::vector<Candidate> run() {
    count();
    find_markers();
    for (std::size_t position = 0; position + 1 < kPositions; ++position) {
      find_devices(position);
      find_classes(position);
    }
    find_motions();
    find_equal_texts();
    find_differences();
    std::stable_sort(found_.begin(), found_.end(), [](const Candidate& a, const Candidate& b) {
      return a.kind != b.kind ? a.kind < b.kind : a.support > b.support;
    });
    return std::move(found_);
  }

 private:
  void count() {
    for (const SampleWords& text : words_) {
      for (std::size_t k = 0; k < std::min(kPositions, text.words.size()); ++k) {
        sides_[k][text.words[k]].add(text.operation);
      }
    }
  }

  bool has_motion(const SampleWords& text) const {
    return std::any_of(text.words.begin(), text.words.end(),
                       [&](const std::string& word) { return vocabulary_.motion(word).has_value(); });
  }

  /// Of each word at a position, how many texts have the same other words as a text of the other side.
  std::map<std::string, std::size_t> twins(std::size_t position) const {
    std::map<std::vector<std::string>, Sides> rests;
    const auto rest_of = [&](const SampleWords& text) {
      std::vector<std::string> rest = text.words;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(position));
      return rest;
    };
    for (const SampleWords& text : words_) {
      if (text.words.size() > position) rests[rest_of(text)].add(text.operation);
    }
    std::map<std::string, std::size_t> counts;
    for (const SampleWords& text : words_) {
      if (text.words.size() <= position) continue;
      const Sides& sides = rests.at(rest_of(text));
      counts[text.words[position]] += (text.operation ? sides.events : sides.operations) > 0 ? 1U : 0U;
    }
    return counts;
  }

  /// A position with short words of which each is on one side.
  void find_markers() {
    std::size_t most = 0;
    for (std::size_t k = 0; k + 1 < kPositions; ++k) {
      WordSides marks;
      Sides total;
      std::map<std::string, std::size_t> twins_of = twins(k);
      for (const auto& [word, sides] : sides_[k]) {
        const auto side = sides.pure();
        if (!side || word.size() > 2 || is_number(word)) continue;
        const bool known = std::find(kDirectionWords.begin(), kDirectionWords.end(), word) != kDirectionWords.end();
        if (!known && static_cast<double>(twins_of[word]) < kLeastTwins * static_cast<double>(sides.total())) continue;
        marks.emplace(word, *side);
        total.operations += *side == name::Direction::operation ? sides.total() : 0;
        total.events += *side == name::Direction::event ? sides.total() : 0;
      }
      const auto least = kLeastMarked * static_cast<double>(words_.size());
      if (total.operations == 0 || total.events == 0 || static_cast<double>(total.total()) < least) continue;
      if (total.total() <= most) continue;
      most = total.total();
      marker_position_ = k;
      marks_ = std::move(marks);
    }
  }

  bool is_marked(std::size_t position) const { return !marks_.empty() && marker_position_ == position; }

  name::SymbolRule rule(std::string pattern) const {
    name::SymbolRule rule;
    rule.patterns.push_back({source_, std::move(pattern)});
    return rule;
  }

  void mark(name::SymbolRule& rule) const {
    name::FieldRule field{"direction", {}, {}};
    for (const auto& [word, side] : marks_) field.words.push_back({word, side});
    rule.fields.push_back(std::move(field));
  }

  void add(CandidateKind kind, std::vector<name::SymbolRule> rules, std::size_t support, std::string why) {
    found_.push_back({kind, std::move(rules), support, std::move(why)});
  }

  /// Words of one shape, such as RB1 and RB2, at a position: devices with many symbols on both sides.
  void find_devices(std::size_t position) {
    struct Shape {
      Sides sides;
      std::set<std::string> devices;
    };
    const bool marked = position > 0 && is_marked(position - 1);
    std::map<std::string, Shape> shapes;
    for (const SampleWords& text : words_) {
      if (text.words.size() < position + 2) continue;
      if (marked && !marks_.contains(text.words[position - 1])) continue;
      const std::string& word = text.words[position];
      if (is_number(word) || word.size() < 2) continue;
      Shape& shape = shapes[shape_of(word)];
      shape.sides.add(text.operation);
      std::string path;
      for (std::size_t i = 0; i < position; ++i) {
        if (!is_marked(i)) path.append(text.words[i]).append("_");
      }
      shape.devices.insert(path.append(word));
    }
    std::string expression;
    std::size_t support = 0;
    for (const auto& [shape, found] : shapes) {
      const auto size = static_cast<double>(found.sides.total()) / static_cast<double>(found.devices.size());
      if (found.sides.operations < kLeastCount || found.sides.events < kLeastCount || size < kLeastOfDevice) continue;
      if (shape.find('#') == std::string::npos || shape == "#") continue;
      expression.append(expression.empty() ? "" : "|").append(expression_of_shape(shape));
      support += found.sides.total();
    }
    if (support == 0) return;
    const std::size_t before = marked ? position - 1 : position;
    std::vector<name::SymbolRule> rules;
    if (marked) {
      rules.push_back(rule(prefix(before) + "{direction}_{device}_{task...}"));
      mark(rules.back());
    }
    rules.push_back(rule(prefix(before) + "{device}_{task...}"));
    for (name::SymbolRule& devices : rules) devices.fields.push_back({"device", expression, {}});
    add(CandidateKind::devices, std::move(rules), support, "devices `" + expression + "`");
  }

  /// Words at a position that are on one side each, in texts with a motion.
  void find_classes(std::size_t position) {
    std::map<std::string, Sides> words;
    for (const SampleWords& text : words_) {
      if (text.words.size() < position + 2 || !has_motion(text)) continue;
      words[text.words[position]].add(text.operation);
    }
    WordSides classes;
    Sides total;
    for (const auto& [word, sides] : words) {
      const auto side = sides.pure();
      if (!side || is_number(word) || vocabulary_.motion(word)) continue;
      classes.emplace(word, *side);
      total.operations += sides.operations;
      total.events += sides.events;
    }
    if (total.operations == 0 || total.events == 0) return;
    for (const std::string_view rest : {"{class}_{device...}_{task:known}", "{class}_{task:known}_{device...}"}) {
      name::SymbolRule motions = rule(prefix(position) + std::string(rest));
      for (const auto& [word, side] : classes) motions.classes.push_back({word, side});
      motions.fan_out = true;
      add(CandidateKind::motions, {std::move(motions)}, total.total(), "classes before a motion");
    }
  }

  void find_motions() {
    const auto support = static_cast<std::size_t>(
        std::count_if(words_.begin(), words_.end(), [&](const SampleWords& text) { return has_motion(text); }));
    if (support == 0) return;
    std::vector<std::string> patterns = {"{process}_{device...}_{task:known}", "{device...}_{task:known}",
                                         "{process}_{task:known}_{device...}", "{task:known}_{device...}"};
    for (const std::string& pattern : patterns) {
      name::SymbolRule motions = rule(pattern);
      motions.fan_out = true;
      add(CandidateKind::motions, {std::move(motions)}, support, "motions");
    }
    if (marks_.empty()) return;
    for (const std::string_view rest :
         {"{direction}_{device...}_{task:known}", "{direction}_{task:known}_{device...}"}) {
      name::SymbolRule marked = rule(prefix(marker_position_) + std::string(rest));
      mark(marked);
      marked.fan_out = true;
      add(CandidateKind::motions, {std::move(marked)}, support + 1, "motions after a direction");
    }
    find_contactors();
  }

  void find_equal_texts() {
    if (marks_.empty()) return;
    name::SymbolRule others =
        rule(marker_position_ == 0 ? "{direction}_{device}_{task...}" : "{device...}_{direction}_{task...}");
    mark(others);
    add(CandidateKind::others, {std::move(others)}, words_.size(), "equal texts after a direction");
  }

  /// Contacts of a contactor (`MC ON`) report that a motor runs, in whichever direction.
  void find_contactors() {
    for (const std::string_view words : {"MC_ON", "MC"}) {
      name::SymbolRule contact = rule("{process}_{device...}_" + std::string(words));
      contact.side = name::Direction::event;
      contact.task = "FWD";
      name::SymbolRule motions = rule("{process}_{device...}_{task:known}");
      motions.fan_out = true;
      add(CandidateKind::motions, {std::move(contact), std::move(motions)}, 0,
          "motions and contactors `" + std::string(words) + "`");
    }
  }

  static std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text.append(text.empty() ? "" : "_").append(quoted(word));
    return text;
  }

  /// Whether the difference says no more than the direction.
  bool is_marker(const Difference& difference) const {
    return marks_.contains(difference.operation.front()) || marks_.contains(difference.operation.back());
  }

  /// Without the direction at the begin, which differs anyway: `q Resin A Motor Up` and `i Resin A Limit Up`.
  std::vector<SampleWords> behind_marks() const {
    std::vector<SampleWords> texts;
    for (const SampleWords& text : words_) {
      if (text.words.size() < 2 || !marks_.contains(text.words.front())) continue;
      texts.push_back(text);
      texts.back().words.erase(texts.back().words.begin());
    }
    return texts;
  }

  void find_differences() {
    find_differences(words_, false);
    if (is_marked(0)) find_differences(behind_marks(), true);
  }

  void find_differences(const std::vector<SampleWords>& words, bool marked) {
    std::size_t count = 0;
    DifferenceLimits limits;
    const std::size_t usual_common = limits.least_common;
    if (marked) limits.least_common = 1;
    for (const Difference& difference : differences_of(words, vocabulary_, limits)) {
      const Cause cause = cause_of(difference, vocabulary_);
      const bool fed_back = difference.operation.empty() && cause == Cause::echo;  // `X` and `X feedback`
      if (!fed_back && (difference.operation.empty() || difference.event.empty() || is_marker(difference))) continue;
      if (!is_credible(difference, cause)) continue;
      const bool plain = difference.operation.size() == 1 && difference.event.size() == 1 &&
                         words[difference.example_operation].words.size() > usual_common;
      if (marked && cause == Cause::unknown && !plain) continue;  // a lamp of a conveyor and the fault of its drive
      if (++count > kMostDifferences) break;
      const bool before = difference.before == difference.support;
      const bool after = difference.after == difference.support;
      if (before == after && (fed_back || !before)) continue;
      std::vector<name::SymbolRule> rules;
      for (const bool operation : {true, false}) {
        std::string pattern = marked ? "{direction}_" : "";
        pattern += pattern_of(operation ? difference.operation : difference.event, before, after);
        name::SymbolRule one = rule(std::move(pattern));
        if (marked) mark(one);
        if (!before || !after) one.task = "ON";
        one.side = operation ? name::Direction::operation : name::Direction::event;
        rules.push_back(std::move(one));
      }
      add(CandidateKind::difference, std::move(rules), difference.support,
          "`" + joined(difference.operation) + "` -> `" + joined(difference.event) + "`");
    }
  }

  /// The device, around or next to the words; without words it is the whole text.
  static std::string pattern_of(const std::vector<std::string>& words, bool before, bool after) {
    if (words.empty()) return "{device...}";
    if (!before) return joined(words) + "_{device...}";
    return "{device...}_" + joined(words) + (after ? "_{task...}" : "");
  }

  const std::vector<SampleWords>& words_;
  name::Source source_;
  const name::Vocabulary& vocabulary_;
  std::array<std::map<std::string, Sides>, kPositions> sides_;
  std::size_t marker_position_ = 0;
  WordSides marks_;
  std::vector<Candidate> found_;
};

}  // namespace

std::vector<Candidate> candidates_of(const std::vector<SampleWords>& words, name::Source source,
                                     const name::Vocabulary& vocabulary) {
  return CandidateFinder(words, source, vocabulary).run();
}

std::vector<Candidate> two_source_candidates(const std::vector<SampleWords>& comments,
                                             const name::Vocabulary& vocabulary) {
  const auto ends_in_motion = [&](const SampleWords& text) {
    return vocabulary.motion(text.words.back()).has_value() ||
           (text.words.size() > 1 && vocabulary.motion(text.words[text.words.size() - 2]).has_value());
  };
  const auto support = static_cast<std::size_t>(std::count_if(comments.begin(), comments.end(), ends_in_motion));
  std::vector<Candidate> candidates;
  if (support < kLeastCount) return candidates;
  for (const std::string_view device : {"{line}_{process}_{device}_*", "{process}_{device}_*", "{device}_*"}) {
    name::SymbolRule rule;
    rule.patterns = {{name::Source::name, std::string(device)}, {name::Source::comment, "*_{task:known}"}};
    candidates.push_back({CandidateKind::motions, {std::move(rule)}, support, "devices of names, motions of comments"});
  }
  return candidates;
}

}  // namespace symplant::infer
