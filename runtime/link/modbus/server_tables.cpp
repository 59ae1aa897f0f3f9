// The tables of a Modbus server.
#include "symplant/link/modbus/server_tables.hpp"

#include <utility>

#include "symplant/link/modbus/transfer_range.hpp"

namespace symplant::link::modbus {

namespace {

std::uint32_t size_of(const IoMap& map, Table table) { return map.sizes[static_cast<std::size_t>(table)]; }

}  // namespace

ServerTables::ServerTables(const tables::PlantTables& tables, const IoMap& map, const image::Map& placed,
                           image::Images& images, image::RequestWatch* watch)
    : images_(images),
      watch_(watch),
      sizes_(map.sizes),
      holding_registers_(image::lane_words(size_of(map, Table::holding_register))),
      holding_lanes_(lanes_of(map, placed, Table::holding_register)),
      input_lanes_(lanes_of(map, placed, Table::input_register)),
      watchdog_(map.watchdog),
      rewriting_(size_of(map, Table::coil), size_of(map, Table::holding_register)) {
  for (std::size_t table = 0; table < kTables; ++table) mapped_[table] = image::PositionSet(map.sizes[table]);
  for (const IoPoint& point : map.points) mapped_[static_cast<std::size_t>(point.table)].add(point.number, point.width);
  if (watchdog_) mapped_[static_cast<std::size_t>(Table::holding_register)].add(*watchdog_, 1);
  for (const Table table : {Table::coil, Table::holding_register}) {
    image::PositionSet& used = used_[static_cast<std::size_t>(table)];
    used = mapped_[static_cast<std::size_t>(table)];
    if (const auto range = transfer_range(tables, map, table)) used.add(range->first, range->count);
  }
  if (watch_ != nullptr) writes_.emplace(map, watch_->found);
  take_operations();
}

/// The tables become as the image of operations is.
void ServerTables::take_operations() noexcept {
  const image::Planes planes = images_.planes();
  for (std::uint32_t address = 0; address < holding_lanes_.size(); ++address) {
    if (holding_lanes_[address] == kNoLane) continue;
    image::set_lane(holding_registers_, address, image::get_lane(planes.operation_numbers, holding_lanes_[address]));
  }
  if (writes_) writes_->changed(planes.operation_bits, holding_registers_);
}

Tables ServerTables::tables() noexcept {
  images_.take_events();
  const image::Planes planes = images_.planes();
  const auto size = [this](Table table) { return sizes_[static_cast<std::size_t>(table)]; };
  return {.coils = {planes.operation_bits, size(Table::coil)},
          .discrete_inputs = {planes.event_bits, size(Table::discrete_input)},
          .holding_registers = {holding_registers_, size(Table::holding_register)},
          .input_registers = {planes.event_numbers, input_lanes_}};
}

void ServerTables::begin_request(std::uint32_t losses) noexcept {
  if (watch_ != nullptr) watch_->reads.begin();
  if (!images_.release(losses)) return;
  rewriting_.begin(mapped_[static_cast<std::size_t>(Table::coil)],
                   mapped_[static_cast<std::size_t>(Table::holding_register)]);
  take_operations();
  images_.publish(rewriting_.complete());
}

/// Puts the registers into the numbers that have them.
void ServerTables::put_registers(std::uint32_t first, std::uint32_t count) noexcept {
  const auto numbers = images_.planes().operation_numbers;
  for (std::uint32_t address = first; address < first + count; ++address) {
    const std::uint32_t lane = holding_lanes_[address];
    const std::uint16_t value = image::get_lane(holding_registers_, address);
    if (lane == kNoLane || image::get_lane(numbers, lane) == value) continue;
    image::set_lane(numbers, lane, value);
    images_.touch(Plane::operation_numbers, lane / image::kLanesPerWord, 1);
  }
}

std::uint32_t ServerTables::written(Table table, std::uint32_t first, std::uint32_t count,
                                    const ClientId& client) noexcept {
  if (count == 0) return 0;
  const bool coils = table == Table::coil;
  coils ? images_.touch(Plane::operation_bits, first, count) : put_registers(first, count);
  rewriting_.wrote(coils, first, count);
  if (writes_) {
    coils ? writes_->wrote_coils(client, first, count, images_.planes().operation_bits, images_.next_image())
          : writes_->wrote_registers(client, first, count, holding_registers_, images_.next_image());
  }
  images_.publish(rewriting_.complete());
  return count - used_[static_cast<std::size_t>(table)].count(first, count);
}

void ServerTables::end_request(Table table, std::uint32_t first, std::uint32_t count) noexcept {
  if (watch_ == nullptr) return;
  if (count != 0 && table == Table::discrete_input) watch_->reads.read(images_.planes().event_bits, first, count);
  watch_->reads.end();
}

bool ServerTables::changed_watchdog(Table table, std::uint32_t first, std::uint32_t count) noexcept {
  const bool written =
      watchdog_ && table == Table::holding_register && first <= *watchdog_ && *watchdog_ < first + count;
  if (!written) return false;
  const std::uint16_t value = image::get_lane(holding_registers_, *watchdog_);
  return std::exchange(watchdog_value_, value) != value;
}

}  // namespace symplant::link::modbus
