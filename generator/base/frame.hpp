// A text with marks that other texts replace.
#pragma once

#include <initializer_list>
#include <string_view>
#include <utility>

#include "base/text_source.hpp"

namespace symplant::base {

/// Writes a frame with each mark replaced by the text that belongs to it. Each mark is in the frame, in this order.
inline void put_framed(std::string_view frame, std::initializer_list<std::pair<std::string_view, TextSource>> texts,
                       TextSink& sink) {
  for (const auto& [mark, text] : texts) {
    const std::size_t at = frame.find(mark);
    sink.put(frame.substr(0, at));
    text(sink);
    frame.remove_prefix(at + mark.size());
  }
  sink.put(frame);
}

}  // namespace symplant::base
