// Reads cases from text.
#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>

#include "property/text_form.hpp"
#include "property/words.hpp"

namespace symplant::property {
namespace {

/// The words of a line, one after the other. Throws std::runtime_error for a missing or invalid word.
class Line {
 public:
  explicit Line(std::string_view text) : rest_(text) { skip_blanks(); }

  bool at_end() const { return rest_.empty(); }
  std::string word() {
    if (rest_.empty()) throw std::runtime_error("a word is missing");
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    std::string taken(rest_.substr(0, end));
    rest_.remove_prefix(end);
    skip_blanks();
    return taken;
  }
  std::string cell() {
    std::string taken = word();
    return taken == "-" ? std::string() : taken;
  }
  std::string all() {
    std::string taken(rest_);
    rest_ = {};
    return taken;
  }
  /// Up to ` while `, which remains.
  std::string condition() {
    std::string taken(rest_.substr(0, std::min(rest_.find(" while "), rest_.size())));
    rest_.remove_prefix(taken.size());
    skip_blanks();
    return taken;
  }
  description::Sequence sequence() {
    const std::string text = word();
    for (const auto each : {description::Sequence::neighbours, description::Sequence::cycle}) {
      if (text == description::sequence_name(each)) return each;
    }
    return description::Sequence::free;
  }
  tables::Time overrun() {
    const std::string text = word();
    return text == "never" ? tables::kNever : number_of<tables::Time>(text);
  }
  template <class Number>
  Number number() {
    return number_of<Number>(word());
  }
  template <class Number>
  static Number number_of(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) {
      throw std::runtime_error("`" + std::string(text) + "` is no number");
    }
    return number;
  }
  tables::Actuation actuation() {
    const std::string text = word();
    const auto at = std::find(kActuationWords.begin(), kActuationWords.end(), text);
    if (at == kActuationWords.end()) throw std::runtime_error("`" + text + "` is no actuation");
    return static_cast<tables::Actuation>(at - kActuationWords.begin());
  }
  description::Duration duration() {
    const std::string text = word();
    const std::size_t first = text.find(':');
    if (first == text.npos) return description::Duration::fixed(number_of<tables::Time>(text));
    const std::size_t second = text.find(':', first + 1);
    if (second == text.npos) throw std::runtime_error("`" + text + "` is no duration");
    description::Duration made;
    made.kind = text[0] == 'u' ? description::Duration::Kind::uniform : description::Duration::Kind::normal;
    const std::string_view view = text;
    made.a = number_of<tables::Time>(view.substr(first + 1, second - first - 1));
    made.b = number_of<tables::Time>(view.substr(second + 1));
    return made;
  }

 private:
  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }
  std::string_view rest_;
};

class Reader {
 public:
  void read(Line line) {
    const std::string word = line.word();
    if (word == "do") return action(line);
    if (word == "plant") {
      result.plant.name = line.word();
    } else if (word == "naming") {
      result.plant.naming = line.word();
    } else if (word == "row") {
      Row row;
      row.name = line.word();
      row.address = line.cell();
      row.type = line.cell();
      row.initial = line.cell();
      result.plant.rows.push_back(std::move(row));
    } else if (word == "defaults") {
      auto& defaults = result.plant.description.defaults;
      defaults.travel = line.number<tables::Time>();
      defaults.dwell = line.number<tables::Time>();
      defaults.actuation = line.actuation();
      if (!line.at_end()) defaults.overrun = line.overrun();
      if (!line.at_end()) defaults.sequence = line.sequence();
    } else if (word == "inverted") {
      result.plant.description.inverted.push_back(line.word());
    } else if (word == "follow") {
      description::GivenFollow& given = result.plant.description.follow.emplace_back();
      given.symbol = line.word();
      given.condition = line.all();
    } else if (word == "device") {
      result.plant.description.devices.emplace_back().path = line.word();
    } else if (word == "requirement") {
      result.plant.description.requirements.emplace_back().name = line.word();
    } else if (!result.plant.description.requirements.empty()) {
      of_requirement(word, line);
    } else {
      of_device(word, line);
    }
  }

