// A program in the form in which STruC++ writes one: what its manual names, and the cell's program with two tasks. No
// line is that compiler's.
#pragma once

#include <cstddef>
#include <cstdint>

namespace strucpp {

inline std::int64_t __CURRENT_TIME_NS = 0;

enum class LocatedArea : std::uint8_t { Input, Output, Memory };
enum class LocatedSize : std::uint8_t { Bit, Byte, Word, DWord, LWord };

struct LocatedVar {
  LocatedArea area;
  LocatedSize size;
  std::uint16_t byte_index;
  std::uint8_t bit_index;
  std::uint8_t unused[3];
  void* pointer;
  bool is_bit() const { return size == LocatedSize::Bit; }
  std::size_t byte_size() const { return is_bit() ? 0 : std::size_t{1} << (static_cast<int>(size) - 1); }
};

struct ProgramBase {
  virtual ~ProgramBase() = default;
  virtual void run() = 0;
};
struct TaskInstance {
  const char* name;
  std::int64_t interval_ns;
  std::int32_t priority;
  ProgramBase** programs;
  std::size_t program_count;
};
struct ResourceInstance {
  const char* name;
  const char* processor;
  TaskInstance* tasks;
  std::size_t task_count;
};
struct ConfigurationInstance {
  virtual ~ConfigurationInstance() = default;
  virtual const char* get_name() const = 0;
  virtual ResourceInstance* get_resources() = 0;
  virtual std::size_t get_resource_count() const = 0;
};

extern LocatedVar locatedVars[11];

struct Program_CELL : ProgramBase {
  bool at_store = false, at_machine = false, idle = false, works = false;
  bool to_machine = false, to_store = false, stop = false, start = false;
  int phase = 0;
  std::int64_t works_since = -1;
  Program_CELL();
  void run() override;
};
struct Program_LIMIT : ProgramBase {
  std::int16_t weight = 0, limit = 0, scans = 0;
  Program_LIMIT();
  void run() override;
};

struct Configuration_CONFIG0 : ConfigurationInstance {
  Program_CELL cell;
  Program_LIMIT limit;
  ProgramBase* programs[2] = {&cell, &limit};
  TaskInstance tasks[2] = {{"MAIN", 20'000'000, 1, &programs[0], 1}, {"FAST", 50'000'000, 0, &programs[1], 1}};
  ResourceInstance resource = {"RES0", "PLC", tasks, 2};
  const char* get_name() const override { return "CONFIG0"; }
  ResourceInstance* get_resources() override { return &resource; }
  std::size_t get_resource_count() const override { return 1; }
};

}  // namespace strucpp
