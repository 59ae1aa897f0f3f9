// Reads VCD files as symplant writes them.
#pragma once

#include <iosfwd>
#include <string>

#include "recording/reading.hpp"

namespace symplant::recording {

/// The symbols of the file: bits and numbers. States of devices, contents of locations, malfunctions and values that
/// are only computed are left out, as a trace gives them in other lines. Names are those of the file, in which blanks
/// are
/// `_` and characters beyond ASCII are like `u00FC`. O(file).
ReadRecording read_vcd(std::istream& file, const std::string& name, const ReadOptions& options);

}  // namespace symplant::recording
