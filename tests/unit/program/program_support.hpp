// Programs of this process, made of a table of variables and a function.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "support/plant_bench.hpp"
#include "symplant/program/lock_step.hpp"

namespace symplant::test {

inline const std::vector<std::string> kCell = {"AGV_O_P1", "AGV_O_P2", "AGV_I_P1", "AGV_I_P2"};

inline symplant_variable reads(const char* symbol, std::uint8_t bits = 1) { return {symbol, nullptr, 0, bits}; }
inline symplant_variable writes(const char* symbol, std::uint8_t bits = 1) { return {symbol, nullptr, 1, bits}; }
inline symplant_variable reads_at(const char* address, std::uint8_t bits = 1) { return {nullptr, address, 0, bits}; }
inline symplant_variable writes_at(const char* address, std::uint8_t bits = 1) { return {nullptr, address, 1, bits}; }

/// A program whose scans call a function with the cells as bytes. One at a time: the interface has no other argument.
class MadeProgram {
 public:
  using Scan = std::function<int(const std::vector<std::uint8_t*>& cells, std::int64_t now)>;

  explicit MadeProgram(std::vector<symplant_variable> variables, Scan scan = {}, std::int64_t period = 0)
      : variables_(std::move(variables)), scan_(std::move(scan)) {
    current = this;
    program = {1,
               sizeof program,
               "made",
               period,
               variables_.data(),
               static_cast<std::uint32_t>(variables_.size()),
               [](void* const* cells) -> void* { return current->begin(cells); },
               [](void*, std::int64_t now) { return current->scan_ ? current->scan_(current->cells_, now) : 0; },
               [](void*) { ++current->destroyed; }};
  }
  MadeProgram(const MadeProgram&) = delete;
  MadeProgram& operator=(const MadeProgram&) = delete;

  symplant_program program{};
  int created = 0;
  int destroyed = 0;
  bool starts = true;

 private:
  void* begin(void* const* cells) {
    ++created;
    cells_.clear();
    for (std::size_t i = 0; i < variables_.size(); ++i) cells_.push_back(static_cast<std::uint8_t*>(cells[i]));
    return starts ? this : nullptr;
  }

  inline static MadeProgram* current = nullptr;
  std::vector<symplant_variable> variables_;
  Scan scan_;
  std::vector<std::uint8_t*> cells_;
};

}  // namespace symplant::test
