// A symbol list that can be damaged: rows as cells, and the devices that they belong to.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace symplant::damage {

struct Cells {
  std::string klass;
  std::string name;
  std::string vendor;
  std::string iec;
  std::string type;
  std::string initial;
  std::string comment;
  std::string raw;  ///< if not empty, written verbatim instead of the cells
};

/// The parts of a name that follows the naming rule.
struct Levels {
  std::string line;
  std::string process;
  std::string device;
  std::string direction;
  std::string task;

  std::string path() const { return line + "_" + process + "_" + device; }
  std::string name() const { return path() + "_" + direction + "_" + task; }
};

/// Five levels, or nothing.
std::optional<Levels> levels_of(std::string_view name);
/// The letters of a word before its first digit, and the rest.
std::string letters_of(std::string_view word);
std::string digits_of(std::string_view word);
/// With `#` for each run of digits, to compare devices with similar names.
std::string class_of(std::string_view device);

/// A task of a device: indexes of rows.
struct Task {
  std::string word;
  std::optional<std::size_t> operation;
  std::optional<std::size_t> event;
};

/// The BOOL symbols of a device.
struct Device {
  Levels levels;  ///< of its first row
  std::vector<std::size_t> rows;
  std::vector<Task> tasks;  ///< by first row

  const Task* task(std::string_view word) const;
};

/// A value: kinds of damage work on a copy.
struct ShopList {
  std::vector<Cells> rows;

  /// With its header line, so that row i is on line i + 2.
  std::string text() const;
  std::vector<Device> devices() const;
  bool has(std::string_view name) const;
};

/// A valid list, as the tool reads it.
ShopList read_list(const std::string& text);

}  // namespace symplant::damage
