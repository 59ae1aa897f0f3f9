// Random programs with the interface symplant/program.h.
#include "property/lock_step/engine_programs.hpp"

#include <array>
#include <cstring>
#include <utility>

namespace symplant::property {
namespace {

/// What the functions of a slot do; they get no other argument that says it.
struct Slot {
  const ProgramTable* table = nullptr;
  const std::vector<symplant_variable>* variables = nullptr;
};
std::array<Slot, EnginePrograms::kMost> slots;

struct Started {
  const Slot& slot;
  std::vector<void*> cells;
  ProgramMemory memory;
};

std::size_t bytes_of(const symplant_variable& variable) { return variable.bits < 8 ? 1 : variable.bits / 8U; }

template <std::size_t kSlot>
void* create(void* const* cells) {
  const Slot& slot = slots[kSlot];
  return new Started{slot, {cells, cells + slot.variables->size()}, ProgramMemory(*slot.table)};
}

int scan(void* instance, std::int64_t now) {
  auto& started = *static_cast<Started*>(instance);
  const ProgramTable& table = *started.slot.table;
  std::vector<std::uint64_t> in(table.reads.size());
  std::vector<std::uint64_t> out(table.writes.size());
  const auto cell = [&](std::size_t i) { return std::pair(started.cells[i], bytes_of((*started.slot.variables)[i])); };
  for (std::size_t i = 0; i < in.size(); ++i) std::memcpy(&in[i], cell(i).first, cell(i).second);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto [at, bytes] = cell(in.size() + i);
    std::memcpy(&out[i], at, bytes);
  }
  react(table, started.memory, in, out, now);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto [at, bytes] = cell(in.size() + i);
    if ((*started.slot.variables)[in.size() + i].bits == 1) out[i] %= 2;
    std::memcpy(at, &out[i], bytes);
  }
  return 0;
}

void destroy(void* instance) { delete static_cast<Started*>(instance); }

}  // namespace

EnginePrograms::EnginePrograms(std::vector<ProgramTable> tables, const model::PlantModel& model) {
  constexpr std::array kCreate = {create<0>, create<1>, create<2>};
  for (std::size_t slot = 0; slot < tables.size(); ++slot) {
    auto one = std::make_unique<One>();
    one->table = std::move(tables[slot]);
    std::vector<std::uint32_t> symbols = one->table.reads;
    symbols.insert(symbols.end(), one->table.writes.begin(), one->table.writes.end());
    one->names.reserve(symbols.size());
    for (std::size_t i = 0; i < symbols.size(); ++i) {
      const model::Symbol& symbol = model.symbols[symbols[i]];
      one->names.emplace_back(symbol.name());
      one->variables.push_back({one->names.back().c_str(), nullptr,
                                static_cast<std::uint8_t>(i >= one->table.reads.size()),
                                static_cast<std::uint8_t>(bits_of(symbol.type))});
    }
    one->program = {.version = 1,
                    .size = sizeof one->program,
                    .name = one->table.name.c_str(),
                    .period_ns = one->table.period,
                    .variables = one->variables.data(),
                    .count = static_cast<std::uint32_t>(one->variables.size()),
                    .create = kCreate[slot],
                    .scan = scan,
                    .destroy = destroy};
    slots[slot] = {&one->table, &one->variables};
    programs_.push_back(std::move(one));
  }
}

std::string EnginePrograms::add_to(program::LockStep& steps, bool reversed) const {
  for (std::size_t i = 0; i < programs_.size(); ++i) {
    const One& one = *programs_[reversed ? programs_.size() - 1 - i : i];
    const std::string error =
        steps.add(one.program, {.controller = one.table.controller,
                                .delay = one.table.delay,
                                .on_loss = one.table.zero_on_loss ? link::OnLoss::zero : link::OnLoss::hold});
    if (!error.empty()) return error;
  }
  return {};
}

}  // namespace symplant::property
