// A plant, its images and requests to them, without a socket.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "symplant/link/image/images.hpp"
#include "symplant/link/modbus/codec.hpp"
#include "symplant/link/modbus/server_tables.hpp"
#include "unit/exec/cell.hpp"

namespace symplant::test {

using Bytes = std::vector<std::uint8_t>;

struct ImageBench {
  tables::PlantTables tables;
  OwnedPlant plant;
  link::modbus::IoMap map;
  link::image::Map placed;
  link::image::Images images;
  link::modbus::ServerTables server;
  std::uint32_t losses = 0;
  std::uint32_t gaps = 0;
  tables::Time time = 0;

  explicit ImageBench(const tables::PlantTables& given, const link::LinkSettings& settings = {})
      : tables(given),
        plant(tables),
        map(link::modbus::make_io_map(tables, 0, settings)),
        placed(image_of(tables, map)),
        images(tables, placed),
        server(tables, map, placed, images) {
    plant->advance_to(0);
    write();
  }

  Bytes ask(const Bytes& request) {
    std::array<std::uint8_t, link::modbus::kMaxPdu> reply{};
    server.begin_request(losses);
    const link::modbus::Answer answer = link::modbus::answer_request(request, server.tables(), {}, reply);
    gaps += server.written(answer.written, answer.first, answer.count);
    return {reply.begin(), reply.begin() + static_cast<std::ptrdiff_t>(answer.size)};
  }
  void write() {
    images.write_events(*plant);
    plant->forget_changed_events();
  }
  void cycle(tables::Time duration = 10 * tables::kMillisecond) {
    images.read_operations(*plant);
    plant->advance_to(time += duration);
    write();
  }
};

}  // namespace symplant::test
