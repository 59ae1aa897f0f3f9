// A session with a PLC's OPC UA server; only for .cpp files of this folder.
#pragma once

#include <open62541/client.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/opc_ua/client_security.hpp"
#include "symplant/link/opc_ua/client_settings.hpp"
#include "symplant/link/opc_ua/open62541.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::opc_ua {

/// One session at a time. Each call ends at a deadline or by interrupt(). Used by one thread; interrupt() by any.
class ClientConnection {
 public:
  ClientConnection(const ClientSettings& settings, ClientSecurity security);
  ClientConnection(const ClientConnection&) = delete;
  ClientConnection& operator=(const ClientConnection&) = delete;
  ~ClientConnection();

  std::string url() const;

  /// Asks the server for its endpoints, chooses the one that the settings ask for, connects and logs in. May wait for a
  /// name server before it looks at the time.
  client::Fault open();
  void close() noexcept;
  void interrupt() noexcept { interrupted_.store(true, std::memory_order_relaxed); }

  /// Sends a request of UA_TYPES[request_type] and waits for its answer. A fault is always one of the transport or an
  /// interruption. A server that does not do the request as a whole answers with a bad status, which is the result.
  template <class Request, class Response, std::size_t type>
  client::Fault call(const Request& request, std::size_t request_type, Owned<Response, type>& response,
                     UA_StatusCode& result) {
    response = {};
    client::Fault fault = transact(&request, UA_TYPES[request_type], response.get(), UA_TYPES[type]);
    result = response->responseHeader.serviceResult;
    return fault;
  }

  /// The name that the server has for itself; empty if it gives none.
  const std::string& application() const noexcept { return application_; }
  /// What is known of the server's certificate, for the user; empty without security.
  const std::string& security_note() const noexcept { return security_.note(); }
  /// Of the latest request that was answered, by the steady clock in ns: before it was sent, and when its answer was
  /// complete.
  tables::Time sent() const noexcept { return sent_; }
  tables::Time answered() const noexcept { return at_; }
  /// Number of answered requests. Any thread.
  std::uint64_t requests() const noexcept { return requests_.load(std::memory_order_relaxed); }

 private:
  using Clock = std::chrono::steady_clock;
  using Endpoints = Owned<UA_GetEndpointsResponse, UA_TYPES_GETENDPOINTSRESPONSE>;
  struct Delete {
    void operator()(UA_Client* client) const noexcept { UA_Client_delete(client); }
  };
  /// The request that waits for its answer. Null responses: the answer comes too late to be of use.
  struct Pending {
    void* response = nullptr;
    std::size_t size = 0;
    bool done = false;
  };
  enum class Waited : std::uint8_t { done, timeout, lost, interrupted };

  static void receive(UA_Client* client, void* connection, UA_UInt32 request, void* response);
  static void watch(UA_Client* client, UA_SecureChannelState channel, UA_SessionState session, UA_StatusCode status);

  static UA_StatusCode open_socket(UA_ConnectionManager* manager, const UA_KeyValueMap* parameters, void* client,
                                   void* context, UA_ConnectionManager_connectionCallback callback);
  static void take_event(UA_ConnectionManager* manager, uintptr_t socket, void* client, void** context,
                         UA_ConnectionState state, const UA_KeyValueMap* parameters, UA_ByteString message);

  client::Fault prepare();
  void take_over_sockets(UA_ClientConfig& config);
  client::Fault connect();
  client::Fault find_server(Endpoints& endpoints);
  client::Fault ask_endpoints(Endpoints& endpoints);
  client::Fault start(const UA_EndpointDescription& endpoint, const UA_UserTokenPolicy* token);
  client::Fault transact(const void* request, const UA_DataType& request_type, void* response,
                         const UA_DataType& response_type);
  template <class Done>
  Waited wait(Done done, Clock::time_point deadline);
  client::Fault failed(Waited waited, const std::string& doing);
  void explain(client::Fault& fault) const;
  client::Fault lost(std::string message);
  UA_StatusCode closed_again() const;
  std::string endpoint_url() const;

  const ClientSettings settings_;
  ClientSecurity security_;
  std::unique_ptr<UA_Client, Delete> client_;
  bool healthy_ = false;                                ///< the server has answered everything so far
  std::string numeric_host_;                            ///< the address of the host
  Clock::time_point until_ = Clock::time_point::max();  ///< while it connects, the end of that
  UA_StatusCode status_ = UA_STATUSCODE_GOOD;
  bool is_secure_ = false;                                         ///< the connection that is made
  int attempts_ = 0;                                               ///< at this connection
  decltype(UA_ConnectionManager::openConnection) open_ = nullptr;  ///< of open62541
  UA_ConnectionManager_connectionCallback callback_ = nullptr;     ///< of open62541
  Pending pending_;
  std::string application_;
  tables::Time sent_ = 0;
  tables::Time at_ = 0;
  std::atomic<std::uint64_t> requests_{0};
  std::atomic<bool> interrupted_{false};
};

}  // namespace symplant::link::opc_ua