  Case result;

 private:
  void of_requirement(const std::string& word, Line& line) {
    description::GivenRequirement& given = result.plant.description.requirements.back();
    if (word == "within") {
      given.within = line.number<tables::Time>();
      return;
    }
    if (word != "never" && word != "after" && word != "expect") throw std::runtime_error("`" + word + "`");
    (word == "never" ? given.never : word == "after" ? given.after : given.expect) = line.all();
  }

  void of_device(const std::string& word, Line& line) {
    if (result.plant.description.devices.empty()) throw std::runtime_error("`" + word + "` without a device");
    description::DeviceDescription& device = result.plant.description.devices.back();
    if (word == "state") {
      device.states.push_back(line.word());
    } else if (word == "initial") {
      device.initial = line.word();
    } else if (word == "rest") {
      device.rest = line.word();
    } else if (word == "actuation") {
      device.actuation = line.actuation();
    } else if (word == "only") {
      device.only = true;
    } else if (word == "sequence") {
      device.sequence = line.sequence();
    } else if (word == "overrun") {
      device.overrun = line.overrun();
    } else if (word == "transition") {
      transition(device.transitions.emplace_back(), line);
    } else if (word == "output") {
      output(device, line);
    } else if (word == "disables") {
      disables(device, line);
    } else if (word == "type") {
      device.type = line.word();
    } else if (word == "behaviour") {
      device.behaviour = line.word();
    } else if (word == "input") {
      std::string name = line.word();
      device.inputs.emplace_back(std::move(name), line.all());
    } else {
      throw std::runtime_error("`" + word + "`");
    }
  }

  void transition(description::GivenTransition& given, Line& line) {
    given.from = line.word();
    given.to = line.word();
    while (!line.at_end()) {
      const std::string word = line.word();
      if (word == "on") given.on = line.word();
      if (word == "automatic") given.automatic = true;
      if (word == "once") given.once = true;
      if (word == "after") given.after = line.duration();
      if (word == "takes") given.takes = line.duration();
      if (word == "weight") given.weight = line.number<std::uint32_t>();
      if (word == "when") given.when = line.condition();
      if (word == "while") given.during = line.all();
    }
  }

  void output(description::DeviceDescription& device, Line& line) {
    const std::string state = line.word();
    if (device.outputs.empty() || device.outputs.back().state != state) device.outputs.emplace_back().state = state;
    auto& side = line.word() == "enter" ? device.outputs.back().enter : device.outputs.back().leave;
    std::string task = line.word();
    side.emplace_back(std::move(task), line.word() == "on");
  }

  void disables(description::DeviceDescription& device, Line& line) {
    const std::string state = line.word();
    if (device.disables.empty() || device.disables.back().state != state) device.disables.emplace_back().state = state;
    device.disables.back().devices.push_back(line.word());
  }

  void action(Line& line) {
    const std::string word = line.word();
    const auto at =
        std::find_if(kActionWords.begin(), kActionWords.end(), [&](const ActionWord& row) { return row.word == word; });
    if (at == kActionWords.end()) throw std::runtime_error("`" + word + "` is no action");
    Action action;
    action.kind = static_cast<Action::Kind>(at - kActionWords.begin());
    if (at->what) action.what = line.word();
    if (at->value) action.value = line.number<std::uint64_t>();
    if (at->time) action.time = line.number<tables::Time>();
    result.actions.push_back(std::move(action));
  }
};

}  // namespace

std::optional<Case> read_case(const std::string& text, std::string& fault) {
  Reader reader;
  std::istringstream stream(text);
  std::string content;
  for (int number = 1; std::getline(stream, content); ++number) {
    const Line line(std::string_view(content).substr(0, content.find('#')));
    if (line.at_end()) continue;
    try {
      reader.read(line);
    } catch (const std::runtime_error& error) {
      fault = "line " + std::to_string(number) + ": " + error.what();
      return std::nullopt;
    }
  }
  return std::move(reader.result);
}

}  // namespace symplant::property
