// A text that is made while it is written, so that nobody has to hold it whole.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace symplant::base {

/// Takes a text part by part.
class TextSink {
 public:
  virtual ~TextSink() = default;
  /// Later parts may be passed over where an earlier one could not be taken.
  virtual void put(std::string_view part) = 0;
};

/// Makes a text: the same one, however often it is asked for.
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
