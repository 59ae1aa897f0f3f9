// Samples from short texts.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "infer/evaluate.hpp"
#include "support/catch.hpp"

namespace symplant::infer {

/// `Q name` is an operation, `I name` an event.
class Samples {
 public:
  explicit Samples(const std::vector<std::string>& symbols) {
    for (const std::string& symbol : symbols) add(symbol);
  }
  Samples(const Samples&) = delete;
  Samples& operator=(const Samples&) = delete;

  operator std::span<const Sample>() const { return samples_; }  // NOLINT: as its element type

 private:
  void add(const std::string& symbol) {
    Sample& sample = samples_.emplace_back();
    sample.text.name = names_.emplace_back(symbol.substr(2));
    sample.side = symbol.front() == 'Q' ? name::Direction::operation : name::Direction::event;
    sample.text.address = sample.side;
  }

  std::deque<std::string> names_;
  std::vector<Sample> samples_;
};

}  // namespace symplant::infer
