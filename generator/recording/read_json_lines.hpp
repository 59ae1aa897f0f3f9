// Reads traces as JSON lines, as symplant writes them.
#pragma once

#include <iosfwd>
#include <string>

#include "recording/reading.hpp"

namespace symplant::recording {

ReadRecording read_json_lines(std::istream& file, const std::string& name, const ReadOptions& options);

}  // namespace symplant::recording
