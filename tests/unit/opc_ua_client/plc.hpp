// A PLC that is an OPC UA server of open62541 in this process: nodes ns=1;s="NAME".
#pragma once

#include <open62541/server.h>
#include <open62541/server_config_default.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <variant>

#include "symplant/link/net/listener.hpp"
#include "symplant/link/opc_ua/open62541.hpp"

namespace symplant::test {

class OpcUaPlc {
 public:
  /// Listens on a free port of the loopback; `limit`: nodes in a request.
  explicit OpcUaPlc(std::uint32_t limit = 0, std::uint16_t port = 0) : port_(port == 0 ? free_port() : port) {
    UA_ServerConfig config{};
    config.logging = link::opc_ua::silent();
    UA_ServerConfig_setMinimal(&config, port_, nullptr);
    config.maxNodesPerRead = limit;
    config.maxNodesPerWrite = limit;
    config.maxNodesPerRegisterNodes = limit;
    intercept_answers(config);
    server_ = UA_Server_newWithConfig(&config);
    UA_Server_run_startup(server_);
    thread_ = std::thread([this] {
      while (!ended_) {
        {
          const std::scoped_lock lock(mutex_);
          if (!silent_) UA_Server_run_iterate(server_, false);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    });
  }
  ~OpcUaPlc() {
    ended_ = true;
    thread_.join();
    UA_Server_run_shutdown(server_);
    UA_Server_delete(server_);
  }
  OpcUaPlc(const OpcUaPlc&) = delete;
  OpcUaPlc& operator=(const OpcUaPlc&) = delete;

  std::uint16_t port() const { return port_; }
  /// While it is silent it answers nothing.
  void silent(bool on) { silent_ = on; }

  /// The answer to the Read request of this number from now on, the first is 1, has this result.
  void fail_read(int number, UA_StatusCode result) {
    const std::scoped_lock lock(mutex_);
    reads_left_ = number;
    failure_ = result;
  }

  /// A variable of the type UA_TYPES[type].
  template <class T>
  void add(const std::string& name, std::size_t type, T value, bool writable = true) {
    const std::scoped_lock lock(mutex_);
    UA_VariableAttributes attributes = UA_VariableAttributes_default;
    UA_Variant_setScalar(&attributes.value, &value, &UA_TYPES[type]);
    attributes.dataType = UA_TYPES[type].typeId;
    attributes.valueRank = UA_VALUERANK_SCALAR;
    attributes.accessLevel = UA_ACCESSLEVELMASK_READ | (writable ? UA_ACCESSLEVELMASK_WRITE : 0);
    UA_Server_addVariableNode(server_, id(name), UA_NODEID_NUMERIC(0, UA_NS0ID_OBJECTSFOLDER),
                              UA_NODEID_NUMERIC(0, UA_NS0ID_ORGANIZES), {1, link::opc_ua::view_of(name)},
                              UA_NODEID_NUMERIC(0, UA_NS0ID_BASEDATAVARIABLETYPE), attributes, nullptr, nullptr);
  }
  void remove(const std::string& name) {
    const std::scoped_lock lock(mutex_);
    UA_Server_deleteNode(server_, id(name), true);
  }
  template <class T>
  void set(const std::string& name, std::size_t type, T value, UA_StatusCode status = UA_STATUSCODE_GOOD) {
    const std::scoped_lock lock(mutex_);
    UA_WriteValue write{};
    write.nodeId = id(name);
    write.attributeId = UA_ATTRIBUTEID_VALUE;
    write.value.hasValue = true;
    UA_Variant_setScalar(&write.value.value, &value, &UA_TYPES[type]);
    write.value.hasStatus = true;
    write.value.status = status;
    UA_Server_write(server_, &write);
  }
  template <class T>
  T get(const std::string& name) {
    const std::scoped_lock lock(mutex_);
    link::opc_ua::OwnedVariant value;
    UA_Server_readValue(server_, id(name), value.get());
    return value->data == nullptr ? T{} : *static_cast<const T*>(value->data);
  }

 private:
  using Send = decltype(UA_ConnectionManager::sendWithConnection);

  void intercept_answers(const UA_ServerConfig& config) {
    for (UA_EventSource* source = config.eventLoop->eventSources; source != nullptr; source = source->next) {
      if (source->eventSourceType != UA_EVENTSOURCETYPE_CONNECTIONMANAGER) continue;
      auto* const manager = reinterpret_cast<UA_ConnectionManager*>(source);
      if (link::opc_ua::text_of(manager->protocol) != "tcp") continue;
      original_send_ = std::exchange(manager->sendWithConnection, send);
    }
    reads_left_ = 0;
  }
  /// Changes the result in an answer without security.
  static UA_StatusCode send(UA_ConnectionManager* manager, uintptr_t connection, const UA_KeyValueMap* parameters,
                            UA_ByteString* message) {
    constexpr std::size_t kType = 26;
    constexpr std::size_t kResult = 40;
    constexpr std::uint16_t kReadResponse = UA_NS0ID_READRESPONSE_ENCODING_DEFAULTBINARY;
    if (message->length >= kResult + sizeof failure_ &&
        std::memcmp(message->data + kType, &kReadResponse, sizeof kReadResponse) == 0 && --reads_left_ == 0) {
      std::memcpy(message->data + kResult, &failure_, sizeof failure_);
    }
    return original_send_(manager, connection, parameters, message);
  }
  inline static Send original_send_ = nullptr;
  inline static int reads_left_ = 0;  ///< until the one that fails
  inline static UA_StatusCode failure_ = UA_STATUSCODE_GOOD;

  static std::uint16_t free_port() {
    auto listener = link::net::listen_on({"127.0.0.1", 0});
    return std::get<link::net::Listener>(listener).bound.port;
  }
  /// Valid until the next call.
  UA_NodeId id(const std::string& name) {
    text_ = "\"" + name + "\"";
    return link::opc_ua::string_node(1, text_);
  }

  const std::uint16_t port_;
  UA_Server* server_ = nullptr;
  std::string text_;
  std::mutex mutex_;
  std::atomic<bool> silent_{false};
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace symplant::test
