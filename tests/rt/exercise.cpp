// Calls every member of Plant, and nothing else.
#include "rt/exercise.hpp"

#include <algorithm>
#include <bit>
#include <string_view>
#include <unordered_map>

#include "property/malfunction_names.hpp"
#include "property/part_differences.hpp"
#include "property/value_differences.hpp"

namespace symplant::test {
namespace {

using property::Action;
using Kind = Action::Kind;

constexpr std::uint32_t kNothing = 0xFFFF'FFFF;

/// An advance over more instants than this ends early: some plants have one every nanosecond.
constexpr int kMostInstants = 300;

}  // namespace

engine::MalfunctionChange::By Exercise::by(const Step& step) noexcept {
  using By = engine::MalfunctionChange::By;
  return step.value != 0 ? By::scenario : By::hand;
}

Happened& Happened::operator+=(const Happened& other) {
  instants += other.instants;
  restores += other.restores;
  restores_elsewhere += other.restores_elsewhere;
  refused_blocks += other.refused_blocks;
  for (std::size_t k = 0; k < findings.size(); ++k) findings[k] += other.findings[k];
  for (std::size_t k = 0; k < findings.size(); ++k) findings_reported[k] += other.findings_reported[k];
  digest += other.digest;
  return *this;
}

Exercise::Exercise(const model::PlantModel& model, const tables::PlantTables& tables,
                   std::vector<engine::Behaviour> behaviours, const std::vector<Action>& actions)
    : tables_(tables), behaviours_(std::move(behaviours)) {
  std::unordered_map<std::string_view, std::uint32_t> symbols;
  std::unordered_map<std::string_view, std::uint32_t> units;
  for (std::uint32_t i = 0; i < model.symbols.size(); ++i) symbols.emplace(model.symbols[i].name(), i);
  for (std::uint32_t i = 0; i < model.units.size(); ++i) units.emplace(model.units[i].path, i);
  std::size_t saves = 1;
  for (const Action& action : actions) {
    if (action.kind == Kind::put || action.kind == Kind::take) {
      const auto location = property::part_location(model.material, action.what);
      if (!location || (action.kind == Kind::put && action.value >= model.material.kinds.size())) continue;
      steps_.push_back({action.kind, static_cast<std::uint32_t>(locations_.size()), action.value, 0, false});
      locations_.push_back(*location);
      continue;
    }
    if (action.kind == Kind::start || action.kind == Kind::stop) {
      const auto number = property::malfunction_number(model, action.what);
      if (number) steps_.push_back({action.kind, *number, action.value, 0, false});
      continue;
    }
    if (action.kind == Kind::set_value) {
      const auto value = property::value_number(model, action.what);
      if (value) steps_.push_back({action.kind, *value, action.value, 0, false});
      continue;
    }
    const auto& names = action.kind == Kind::set_state ? units : symbols;
    const auto found = names.find(action.what);
    std::uint32_t what = found == names.end() ? kNothing : found->second;
    if (!action.what.empty() && what == kNothing) continue;
    if (action.kind == Kind::set && tables.symbols[what].direction() != tables::Direction::operation) continue;
    if (action.kind == Kind::set_state && action.value >= model.units[what].states.size()) continue;
    if (action.kind == Kind::save) ++saves;
    steps_.push_back({action.kind, what, action.value, action.time, false});
  }
  const std::size_t size = plant::Plant::memory_size(tables, behaviours_);
  for (Memory& memory : memory_) memory.resize(size / sizeof(std::max_align_t) + 1);
  saves_.resize(saves, std::vector<std::byte>(size));  // each save is a block of the memory
}

void Exercise::run() noexcept {
  happened_ = {};
  saved_ = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t size = plant::Plant::memory_size(tables_, behaviours_);
    plants_[i].emplace(tables_, bytes(memory_[i]).first(size), behaviours_);
  }
  plant_ = &*plants_[0];
  for (Step& step : steps_) {
    act(step);
    read_all();
  }
}

void Exercise::act(Step& step) noexcept {
  switch (step.kind) {
    case Kind::reset:
      return plant_->reset(step.value, step.time);
    case Kind::set:
      return set(step);
    case Kind::set_input:
      return add(plant_->set_input(step.what, step.value) ? 1 : 0);
    case Kind::force:
      return plant_->force(step.what, step.value);
    case Kind::release:
      return plant_->release(step.what);
    case Kind::set_state:
      return plant_->set_state(step.what, static_cast<std::uint8_t>(step.value));
    case Kind::set_quality:
      return plant_->set_quality(step.value != 0);
    case Kind::save:
      return save();
    case Kind::restore:
      return restore(step);
    case Kind::put:
      return add(plant_->put(locations_[step.what], static_cast<std::uint32_t>(step.value)) ? 1 : 0);
    case Kind::take:
      return add(plant_->take(locations_[step.what]) ? 1 : 0);
    case Kind::start:
      return add(plant_->start_malfunction(step.what, by(step)) ? 1 : 0);
    case Kind::stop:
      return add(plant_->stop_malfunction(step.what, by(step)) ? 1 : 0);
    case Kind::set_value:
      return add(plant_->set_value(step.what, std::bit_cast<double>(step.value)) ? 1 : 0);
    case Kind::further:
    case Kind::run:
    case Kind::advance:
    case Kind::advance_to_due:
    case Kind::advance_before:
      return advance(step);
  }
}

