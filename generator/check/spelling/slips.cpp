// Names that differ by a slip from those that are meant.
#include "check/spelling/slips.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_set>
#include <utility>

#include "check/spelling/near_words.hpp"
#include "check/spelling/split_devices.hpp"
#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::check {
namespace {

using model::kNone;
using name::Level;

/// A word counts as common compared with another if it is that many times as common.
constexpr std::uint64_t kCommonName = 8;
constexpr std::uint64_t kCommonTask = 4;
/// Letters of a word that may be a slip only because it is rare: UP and UPS may be two words.
constexpr std::size_t kShortestRare = 3;

constexpr std::array kLevels{Level::line, Level::process, Level::device, Level::task};

std::string_view word_at(const name::NameReading& reading, Level level) {
  switch (level) {
    case Level::line:
      return reading.line();
    case Level::process:
      return reading.process();
    case Level::device:
      return reading.device();
    default:
      return reading.task();
  }
}

std::u32string code_points(std::string_view text) {
  std::u32string points;
  points.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const text::CodePoint point = text::code_point_at(text, at);
    points += point.value;
    at += point.length;
  }
  return points;
}

/// `written` with the letters of `pattern`, a word of the same class but for a slip in its letters: its digits stay.
std::string with_letters_of(std::string_view pattern, std::string_view written) {
  std::string word;
  std::size_t from = 0;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (!text::is_digit(pattern[i])) {
      word += pattern[i];
      continue;
    }
    while (i + 1 < pattern.size() && text::is_digit(pattern[i + 1])) ++i;
    while (from < written.size() && !text::is_digit(written[from])) ++from;
    while (from < written.size() && text::is_digit(written[from])) word += written[from++];
  }
  return word;
}

/// The words of one level, digits apart, and how many devices have each (of tasks: how many symbols).
class Vocabulary {
 public:
  /// O(length); nothing but a comparison where `word` is the one before.
  std::uint32_t add(std::string_view word, std::uint64_t count) {
    if (word != last_) {
      const auto [found, added] = locations_.try_emplace(class_name(word), static_cast<std::uint32_t>(words_.size()));
      if (added) {
        words_.push_back({code_points(found->first), 0});
        shown_.push_back(word);
      }
      last_ = word;
      last_location_ = found->second;
    }
    words_[last_location_].count += count;
    uses_.resize(words_.size());
    return last_location_;
  }

  /// Counts symbols that have the word.
  void use(std::uint32_t location, tables::Direction direction, std::uint32_t symbols) {
    (direction == tables::Direction::operation ? uses_[location].operations : uses_[location].events) += symbols;
  }

  /// Fills `meant`: for each word the commoner ones near it.
  void compare() {
    const NearWords near(words_);
    meant_.resize(words_.size());
    for (std::uint32_t location = 0; location < words_.size(); ++location) {
      meant_[location] = near.commoner_near(location);
      any_ = any_ || !meant_[location].empty();
    }
  }

  bool any() const { return any_; }
  const std::vector<std::uint32_t>& meant(std::uint32_t location) const { return meant_[location]; }
  const NearWords::Word& word(std::uint32_t location) const { return words_[location]; }
  std::string_view shown(std::uint32_t location) const { return shown_[location]; }
  /// Whether just one symbol has the word.
  bool is_single(std::uint32_t location) const { return uses_[location].operations + uses_[location].events == 1; }
  bool has(std::uint32_t location, tables::Direction direction) const {
    return (direction == tables::Direction::operation ? uses_[location].operations : uses_[location].events) != 0;
  }

 private:
  struct Uses {
    std::uint64_t operations = 0;
    std::uint64_t events = 0;
  };

  std::unordered_map<std::string, std::uint32_t> locations_;
  std::vector<Uses> uses_;
  std::vector<NearWords::Word> words_;
  std::vector<std::string_view> shown_;  ///< as the first symbol writes it
  std::vector<std::vector<std::uint32_t>> meant_;
  std::string_view last_;
  std::uint32_t last_location_ = 0;
  bool any_ = false;
};

/// A symbol under another name.
struct Meant {
  std::string word;
  std::string name;
  std::string path;
  std::string task;
};

class SlipSearch {
 public:
  SlipSearch(const model::PlantModel& plant, const DeviceClasses& classes) : plant_(plant), classes_(classes) {}

