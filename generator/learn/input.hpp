// What is learned from: a recording, and which symbols of the plant it has.
#pragma once

#include "observe/play.hpp"
#include "recording/recording.hpp"

namespace symplant::learn {

/// A recording with the symbols of its series, as observe::match() finds them.
struct Input {
  recording::Recording recording;
  observe::Matched matched;
};

}  // namespace symplant::learn
