// The parts of one symbol's name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "name/naming_rule.hpp"
#include "text/source_file.hpp"

namespace symplant::name {

/// Why a name does not follow the rule.
enum class NameFault : std::uint8_t {
  none,
  illegal_character,  ///< something other than letters, digits and the separator
  wrong_number_of_levels,
  empty_level,       ///< two adjacent separators, or one at an end
  direction_not_io,  ///< the direction level is not one of the rule's words
  not_linked,        ///< a custom rule is in force, and the symbol is in no unit
};

/// The levels of a name that a custom rule reads; they need not be parts of the name.
struct LevelTexts {
  std::string_view device_path;
  std::string_view line;
  std::string_view process;
  std::string_view device;
  std::string_view task;
};

/// The levels of a name, or its fault. There is one for each symbol, so it holds offsets and makes the views on demand.
class NameReading {
 public:
  NameReading() = default;
  /// The name must outlive the reading.
  explicit NameReading(std::string_view name) : of_(name.data()) {}
  /// The texts must outlive the reading.
  static NameReading of(const LevelTexts& texts, NameFault fault, Direction direction) {
    NameReading reading;
    reading.of_ = &texts;
    reading.has_texts_ = true;
    reading.fault = fault;
    reading.direction = direction;
    return reading;
  }

  /// `text` must be a part of the name.
  void set(Level level, std::string_view text) {
    if (Part* const part = part_of(level)) *part = part_at(text);
  }
  void set_fault(NameFault what, std::string_view text) {
    fault = what;
    task_ = part_at(text);
  }

  // Empty if the fault is in front of them; with `not_linked`, as the custom rule reads them:
  std::string_view line() const { return has_texts_ ? texts().line : text_of(line_); }
  std::string_view process() const { return has_texts_ ? texts().process : text_of(process_); }
  std::string_view device() const { return has_texts_ ? texts().device : text_of(device_); }
  // Empty with any fault:
  std::string_view task() const { return has_texts_ ? texts().task : has_levels() ? text_of(task_) : ""; }
  /// Line, process and device with separators: identifies the device.
  std::string_view device_path() const {
    if (has_texts_) return texts().device_path;
    return has_levels() ? text_of({0, device_.begin + device_.size}) : "";
  }
  /// The bytes of the name that the fault is about.
  text::Span where() const {
    return has_levels() ? text::Span() : text::Span{task_.begin, std::size_t{task_.begin} + task_.size};
  }

  std::uint32_t levels = 0;  ///< the number of levels; 0 if an illegal character was found first
  NameFault fault = NameFault::none;
  Direction direction = Direction::operation;

 private:
  struct Part {
    std::uint32_t begin = 0;
    std::uint32_t size = 0;
  };

  const char* name() const { return static_cast<const char*>(of_); }
  const LevelTexts& texts() const { return *static_cast<const LevelTexts*>(of_); }
  bool has_levels() const { return fault == NameFault::none; }
  Part* part_of(Level level) {
    switch (level) {
      case Level::line:
        return &line_;
      case Level::process:
        return &process_;
      case Level::device:
        return &device_;
      case Level::task:
        return &task_;
      case Level::direction:
        break;
    }
    return nullptr;
  }
  Part part_at(std::string_view text) const {
    return {static_cast<std::uint32_t>(text.data() - name()), static_cast<std::uint32_t>(text.size())};
  }
  std::string_view text_of(Part part) const { return {name() + part.begin, part.size}; }

  bool has_texts_ = false;
  const void* of_ = nullptr;  ///< the name, or LevelTexts if has_texts_
  Part line_;
  Part process_;
  Part device_;
  Part task_;  ///< or what the fault is about
};

}  // namespace symplant::name