  std::vector<Slip> find() {
    collect_words();
    bool any = false;
    for (Vocabulary& vocabulary : vocabularies_) {
      vocabulary.compare();
      any = any || vocabulary.any();
    }
    for (std::uint32_t symbol = 0; any && symbol < plant_.symbols.size(); ++symbol) look_at(symbol);
    add_split_devices();
    return std::move(slips_);
  }

 private:
  Vocabulary& vocabulary(Level level) {
    return vocabularies_[static_cast<std::size_t>(std::find(kLevels.begin(), kLevels.end(), level) - kLevels.begin())];
  }

  void collect_words() {
    for (const Level level : {Level::line, Level::process, Level::device}) {
      std::vector<std::uint32_t>& locations = locations_[static_cast<std::size_t>(level)];
      locations.reserve(classes_.devices());
      for (std::uint32_t device = 0; device < classes_.devices(); ++device) {
        const model::Symbol& first = plant_.symbols[classes_.first_symbol(device)];
        locations.push_back(vocabulary(level).add(word_at(first.reading, level), 1));
      }
    }
    for (std::uint32_t symbol = 0; symbol < plant_.symbols.size(); ++symbol) {
      const std::uint32_t device = classes_.device_of(symbol);
      if (device == kNone) continue;
      for (const Level level : {Level::line, Level::process, Level::device}) {
        const std::uint32_t location = locations_[static_cast<std::size_t>(level)][device];
        vocabulary(level).use(location, plant_.symbols[symbol].direction, 1);
      }
    }
    tasks_.reserve(classes_.parts().size());
    for (std::uint32_t part = 0; part < classes_.parts().size(); ++part) {
      const DeviceClasses::Part& of = classes_.parts()[part];
      tasks_.push_back(vocabulary(Level::task).add(of.task, classes_.count(part)));
      vocabulary(Level::task).use(tasks_.back(), of.direction, classes_.count(part));
    }
  }

  /// Devices that two spellings of a line or process divide, unless one of their symbols has a slip already.
  void add_split_devices() {
    const std::vector<SplitDevice> splits = split_devices(plant_);
    if (splits.empty()) return;
    std::vector<bool> slipped(classes_.devices());
    for (const Slip& slip : slips_) {
      for (const std::uint32_t symbol : slip.symbols) slipped[classes_.device_of(symbol)] = true;
      if (slip.meant_device != kNone) slipped[slip.meant_device] = true;
    }
    for (const SplitDevice& split : splits) {
      if (slipped[split.part] || slipped[split.whole]) continue;
      const std::uint32_t first = classes_.first_symbol(split.part);
      const std::uint32_t first_of_whole = classes_.first_symbol(split.whole);
      Slip slip{split.level,
                Slip::Why::complements,
                word_at(plant_.symbols[first].reading, split.level),
                {},
                {},
                split.whole,
                0,
                {}};
      slip.meant = word_at(plant_.symbols[first_of_whole].reading, split.level);
      slip.meant_path = plant_.units[split.whole].path;
      const model::Unit& part = plant_.units[split.part];
      slip.symbols = part.operations;
      slip.symbols.insert(slip.symbols.end(), part.events.begin(), part.events.end());
      std::sort(slip.symbols.begin(), slip.symbols.end());
      slips_.push_back(std::move(slip));
    }
    std::sort(slips_.begin(), slips_.end(),
              [](const Slip& a, const Slip& b) { return a.symbols.front() < b.symbols.front(); });
  }

  /// The word's index in its vocabulary.
  std::uint32_t location_of(std::uint32_t symbol, Level level) const {
    const std::uint32_t device = classes_.device_of(symbol);
    if (level != Level::task) return locations_[static_cast<std::size_t>(level)][device];
    const model::Symbol& of = plant_.symbols[symbol];
    return tasks_[classes_.find(classes_.class_of(device), of.direction, of.reading.task())];
  }

  void look_at(std::uint32_t symbol) {
    if (classes_.device_of(symbol) == kNone) return;
    for (const Level level : kLevels) {
      if (!vocabulary(level).any()) continue;
      const std::uint32_t location = location_of(symbol, level);
      for (const std::uint32_t meant : vocabulary(level).meant(location)) {
        if (try_slip(symbol, level, location, meant)) return;
      }
    }
  }

