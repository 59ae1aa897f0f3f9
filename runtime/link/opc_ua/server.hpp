// An OPC UA server of a plant, and the thread that serves its clients.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "symplant/link/image/images.hpp"
#include "symplant/link/image/position_set.hpp"
#include "symplant/link/image/rewriting.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/opc_ua/address_space.hpp"
#include "symplant/link/opc_ua/malfunction_index.hpp"
#include "symplant/link/opc_ua/messages.hpp"
#include "symplant/link/opc_ua/server_config.hpp"
#include "symplant/link/opc_ua/sessions.hpp"
#include "symplant/link/opc_ua/variables.hpp"
#include "symplant/share/ring.hpp"

namespace symplant::link::opc_ua {

/// Which of its points clients have read (or monitor) and written.
struct Touched {
  image::PositionSet read;
  image::PositionSet written;
};

/// Serves clients from start() to its destruction, in a separate thread that takes no signals; open62541 is used by
/// that thread only. All other members are for any thread unless noted.
class Server {
 public:
  /// What the server shows. All of it must outlive the server.
  struct Shown {
    const tables::PlantTables& tables;
    const image::Map& map;
    image::Images& images;
    PlantImage& plant;
    std::uint64_t model_hash;
    bool initial;  ///< as for Variables
  };

  /// A server at settings.address, whose port may be 0: any free port. May take a second for a certificate.
  static std::variant<std::unique_ptr<Server>, LinkError> start(ServerSettings settings, const LinkSettings& link,
                                                                const Shown& shown);

  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server();

  const net::HostPort& bound() const noexcept { return bound_; }

  /// While it is cut, nothing is read from clients and nothing is sent to them. Wait-free.
  void cut(bool on) noexcept { cut_.store(on, std::memory_order_relaxed); }
  /// Number of signs of life: reads and writes of symbols, and looks at a client with a subscription that lives.
  std::uint64_t heard() const noexcept { return heard_.load(std::memory_order_acquire); }
  /// Sets the number of losses so far.
  void lost(std::uint32_t losses) noexcept { losses_.store(losses, std::memory_order_relaxed); }
  LinkStatus status() const noexcept;
  std::vector<std::string> take_messages() { return messages_.take(); }

  /// As Link::take_command(). For the cycle's thread.
  std::optional<LinkCommand> take_command(bool frozen) noexcept;

  /// By point of the map. To be called after stop().
  const Touched& touched() const noexcept { return touched_; }
  /// Ends the thread. Idempotent; not for two threads at a time.
  void stop();

 private:
  Server(const Shown& shown, net::HostPort bound);

  std::optional<LinkError> prepare(const ServerSettings& settings, const LinkSettings& link);
  static NodeCallbacks callbacks();
  void serve();
  void publish_writes();
  bool write_changes();
  void look_at_sessions();
  void forget_operations();

  // What clients do.
  void on_read(const Variable& variable) noexcept;
  UA_StatusCode on_write(Variable& variable, const UA_NumericRange* range, const UA_DataValue& value);
  UA_StatusCode on_malfunction(const UA_Variant& name, LinkCommand::Kind kind);
  UA_StatusCode command(LinkCommand command) noexcept;
  UA_StatusCode freezing(LinkCommand given);
  UA_StatusCode start_malfunction(const UA_Variant* inputs, UA_Variant* outputs);
  UA_StatusCode end_malfunction(const UA_Variant* inputs, UA_Variant* outputs);
  UA_StatusCode freeze(const UA_Variant* inputs, UA_Variant* outputs);
  UA_StatusCode run(const UA_Variant* inputs, UA_Variant* outputs);
  UA_StatusCode step(const UA_Variant* inputs, UA_Variant* outputs);

  static Server& of(UA_Server* server) { return *static_cast<Server*>(access_of(server).owner); }
  static UA_StatusCode read(UA_Server* server, const UA_NodeId* session, void* session_context, const UA_NodeId* node,
                            void* context, UA_Boolean with_time, const UA_NumericRange* range, UA_DataValue* value);
  static UA_StatusCode write(UA_Server* server, const UA_NodeId* session, void* session_context, const UA_NodeId* node,
                             void* context, const UA_NumericRange* range, const UA_DataValue* value);
  static void monitored(UA_Server* server, const UA_NodeId* session, void* session_context, const UA_NodeId* node,
                        void* context, UA_UInt32 attribute, UA_Boolean removed);
  template <auto act>
  static UA_StatusCode call(UA_Server* server, const UA_NodeId* session, void* session_context, const UA_NodeId* method,
                            void* method_context, const UA_NodeId* object, void* object_context,
                            std::size_t inputs_size, const UA_Variant* inputs, std::size_t outputs_size,
                            UA_Variant* outputs);

  const Shown shown_;
  const net::HostPort bound_;
  Messages messages_;
  ServerAccess access_;
  Variables variables_;
  PlantNodes nodes_;
  std::vector<std::string> ids_;  ///< of the nodes of all variables
  MalfunctionIndex malfunctions_;
  image::Rewriting rewriting_;
  image::PositionSet all_bits_;
  image::PositionSet all_numbers_;
  Touched touched_;
  share::Ring<LinkCommand> commands_;
  bool own_access_ = true;  ///< the server itself reads or writes its nodes, no client
  bool serving_ = false;    ///< all nodes are there
  bool written_ = false;    ///< a client has written since the last publish_writes()
  bool freezes_ = false;    ///< a client froze or stepped the plant, and none has let it run since
  Sessions sessions_;
  OwnedServer server_;

  using Count = std::atomic<std::uint64_t>;
  Count heard_{0};
  Count requests_{0};
  Count refused_{0};  ///< writes and calls
  Count crowded_out_{0};
  std::atomic<std::uint32_t> connections_{0};
  std::atomic<std::uint32_t> losses_{0};
  std::atomic<bool> frozen_otherwise_{false};
  std::atomic<bool> cut_{false};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace symplant::link::opc_ua
