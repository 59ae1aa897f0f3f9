// The link `opc-ua-server`: images on one side, an OPC UA server on the other.
#include "symplant/link/opc_ua/server_link.hpp"

#include <algorithm>
#include <utility>

#include "symplant/link/image/cycle_side.hpp"
#include "symplant/link/opc_ua/server.hpp"
#include "symplant/link/opc_ua/server_image.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::link::opc_ua {

namespace {

class ServerLink final : public Link {
 public:
  ServerLink(const tables::PlantTables& tables, const LinkChoice& link, const plant::Plant* plant)
      : tables_(tables),
        map_(server_image(tables, link)),
        cycle_(tables, map_, link.settings, plant),
        plant_(tables, map_) {}

  std::optional<LinkError> start(const ServerSettings& settings, const LinkSettings& link) {
    auto started =
        Server::start(settings, link, {tables_, map_, cycle_.images(), plant_, tables::model_hash(tables_), false});
    if (auto* error = std::get_if<LinkError>(&started)) return std::move(*error);
    server_ = std::move(std::get<std::unique_ptr<Server>>(started));
    return std::nullopt;
  }

  std::string url() const override {
    return std::string(kServerScheme) + "://" + net::format_host_port(server_->bound());
  }

  void read_operations(plant::Plant& plant, tables::Time now) noexcept override {
    if (cycle_.read_operations(plant, now, server_->heard())) server_->lost(cycle_.losses());
  }

  void write_events(const plant::Plant& plant, const exec::CycleStatus& status) noexcept override {
    plant_.write(plant, status);
    cycle_.write_events(plant, status);
  }

  void leave() noexcept override { cycle_.leave(); }
  void cut(bool on) noexcept override { server_->cut(on); }
  exec::LinkState state() const noexcept override { return cycle_.state(); }
  bool freezes_plant() const noexcept override { return cycle_.freezes_plant(); }
  LinkStatus status() const noexcept override { return server_->status(); }
  std::vector<std::string> take_messages() override { return server_->take_messages(); }
  bool has_commands() const override { return true; }
  std::optional<LinkCommand> take_command(bool frozen) noexcept override { return server_->take_command(frozen); }

 private:
  const tables::PlantTables& tables_;
  image::Map map_;
  image::CycleSide cycle_;
  PlantImage plant_;
  std::unique_ptr<Server> server_;  // last member: its thread ends before what it uses is destroyed
};

}  // namespace

LinkResult open_server_link(std::string_view rest, const LinkChoice& link, const tables::PlantTables& tables,
                            const plant::Plant* plant) {
  auto settings = read_server_settings(rest);
  if (auto* error = std::get_if<LinkError>(&settings)) return std::move(*error);
  auto made = std::make_unique<ServerLink>(tables, link, plant);
  if (auto error = made->start(std::get<ServerSettings>(settings), link.settings)) return std::move(*error);
  return made;
}

}  // namespace symplant::link::opc_ua
