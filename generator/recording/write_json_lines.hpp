// Writes a recording as JSON lines.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/text_source.hpp"
#include "recording/recording.hpp"

namespace symplant::recording {

/// Writes the changes of symbols as the lines of a trace, and gaps; for readers of traces only. Parts are left out. The
/// header has `recorded` if the recording is not of a plant. O(changes).
void write_json_lines(const Recording& recording, base::TextSink& sink);

/// Series that only have 0 and 1 are BOOLs unless their file says that they are numbers. Makes them numbers where
/// `kind_of` gives this for their name.
void settle_kinds(Recording& recording, const std::function<std::optional<Series::Kind>(const std::string&)>& kind_of);

}  // namespace symplant::recording
