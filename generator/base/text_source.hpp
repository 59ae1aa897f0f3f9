// A text that is made while it is written, so that it is never whole in memory.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

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

/// A text that exists already.
inline TextSource whole(std::string text) {
  return [text = std::move(text)](TextSink& sink) { sink.put(text); };
}

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

/// Collects small parts of a text and passes them to a sink in large ones.
class PartCollector {
 public:
  explicit PartCollector(TextSink& sink) : sink_(sink) {}

  void add(std::string_view part) {
    parts_.append(part);
    if (parts_.size() >= kHandedOn) finish();
  }
  /// Passes the rest to the sink. Call after the last part.
  void finish() {
    sink_.put(parts_);
    parts_.clear();
  }

 private:
  static constexpr std::size_t kHandedOn = std::size_t{1} << 16U;  ///< bytes at a time

  TextSink& sink_;
  std::string parts_;
};

}  // namespace symplant::base
