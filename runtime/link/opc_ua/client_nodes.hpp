// The nodes of one direction on a connection: which of them can be exchanged, and as what; only for .cpp files of this
// folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/opc_ua/client_connection.hpp"
#include "symplant/link/opc_ua/client_map.hpp"
#include "symplant/link/opc_ua/open62541.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::opc_ua {

/// What a server allows in one request; 0: any number of nodes.
struct OperationLimits {
  std::uint32_t read = 0;
  std::uint32_t write = 0;
  std::uint32_t register_nodes = 0;
};

/// The namespaces of a server, by number.
using Namespaces = std::vector<std::string>;

class ClientNodes {
 public:
  /// `writes`: they are written, otherwise only read.
  ClientNodes(std::vector<ClientNode> nodes, bool writes);

  /// Looks at those nodes that cannot be exchanged yet, after forget() at all of them.
  client::Fault resolve(ClientConnection& connection, const Namespaces& namespaces, OperationLimits& limits);
  /// A new connection: nothing is known.
  void forget();

  std::size_t size() const noexcept { return nodes_.size(); }
  const ClientNode& node(std::size_t i) const { return nodes_[i]; }
  /// Whether it was found on this connection, has the right type, and can be read.
  bool is_readable(std::size_t i) const { return states_[i].readable; }
  /// The same for what the link does with it: an event is written.
  bool is_usable(std::size_t i) const { return writes_ ? states_[i].writable : states_[i].readable; }
  const UA_NodeId& id(std::size_t i) const { return *states_[i].id; }
  /// The type of its values: that of the symbol, or the one with a sign of the same size.
  tables::DataType type(std::size_t i) const { return states_[i].type; }
  /// Why it cannot be exchanged, or the bad status of its latest value; good otherwise.
  UA_StatusCode status(std::size_t i) const { return states_[i].status; }
  /// For how long: 0 at the first call after that began.
  tables::Time bad_for(std::size_t i, tables::Time now);
  bool any_unusable() const;

  /// The number of a value that was read; nothing, and its status is noted, if it is bad or of another type.
  std::optional<std::uint64_t> take(std::size_t i, const UA_DataValue& value);
  /// The status of writing it. `detail`: more words on it.
  void note(std::size_t i, UA_StatusCode status, std::string detail = {});
  /// The messages on statuses that are new since the last call.
  std::vector<client::Rejection> take_rejections();

 private:
  struct State {
    bool readable = false;
    bool writable = false;
    OwnedNodeId id;
    tables::DataType type = tables::DataType::boolean;
    UA_StatusCode status = UA_STATUSCODE_GOOD;
    std::optional<tables::Time> since;  ///< of the first bad_for() with this status
    UA_StatusCode announced = UA_STATUSCODE_GOOD;
    std::string detail;  ///< "the symbol is INT, the node Float"
  };
  bool make_id(std::size_t i, const Namespaces& namespaces);
  client::Fault examine(ClientConnection& connection, std::span<const std::size_t> some, OperationLimits& limits);
  void judge(std::size_t i, std::span<const OwnedDataValue> attributes);
  bool has_type(std::size_t i, std::span<const OwnedDataValue> attributes);
  client::Fault register_nodes(ClientConnection& connection, std::span<const std::size_t> some,
                               OperationLimits& limits);
  std::string words_of(UA_StatusCode status, std::span<const std::size_t> some) const;

  std::vector<ClientNode> nodes_;
  const bool writes_;
  std::vector<State> states_;
};

}  // namespace symplant::link::opc_ua