  bool try_slip(std::uint32_t symbol, Level level, std::uint32_t written, std::uint32_t meant) {
    const NearWords::Word& word = vocabulary(level).word(written);
    const NearWords::Word& other = vocabulary(level).word(meant);
    if (level == Level::task && differ_by_ending(word.text, other.text)) return false;  // SP405 reports it
    const bool long_enough = std::min(letters_in(word.text), letters_in(other.text)) >= kShortestRare;
    const bool common = other.count >= word.count * (level == Level::task ? kCommonTask : kCommonName);
    if (are_two_words(symbol, level, written, meant, common)) return false;
    const bool rare = long_enough && common;
    const bool stray = is_stray(symbol);
    if (!rare && !stray) return false;
    const Meant as = renamed(symbol, level, vocabulary(level).shown(meant));
    if (exists(as.name)) return false;
    const std::uint32_t device = level == Level::task ? classes_.device_of(symbol) : device_at(as.path);
    if (stray && device != kNone && lacks(device, symbol, as)) {
      add(symbol, level, Slip::Why::lacks, as, device, other.count);
      return true;
    }
    if (!rare || !fits(symbol, level, as, device)) return false;
    add(symbol, level, Slip::Why::common, as, device, other.count);
    return true;
  }

  /// Whether two near words are most likely two classes: they differ in an axis, or in a letter of a short code and the
  /// first is more than a single symbol; or the other one has no symbol of this direction at all.
  bool are_two_words(std::uint32_t symbol, Level level, std::uint32_t written, std::uint32_t meant, bool common) {
    const Vocabulary& words = vocabulary(level);
    const std::u32string& word = words.word(written).text;
    const std::u32string& other = words.word(meant).text;
    if (differ_by_axis(word, other)) return true;
    if (level == Level::task && !differ_by_another_letter(word, other)) return false;
    if (differ_by_class_letter(word, other) && !(common && words.is_single(written))) return true;
    return !words.has(meant, plant_.symbols[symbol].direction);
  }

  /// The symbol is not expected in its device: its siblings do not have it, and it has no other side.
  bool is_stray(std::uint32_t symbol) const {
    const model::Symbol& of = plant_.symbols[symbol];
    const std::uint32_t device = classes_.device_of(symbol);
    const Expected expected = classes_.expects(device, of.direction, of.reading.task(), true);
    if (expected != Expected::unclear) return expected == Expected::no;
    return !has_side(device, of.reading.task(), other_side(of.direction));
  }

  /// The device that is meant is expected to have what the symbol would be, and has it not.
  bool lacks(std::uint32_t device, std::uint32_t symbol, const Meant& as) const {
    const tables::Direction direction = plant_.symbols[symbol].direction;
    const Expected expected = classes_.expects(device, direction, as.task, false);
    if (expected != Expected::unclear) return expected == Expected::yes;
    return has_side(device, as.task, other_side(direction)) || continues(device, as.task, direction);
  }

  /// Whether the word that is meant goes with the symbol, where no device is known to lack it.
  bool fits(std::uint32_t symbol, Level level, const Meant& as, std::uint32_t device) const {
    const model::Symbol& of = plant_.symbols[symbol];
    if (level == Level::line || level == Level::process) return true;
    if (level == Level::task) return is_known(classes_.class_of(classes_.device_of(symbol)), of.direction, as.task);
    if (device != kNone) return is_known(classes_.class_of(device), of.direction, as.task);
    const std::uint32_t class_of_meant = classes_.class_called(class_name(as.word));
    if (class_of_meant == kNone) return false;
    const std::uint32_t part = classes_.find(class_of_meant, of.direction, as.task);
    return part != kNone && 4 * std::uint64_t{classes_.count(part)} >=
                                3 * std::uint64_t{classes_.classes()[class_of_meant].devices.size()};
  }

  /// Whether a device of the class has such a task, digits apart.
  bool is_known(std::uint32_t of, tables::Direction direction, std::string_view task) const {
    const auto& parts = classes_.classes()[of].parts;
    return std::any_of(parts.begin(), parts.end(), [&](std::uint32_t part) {
      const DeviceClasses::Part& known = classes_.parts()[part];
      return known.direction == direction && class_name(known.task) == class_name(task);
    });
  }

