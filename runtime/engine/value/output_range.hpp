// The range of the numbers that an output of a value had.
#pragma once

namespace symplant::engine {

struct OutputRange {
  double least;
  double greatest;
};

}  // namespace symplant::engine
