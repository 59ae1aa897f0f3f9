// A plant with a link `opc-ua-server`, cycled by a thread, and a client of open62541.
#pragma once

#include <open62541/client.h>
#include <open62541/client_config_default.h>
#include <open62541/client_highlevel.h>
#include <open62541/client_subscriptions.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "support/catch.hpp"
#include "support/described_plant.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/opc_ua/open62541.hpp"
#include "symplant/plant/owned_plant.hpp"

namespace symplant::test {

/// Asks until the answer is yes, or 30 s are over: the speed of the machine is not known.
inline bool soon(const std::function<bool()>& ask) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (!ask()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

class ServedPlant {
 public:
  explicit ServedPlant(const tables::PlantTables& tables, const std::string& settings = "",
                       link::LinkSettings link_settings = {})
      : plant_(tables) {
    plant_.reset();
    auto result = link::open_link({"opc-ua-server://127.0.0.1:0" + settings, 0, link_settings}, tables, &plant_);
    if (auto* error = std::get_if<link::LinkError>(&result)) FAIL(error->message);
    link_ = std::move(std::get<std::unique_ptr<link::Link>>(result));
  }
  ~ServedPlant() { pause(); }
  ServedPlant(const ServedPlant&) = delete;
  ServedPlant& operator=(const ServedPlant&) = delete;

  /// Cycles of 1 ms of plant time, until pause().
  void run() {
    stop_ = false;
    cycling_ = std::thread([this] {
      while (!stop_) {
        cycle();
        std::this_thread::sleep_for(std::chrono::microseconds(200));
      }
    });
  }
  void pause() {
    stop_ = true;
    if (cycling_.joinable()) cycling_.join();
  }
  void cycle() {
    link_->read_operations(plant_, link_time_ += tables::kMillisecond);
    while (const auto command = link_->take_command(frozen_)) {
      using Kind = link::LinkCommand::Kind;
      if (command->kind == Kind::start_malfunction) plant_.start_malfunction(command->of);
      if (command->kind == Kind::end_malfunction) plant_.stop_malfunction(command->of);
      commands_.push_back(*command);
    }
    plant_.advance_to(plant_.now() + tables::kMillisecond);
    link_->write_events(plant_, {.cycles = cycles_++});
    plant_.forget_changed_events();
    state_ = link_->state();
  }

  link::Link& link() { return *link_; }
  exec::LinkState state() const { return state_; }
  /// Only while it is paused.
  plant::Plant& plant() { return plant_; }
  const std::vector<link::LinkCommand>& commands() const { return commands_; }
  /// Something other than the link freezes the plant.
  void freeze_otherwise() { frozen_ = true; }
  std::string endpoint() const {
    const std::string url = link_->url();
    return "opc.tcp" + url.substr(url.find(':'));
  }

 private:
  plant::OwnedPlant plant_;
  std::unique_ptr<link::Link> link_;
  tables::Time link_time_ = 0;
  std::uint64_t cycles_ = 0;
  std::vector<link::LinkCommand> commands_;
  std::atomic<exec::LinkState> state_{exec::LinkState::waiting};
  std::atomic<bool> frozen_{false};
  std::atomic<bool> stop_{true};
  std::thread cycling_;
};

class UaClient {
 public:
  /// Anonymous, without security.
  explicit UaClient(const std::string& endpoint) : client_(made()) {
    REQUIRE(UA_Client_connect(client_.get(), endpoint.c_str()) == UA_STATUSCODE_GOOD);
  }

  UA_Client* get() { return client_.get(); }

  link::opc_ua::OwnedDataValue read(const std::string& name, UA_AttributeId attribute = UA_ATTRIBUTEID_VALUE) {
    UA_ReadValueId id;
    UA_ReadValueId_init(&id);
    id.nodeId = node(name);
    id.attributeId = attribute;
    UA_ReadRequest request;
    UA_ReadRequest_init(&request);
    request.nodesToRead = &id;
    request.nodesToReadSize = 1;
    request.timestampsToReturn = UA_TIMESTAMPSTORETURN_BOTH;
    UA_ReadResponse response = UA_Client_Service_read(client_.get(), request);
    link::opc_ua::OwnedDataValue result;
    if (response.resultsSize == 1) {
      std::swap(*result, *response.results);
    } else {
      result->status = response.responseHeader.serviceResult;
    }
    UA_ReadResponse_clear(&response);
    return result;
  }
  /// The value of a scalar of type T, whatever its status.
  template <class T>
  T value(const std::string& name) {
    const auto read_value = read(name);
    REQUIRE(UA_Variant_isScalar(&read_value->value));
    REQUIRE(read_value->value.type->memSize == sizeof(T));
    return *static_cast<const T*>(read_value->value.data);
  }
  std::string text(const std::string& name) {
    const auto read_value = read(name);
    REQUIRE(read_value->value.type == &UA_TYPES[UA_TYPES_STRING]);
    return std::string(link::opc_ua::text_of(*static_cast<const UA_String*>(read_value->value.data)));
  }
  UA_StatusCode status(const std::string& name) { return read(name)->status; }

  template <class T>
  UA_StatusCode write(const std::string& name, std::size_t type, T value) {
    UA_Variant variant;
    UA_Variant_setScalar(&variant, &value, &UA_TYPES[type]);
    return UA_Client_writeValueAttribute(client_.get(), node(name), &variant);
  }

  UA_StatusCode write(UA_WriteValue& value) {
    UA_WriteRequest request;
    UA_WriteRequest_init(&request);
    request.nodesToWrite = &value;
    request.nodesToWriteSize = 1;
    UA_WriteResponse response = UA_Client_Service_write(client_.get(), request);
    const UA_StatusCode status = response.resultsSize == 1 ? *response.results : response.responseHeader.serviceResult;
    UA_WriteResponse_clear(&response);
    return status;
  }

  /// Calls a method of the plant. `outputs` may be null.
  UA_StatusCode call(const std::string& method, std::vector<UA_Variant> inputs,
                     link::opc_ua::OwnedVariant* output = nullptr) {
    std::size_t count = 0;
    UA_Variant* outputs = nullptr;
    const UA_StatusCode status = UA_Client_call(client_.get(), node("/plant"), node("/plant/" + method), inputs.size(),
                                                inputs.data(), &count, &outputs);
    if (output != nullptr && count == 1) std::swap(**output, *outputs);
    UA_Array_delete(outputs, count, &UA_TYPES[UA_TYPES_VARIANT]);
    return status;
  }

  static UA_NodeId node(const std::string& name) { return link::opc_ua::string_node(2, name); }
  static UA_Client* made() {
    UA_ClientConfig config{};
    config.logging = link::opc_ua::silent();
    UA_ClientConfig_setDefault(&config);
    return UA_Client_newWithConfig(&config);
  }

 private:
  struct Delete {
    void operator()(UA_Client* client) const noexcept { UA_Client_delete(client); }
  };
  std::unique_ptr<UA_Client, Delete> client_;
};

}  // namespace symplant::test
