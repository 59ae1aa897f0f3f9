// The part of a naming rule that is about texts: separators, what is ignored, what is written together.
#pragma once

#include <span>

#include "infer/evaluate.hpp"
#include "name/naming.hpp"

namespace symplant::infer {

/// A naming rule without rules. O(samples).
name::Naming frame_of(std::span<const Sample> samples);

/// Adds replacements for words that operations and events abbreviate differently (`W/MILL`, `W/M`). O(samples).
void add_abbreviations(name::Naming& frame, std::span<const Sample> samples);

}  // namespace symplant::infer
