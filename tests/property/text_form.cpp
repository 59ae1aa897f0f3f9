// Writes cases. An empty cell is `-`; conditions are last on their lines.
#include "property/text_form.hpp"

#include <string_view>

#include "property/text_malfunctions.hpp"
#include "property/text_material.hpp"
#include "property/text_values.hpp"
#include "property/words.hpp"

namespace symplant::property {
namespace {

class Writer {
 public:
  void line(std::string_view text) { text_.append(text).append("\n"); }
  std::string take() { return std::move(text_); }

  void device(const description::DeviceDescription& device) {
    line("device " + device.path);
    for (const std::string& state : device.states) line("  state " + state);
    if (device.initial) line("  initial " + *device.initial);
    if (device.rest) line("  rest " + *device.rest);
    if (device.actuation) line("  actuation " + std::string(word_of(*device.actuation)));
    if (device.only) line("  only");
    if (device.sequence) line("  sequence " + std::string(description::sequence_name(*device.sequence)));
    if (device.overrun) line("  overrun " + text_of_overrun(*device.overrun));
    for (const description::GivenTransition& given : device.transitions) transition(given);
    for (const description::GivenOutputs& given : device.outputs) {
      for (const auto& [task, on] : given.enter) output(given.state, "enter", task, on);
      for (const auto& [task, on] : given.leave) output(given.state, "leave", task, on);
    }
    for (const description::GivenDisables& given : device.disables) {
      for (const std::string& other : given.devices) line("  disables " + given.state + " " + other);
    }
    if (!device.type.empty()) line("  type " + device.type);
    if (!device.behaviour.empty()) line("  behaviour " + device.behaviour);
    for (const auto& [name, condition] : device.inputs) line("  input " + name + " " + condition);
  }

  void requirement(const description::GivenRequirement& given) {
    line("requirement " + given.name);
    if (!given.never.empty()) return line("  never " + given.never);
    line("  after " + given.after);
    line("  expect " + given.expect);
    line("  within " + std::to_string(given.within));
    if (given.earliest != 0) line("  earliest " + std::to_string(given.earliest));
  }

 private:
  void transition(const description::GivenTransition& given) {
    std::string text = "  transition " + given.from + " " + given.to;
    if (!given.on.empty()) text += " on " + given.on;
    if (given.automatic) text += " automatic";
    if (given.once) text += " once";
    if (given.after) text += " after " + text_of(*given.after);
    if (given.takes) text += " takes " + text_of(*given.takes);
    if (given.numbers.weight != 0) text += " weight " + std::to_string(given.numbers.weight);
    if (!given.when.empty()) text += " when " + given.when;
    if (!given.during.empty()) text += " while " + given.during;
    line(text);
  }
  void output(const std::string& state, std::string_view when, const std::string& task, bool on) {
    line("  output " + state + " " + std::string(when) + " " + task + (on ? " on" : " off"));
  }

  std::string text_;
};

std::string cell(const std::string& content) { return content.empty() ? "-" : content; }

std::string text_of(const Action& action) {
  std::string text = "do " + std::string(word_of(action.kind));
  if (takes_what(action.kind)) text += " " + cell(action.what);
  if (takes_value(action.kind)) text += " " + std::to_string(action.value);
  if (takes_time(action.kind)) text += " " + std::to_string(action.time);
  return text;
}

}  // namespace

std::string write_case(const Case& the_case) {
  Writer writer;
  const PlantText& plant = the_case.plant;
  writer.line("plant " + plant.name);
  if (!plant.naming.empty()) writer.line("naming " + plant.naming);
  for (const Row& row : plant.rows) {
    writer.line("row " + row.name + " " + cell(row.address) + " " + cell(row.type) + " " + cell(row.initial));
  }
  const description::Defaults& defaults = plant.description.defaults;
  writer.line("defaults " + std::to_string(defaults.travel) + " " + std::to_string(defaults.dwell) + " " +
              std::string(word_of(defaults.actuation)) + " " + text_of_overrun(defaults.overrun) + " " +
              std::string(description::sequence_name(defaults.sequence)));
  for (const std::string& symbol : plant.description.inverted) writer.line("inverted " + symbol);
  for (const description::GivenFollow& given : plant.description.follow) {
    writer.line("follow " + given.symbol + " " + given.condition);
    if (!given.off.empty()) writer.line("follow-off " + given.off);
  }
  for (const description::DeviceDescription& device : plant.description.devices) writer.device(device);
  for (const description::GivenRequirement& given : plant.description.requirements) writer.requirement(given);
  for (const std::string& line : material_lines(plant.description.material)) writer.line(line);
  for (const std::string& line : malfunction_lines(plant.description.malfunctions)) writer.line(line);
  for (const std::string& line : value_lines(plant.description)) writer.line(line);
  for (const Action& action : the_case.actions) writer.line(text_of(action));
  return writer.take();
}

}  // namespace symplant::property
