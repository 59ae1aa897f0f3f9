// The variables of the server.
#include "symplant/link/opc_ua/variables.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

#include "symplant/link/image/numbers.hpp"
#include "symplant/link/image/words.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::link::opc_ua {

namespace {

using Kind = Variable::Kind;
using tables::DataType;

constexpr std::size_t kPlant = kPlanes;  ///< the group of what PlantImage has

std::uint64_t bits(double number) noexcept { return std::bit_cast<std::uint64_t>(number); }

/// A time in ns since 1970 as OPC UA has it: in 100 ns since 1601.
UA_DateTime date_time(std::uint64_t wall) noexcept {
  return UA_DATETIME_UNIX_EPOCH + static_cast<UA_DateTime>(wall / 100);
}

/// The number of the status at the last cycle of the images; they have their status after all other numbers.
std::uint64_t cycles_of(const image::Planes& planes, const image::Map& map) noexcept {
  constexpr std::size_t kHeartbeat = 1;  // in kStatusFields
  return planes.event_numbers[*map.status + kHeartbeat];
}

}  // namespace

Variables::Variables(const tables::PlantTables& tables, const image::Map& map, image::Images& images, PlantImage& plant,
                     bool initial)
    : tables_(tables), map_(map), images_(images), plant_(plant), ready_(initial) {
  const auto add = [this](Kind kind, std::uint32_t of, DataType type) {
    Variable variable;
    variable.kind = kind;
    variable.of = of;
    variable.type = type;
    variable.value = Scalar(0, type);
    all_.push_back(variable);
  };
  all_.reserve(map.points.size() + tables.values.outputs + 4 * tables.units.size() + tables.malfunctions.size() + 3);
  for (std::uint32_t i = 0; i < map.points.size(); ++i) {
    add(is_event(map.points[i].plane) ? Kind::event : Kind::operation, i, tables.symbols[map.points[i].symbol].type());
  }
  for (std::uint32_t i = 0; i < tables.values.outputs; ++i) add(Kind::output, i, DataType::lreal);
  for (std::uint32_t i = 0; i < tables.units.size(); ++i) {
    for (const Kind kind : {Kind::state, Kind::target, Kind::moving}) add(kind, i, DataType::boolean);
    add(Kind::progress, i, DataType::lreal);
  }
  for (std::uint32_t i = 0; i < tables.malfunctions.size(); ++i) add(Kind::active, i, DataType::boolean);
  add(Kind::cycles, 0, DataType::ulint);
  add(Kind::plant_time, 0, DataType::lreal);
  add(Kind::frozen, 0, DataType::boolean);
  add_states(tables);

  const image::Planes planes = images.planes();
  const std::array words = {planes.operation_bits.size(), planes.event_bits.size(), planes.operation_numbers.size(),
                            planes.event_numbers.size(), plant.at().end};
  for (std::size_t group = 0; group < groups_.size(); ++group) groups_[group] = by_word(words[group], group);
  const auto seen = [this](Plane plane, auto of) {
    groups_[static_cast<std::size_t>(plane)].seen.assign(of.begin(), of.end());
  };
  seen(Plane::operation_bits, planes.operation_bits);
  seen(Plane::event_bits, planes.event_bits);
  seen(Plane::operation_numbers, planes.operation_numbers);
  seen(Plane::event_numbers, planes.event_numbers);
  groups_[kPlant].seen.assign(plant.words().begin(), plant.words().end());
  for (Variable& variable : all_) {
    refresh_value(variable, groups_[group_of(variable)].seen);
    variable.since = UA_DateTime_now();
  }
}

void Variables::add_states(const tables::PlantTables& tables) {
  for (const std::string_view name : tables::split_names(tables.state_names)) state_names_.push_back(view_of(name));
  std::uint32_t states = 0;
  for (const tables::TypeRow& type : tables.types) {
    first_states_.push_back(states);
    states += type.states;
  }
}

std::size_t Variables::group_of(const Variable& variable) const noexcept {
  const bool of_symbol = variable.kind == Kind::operation || variable.kind == Kind::event;
  return of_symbol ? static_cast<std::size_t>(map_.points[variable.of].plane) : kPlant;
}

/// The word that a variable shows, in its group.
std::size_t Variables::word_of(const Variable& variable) const noexcept {
  const PlantWords& at = plant_.at();
  switch (variable.kind) {
    case Kind::operation:
    case Kind::event: {
      const image::Point& point = map_.points[variable.of];
      return has_bits(point.plane) ? point.position / image::kBitsPerWord : point.position;
    }
    case Kind::output:
      return at.outputs + variable.of;
    case Kind::state:
    case Kind::target:
    case Kind::moving:
    case Kind::progress:
      return at.units + variable.of;
    case Kind::active:
      return at.active + variable.of / image::kBitsPerWord;
    case Kind::cycles:
      return PlantWords::kCycles;
    case Kind::plant_time:
      return PlantWords::kPlantTime;
    case Kind::frozen:
      return PlantWords::kFrozen;
  }
  return 0;
}

Variables::ByWord Variables::by_word(std::size_t words, std::size_t group) const {
  ByWord result;
  result.first.assign(words + 1, 0);
  for (const Variable& variable : all_) {
    if (group_of(variable) == group) ++result.first[word_of(variable) + 1];
  }
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  result.rows.resize(result.first.back());
  std::vector<std::uint32_t> next = result.first;
  for (std::uint32_t row = 0; row < all_.size(); ++row) {
    if (group_of(all_[row]) == group) result.rows[next[word_of(all_[row])]++] = row;
  }
  return result;
}

