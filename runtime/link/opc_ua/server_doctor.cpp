// Listens as an OPC UA server and notes what clients read and write.
#include "symplant/link/opc_ua/server_doctor.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <utility>

#include "symplant/link/opc_ua/server.hpp"
#include "symplant/link/opc_ua/server_image.hpp"
#include "symplant/link/opc_ua/server_nodes.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::link::opc_ua {

namespace {

constexpr auto kBetweenPolls = std::chrono::milliseconds(50);

class ServerDoctor {
 public:
  ServerDoctor(const tables::PlantTables& tables, const LinkChoice& link)
      : tables_(tables), link_(link), map_(server_image(tables, link)), images_(tables, map_), plant_(tables, map_) {}

  doctor::Examined examine(const ServerSettings& settings, const doctor::Options& options) {
    auto started =
        Server::start(settings, link_.settings, {tables_, map_, images_, plant_, tables::model_hash(tables_), true});
    if (auto* error = std::get_if<LinkError>(&started)) return std::move(*error);
    Server& server = *std::get<std::unique_ptr<Server>>(started);
    report_.url = std::string(kServerScheme) + "://" + net::format_host_port(server.bound());
    std::uint32_t connections = 0;
    const auto end = std::chrono::steady_clock::now() + std::chrono::nanoseconds(options.duration);
    while (std::chrono::steady_clock::now() < end && (options.stop == nullptr || !options.stop->load())) {
      std::this_thread::sleep_for(kBetweenPolls);
      connections = std::max(connections, server.status().connections);
    }
    server.stop();
    report_connection(server, connections);
    if (report_.reached) report_symbols(server.touched(), server.status());
    return std::move(report_);
  }

 private:
  void step(std::string name, doctor::Result result, std::string text) {
    report_.steps.push_back({std::move(name), result, std::move(text)});
  }

  void report_connection(Server& server, std::uint32_t connections) {
    for (std::string& message : server.take_messages()) step("security", doctor::Result::warning, std::move(message));
    const LinkStatus status = server.status();
    report_.reached = server.heard() != 0 || status.requests != 0 || connections != 0;
    if (!report_.reached) {
      step("connection", doctor::Result::bad,
           "no client opened a session at opc.tcp://" + net::format_host_port(server.bound()) +
               "; check the address that the client has for this computer, its security, and firewalls");
      return;
    }
    step("connection", doctor::Result::good, std::to_string(status.requests) + " requests");
  }

  void report_symbols(const Touched& touched, const LinkStatus& status) {
    const auto texts = tables::split_names(tables_.symbol_names);
    std::size_t untouched = 0;
    for (std::uint32_t i = 0; i < map_.points.size(); ++i) {
      const std::uint32_t symbol = map_.points[i].symbol;
      const bool event = is_event(map_.points[i].plane);
      const bool is_touched = (event ? touched.read : touched.written).has_any(i, 1);
      report_.points.push_back({symbol,
                                symbol_node_text(texts[std::size_t{symbol} * 2]),
                                is_touched ? doctor::Result::good : doctor::Result::warning,
                                {},
                                is_touched ? ""
                                : event    ? "no client read it"
                                           : "no client wrote it"});
      if (!is_touched) ++untouched;
    }
    step("map", untouched == 0 ? doctor::Result::good : doctor::Result::warning,
         std::to_string(map_.points.size() - untouched) + " of " + std::to_string(map_.points.size()) +
             " symbols were read or written");
    if (status.exceptions != 0) {
      step("writes", doctor::Result::bad,
           std::to_string(status.exceptions) +
               " writes and calls were refused; compare the types of the client's "
               "variables with those of the nodes");
    }
  }

  const tables::PlantTables& tables_;
  const LinkChoice& link_;
  image::Map map_;
  image::Images images_;
  PlantImage plant_;
  doctor::Report report_;
};

}  // namespace

doctor::Examined examine_server(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                                const doctor::Options& options) {
  auto settings = read_server_settings(rest);
  if (auto* error = std::get_if<LinkError>(&settings)) return std::move(*error);
  return ServerDoctor(tables, link).examine(std::get<ServerSettings>(settings), options);
}

}  // namespace symplant::link::opc_ua
