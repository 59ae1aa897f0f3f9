// The conversation with a PLC that is an OPC UA server; only for .cpp files of this folder.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/opc_ua/client_connection.hpp"
#include "symplant/link/opc_ua/client_map.hpp"
#include "symplant/link/opc_ua/client_nodes.hpp"
#include "symplant/link/opc_ua/client_security.hpp"
#include "symplant/link/opc_ua/client_settings.hpp"

namespace symplant::link::opc_ua {

class ClientDialog final : public client::Dialog {
 public:
  /// `reads_only`: the events are read, too, and never written.
  ClientDialog(const ClientSettings& settings, ClientSecurity security, ClientMap map, bool reads_only);

  std::string url() const override { return connection_.url(); }
  client::Fault open() override;
  void close() noexcept override { connection_.close(); }
  /// OPC UA has nothing to compare: always unverifiable. Looks at all nodes.
  client::Identity identify(client::Fault& fault) override;
  /// One request for all nodes, unless the server limits their number. A node whose value is bad keeps its former one.
  client::Fault read(const client::Words& operations, tables::Time now) override;
  client::Fault write(std::span<const client::LaneChange> changes, std::vector<client::Unwritten>& unwritten) override;
  client::Fault read_back(const client::Words& events, tables::Time now) override;
  void observe(client::ReadObserver* observer) noexcept override { observer_ = observer; }
  void retry_rejected() noexcept override { next_look_ = 0; }
  bool is_dividing() const noexcept override { return false; }
  std::vector<client::Rejection> take_rejections() override;
  std::vector<client::LeftOut> take_left_out() override;
  std::string functions() const override;
  void interrupt() noexcept override { connection_.interrupt(); }
  std::uint64_t requests() const noexcept override { return connection_.requests(); }
  std::uint64_t rejected() const noexcept override { return rejected_.load(std::memory_order_relaxed); }

 private:
  static constexpr std::size_t kNoNode = static_cast<std::size_t>(-1);
  /// A node to be written, and the changes that it comes from.
  struct Writing {
    std::size_t node;
    std::uint64_t number;
    std::size_t first;  ///< of the changes
    std::size_t count;
    std::uint16_t mask;  ///< of the change of a bit
  };

  static std::vector<std::size_t> by_position(const ClientNodes& nodes, Plane plane, std::uint32_t size);
  client::Fault prepare();
  client::Fault ask_server();
  client::Fault look_again(tables::Time now);
  client::Fault read_all(ClientNodes& nodes, const client::Words& out);
  bool take(ClientNodes& nodes, std::span<const std::size_t> some, std::span<const UA_DataValue> values,
            const client::Words& out);
  client::Fault keep_alive();
  void leave_out(tables::Time now);
  std::vector<Writing> writings_of(std::span<const client::LaneChange> changes);
  void refuse(const Writing& writing, UA_StatusCode status, std::span<const client::LaneChange> changes,
              std::vector<client::Unwritten>& unwritten);
  client::Fault write_some(std::span<const Writing> some, std::span<const client::LaneChange> changes,
                           std::vector<client::Unwritten>& unwritten, UA_StatusCode& result);

  ClientConnection connection_;
  ClientNodes operations_;
  ClientNodes events_;
  std::vector<std::size_t> event_of_bit_;     ///< by position; kNoNode
  std::vector<std::size_t> event_of_number_;  ///< by position; kNoNode
  std::vector<std::uint64_t> numbers_;        ///< of events, as written last
  bool prepared_ = false;                     ///< the server was asked on this connection
  Namespaces namespaces_;
  OperationLimits limits_;
  std::string identity_;
  std::optional<tables::Time> next_look_;  ///< at the nodes that could not be exchanged; nothing before a reading
  tables::Time look_pause_ = 0;
  std::vector<bool> reported_out_;  ///< by operation: it was reported as left out
  std::vector<client::LeftOut> left_out_;
  client::ReadObserver* observer_ = nullptr;
  std::atomic<std::uint64_t> rejected_{0};
};

}  // namespace symplant::link::opc_ua
