// Reads cases from text.
#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "property/text_form.hpp"
#include "property/text_line.hpp"
#include "property/text_malfunctions.hpp"
#include "property/text_material.hpp"
#include "property/text_values.hpp"
#include "property/words.hpp"

namespace symplant::property {
namespace {

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
    } else if (word == "follow-off" && !result.plant.description.follow.empty()) {
      result.plant.description.follow.back().off = line.all();
    } else if (word == "device") {
      result.plant.description.devices.emplace_back().path = line.word();
    } else if (word == "requirement") {
      result.plant.description.requirements.emplace_back().name = line.word();
    } else if (word == "material") {
      read_material(line, result.plant.description.material);
    } else if (word.starts_with("malfunction") || word == "effect" || word.starts_with("effect-")) {
      read_malfunction(word, line, result.plant.description.malfunctions);
    } else if (is_value_word(word)) {
      read_value(word, line, result.plant.description);
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
    if (word == "within" || word == "earliest") {
      (word == "within" ? given.within : given.earliest) = line.number<tables::Time>();
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
      if (word == "weight") given.numbers.weight = line.number<std::uint32_t>();
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
