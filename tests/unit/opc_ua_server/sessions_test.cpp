// The sessions of the OPC UA server, from look to look.
#include "symplant/link/opc_ua/sessions.hpp"

#include "symplant/link/net/listener.hpp"
#include "symplant/link/opc_ua/server_config.hpp"
#include "unit/opc_ua_server/served_plant.hpp"

using namespace symplant;
using link::opc_ua::Sessions;
using test::UaClient;
using namespace std::chrono_literals;

namespace {

/// A server without nodes, for one session. The thread of a test uses it between serve() calls.
class SmallServer {
 public:
  SmallServer() {
    auto listener = link::net::listen_on({"127.0.0.1", 0});
    settings_.address = std::get<link::net::Listener>(listener).bound;
    listener = link::LinkError{};  // closes it
    auto made = link::opc_ua::make_server(settings_, {}, "small", access_);
    server_ = std::move(std::get<link::opc_ua::OwnedServer>(made));
    UA_Server_getConfig(server_.get())->maxSessions = 1;
    REQUIRE(UA_Server_run_startup(server_.get()) == UA_STATUSCODE_GOOD);
  }
  ~SmallServer() { UA_Server_run_shutdown(server_.get()); }
  SmallServer(const SmallServer&) = delete;
  SmallServer& operator=(const SmallServer&) = delete;

  /// Serves clients while `act` runs.
  void serve(const std::function<void()>& act) {
    std::atomic<bool> stop{false};
    std::thread serving([&] {
      while (!stop) UA_Server_run_iterate(server_.get(), false);
    });
    act();
    stop = true;
    serving.join();
  }
  UA_Server* get() { return server_.get(); }
  std::string endpoint() const { return "opc.tcp://" + link::net::format_host_port(settings_.address); }

 private:
  link::opc_ua::ServerSettings settings_;
  link::opc_ua::Messages messages_;
  link::opc_ua::ServerAccess access_{messages_, std::nullopt, nullptr};
  link::opc_ua::OwnedServer server_;
};

}  // namespace

TEST_CASE("A session that has been silent makes room for another client when all are taken") {
  SmallServer server;
  Sessions sessions;
  const auto begin = Sessions::Clock::now();
  std::unique_ptr<UaClient> first;
  server.serve([&] { first = std::make_unique<UaClient>(server.endpoint()); });
  CHECK(sessions.look(server.get(), begin).open == 1);
  UA_Client* const second = UaClient::made();
  server.serve(
      [&] { CHECK(UA_Client_connect(second, server.endpoint().c_str()) == UA_STATUSCODE_BADTOOMANYSESSIONS); });
  UA_Client_delete(second);
  CHECK(sessions.look(server.get(), begin + Sessions::kAbandoned).refused == 1);
  CHECK(sessions.look(server.get(), begin + Sessions::kAbandoned + 1ms).refused == 0);
  CHECK(sessions.look(server.get(), begin + Sessions::kAbandoned + 2ms).open == 0);
  server.serve([&] {
    UaClient third(server.endpoint());
    first.reset();
  });
  CHECK(sessions.look(server.get(), begin + Sessions::kAbandoned + 3ms).refused == 0);
}
