// Listens on a server link and notes what the PLC touches.
#include "symplant/link/modbus/server_doctor.hpp"

#include <array>
#include <chrono>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "symplant/link/image/images.hpp"
#include "symplant/link/image/position_set.hpp"
#include "symplant/link/modbus/codec.hpp"
#include "symplant/link/modbus/server.hpp"
#include "symplant/link/modbus/server_link.hpp"
#include "symplant/link/modbus/server_tables.hpp"
#include "symplant/link/modbus/transfer_range.hpp"
#include "symplant/link/net/listener.hpp"
#include "symplant/tables/version.hpp"

namespace symplant::link::modbus {

namespace {

constexpr auto kBetweenPolls = std::chrono::milliseconds(50);
constexpr std::size_t kRangesShown = 4;

/// Answers from images without a plant, and notes the addresses. Used by the server's thread; the notes may be read
/// after that has ended.
class Noting final : public Responder {
 public:
  Noting(ServerTables& tables, const IoMap& map, std::string_view plant) : tables_(tables), plant_(plant) {
    for (std::size_t t = 0; t < kTables; ++t) touched_[t] = image::PositionSet(map.sizes[t]);
  }

  Answer respond(const ClientId& /*client*/, std::span<const std::uint8_t> request,
                 std::span<std::uint8_t, kMaxPdu> reply) noexcept override {
    const Answer answer = answer_request(request, tables_.tables(), {"symplant", plant_, tables::version()}, reply);
    tables_.written(answer.written, answer.first, answer.count);
    if (answer.count != 0) note(answer.written, answer.first, answer.count);
    if (answer.read_count != 0) note(answer.read, answer.read_first, answer.read_count);
    ++requests;
    if (answer.exception != Exception::none) ++exceptions[static_cast<std::size_t>(answer.exception)];
    return answer;
  }
  void refused(std::span<const std::uint8_t> /*request*/) noexcept override { ++requests; }

  const image::PositionSet& touched(Table table) const { return touched_[static_cast<std::size_t>(table)]; }

  std::uint64_t requests = 0;
  std::array<std::uint64_t, 16> exceptions{};  ///< by code

 private:
  void note(Table table, std::uint32_t first, std::uint32_t count) noexcept {
    touched_[static_cast<std::size_t>(table)].add(first, count);
  }

  ServerTables& tables_;
  std::string_view plant_;
  std::array<image::PositionSet, kTables> touched_;
};

/// The ranges of addresses that are touched but not mapped: "5 to 7, 12".
std::string unmapped_text(const image::PositionSet& touched, const image::PositionSet& mapped, std::uint32_t size) {
  std::string text;
  std::size_t ranges = 0;
  for (std::uint32_t at = 0; at < size; ++at) {
    const auto is_unmapped = [&](std::uint32_t i) { return touched.has_any(i, 1) && !mapped.has_any(i, 1); };
    if (!is_unmapped(at)) continue;
    const std::uint32_t first = at;
    while (at + 1 < size && is_unmapped(at + 1)) ++at;
    if (ranges++ >= kRangesShown) continue;
    text += (text.empty() ? "" : ", ") + std::to_string(first);
    if (at != first) text += " to " + std::to_string(at);
  }
  return ranges > kRangesShown ? text + " and " + std::to_string(ranges - kRangesShown) + " more ranges" : text;
}

class ServerDoctor {
 public:
  ServerDoctor(const tables::PlantTables& tables, const LinkChoice& link, IoMap map)
      : tables_(tables),
        link_(link),
        map_(std::move(map)),
        placed_(image_of(tables, map_)),
        images_(tables, placed_),
        served_(tables, map_, placed_, images_),
        noting_(served_, map_, tables.name) {}

  doctor::Report examine(net::Listener listener, const doctor::Options& options) {
    report_.url = "modbus-tcp-server://" + net::format_host_port(listener.bound);
    std::uint32_t connections = 0;
    {
      Server server(std::move(listener.socket), noting_, {.connections = link_.settings.connections});
      const auto end = std::chrono::steady_clock::now() + std::chrono::nanoseconds(options.duration);
      while (std::chrono::steady_clock::now() < end && (options.stop == nullptr || !options.stop->load())) {
        std::this_thread::sleep_for(kBetweenPolls);
        connections = std::max(connections, server.connections());
      }
    }
    report_.reached = noting_.requests != 0;
    report_requests(connections);
    if (report_.reached) report_addresses();
    return std::move(report_);
  }

