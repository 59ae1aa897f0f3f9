// The link `modbus-tcp-server`: images on one side, sockets on the other.
#include "symplant/link/modbus/server_link.hpp"

#include <atomic>
#include <system_error>
#include <utility>

#include "symplant/link/image/cycle_side.hpp"
#include "symplant/link/image/request_watch.hpp"
#include "symplant/link/modbus/refusals.hpp"
#include "symplant/link/modbus/server.hpp"
#include "symplant/link/modbus/server_tables.hpp"
#include "symplant/link/net/listener.hpp"
#include "symplant/tables/version.hpp"

namespace symplant::link::modbus {

namespace {

constexpr std::string_view kScheme = "modbus-tcp-server";

/// Answers requests from the images and counts them. Used by the server's thread; any thread may read the counts.
class ImageResponder final : public Responder {
 public:
  /// If the map has a watchdog, only a change of its register is a sign of life.
  ImageResponder(ServerTables& tables, image::RequestWatch& watch, const Identity& identity, const IoMap& map) noexcept
      : tables_(tables),
        watch_(watch),
        identity_(identity),
        watched_(map.watchdog.has_value()),
        state_register_(map.status_block ? *map.status_block + kStatusFields[kStateField].first : kNowhere) {}

  Answer respond(const ClientId& client, std::span<const std::uint8_t> request,
                 std::span<std::uint8_t, kMaxPdu> reply) noexcept override {
    const bool left =
        left_.load(std::memory_order_acquire);  // read before the image, which then has the stopping state
    tables_.begin_request(losses_.load(std::memory_order_relaxed));
    const Answer answer = answer_request(request, tables_.tables(), identity_, reply);
    const std::uint32_t gaps = tables_.written(answer.written, answer.first, answer.count, client);
    // After written(), so that a cycle that sees the count also sees the data.
    if (watched_ ? tables_.changed_watchdog(answer.written, answer.first, answer.count) : touches_map(answer)) {
      heard_.fetch_add(1, std::memory_order_release);
    }
    if (reads_state(answer)) (left ? end_read_ : state_read_).store(true, std::memory_order_relaxed);
    if (answer.size != 0) add(requests_, 1);
    if (answer.exception != Exception::none) refuse(request, answer.exception);
    if (gaps != 0) add(gaps_, gaps);
    tables_.end_request(answer.read, answer.read_first, answer.read_count);
    return answer;
  }

  void refused(std::span<const std::uint8_t> request) noexcept override {
    add(requests_, 1);
    if (!request.empty()) refuse(request, Exception::server_device_busy);
  }

  void left(const ClientId& client) noexcept override { tables_.left(client); }

  /// Number of signs of life: requests that touched the map or changed the watchdog. Any thread.
  std::uint64_t heard() const noexcept { return heard_.load(std::memory_order_acquire); }
  /// Sets the number of losses so far. Any thread.
  void lost(std::uint32_t losses) noexcept { losses_.store(losses, std::memory_order_relaxed); }

  /// The image now has the stopping state. Any thread, once.
  void left() noexcept { left_.store(true, std::memory_order_release); }

  LinkStatus status() const noexcept {
    LinkStatus status;
    status.end_unread = left_.load(std::memory_order_relaxed) && state_read_.load(std::memory_order_relaxed) &&
                        !end_read_.load(std::memory_order_relaxed);
    status.losses = losses_.load(std::memory_order_relaxed);
    status.requests = requests_.load(std::memory_order_relaxed);
    status.exceptions = exceptions_.load(std::memory_order_relaxed);
    status.writes_to_gaps = gaps_.load(std::memory_order_relaxed);
    return status;
  }

 private:
  using Count = std::atomic<std::uint64_t>;
  static void add(Count& count, std::uint64_t more) noexcept { count.fetch_add(more, std::memory_order_relaxed); }

  void refuse(std::span<const std::uint8_t> request, Exception exception) noexcept {
    add(exceptions_, 1);
    const auto refusal = refusals_.add(request, exception);
    if (refusal) watch_.found.add({tables::FindingKind::request_refused, tables::kNone, pack(*refusal)});
  }

  bool touches_map(const Answer& answer) const noexcept {
    return (answer.count != 0 && tables_.is_mapped(answer.written, answer.first, answer.count)) ||
           (answer.read_count != 0 && tables_.is_mapped(answer.read, answer.read_first, answer.read_count));
  }

  bool reads_state(const Answer& answer) const noexcept {
    return answer.read_count != 0 && answer.read == Table::input_register && answer.read_first <= state_register_ &&
           state_register_ - answer.read_first < answer.read_count;
  }

