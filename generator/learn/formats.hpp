// The forms in which what was learned is shown.
#pragma once

#include "base/text_source.hpp"
#include "learn/learned.hpp"

namespace symplant::learn {

/// For a terminal: a table of times for each group of devices, then what is odd, and what was not seen.
void write_text(const Learned& learned, base::TextSink& sink);

/// The same with each row and name, and the moves that are not used by device.
void write_long_text(const Learned& learned, base::TextSink& sink);

/// For programs: everything, with each sample.
void write_json(const Learned& learned, base::TextSink& sink);

/// A page for a browser: a picture of each time, what is odd first. One file without references.
void write_html(const Learned& learned, base::TextSink& sink);

}  // namespace symplant::learn
