// Checks the links in a description.
#include "elements/link/resolve.hpp"

#include <algorithm>
#include <optional>

#include "description/faults.hpp"
#include "model/plant_model.hpp"
#include "text/ascii.hpp"

namespace symplant::model {

namespace {

std::optional<std::size_t> find_controller(const PlantModel& plant, std::string_view wanted) {
  const auto found = std::find_if(plant.controllers.begin(), plant.controllers.end(),
                                  [&](const std::string& name) { return text::equal_ignoring_case(name, wanted); });
  if (found == plant.controllers.end()) return std::nullopt;
  return static_cast<std::size_t>(found - plant.controllers.begin());
}

/// Reports that the controller of a link or program, which `what` says, does not exist.
void report_unknown(const PlantModel& plant, const std::string& controller, const description::Pointer& place,
                    const std::string& what, description::Faults& faults) {
  if (controller.empty()) {
    faults.add(place,
               "the plant has several controllers, and this " + what + " names none of them; give it a `controller`");
  } else if (plant.controllers.size() == 1 && plant.controllers[0].empty()) {
    faults.add(place / "controller",
               "controller " + description::ticked(controller) + " not found, because this plant's only " +
                   "controller has no name; remove `controller` here, or add it to its list in `symbols`",
               description::FaultKind::unknown_name);
  } else {
    const auto nearest = faults.nearest(controller, plant.controllers.size(),
                                        [&](std::size_t c) -> std::string_view { return plant.controllers[c]; });
    faults.add(place / "controller", description::missing("controller " + description::ticked(controller), nearest),
               description::FaultKind::unknown_name);
  }
}

}  // namespace

std::vector<const description::LinkDescription*> check_links(const PlantModel& plant, description::Faults& faults) {
  std::vector<bool> linked(plant.controllers.size());
  std::vector<const description::LinkDescription*> settings(plant.controllers.size());
  const std::vector<description::LinkDescription>& links = plant.description->links;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const description::LinkDescription& link = links[i];
    const description::Pointer place = description::Pointer("/links") / i;
    const bool the_only = link.controller.empty() && plant.controllers.size() == 1;
    if (link.controller.empty() && link.url == "loop:" && !the_only) {
      if (link.has_settings) {
        faults.add(place, "this `loop:` is for all controllers, but settings are for one; give it a `controller`");
      }
      continue;
    }
    const auto controller = the_only ? std::optional<std::size_t>(0) : find_controller(plant, link.controller);
    if (controller) {
      if (link.url != "loop:" && linked[*controller]) {
        faults.add(place, "this is the second link of its controller, and both would write its operations; remove one");
      } else if (link.has_settings && settings[*controller] != nullptr) {
        faults.add(place, "another link of this controller also has settings; give all of them in one link");
      }
      linked[*controller] = linked[*controller] || link.url != "loop:";
      if (link.has_settings) settings[*controller] = &link;
    } else {
      report_unknown(plant, link.controller, place, "link", faults);
    }
  }
  return settings;
}

void check_programs(const PlantModel& plant, description::Faults& faults) {
  std::vector<bool> has_program(plant.controllers.size());
  const std::vector<description::ProgramDescription>& programs = plant.description->programs;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const std::string& name = programs[i].controller;
    const description::Pointer place = description::Pointer("/programs") / i;
    const bool the_only = name.empty() && plant.controllers.size() == 1;
    const auto controller = the_only ? std::optional<std::size_t>(0) : find_controller(plant, name);
    if (!controller) {
      report_unknown(plant, name, place, "program", faults);
    } else if (has_program[*controller]) {
      faults.add(place, "this is the second program of its controller; remove one");
    } else {
      has_program[*controller] = true;
    }
  }
}

}  // namespace symplant::model
