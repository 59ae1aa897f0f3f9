// Reads traces and recordings of any format.
#include "recording/read.hpp"

#include "recording/read_json_lines.hpp"

namespace symplant::recording {

ReadRecording read_recording(std::istream& file, const std::string& name, const ReadOptions& options) {
  return read_json_lines(file, name, options);
}

}  // namespace symplant::recording
