// Writes a text that is made in parts to a stream.
#pragma once

#include <ostream>

#include "base/text_source.hpp"

namespace symplant::app {

class StreamSink final : public base::TextSink {
 public:
  explicit StreamSink(std::ostream& out) : out_(out) {}
  void put(std::string_view part) override { out_ << part; }

 private:
  std::ostream& out_;
};

}  // namespace symplant::app
