// What the number of a signal says about the value that it shows.
#pragma once

#include <cstdint>
#include <optional>

#include "model/plant_model.hpp"

namespace symplant::study {

/// A number that follows an output in a straight line, before it is rounded: factor * output + offset.
struct Line {
  std::uint32_t output = model::kNone;
  double factor = 1;
  double offset = 0;

  double output_for(double number) const { return (number - offset) / factor; }
};

/// The line of a formula; nothing if it reads anything but one output, or is no line. `floor`, `ceil` and `round` count
/// as the line in the middle of their steps, `wrap` as the line within its range. O(steps).
std::optional<Line> line_of(const condition::Formula& formula);

/// The line of a signal with its scale. O(steps).
std::optional<Line> line_of(const model::Signal& signal);

/// After which distance the number of a signal begins again: the range of a `wrap` that is the last step of its
/// formula; 0 without one. O(1).
double period_of(const model::Signal& signal);

}  // namespace symplant::study
