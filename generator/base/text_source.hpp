// A text that is made while it is written, so that it is never whole in memory.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace symplant::base {

/// Receives a text part by part.
class TextSink {
 public:
  virtual ~TextSink() = default;
  /// May ignore later parts after an earlier one failed.
  virtual void put(std::string_view part) = 0;
};

/// Makes a text. Every call makes the same text.
using TextSource = std::function<void(TextSink&)>;

/// The text as a whole.
inline std::string text_of(const TextSource& source) {
  class Whole final : public TextSink {
   public:
    void put(std::string_view part) override { text.append(part); }
    std::string text;
  } whole;
  source(whole);
  return std::move(whole.text);
}

}  // namespace symplant::base