UA_DataValue Variables::value_of(const Variable& variable) const noexcept {
  UA_DataValue value;
  UA_DataValue_init(&value);
  value.hasValue = true;
  if (variable.text != nullptr) {
    UA_Variant_setScalar(&value.value, const_cast<UA_String*>(variable.text), &UA_TYPES[UA_TYPES_STRING]);
    value.value.storageType = UA_VARIANT_DATA_NODELETE;
  } else {
    value.value = variable.value.variant();
  }
  value.hasStatus = true;
  value.status = !ready_ && variable.kind != Kind::operation ? UA_STATUSCODE_BADWAITINGFORINITIALDATA
                 : variable.decided                          ? UA_STATUSCODE_BADSENSORFAILURE
                                                             : UA_STATUSCODE_GOOD;
  value.hasSourceTimestamp = true;
  value.sourceTimestamp = variable.since;
  return value;
}

/// Sets the value; returns whether it is another one.
bool Variables::set(Variable& variable, std::uint64_t number) noexcept {
  const Scalar value(number, variable.type);
  if (value == variable.value) return false;
  variable.value = value;
  return true;
}

void Variables::note(Variable& variable, bool changed) {
  if (!changed) return;
  variable.since = time_;
  if (variable.monitored != 0) changed_.push_back(&variable);
}

/// Refreshes the variables of the words that have changed.
template <class Refresh>
void Variables::refresh(ByWord& group, std::span<const std::uint64_t> words, Refresh again) {
  for (std::size_t word = 0; word < words.size(); ++word) {
    if (words[word] == group.seen[word]) continue;
    group.seen[word] = words[word];
    for (std::uint32_t i = group.first[word]; i < group.first[word + 1]; ++i) again(all_[group.rows[i]]);
  }
}

/// Sets the value from the words of its group, without a note.
void Variables::refresh_value(Variable& variable, std::span<const std::uint64_t> words) noexcept {
  const std::uint64_t word = words[word_of(variable)];
  const auto name_of = [this, &variable](std::uint8_t state) {
    return &state_names_[first_states_[tables_.units[variable.of].type] + state];
  };
  switch (variable.kind) {
    case Kind::operation:
    case Kind::event: {
      const image::Point& point = map_.points[variable.of];
      set(variable, has_bits(point.plane) ? word >> (point.position % image::kBitsPerWord) & 1 : word);
      return;
    }
    case Kind::output:
    case Kind::cycles:
    case Kind::frozen:
      set(variable, word);
      return;
    case Kind::state:
      variable.text = name_of(unpack_unit(word).state);
      return;
    case Kind::target:
      variable.text = name_of(unpack_unit(word).target);
      return;
    case Kind::moving:
      set(variable, unpack_unit(word).moving ? 1 : 0);
      return;
    case Kind::progress:
      set(variable, bits(unpack_unit(word).progress / 1000.0));
      return;
    case Kind::active:
      set(variable, word >> (variable.of % image::kBitsPerWord) & 1);
      return;
    case Kind::plant_time:
      set(variable, bits(static_cast<double>(word) / 1e9));
      return;
  }
}

void Variables::refresh_plant(std::span<const std::uint64_t> words) {
  ByWord& group = groups_[kPlant];
  const PlantWords& at = plant_.at();
  for (std::size_t word = at.decided; word < at.active; ++word) {
    for (std::uint64_t changed = words[word] ^ group.seen[word]; changed != 0; changed &= changed - 1) {
      const auto bit = static_cast<std::uint32_t>(std::countr_zero(changed));
      Variable& variable = all_[(word - at.decided) * image::kBitsPerWord + bit];
      variable.decided = (words[word] >> bit & 1) != 0;
      note(variable, true);
    }
  }
}

/// The images are of the same cycle, or are taken again at the next update.
void Variables::take() {
  const auto again = [this](Variable& variable) {
    const Scalar before = variable.value;
    const UA_String* const text = variable.text;
    refresh_value(variable, groups_[group_of(variable)].seen);
    note(variable, before != variable.value || text != variable.text);
  };
  const image::Planes written = images_.planes();
  refresh(groups_[static_cast<std::size_t>(Plane::operation_bits)], written.operation_bits, again);
  refresh(groups_[static_cast<std::size_t>(Plane::operation_numbers)], written.operation_numbers, again);

  plant_.take();
  images_.take_events();
  const image::Planes planes = images_.planes();
  const auto words = plant_.words();
  if (words[PlantWords::kCycles] != cycles_of(planes, map_)) return;
  if (words[PlantWords::kCycles] == groups_[kPlant].seen[PlantWords::kCycles]) return;
  time_ = date_time(words[PlantWords::kTime]);
  refresh(groups_[static_cast<std::size_t>(Plane::event_bits)], planes.event_bits, again);
  refresh(groups_[static_cast<std::size_t>(Plane::event_numbers)], planes.event_numbers, again);
  refresh_plant(words);
  refresh(groups_[kPlant], words, again);
  if (ready_) return;
  ready_ = true;
  for (Variable& variable : all_) note(variable, variable.kind != Kind::operation);
}

void Variables::wrote(Variable& variable, std::uint64_t number) noexcept {
  set(variable, number);
  variable.since = UA_DateTime_now();
}

}  // namespace symplant::link::opc_ua
