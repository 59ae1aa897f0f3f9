// Makes a program in lock step of what matiec's iec2c has compiled from Structured Text: its variables AT %I and %Q are
// bound by their addresses, and their memory is the cells. Compile it together with that output
// (docs/testing-programs.md). Variables AT %M belong to the program.
#include <symplant/program.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "iec_types_all.h"

#ifndef SYMPLANT_NAME
#define SYMPLANT_NAME "program"  // for messages
#endif

extern "C" {
#define __LOCATED_VAR(type, name, ...) type* name;
#include "LOCATED_VARIABLES.h"
#undef __LOCATED_VAR
TIME __CURRENT_TIME;
BOOL __DEBUG = 0;
extern unsigned long long common_ticktime__;  // ns; 0 without a cyclic task
void config_init__(void);
void config_run__(unsigned long tick);
}

namespace {

struct Located {
  void** memory;
  std::string address;
  std::uint8_t bits;
};

template <class T>
Located located(T*& memory, const char* area_and_size, std::string numbers) {
  std::replace(numbers.begin(), numbers.end(), ',', '.');
  const auto bits = static_cast<std::uint8_t>(area_and_size[1] == 'X' ? 1 : 8 * sizeof(T));
  return {reinterpret_cast<void**>(&memory), '%' + (area_and_size + numbers), bits};
}

std::vector<Located> all() {
  return {
#define __LOCATED_VAR(type, name, area, size, ...) located(name, #area #size, #__VA_ARGS__),
#include "LOCATED_VARIABLES.h"
#undef __LOCATED_VAR
  };
}

std::vector<Located> bound;             // inputs and outputs, in the order of the cells
std::vector<std::uint64_t> own_memory;  // of variables AT %M
unsigned long scans = 0;

void* create(void* const* cells) {
  std::vector<std::uint64_t> inputs(bound.size());
  for (std::size_t i = 0; i < bound.size(); ++i) {
    *bound[i].memory = cells[i];
    std::memcpy(&inputs[i], cells[i], sizeof inputs[i]);
  }
  std::fill(own_memory.begin(), own_memory.end(), 0);
  scans = 0;
  config_init__();
  for (std::size_t i = 0; i < bound.size(); ++i) {  // has given each variable its initial value
    if (bound[i].address[1] == 'I') std::memcpy(cells[i], &inputs[i], sizeof inputs[i]);
  }
  return &bound;
}

int scan(void*, std::int64_t now_ns) {
  __CURRENT_TIME.tv_sec = now_ns / 1000000000;
  __CURRENT_TIME.tv_nsec = now_ns % 1000000000;
  config_run__(common_ticktime__ != 0 ? now_ns / common_ticktime__ : scans++);
  return 0;
}

void destroy(void*) {}

}  // namespace

extern "C" const symplant_program* symplant_program_v1() {
  static std::vector<symplant_variable> variables;
  static symplant_program program = {1, sizeof program, SYMPLANT_NAME, 0, nullptr, 0, create, scan, destroy};
  if (program.variables != nullptr) return &program;

  const std::vector<Located> variables_at = all();
  own_memory.resize(variables_at.size());
  for (const Located& variable : variables_at) {
    if (variable.address[1] != 'M')
      bound.push_back(variable);
    else
      *variable.memory = &own_memory[&variable - variables_at.data()];
  }
  for (const Located& variable : bound) {
    variables.push_back({nullptr, variable.address.c_str(), variable.address[1] == 'Q', variable.bits});
  }
  program.variables = variables.data();
  program.count = static_cast<std::uint32_t>(variables.size());
  program.period_ns = static_cast<std::int64_t>(common_ticktime__);
  return &program;
}
