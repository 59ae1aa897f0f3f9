// Reads traces and recordings of any format.
#pragma once

#include <iosfwd>
#include <string>

#include "recording/reading.hpp"

namespace symplant::recording {

/// Reads a trace. If the plant was reset or restored, only what follows the last time counts. A trace does not have the
/// directions of symbols: an operation is what a program of its header writes, or what has the level `O` in its name.
/// O(file).
ReadRecording read_recording(std::istream& file, const std::string& name, const ReadOptions& options = {});

}  // namespace symplant::recording
