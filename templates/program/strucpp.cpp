// Makes a program in lock step of what STruC++ has compiled from Structured Text: its variables AT %I and %Q are bound
// by their addresses. Compile it together with that output (docs/testing-programs.md), with the program's header
// included
// (-include cell.hpp). Variables AT %M belong to the program.
#include <symplant/program.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <string>
#include <vector>

#ifndef SYMPLANT_CONFIGURATION
#define SYMPLANT_CONFIGURATION Configuration_CONFIG0  // the class of `CONFIGURATION Config0`
#endif

namespace {

struct Program {
  strucpp::SYMPLANT_CONFIGURATION configuration;
  std::vector<strucpp::TaskInstance*> tasks;  // the most urgent first
  void* const* cells;
};

// The variables that are inputs or outputs, in the order of the cells; the pointers to their memory exist from
// create().
std::vector<const strucpp::LocatedVar*> located;

void* create(void* const* cells) {
  auto* program = new Program{{}, {}, cells};
  for (std::size_t i = 0; i < program->configuration.get_resource_count(); ++i) {
    const strucpp::ResourceInstance& resource = program->configuration.get_resources()[i];
    for (std::size_t k = 0; k < resource.task_count; ++k) program->tasks.push_back(&resource.tasks[k]);
  }
  std::stable_sort(program->tasks.begin(), program->tasks.end(),
                   [](const auto* a, const auto* b) { return a->priority < b->priority; });
  return program;
}

int scan(void* instance, std::int64_t now_ns) {
  auto& program = *static_cast<Program*>(instance);
  const auto size = [](const strucpp::LocatedVar& variable) { return std::max<std::size_t>(variable.byte_size(), 1); };
  for (std::size_t i = 0; i < located.size(); ++i) {
    if (located[i]->area == strucpp::LocatedArea::Input) {
      std::memcpy(located[i]->pointer, program.cells[i], size(*located[i]));
    }
  }
  strucpp::__CURRENT_TIME_NS = now_ns;
  for (const strucpp::TaskInstance* task : program.tasks) {
    if (task->interval_ns > 0 && now_ns % task->interval_ns != 0) continue;
    for (std::size_t i = 0; i < task->program_count; ++i) task->programs[i]->run();
  }
  for (std::size_t i = 0; i < located.size(); ++i) {
    if (located[i]->area == strucpp::LocatedArea::Output) {
      std::memcpy(program.cells[i], located[i]->pointer, size(*located[i]));
    }
  }
  return 0;
}

void destroy(void* instance) { delete static_cast<Program*>(instance); }

std::string address_of(const strucpp::LocatedVar& variable) {
  std::string text = {'%', "IQ"[static_cast<int>(variable.area)], "XBWDL"[static_cast<int>(variable.size)]};
  text += std::to_string(variable.byte_index);
  return variable.is_bit() ? text + '.' + std::to_string(variable.bit_index) : text;
}

}  // namespace

extern "C" const symplant_program* symplant_program_v1() {
  static std::vector<std::string> addresses;
  static std::vector<symplant_variable> variables;
  static symplant_program program = {1, sizeof program, nullptr, 0, nullptr, 0, create, scan, destroy};
  if (program.name != nullptr) return &program;

  for (const strucpp::LocatedVar& variable : strucpp::locatedVars) {
    if (variable.area != strucpp::LocatedArea::Memory) located.push_back(&variable);
  }
  for (const strucpp::LocatedVar* variable : located) addresses.push_back(address_of(*variable));
  for (std::size_t i = 0; i < located.size(); ++i) {
    const auto bits = static_cast<std::uint8_t>(located[i]->is_bit() ? 1 : 8 * located[i]->byte_size());
    variables.push_back({nullptr, addresses[i].c_str(), located[i]->area == strucpp::LocatedArea::Output, bits});
  }
  program.variables = variables.data();
  program.count = static_cast<std::uint32_t>(variables.size());
  auto* const first = static_cast<Program*>(create(nullptr));
  for (const strucpp::TaskInstance* task : first->tasks)
    program.period_ns = std::gcd(program.period_ns, task->interval_ns);
  program.name = first->configuration.get_name();
  destroy(first);
  return &program;
}