void Exercise::set(const Step& step) noexcept {
  const tables::SymbolRow& row = tables_.symbols[step.what];
  if (row.type() != tables::DataType::boolean) return plant_->set_operation_value(row.index, step.value);
  if (happened_.digest % 2 == 0) return plant_->set_operation(row.index, step.value != 0);
  plant_->set_operations(row.index / 64, std::uint64_t{1} << (row.index % 64), step.value != 0 ? ~std::uint64_t{0} : 0);
}

void Exercise::save() noexcept {
  const std::span<const std::byte> block = plant_->save();
  std::copy(block.begin(), block.end(), saves_[saved_].begin());
  if (saved_ + 1 < saves_.size()) ++saved_;
}

void Exercise::restore(const Step& step) noexcept {
  if (saved_ == 0) return;
  const std::vector<std::byte>& kept = saves_[step.value % saved_];
  if (step.time != 0) {
    plant_ = plant_ == &*plants_[0] ? &*plants_[1] : &*plants_[0];
    ++happened_.restores_elsewhere;
  }
  const std::span<const std::byte> block(kept.data(), plant_->save().size());
  if (!plant_->restore(block.first(block.size() / 2))) ++happened_.refused_blocks;
  if (plant_->restore(block)) ++happened_.restores;
}

void Exercise::advance(Step& step) noexcept {
  const tables::Time now = plant_->now();
  tables::Time target = now > tables::kNever - 1 - step.time ? tables::kNever - 1 : now + step.time;
  if (step.kind == Kind::advance_to_due) {
    target = plant_->next_due() == tables::kNever ? now + tables::kSecond : plant_->next_due();
  }
  for (int i = 0; !step.at_once && plant_->next_due() < target; ++i) {
    if (i == kMostInstants) return;
    plant_->advance_before(plant_->next_due() + 1, this);
  }
  step.at_once = true;
  if (step.kind == Kind::advance_before) {
    plant_->advance_before(target, this);
  } else {
    plant_->advance_to(target, this);
  }
}

void Exercise::read_all() noexcept {
  const plant::Plant& plant = *plant_;
  add(plant.state_hash());
  add(plant.model_hash());
  add(static_cast<std::uint64_t>(plant.now()));
  add(static_cast<std::uint64_t>(plant_->next_due()));
  for (const std::uint64_t word : plant.operations()) add(word);
  for (const std::uint64_t word : plant.events()) add(word);
  for (const std::uint64_t word : plant.disarmed()) add(word);
  for (std::uint32_t i = 0; i < tables_.symbols.size(); ++i) {
    const tables::SymbolRow& row = tables_.symbols[i];
    const bool operation = row.direction() == tables::Direction::operation;
    add(plant.is_forced(i) ? 1 : 0);
    add(plant.malfunction_of_symbol(i));
    if (row.type() == tables::DataType::boolean) {
      add((operation ? plant.operation(row.index) : plant.event(row.index)) ? 1 : 0);
    } else {
      add(operation ? plant.operation_value(row.index) : plant.event_value(row.index));
    }
  }
  for (std::uint32_t u = 0; u < tables_.units.size(); ++u) {
    const plant::UnitView view = plant.unit(u);
    add(plant.is_stuck(u) ? 1 : 0);
    add(static_cast<std::uint64_t>(view.remaining) ^ std::bit_cast<std::uint64_t>(view.progress) ^ view.target);
  }
  for (const engine::ActiveMalfunction& active : plant.active_malfunctions()) {
    const plant::MalfunctionView view = plant.malfunction(active.number);
    add(static_cast<std::uint64_t>(view.since) ^ static_cast<std::uint64_t>(view.next_due));
  }
  for (std::uint32_t controller = 0; controller < 2; ++controller) add(plant.is_cut(controller) ? 1 : 0);
  add(plant.changed_events().size() + plant.changed_event_values().size() + plant.lost_findings());
  plant_->forget_changed_events();
  tables::Finding finding{};
  while (plant_->take_finding(finding)) ++happened_.findings[static_cast<std::size_t>(finding.kind)];
}

void Exercise::instant(const engine::Instant& instant) noexcept {
  ++happened_.instants;
  add(static_cast<std::uint64_t>(instant.time) + instant.units.size());
  for (const engine::WordChange& change : instant.operations) add(change.bits);
  for (const engine::WordChange& change : instant.events) add(change.bits);
  for (const std::uint32_t slot : instant.operation_slots) add(slot);
  for (const std::uint32_t slot : instant.event_slots) add(slot);
  for (const engine::MalfunctionChange& change : instant.malfunctions) add(change.malfunction);
}

void Exercise::finding(const tables::Finding& finding) noexcept {
  ++happened_.findings_reported[static_cast<std::size_t>(finding.kind)];
}

void Exercise::add(std::uint64_t value) noexcept {
  happened_.digest = std::rotl(happened_.digest ^ value, 5) * 0x9E37'79B9'7F4A'7C15;
}

}  // namespace symplant::test