  ServerTables& tables_;
  image::RequestWatch& watch_;
  Refusals refusals_;
  Identity identity_;
  bool watched_;
  std::uint32_t state_register_;
  Count requests_{0};
  Count exceptions_{0};
  Count gaps_{0};
  Count heard_{0};
  std::atomic<std::uint32_t> losses_{0};
  std::atomic<bool> left_{false};
  std::atomic<bool> state_read_{false};  ///< the state in the status block, while the plant ran
  std::atomic<bool> end_read_{false};    ///< the state in the status block, after left()
};

class ServerLink final : public Link {
 public:
  ServerLink(const tables::PlantTables& tables, const IoMap& map, const LinkSettings& settings, net::Listener listener,
             const plant::Plant* plant)
      : bound_(std::move(listener.bound)),
        placed_(image_of(tables, map)),
        watch_(placed_),
        cycle_(tables, placed_, policies_of(map, settings), plant, &watch_),
        tables_(tables, map, placed_, cycle_.images(), &watch_),
        responder_(tables_, watch_, {"symplant", tables.name, tables::version()}, map),
        server_(std::move(listener.socket), responder_, options_of(settings)) {}

  std::string url() const override { return std::string(kScheme) + "://" + net::format_host_port(bound_); }

  void read_operations(plant::Plant& plant, tables::Time now) noexcept override {
    if (cycle_.read_operations(plant, now, responder_.heard())) responder_.lost(cycle_.losses());
  }

  void write_events(const plant::Plant& plant, const exec::CycleStatus& status) noexcept override {
    cycle_.write_events(plant, status);
  }

  void leave() noexcept override {
    cycle_.leave();
    responder_.left();
  }

  std::optional<LinkFinding> take_finding() noexcept override {
    using tables::FindingKind;
    while (const std::optional<LinkFinding> finding = watch_.take()) {
      // Without a PLC nothing is missed.
      const bool missed = finding->kind == FindingKind::not_read || finding->kind == FindingKind::not_sampled;
      if (!missed || state() == exec::LinkState::live) return finding;
    }
    return std::nullopt;
  }

  std::vector<std::uint32_t> events_on_request() const override {
    std::vector<std::uint32_t> events;
    for (const image::Point& point : placed_.points) {
      if (point.plane == Plane::event_bits) events.push_back(point.symbol);
    }
    return events;
  }
  void cut(bool on) noexcept override { server_.cut(on); }
  exec::LinkState state() const noexcept override { return cycle_.state(); }
  bool freezes_plant() const noexcept override { return cycle_.freezes_plant(); }

  LinkStatus status() const noexcept override {
    LinkStatus status = responder_.status();
    status.connections = server_.connections();
    status.crowded_out = server_.crowded_out();
    return status;
  }

 private:
  static ServerOptions options_of(const LinkSettings& settings) {
    return {.connections = settings.connections,
            .idle = settings.idle,
            .keep = {settings.keep.begin(), settings.keep.end()}};
  }

  /// With a watchdog the link is lost when that does not change.
  static LinkSettings policies_of(const IoMap& map, LinkSettings settings) {
    if (map.watchdog) settings.loss_after = settings.watchdog_within;
    return settings;
  }

  net::HostPort bound_;
  image::Map placed_;
  image::RequestWatch watch_;
  image::CycleSide cycle_;
  ServerTables tables_;
  ImageResponder responder_;
  Server server_;  // last member: its thread ends before what it uses is destroyed
};

}  // namespace

std::variant<net::HostPort, LinkError> server_address(std::string_view rest) {
  if (rest.substr(0, 2) == "//") return net::parse_host_port(rest.substr(2));
  return LinkError{LinkError::Kind::usage, "`" + std::string(rest) + "` after `" + std::string(kScheme) +
                                               ":` is not an address: give //HOST:PORT"};
}

std::string address_fault(std::string_view rest) {
  const auto address = server_address(rest);
  const auto* const error = std::get_if<LinkError>(&address);
  return error == nullptr ? std::string() : error->message;
}

std::variant<LinkMap, LinkError> server_map(std::string_view /*rest*/, const LinkChoice& link,
                                            const tables::PlantTables& tables) {
  auto io = std::make_shared<const IoMap>(make_io_map(tables, link.controller, link.settings));
  LinkMap map{{}, unreachable_symbols(*io), {}, io};
  map.symbols.reserve(io->points.size());
  for (const IoPoint& point : io->points) {
    map.symbols.push_back({point.symbol, location_text(point), point.word_order, point.on_loss});
  }
  return map;
}

LinkResult open_server_link(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                            const plant::Plant* plant) {
  auto address = server_address(rest);
  if (auto* error = std::get_if<LinkError>(&address)) return std::move(*error);
  const IoMap map = make_io_map(tables, link.controller, link.settings);
  if (!map.faults.empty()) return LinkError{LinkError::Kind::usage, fault_text(tables, map, map.faults.front())};
  auto listener = net::listen_on(std::get<net::HostPort>(address));
  if (auto* error = std::get_if<LinkError>(&listener)) return std::move(*error);
  try {
    return std::make_unique<ServerLink>(tables, map, link.settings, std::move(std::get<net::Listener>(listener)),
                                        plant);
  } catch (const std::system_error& error) {
    return LinkError{LinkError::Kind::environment, std::string("cannot start the Modbus server: ") + error.what()};
  }
}

}  // namespace symplant::link::modbus
