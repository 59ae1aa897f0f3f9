// Random programs: tables of reactions.
#include "property/lock_step/reactions.hpp"

#include <algorithm>

#include "symplant/tables/lists.hpp"

namespace symplant::property {

using tables::kMillisecond;

unsigned bits_of(tables::DataType type) {
  switch (type) {
    case tables::DataType::boolean:
      return 1;
    case tables::DataType::sint:
    case tables::DataType::usint:
    case tables::DataType::byte:
      return 8;
    case tables::DataType::int_:
    case tables::DataType::uint:
    case tables::DataType::word:
      return 16;
    case tables::DataType::dint:
    case tables::DataType::udint:
    case tables::DataType::dword:
    case tables::DataType::real:
      return 32;
    default:
      return 64;
  }
}

void react(const ProgramTable& table, ProgramMemory& memory, const std::vector<std::uint64_t>& in,
           std::vector<std::uint64_t>& out, tables::Time now) {
  for (std::size_t w = 0; w < table.writes.size(); ++w) {
    const Reaction& reaction = table.reactions[w];
    const std::uint64_t a = in.empty() ? 0 : in[reaction.a];
    const std::uint64_t b = in.empty() ? 0 : in[reaction.b];
    const std::uint64_t before = in.empty() ? 0 : memory.before[reaction.a];
    std::uint32_t& count = memory.counts[w];
    std::uint64_t& value = out[w];
    switch (reaction.kind) {
      case Reaction::Kind::copy:
        value = a;
        break;
      case Reaction::Kind::invert:
        value = a == 0 ? 1 : 0;
        break;
      case Reaction::Kind::both:
        value = a != 0 && b != 0 ? 1 : 0;
        break;
      case Reaction::Kind::toggle:
        if (a != 0 && before == 0) value = value == 0 ? 1 : 0;
        break;
      case Reaction::Kind::on_delay:
        count = a != 0 ? count + 1 : 0;
        value = count >= reaction.scans ? 1 : 0;
        break;
      case Reaction::Kind::pulse:
        value = ++count % (2 * reaction.scans) < reaction.scans ? 1 : 0;
        break;
      case Reaction::Kind::keep:
        if (a != 0) value = b;
        break;
      case Reaction::Kind::add:
        value += a + 1;
        break;
      case Reaction::Kind::clock:
        value = static_cast<std::uint64_t>(now / table.period / reaction.scans) % 2;
        break;
    }
  }
  memory.before = in;
}

std::vector<ProgramTable> random_programs(Dice& dice, const model::PlantModel& model,
                                          const tables::PlantTables& tables) {
  static const std::vector<tables::Time> kPeriods = {10 * kMillisecond, 10 * kMillisecond, 20 * kMillisecond,
                                                     40 * kMillisecond, 7 * kMillisecond,  333'333'333};
  std::vector<bool> follows(model.symbols.size());
  for (const tables::SharedAddress& shared : tables.shared_addresses) follows[shared.symbol] = true;
  std::vector<ProgramTable> programs(1 + dice.below(3));
  for (std::size_t p = 0; p < programs.size(); ++p) {
    ProgramTable& program = programs[p];
    program.name = "p" + std::to_string(p);
    program.controller = static_cast<std::uint32_t>(dice.below(model.controllers.size()));
    program.period = dice.pick(kPeriods);
    program.delay = dice.percent(50) ? program.period : dice.percent(50) ? 1 : program.period / 3 + 1;
    program.zero_on_loss = dice.percent(50);
  }
  for (std::uint32_t i = 0; i < model.symbols.size(); ++i) {
    ProgramTable& program = programs[dice.below(programs.size())];
    if (tables::controller_of(tables, i) != program.controller || dice.percent(15)) continue;
    if (model.symbols[i].direction == tables::Direction::event) {
      program.reads.push_back(i);
    } else if (!follows[i]) {
      program.writes.push_back(i);
    }
  }
  for (ProgramTable& program : programs) {
    for (std::size_t w = 0; w < program.writes.size(); ++w) {
      Reaction reaction{static_cast<Reaction::Kind>(dice.below(Reaction::kKinds)), dice.below(program.reads.size()),
                        dice.below(program.reads.size()), static_cast<std::uint32_t>(1 + dice.below(30))};
      const bool bit = model.symbols[program.writes[w]].type == tables::DataType::boolean;
      if (bit && reaction.kind == Reaction::Kind::add) reaction.kind = Reaction::Kind::toggle;
      program.reactions.push_back(reaction);
    }
  }
  return programs;
}

}  // namespace symplant::property
