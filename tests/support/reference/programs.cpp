// PLC programs in lock step with the reference's plant.
#include "support/reference/programs.hpp"

#include <algorithm>
#include <bit>

namespace symplant::reference {
namespace {

using tables::DataType;

bool is_signed(DataType type) { return type >= DataType::sint && type <= DataType::lint; }

/// Bytes of a number; 0 of BOOL.
int bytes_of(DataType type) {
  constexpr int kBytes[] = {0, 1, 2, 4, 8, 1, 2, 4, 8, 1, 2, 4, 8, 4, 8};
  return kBytes[static_cast<int>(type)];
}

}  // namespace

LockStep::LockStep(const model::PlantModel& model, Plant& plant, std::vector<Program> programs)
    : model_(model), plant_(plant) {
  for (Program& program : programs) {
    Running running;
    for (const std::uint32_t symbol : program.writes) running.written.push_back(number(symbol));
    running.out = running.at_start = running.written;
    running.program = std::move(program);
    running_.push_back(std::move(running));
  }
}

/// A symbol's value as a variable of its type.
std::uint64_t LockStep::number(std::uint32_t symbol) const {
  const DataType type = model_.symbols[symbol].type;
  const std::uint64_t value = plant_.value(symbol);
  if (type == DataType::boolean) return value;
  if (type == DataType::real) return std::bit_cast<std::uint32_t>(static_cast<float>(std::bit_cast<double>(value)));
  return bytes_of(type) == 8 ? value : value % (std::uint64_t{1} << (8 * bytes_of(type)));
}

void LockStep::write(const Running& running, std::size_t index, std::uint64_t number) {
  const std::uint32_t symbol = running.program.writes[index];
  const DataType type = model_.symbols[symbol].type;
  std::uint64_t value = number;
  if (type == DataType::real) {
    value = std::bit_cast<std::uint64_t>(static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(number))));
  } else if (is_signed(type) && bytes_of(type) < 8 && number >> (8 * bytes_of(type) - 1) != 0) {
    value = number - (std::uint64_t{1} << (8 * bytes_of(type)));
  }
  plant_.set_operation(symbol, value);
}

void LockStep::zero(Running& running) {
  for (std::size_t i = 0; i < running.written.size(); ++i) {
    running.written[i] = 0;
    write(running, i, 0);
  }
}

void LockStep::start(Running& running) { running.scan = running.program.start(); }

bool LockStep::is_lost(std::uint32_t controller) const {
  const auto& active = plant_.save().malfunctions.active;
  return std::any_of(active.begin(), active.end(), [&](const ActiveWorld& one) {
    if (one.number >= model_.malfunctions.size()) return false;
    const std::vector<model::Effect>& effects = model_.malfunctions[one.number].effects;
    return std::any_of(effects.begin(), effects.end(), [&](const model::Effect& effect) {
      return effect.kind == tables::MalfunctionKind::lose && effect.subject == controller;
    });
  });
}

bool LockStep::advance_to(Time time, int most) {
  if (!begun_) {
    for (Running& running : running_) start(running);
  }
  begun_ = true;
  for (;;) {
    Time next = std::min(time, std::max(plant_.next_due(), plant_.now()));
    for (const Running& running : running_) {
      next = std::min(next, running.next);
      if (!running.pending.empty()) next = std::min(next, running.sample);
    }
    if (most-- == 0) return false;
    for (Running& running : running_) {
      if (running.pending.empty() || running.sample != next) continue;
      for (const auto& [index, number] : running.pending) write(running, index, number);
      running.pending.clear();
    }
    plant_.advance_to(next);
    bool zeroed_now = false;
    for (Running& running : running_) {
      const bool lost = is_lost(running.program.controller);
      if (lost && !running.lost) {
        ++losses;
        for (const auto& [index, number] : running.pending) running.written[index] = running.before[index];
        running.pending.clear();
        const bool any =
            std::any_of(running.written.begin(), running.written.end(), [](std::uint64_t n) { return n != 0; });
        if (running.program.zero_on_loss && any) {
          zero(running);
          ++zeroed;
          zeroed_now = true;
        }
      }
      running.lost = lost;
    }
    if (zeroed_now) plant_.advance_to(next);
    std::vector<std::vector<std::uint64_t>> inputs;
    for (const Running& running : running_) {
      std::vector<std::uint64_t>& in = inputs.emplace_back();
      for (const std::uint32_t symbol : running.program.reads) in.push_back(number(symbol));
    }
    for (std::size_t i = 0; i < running_.size(); ++i) {
      Running& running = running_[i];
      if (running.next != next) continue;
      running.next += running.program.period;
      if (running.lost) continue;
      ++scans;
      running.scan(inputs[i], running.out, next);
      running.sample = next + running.program.delay;
      for (std::size_t w = 0; w < running.out.size(); ++w) {
        const DataType type = model_.symbols[running.program.writes[w]].type;
        if (type == DataType::boolean) running.out[w] %= 2;
        if (bytes_of(type) != 0 && bytes_of(type) < 8) running.out[w] %= std::uint64_t{1} << (8 * bytes_of(type));
        if (running.out[w] == running.written[w]) continue;
        running.before[w] = running.written[w];
        running.pending[w] = running.written[w] = running.out[w];
        ++samples;
      }
    }
    if (next >= time) return true;
  }
}

void LockStep::restart(std::uint32_t controller) {
  for (Running& running : running_) {
    if (running.program.controller != controller) continue;
    running.pending.clear();
    zero(running);
    // A cold start: the variables are as at the beginning, until a scan writes them.
    running.out = running.at_start;
    start(running);
  }
}

}  // namespace symplant::reference
