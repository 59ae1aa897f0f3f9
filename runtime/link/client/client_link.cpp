// A link that goes to the PLC.
#include "symplant/link/client/client_link.hpp"

#include <system_error>
#include <utility>

#include "symplant/link/client/poller.hpp"
#include "symplant/link/image/cycle_side.hpp"

namespace symplant::link::client {

namespace {

class ClientLink final : public Link {
 public:
  ClientLink(ClientParts parts, std::string note, const LinkSettings& settings, const tables::PlantTables& tables,
             const plant::Plant* plant)
      : cycle_(tables, parts.map, settings, plant),
        poller_(std::move(parts), tables, cycle_.images(), settings.arm, std::move(note)) {}

  std::string url() const override { return poller_.url(); }

  void read_operations(plant::Plant& plant, tables::Time now) noexcept override {
    if (cycle_.read_operations(plant, now, poller_.signs())) poller_.lost(cycle_.losses());
  }
  void write_events(const plant::Plant& plant, const exec::CycleStatus& status) noexcept override {
    cycle_.write_events(plant, status);
  }
  void leave() noexcept override {
    cycle_.leave();
    poller_.leave();
  }
  void cut(bool on) noexcept override { poller_.cut(on); }
  exec::LinkState state() const noexcept override { return cycle_.state(); }
  std::optional<LinkFinding> take_finding() noexcept override { return poller_.take_finding(); }
  bool freezes_plant() const noexcept override { return cycle_.freezes_plant(); }

  LinkStatus status() const noexcept override { return poller_.status(); }
  std::vector<std::string> take_messages() override { return poller_.take_messages(); }

 private:
  image::CycleSide cycle_;
  Poller poller_;  // last member: its thread ends before what it uses is destroyed
};

}  // namespace

LinkResult open_client_link(ClientParts parts, const LinkSettings& settings, const tables::PlantTables& tables,
                            const plant::Plant* plant) {
  try {
    std::string note = unreachable_text(parts.unreachable, tables);
    return std::make_unique<ClientLink>(std::move(parts), std::move(note), settings, tables, plant);
  } catch (const std::system_error& error) {
    return LinkError{LinkError::Kind::environment, std::string("cannot start the link's thread: ") + error.what()};
  }
}

}  // namespace symplant::link::client