  static tables::Direction other_side(tables::Direction direction) {
    return direction == tables::Direction::operation ? tables::Direction::event : tables::Direction::operation;
  }

  bool has_side(std::uint32_t device, std::string_view task, tables::Direction direction) const {
    if (device >= plant_.units.size()) return false;
    const model::Unit& unit = plant_.units[device];
    return std::any_of(unit.states.begin(), unit.states.end(), [&](const model::State& state) {
      const std::uint32_t side = direction == tables::Direction::operation ? state.operation : state.event;
      return side != kNone && text::equal_ignoring_case(state.name, task);
    });
  }

  /// Whether a device has the same word with the number before or after: `GAP2` or `GAP4` for `GAP3`.
  bool continues(std::uint32_t device, std::string_view task, tables::Direction direction) const {
    std::size_t digits = task.size();
    while (digits > 0 && text::is_digit(task[digits - 1])) --digits;
    if (digits == task.size() || task.size() - digits > 6) return false;
    const long number = std::stol(std::string(task.substr(digits)));
    const std::string letters(task.substr(0, digits));
    const std::uint32_t of = classes_.class_of(device);
    return classes_.find(of, direction, letters + std::to_string(number - 1)) != kNone ||
           classes_.find(of, direction, letters + std::to_string(number + 1)) != kNone;
  }

  Meant renamed(std::uint32_t symbol, Level level, std::string_view pattern) const {
    const model::Symbol& of = plant_.symbols[symbol];
    const std::string_view written = word_at(of.reading, level);
    const auto at = static_cast<std::size_t>(written.data() - of.name().data());
    Meant as;
    as.word = with_letters_of(pattern, written);
    as.name = of.name();
    as.name.replace(at, written.size(), as.word);
    as.task = level == Level::task ? as.word : std::string(of.reading.task());
    as.path = of.reading.device_path();
    if (level != Level::task) as.path.replace(at, written.size(), as.word);
    return as;
  }

  bool exists(const std::string& name) {
    if (names_.empty()) {
      names_.reserve(plant_.symbols.size());
      for (const model::Symbol& symbol : plant_.symbols) names_.insert(symbol.name());
    }
    return names_.count(name) != 0;
  }

  std::uint32_t device_at(const std::string& path) {
    if (paths_.empty()) {
      paths_.reserve(classes_.devices());
      for (std::uint32_t device = 0; device < classes_.devices(); ++device) {
        paths_.emplace(plant_.symbols[classes_.first_symbol(device)].reading.device_path(), device);
      }
    }
    const auto found = paths_.find(path);
    return found == paths_.end() ? kNone : found->second;
  }

  /// One finding for all symbols of a device with one slip; for a line or a process that is written otherwise, one for
  /// all its devices.
  void add(std::uint32_t symbol, Level level, Slip::Why why, const Meant& as, std::uint32_t device,
           std::uint64_t others) {
    const model::Symbol& of = plant_.symbols[symbol];
    const std::string_view written = word_at(of.reading, level);
    const auto end = static_cast<std::size_t>(written.data() + written.size() - of.name().data());
    std::string key = std::to_string(static_cast<int>(level)) + text::to_upper(of.name().substr(0, end)) + ' ' +
                      text::to_upper(as.word);
    if (level == Level::task) key = text::to_upper(of.reading.device_path()) + ' ' + text::to_upper(written);
    const auto [found, added] = by_key_.try_emplace(std::move(key), slips_.size());
    if (added) slips_.push_back({level, why, written, as.word, as.path, device, others, {}});
    slips_[found->second].symbols.push_back(symbol);
  }

  const model::PlantModel& plant_;
  const DeviceClasses& classes_;
  std::array<Vocabulary, kLevels.size()> vocabularies_;
  std::array<std::vector<std::uint32_t>, 3> locations_;  ///< by Level, then by device
  std::vector<std::uint32_t> tasks_;                     ///< by part
  std::unordered_set<std::string_view, text::HashIgnoringCase, text::EqualIgnoringCase> names_;
  text::ByName<std::uint32_t> paths_;
  std::unordered_map<std::string, std::size_t> by_key_;
  std::vector<Slip> slips_;
};

}  // namespace

std::vector<Slip> find_slips(const model::PlantModel& plant, const DeviceClasses& classes) {
  return SlipSearch(plant, classes).find();
}

}  // namespace symplant::check