 private:
  void step(std::string name, doctor::Result result, std::string text) {
    report_.steps.push_back({std::move(name), result, std::move(text)});
  }

  void report_requests(std::uint32_t connections) {
    if (noting_.requests == 0) {
      step("connection", doctor::Result::bad,
           connections == 0 ? "no client connected to " + report_.url +
                                  "; check the address that the PLC has for this computer, and firewalls"
                            : "a client connected, but sent no request");
      return;
    }
    step("connection", doctor::Result::good, std::to_string(noting_.requests) + " requests");
    constexpr std::array kMeanings = {std::pair{1, "unknown functions"}, std::pair{2, "addresses beyond the map"},
                                      std::pair{3, "wrong quantities or values"}};
    for (const auto& [code, meaning] : kMeanings) {
      const std::uint64_t count = noting_.exceptions[static_cast<std::size_t>(code)];
      if (count == 0) continue;
      step("requests", doctor::Result::bad,
           std::to_string(count) + " answered with exception " + std::to_string(code) + " (" + meaning +
               "); compare the PLC's request list with `symplant map`");
    }
  }

  void report_addresses() {
    std::array<image::PositionSet, kTables> mapped;
    for (std::size_t t = 0; t < kTables; ++t) mapped[t] = image::PositionSet(map_.sizes[t]);
    std::size_t untouched = 0;
    for (const IoPoint& point : map_.points) {
      mapped[static_cast<std::size_t>(point.table)].add(point.number, point.width);
      const bool touched = noting_.touched(point.table).count(point.number, point.width) == point.width;
      const bool event = tables_.symbols[point.symbol].direction() == tables::Direction::event;
      report_.points.push_back({point.symbol,
                                std::string(table_name(point.table)) + " " + std::to_string(point.number),
                                touched ? doctor::Result::good : doctor::Result::warning,
                                {},
                                touched ? ""
                                : event ? "the PLC never read it"
                                        : "the PLC never wrote it"});
      if (!touched) ++untouched;
    }
    if (map_.status_block)
      mapped[static_cast<std::size_t>(Table::input_register)].add(*map_.status_block, kStatusWords);
    if (map_.watchdog) mapped[static_cast<std::size_t>(Table::holding_register)].add(*map_.watchdog, 1);
    for (std::size_t t = 0; t < kTables; ++t) {
      const auto range = transfer_range(tables_, map_, static_cast<Table>(t));
      if (range) mapped[t].add(range->first, range->count);
    }
    step("map", untouched == 0 ? doctor::Result::good : doctor::Result::warning,
         std::to_string(map_.points.size() - untouched) + " of " + std::to_string(map_.points.size()) +
             " mapped symbols were read or written");
    for (std::size_t t = 0; t < kTables; ++t) {
      const auto table = static_cast<Table>(t);
      const std::string ranges = unmapped_text(noting_.touched(table), mapped[t], map_.sizes[t]);
      if (ranges.empty()) continue;
      step("gaps", doctor::Result::warning,
           std::string("the PLC touched ") + table_name(table) + "s that no symbol uses: " + ranges);
    }
  }

  const tables::PlantTables& tables_;
  const LinkChoice& link_;
  IoMap map_;
  image::Map placed_;
  image::Images images_;
  ServerTables served_;
  Noting noting_;
  doctor::Report report_;
};

}  // namespace

doctor::Examined examine_server(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                                const doctor::Options& options) {
  auto address = server_address(rest);
  if (auto* error = std::get_if<LinkError>(&address)) return std::move(*error);
  IoMap map = make_io_map(tables, link.controller, link.settings);
  if (!map.faults.empty()) return LinkError{LinkError::Kind::usage, fault_text(tables, map, map.faults.front())};
  auto listener = net::listen_on(std::get<net::HostPort>(address));
  if (auto* error = std::get_if<LinkError>(&listener)) return std::move(*error);
  try {
    return ServerDoctor(tables, link, std::move(map)).examine(std::move(std::get<net::Listener>(listener)), options);
  } catch (const std::system_error& error) {
    return LinkError{LinkError::Kind::environment, std::string("cannot start the Modbus server: ") + error.what()};
  }
}

}  // namespace symplant::link::modbus
