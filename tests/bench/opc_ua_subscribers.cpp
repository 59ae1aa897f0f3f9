// Clients of an OPC UA server that subscribe to all nodes of a file, and the time from a write to its effect.
// usage: opc_ua_subscribers ENDPOINT NAMES SUBSCRIBERS SECONDS
// NAMES: a file with a node id of namespace 2 in each line. Prints the reported values per second; of 200 writes of
// L_P_CYL_O_ADV and L_P_CYL_O_RET the time until a read of L_P_CYL_I_ADV shows their effect.
#include <open62541/client.h>
#include <open62541/client_config_default.h>
#include <open62541/client_highlevel.h>
#include <open62541/client_subscriptions.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

struct Delete {
  void operator()(UA_Client* client) const noexcept { UA_Client_delete(client); }
};
using Client = std::unique_ptr<UA_Client, Delete>;

Client connected(const char* endpoint) {
  static UA_Logger silent{nullptr, nullptr, nullptr};
  UA_ClientConfig config{};
  config.logging = &silent;
  UA_ClientConfig_setDefault(&config);
  Client client(UA_Client_newWithConfig(&config));
  if (UA_Client_connect(client.get(), endpoint) != UA_STATUSCODE_GOOD) std::exit(1);
  return client;
}

UA_NodeId node(const std::string& name) {
  UA_NodeId id = UA_NODEID_NULL;
  id.namespaceIndex = 2;
  id.identifierType = UA_NODEIDTYPE_STRING;
  id.identifier.string = {name.size(), reinterpret_cast<UA_Byte*>(const_cast<char*>(name.data()))};
  return id;
}

void count(UA_Client*, UA_UInt32, void*, UA_UInt32, void* context, UA_DataValue*) {
  static_cast<std::atomic<std::uint64_t>*>(context)->fetch_add(1, std::memory_order_relaxed);
}

void subscribe(UA_Client* client, const std::vector<std::string>& names, std::atomic<std::uint64_t>& values) {
  UA_CreateSubscriptionRequest request = UA_CreateSubscriptionRequest_default();
  request.requestedPublishingInterval = 10;
  const auto subscription = UA_Client_Subscriptions_create(client, request, nullptr, nullptr, nullptr);
  std::vector<UA_MonitoredItemCreateRequest> items;
  for (const std::string& name : names) {
    items.push_back(UA_MonitoredItemCreateRequest_default(node(name)));
    items.back().requestedParameters.samplingInterval = 10;
    items.back().requestedParameters.queueSize = 1;
  }
  UA_CreateMonitoredItemsRequest create;
  UA_CreateMonitoredItemsRequest_init(&create);
  create.subscriptionId = subscription.subscriptionId;
  create.timestampsToReturn = UA_TIMESTAMPSTORETURN_SOURCE;
  create.itemsToCreate = items.data();
  create.itemsToCreateSize = items.size();
  std::vector<void*> contexts(items.size(), &values);
  std::vector<UA_Client_DataChangeNotificationCallback> callbacks(items.size(), count);
  std::vector<UA_Client_DeleteMonitoredItemCallback> deleted(items.size(), nullptr);
  auto created =
      UA_Client_MonitoredItems_createDataChanges(client, create, contexts.data(), callbacks.data(), deleted.data());
  if (created.resultsSize != items.size()) std::exit(1);
  UA_CreateMonitoredItemsResponse_clear(&created);
}

bool read(UA_Client* client, const std::string& name) {
  UA_Variant value;
  UA_Variant_init(&value);
  UA_Client_readValueAttribute(client, node(name), &value);
  const bool on = UA_Variant_hasScalarType(&value, &UA_TYPES[UA_TYPES_BOOLEAN]) && *static_cast<bool*>(value.data);
  UA_Variant_clear(&value);
  return on;
}

void write(UA_Client* client, const std::string& name, bool on) {
  UA_Variant value;
  UA_Variant_init(&value);
  UA_Variant_setScalar(&value, &on, &UA_TYPES[UA_TYPES_BOOLEAN]);
  UA_Client_writeValueAttribute(client, node(name), &value);
}

void print_effects(const char* endpoint) {
  const Client client = connected(endpoint);
  std::vector<double> times;
  for (int i = 0; i < 200; ++i) {
    const bool out = i % 2 == 0;
    write(client.get(), out ? "L_P_CYL_O_RET" : "L_P_CYL_O_ADV", false);
    const auto begin = Clock::now();
    write(client.get(), out ? "L_P_CYL_O_ADV" : "L_P_CYL_O_RET", true);
    while (read(client.get(), "L_P_CYL_I_ADV") != out) std::this_thread::sleep_for(std::chrono::microseconds(200));
    times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    std::this_thread::sleep_for(std::chrono::milliseconds(7 + i % 11));
  }
  std::sort(times.begin(), times.end());
  std::printf("from a write to its effect, in ms: p50 %.1f, p95 %.1f, max %.1f\n", times[100], times[190], times[199]);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return std::fprintf(stderr, "usage: opc_ua_subscribers ENDPOINT NAMES SUBSCRIBERS SECONDS\n"), 2;
  std::vector<std::string> names;
  std::ifstream file(argv[2]);
  for (std::string name; std::getline(file, name);) names.push_back(name);
  std::atomic<std::uint64_t> values{0};
  std::atomic<int> ready{0};
  std::atomic<bool> stop{false};
  std::vector<std::jthread> threads;
  const int subscribers = std::atoi(argv[3]);
  for (int i = 0; i < subscribers; ++i) {
    threads.emplace_back([&] {
      const Client client = connected(argv[1]);
      subscribe(client.get(), names, values);
      ++ready;
      while (!stop) UA_Client_run_iterate(client.get(), 10);
    });
  }
  while (ready < subscribers) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const std::uint64_t before = values;
  const auto begin = Clock::now();
  std::this_thread::sleep_for(std::chrono::duration<double>(std::atof(argv[4])));
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  std::printf("%d subscribers to %zu nodes: %.0f values per second\n", subscribers, names.size(),
              static_cast<double>(values - before) / seconds);
  print_effects(argv[1]);
  stop = true;
  return 0;
}
