// What a description says of links to PLCs.
#pragma once

#include <string>
#include <string_view>

namespace symplant::model {

/// A link of the plant, opened where the command line names none.
struct LinkDescription {
  std::string url;
  std::string controller;  ///< whose symbols it carries; empty where none is named
};

/// Whether a controller may have this name: it is not empty, and `--link NAME=URL` can say it: no `=`, `:` or control
/// character, no blank at an end.
bool is_controller_name(std::string_view name);

class Faults;
struct PlantModel;

/// Records what is wrong with the links of a plant's description: a controller that the plant has not, none named where
/// that leaves it open, two links of one controller. O(links * controllers).
void check_links(const PlantModel& plant, Faults& faults);

}  // namespace symplant::model
