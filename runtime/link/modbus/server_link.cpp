// The link `modbus-tcp-server`: images on one side, sockets on the other.
#include "symplant/link/modbus/server_link.hpp"

#include <atomic>
#include <system_error>

#include "symplant/core/version.hpp"
#include "symplant/link/modbus/images.hpp"
#include "symplant/link/modbus/listener.hpp"
#include "symplant/link/modbus/server.hpp"

namespace symplant::link::modbus {

namespace {

constexpr std::string_view kScheme = "modbus-tcp-server";

/// Answers requests from the images and counts them. Lives in the server's thread; the counts may be read by any.
class ImageResponder final : public Responder {
 public:
  ImageResponder(Images& images, const Identity& identity) noexcept : images_(images), identity_(identity) {}

  Answer respond(std::span<const std::uint8_t> request, std::span<std::uint8_t, kMaxPdu> reply) noexcept override {
    const Answer answer = answer_request(request, images_.tables(), identity_, reply);
    const std::uint32_t gaps = images_.written(answer);
    if (answer.size != 0) add(requests_, 1);
    if (answer.exception != Exception::none) add(exceptions_, 1);
    if (gaps != 0) add(gaps_, gaps);
    return answer;
  }

  void refused() noexcept override {
    add(requests_, 1);
    add(exceptions_, 1);
  }

  LinkStatus status() const noexcept {
    LinkStatus status;
    status.requests = requests_.load(std::memory_order_relaxed);
    status.exceptions = exceptions_.load(std::memory_order_relaxed);
    status.writes_to_gaps = gaps_.load(std::memory_order_relaxed);
    return status;
  }

 private:
  using Count = std::atomic<std::uint64_t>;
  static void add(Count& count, std::uint64_t more) noexcept { count.fetch_add(more, std::memory_order_relaxed); }

  Images& images_;
  Identity identity_;
  Count requests_{0};
  Count exceptions_{0};
  Count gaps_{0};
};

class ServerLink final : public Link {
 public:
  ServerLink(const core::PlantTables& tables, const IoMap& map, Listener listener, const core::Plant* plant)
      : bound_(std::move(listener.bound)),
        images_(tables, map),
        responder_(filled(images_, plant), {"symplant", tables.name, core::version()}),
        server_(std::move(listener.socket), responder_) {}

  std::string url() const override { return std::string(kScheme) + "://" + format_host_port(bound_); }
  void read_operations(core::Plant& plant, core::Time /*now*/) noexcept override { images_.read_operations(plant); }
  void write_events(const core::Plant& plant, const exec::CycleStatus& /*status*/) noexcept override {
    images_.write_events(plant);
  }

  LinkStatus status() const noexcept override {
    LinkStatus status = responder_.status();
    status.connections = server_.connections();
    return status;
  }

 private:
  /// The images with the plant's events, before the server's thread begins to answer from them.
  static Images& filled(Images& images, const core::Plant* plant) {
    if (plant != nullptr) images.write_events(*plant);
    return images;
  }

  HostPort bound_;
  Images images_;
  ImageResponder responder_;
  Server server_;  // last: its thread ends before what it uses
};

}  // namespace

LinkResult open_server_link(std::string_view rest, const LinkChoice& link, const core::PlantTables& tables,
                            const core::Plant* plant) {
  if (rest.substr(0, 2) != "//") {
    return LinkError{LinkError::Kind::usage, "`" + std::string(rest) + "` behind `" + std::string(kScheme) +
                                                 ":` is no address: give //HOST:PORT"};
  }
  auto address = parse_host_port(rest.substr(2));
  if (auto* error = std::get_if<LinkError>(&address)) return std::move(*error);
  const IoMap map = make_io_map(tables, link.controller, link.settings);
  if (!map.faults.empty()) return LinkError{LinkError::Kind::usage, fault_text(tables, map, map.faults.front())};
  auto listener = listen_on(std::get<HostPort>(address));
  if (auto* error = std::get_if<LinkError>(&listener)) return std::move(*error);
  try {
    return std::make_unique<ServerLink>(tables, map, std::move(std::get<Listener>(listener)), plant);
  } catch (const std::system_error& error) {
    return LinkError{LinkError::Kind::environment, std::string("cannot start the Modbus server: ") + error.what()};
  }
}

}  // namespace symplant::link::modbus
