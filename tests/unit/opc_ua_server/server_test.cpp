// The OPC UA server of a plant, with a client of open62541.
#include "symplant/link/opc_ua/server_config.hpp"
#include "unit/opc_ua_server/served_plant.hpp"

using namespace symplant;
using test::ServedPlant;
using test::soon;
using test::UaClient;

namespace {

const test::DescribedPlant& tank() {
  static const test::DescribedPlant plant({{"L_T_PUMP_O_RUN", "", "BOOL", "FALSE", "%QX0"},
                                           {"L_T_PUMP_I_RUN", "", "BOOL", "FALSE", "%IX0"},
                                           {"L_T_PUMP_I_STOP", "", "BOOL", "TRUE", "%IX1"},
                                           {"L_T_TANK_I_LEVEL", "", "REAL", "0", "%ID4"},
                                           {"L_T_TANK_I_RAW", "", "INT", "0", "%IW20"},
                                           {"L_T_TANK_O_SET", "", "INT", "7", "%QW8"},
                                           {"L_T_TANK_O_GAIN", "", "REAL", "0", "%QD10"},
                                           {"X_I_LONELY", "", "BOOL", "FALSE", "%IX9"}},
                                          R"("name": "tank",
         "values": { "level": { "unit": "l", "start": 20, "min": 0, "max": 120, "integral": "0" },
                     "speed": { "unit": "m/s", "is": "1" } },
         "signals": { "L_T_TANK_I_LEVEL": { "of": "level", "every": "10ms" },
                      "L_T_TANK_I_RAW": { "of": "level", "from": [0, 120], "to": [0, 1200], "every": "10ms" } },
         "malfunctions": [ { "name": "float stuck", "force": { "L_T_TANK_I_LEVEL": 3.5 } } ])");
  return plant;
}

UA_Variant text_argument(UA_String& text) {
  UA_Variant variant;
  UA_Variant_setScalar(&variant, &text, &UA_TYPES[UA_TYPES_STRING]);
  return variant;
}

/// Changes that a subscription reports of one node.
class Monitored {
 public:
  Monitored(UaClient& client, const std::string& name, double sampling = 10) : client_(client) {
    UA_CreateSubscriptionRequest request = UA_CreateSubscriptionRequest_default();
    request.requestedPublishingInterval = 10;
    const UA_CreateSubscriptionResponse response =
        UA_Client_Subscriptions_create(client.get(), request, nullptr, nullptr, nullptr);
    REQUIRE(response.responseHeader.serviceResult == UA_STATUSCODE_GOOD);
    UA_MonitoredItemCreateRequest item = UA_MonitoredItemCreateRequest_default(UaClient::node(name));
    item.requestedParameters.samplingInterval = sampling;
    item.requestedParameters.queueSize = 100;
    const UA_MonitoredItemCreateResult created = UA_Client_MonitoredItems_createDataChange(
        client.get(), response.subscriptionId, UA_TIMESTAMPSTORETURN_BOTH, item, this, changed, nullptr);
    REQUIRE(created.statusCode == UA_STATUSCODE_GOOD);
    interval = created.revisedSamplingInterval;
  }
  bool sees(const std::vector<UA_StatusCode>& expected) {
    return soon([&] {
      UA_Client_run_iterate(client_.get(), 1);
      return statuses == expected;
    });
  }

  double interval = -1;
  std::vector<UA_StatusCode> statuses;

 private:
  static void changed(UA_Client*, UA_UInt32, void*, UA_UInt32, void* context, UA_DataValue* value) {
    static_cast<Monitored*>(context)->statuses.push_back(value->hasStatus ? value->status : UA_STATUSCODE_GOOD);
  }
  UaClient& client_;
};

}  // namespace

TEST_CASE("A client reads and writes symbols by their names and types") {
  ServedPlant served(tank().rows);
  served.run();
  UaClient client(served.endpoint());
  CHECK(soon([&] { return client.value<bool>("L_T_PUMP_I_STOP"); }));
  CHECK(client.value<std::int16_t>("L_T_TANK_O_SET") == 7);
  CHECK(client.write("L_T_PUMP_O_RUN", UA_TYPES_BOOLEAN, true) == UA_STATUSCODE_GOOD);
  CHECK(client.write("L_T_TANK_O_SET", UA_TYPES_INT16, std::int16_t{-12}) == UA_STATUSCODE_GOOD);
  CHECK(client.write("L_T_TANK_O_GAIN", UA_TYPES_FLOAT, 0.5F) == UA_STATUSCODE_GOOD);
  CHECK(soon([&] { return client.value<bool>("L_T_PUMP_I_RUN"); }));
  CHECK(client.value<std::int16_t>("L_T_TANK_O_SET") == -12);
  CHECK(soon([&] { return client.value<float>("L_T_TANK_I_LEVEL") == 20.0F; }));
  served.pause();
  const auto slot = tank().rows.symbols[tank().symbol("L_T_TANK_O_SET")].index;
  CHECK(static_cast<std::int64_t>(served.plant().operation_value(slot)) == -12);
}

TEST_CASE("A client may not write events, other types, statuses or parts of values") {
  ServedPlant served(tank().rows);
  served.run();
  UaClient client(served.endpoint());
  CHECK(client.write("L_T_PUMP_I_RUN", UA_TYPES_BOOLEAN, true) == UA_STATUSCODE_BADNOTWRITABLE);
  CHECK(client.write("/value/level", UA_TYPES_DOUBLE, 1.0) == UA_STATUSCODE_BADNOTWRITABLE);
  CHECK(client.write("L_T_TANK_O_SET", UA_TYPES_INT32, 5) == UA_STATUSCODE_BADTYPEMISMATCH);
  CHECK(client.write("L_T_NO_SUCH", UA_TYPES_BOOLEAN, true) == UA_STATUSCODE_BADNODEIDUNKNOWN);
  UA_WriteValue bad;
  UA_WriteValue_init(&bad);
  bool on = true;
  bad.nodeId = UaClient::node("L_T_PUMP_O_RUN");
  bad.attributeId = UA_ATTRIBUTEID_VALUE;
  UA_Variant_setScalar(&bad.value.value, &on, &UA_TYPES[UA_TYPES_BOOLEAN]);
  bad.value.hasValue = true;
  bad.value.hasStatus = true;
  bad.value.status = UA_STATUSCODE_BADSENSORFAILURE;
  CHECK(client.write(bad) == UA_STATUSCODE_BADWRITENOTSUPPORTED);
  CHECK(served.link().status().exceptions == 1);
}

TEST_CASE("Before the first cycle values are not good yet") {
  ServedPlant served(tank().rows);
  UaClient client(served.endpoint());
  CHECK(client.status("L_T_PUMP_I_STOP") == UA_STATUSCODE_BADWAITINGFORINITIALDATA);
  CHECK(client.status("/value/level") == UA_STATUSCODE_BADWAITINGFORINITIALDATA);
  CHECK(client.status("L_T_PUMP_O_RUN") == UA_STATUSCODE_GOOD);
  served.cycle();
  CHECK(soon([&] { return client.status("L_T_PUMP_I_STOP") == UA_STATUSCODE_GOOD; }));
}

TEST_CASE("A client sees devices, values and what the plant does") {
  ServedPlant served(tank().rows);
  served.run();
  UaClient client(served.endpoint());
  CHECK(soon([&] { return client.status("/device/L_T_PUMP/state") == UA_STATUSCODE_GOOD; }));
  CHECK(client.text("/device/L_T_PUMP/state") == "STOP");
  CHECK_FALSE(client.value<bool>("/device/L_T_PUMP/moving"));
  CHECK(client.value<double>("/value/level") == 20);
  CHECK(client.value<std::uint64_t>("/plant/Cycles") > 0);
  CHECK_FALSE(client.value<bool>("/plant/Frozen"));
  client.write("L_T_PUMP_O_RUN", UA_TYPES_BOOLEAN, true);
  CHECK(soon([&] { return client.text("/device/L_T_PUMP/state") == "RUN"; }));
}

TEST_CASE("A value with a unit and a signal that shows it have the unit, a scaled signal does not") {
  ServedPlant served(tank().rows);
  UaClient client(served.endpoint());
  const auto unit_of = [&](const std::string& name) {
    const auto value = client.read(name + "/EngineeringUnits");
    if (value->value.type != &UA_TYPES[UA_TYPES_EUINFORMATION]) return std::string();
    return std::string(
        link::opc_ua::text_of(static_cast<const UA_EUInformation*>(value->value.data)->displayName.text));
  };
  CHECK(unit_of("/value/level") == "l");
  CHECK(unit_of("/value/speed") == "m/s");
  CHECK(unit_of("L_T_TANK_I_LEVEL") == "l");
  CHECK(unit_of("L_T_TANK_I_RAW").empty());
  const auto range = client.read("/value/level/EURange");
  REQUIRE(range->value.type == &UA_TYPES[UA_TYPES_RANGE]);
  CHECK(static_cast<const UA_Range*>(range->value.data)->low == 0);
  CHECK(static_cast<const UA_Range*>(range->value.data)->high == 120);
}

TEST_CASE("The server allows as many nodes in a request as the plant has") {
  ServedPlant served(tank().rows);
  UaClient client(served.endpoint());
  for (const int limit : {UA_NS0ID_SERVER_SERVERCAPABILITIES_OPERATIONLIMITS_MAXNODESPERREAD,
                          UA_NS0ID_SERVER_SERVERCAPABILITIES_OPERATIONLIMITS_MAXNODESPERWRITE,
                          UA_NS0ID_SERVER_SERVERCAPABILITIES_OPERATIONLIMITS_MAXMONITOREDITEMSPERCALL}) {
    link::opc_ua::OwnedVariant value;
    REQUIRE(UA_Client_readValueAttribute(client.get(), UA_NODEID_NUMERIC(0, static_cast<UA_UInt32>(limit)),
                                         value.get()) == UA_STATUSCODE_GOOD);
    CHECK(*static_cast<const UA_UInt32*>(value->data) >= 1000);
  }
}

TEST_CASE("An event that a malfunction decides is bad as long as it is active, for a subscriber too") {
  ServedPlant served(tank().rows);
  served.run();
  UaClient client(served.endpoint());
  REQUIRE(soon([&] { return client.value<float>("L_T_TANK_I_LEVEL") == 20.0F; }));
  Monitored level(client, "L_T_TANK_I_LEVEL");
  CHECK(level.interval == 0);
  CHECK(level.sees({UA_STATUSCODE_GOOD}));
  UA_String name = link::opc_ua::view_of("Float Stuck");
  CHECK(client.call("StartMalfunction", {text_argument(name)}) == UA_STATUSCODE_GOOD);
  CHECK(level.sees({UA_STATUSCODE_GOOD, UA_STATUSCODE_BADSENSORFAILURE}));
  CHECK(client.value<float>("L_T_TANK_I_LEVEL") == 3.5F);
  CHECK(client.value<bool>("/malfunction/float stuck"));
  CHECK(client.status("/value/level") == UA_STATUSCODE_GOOD);
  CHECK(client.call("EndMalfunction", {text_argument(name)}) == UA_STATUSCODE_GOOD);
  CHECK(level.sees({UA_STATUSCODE_GOOD, UA_STATUSCODE_BADSENSORFAILURE, UA_STATUSCODE_GOOD}));
  CHECK_FALSE(client.value<bool>("/malfunction/float stuck"));
}

TEST_CASE("What is not of the plant is sampled") {
  ServedPlant served(tank().rows);
  UaClient client(served.endpoint());
  UA_CreateSubscriptionRequest request = UA_CreateSubscriptionRequest_default();
  const auto response = UA_Client_Subscriptions_create(client.get(), request, nullptr, nullptr, nullptr);
  auto item = UA_MonitoredItemCreateRequest_default(UA_NODEID_NUMERIC(0, UA_NS0ID_SERVER_SERVERSTATUS_CURRENTTIME));
  item.requestedParameters.samplingInterval = 100;
  const auto created = UA_Client_MonitoredItems_createDataChange(
      client.get(), response.subscriptionId, UA_TIMESTAMPSTORETURN_BOTH, item, nullptr,
      [](UA_Client*, UA_UInt32, void*, UA_UInt32, void*, UA_DataValue*) {}, nullptr);
  CHECK(created.revisedSamplingInterval == 100);
}

TEST_CASE("Methods become commands of the run, and invalid arguments are refused") {
  ServedPlant served(tank().rows);
  UaClient client(served.endpoint());
  UA_String unknown = link::opc_ua::view_of("float stück");
  CHECK(client.call("StartMalfunction", {text_argument(unknown)}) == UA_STATUSCODE_BADINVALIDARGUMENT);
  UA_UInt32 cycles = 0;
  UA_Variant steps;
  UA_Variant_setScalar(&steps, &cycles, &UA_TYPES[UA_TYPES_UINT32]);
  CHECK(client.call("Step", {steps}) == UA_STATUSCODE_BADINVALIDARGUMENT);
  cycles = 3;
  CHECK(client.call("Step", {steps}) == UA_STATUSCODE_GOOD);
  CHECK(client.call("Freeze", {}) == UA_STATUSCODE_GOOD);
  served.freeze_otherwise();
  served.cycle();
  link::opc_ua::OwnedVariant frozen;
  CHECK(client.call("Run", {}, &frozen) == UA_STATUSCODE_GOOD);
  REQUIRE(UA_Variant_hasScalarType(frozen.get(), &UA_TYPES[UA_TYPES_BOOLEAN]));
  CHECK(*static_cast<const bool*>(frozen->data));
  served.cycle();
  using Kind = link::LinkCommand::Kind;
  REQUIRE(served.commands().size() == 3);
  CHECK(served.commands()[0].kind == Kind::step);
  CHECK(served.commands()[0].of == 3);
  CHECK(served.commands()[1].kind == Kind::freeze);
  CHECK(served.commands()[2].kind == Kind::run);
  const auto messages = served.link().take_messages();
  REQUIRE(messages.size() == 2);
  CHECK(messages[0].find("`float stück`, which was not found; did you mean `float stuck`?") != std::string::npos);
  CHECK(messages[1] == "a client steps the plant, and so froze it; its method Run ends this");
  CHECK(client.call("Freeze", {}) == UA_STATUSCODE_GOOD);
  CHECK(served.link().take_messages() ==
        std::vector<std::string>{"a client froze the plant; its method Run ends this"});
}

TEST_CASE("Messages of one cause are limited, and do not silence those of another one") {
  using link::opc_ua::Messages;
  Messages messages;
  for (int i = 0; i < 200; ++i) messages.add_once(Messages::Cause::user, "user " + std::to_string(i % 100));
  const auto users = messages.take();
  REQUIRE(users.size() == Messages::kMost + 1);
  CHECK(users.back() == "user 50; further messages of this kind are not reported");
  messages.add(Messages::Cause::freeze, "frozen");
  messages.add(Messages::Cause::freeze, "frozen");
  messages.add_once(Messages::Cause::certificate, "certificate");
  messages.add_once(Messages::Cause::certificate, "certificate");
  CHECK(messages.take() == std::vector<std::string>{"frozen", "frozen", "certificate"});
}

TEST_CASE("The link is live while a client reads, is lost without one, and zeroes operations as set") {
  link::LinkSettings settings;
  settings.on_loss = link::OnLoss::zero;
  settings.loss_after = 200 * tables::kMillisecond;
  settings.resync = 100 * tables::kMillisecond;
  ServedPlant served(tank().rows, "", settings);
  served.run();
  CHECK(served.state() == exec::LinkState::waiting);
  {
    UaClient client(served.endpoint());
    client.write("L_T_TANK_O_SET", UA_TYPES_INT16, std::int16_t{99});
    CHECK(soon([&] { return client.status("L_T_PUMP_I_RUN"), served.state() == exec::LinkState::live; }));
  }
  CHECK(soon([&] { return served.state() == exec::LinkState::lost; }));
  served.pause();
  CHECK(served.plant().operation_value(tank().rows.symbols[tank().symbol("L_T_TANK_O_SET")].index) == 0);
  CHECK(served.link().status().losses == 1);
  served.run();
  UaClient again(served.endpoint());
  CHECK(again.value<std::int16_t>("L_T_TANK_O_SET") == 0);
}

TEST_CASE("A connected client with a subscription keeps the link live, though it sends no other request") {
  link::LinkSettings settings;
  settings.loss_after = 2 * tables::kSecond;  // 2,000 cycles: 0.4 s or more
  ServedPlant served(tank().rows, "", settings);
  served.run();
  UaClient client(served.endpoint());
  REQUIRE(soon([&] { return client.status("L_T_PUMP_I_RUN") == UA_STATUSCODE_GOOD; }));
  Monitored level(client, "L_T_PUMP_I_RUN");
  CHECK(level.sees({UA_STATUSCODE_GOOD}));
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
  while (std::chrono::steady_clock::now() < end) UA_Client_run_iterate(client.get(), 10);
  CHECK(served.link().status().losses == 0);
}

TEST_CASE("A client with a subscription that hangs does not keep the link live") {
  link::LinkSettings settings;
  settings.loss_after = 2 * tables::kSecond;  // longer than the server looks at its sessions: 0.4 s or more
  ServedPlant served(tank().rows, "", settings);
  served.run();
  UaClient client(served.endpoint());
  Monitored level(client, "L_T_PUMP_I_STOP");
  CHECK(soon([&] { return UA_Client_run_iterate(client.get(), 1), served.state() == exec::LinkState::live; }));
  CHECK(soon([&] { return served.state() == exec::LinkState::lost; }));  // its connection is open
  CHECK(soon([&] { return UA_Client_run_iterate(client.get(), 1), served.state() == exec::LinkState::live; }));
}

TEST_CASE("Only clients for which there is no session count as refused for lack of room") {
  ServedPlant served(tank().rows);
  served.run();
  const auto is_looked_at = [&] {  // a later request is counted
    const auto requests = served.link().status().requests;
    UaClient client(served.endpoint());
    return soon([&] { return client.status("L_T_PUMP_I_RUN"), served.link().status().requests > requests; });
  };
  {
    UaClient client(served.endpoint());
    UA_ActivateSessionRequest request;
    UA_ActivateSessionRequest_init(&request);
    UA_ActivateSessionResponse response;
    UA_UserNameIdentityToken user;
    UA_UserNameIdentityToken_init(&user);
    user.userName = link::opc_ua::view_of("somebody");
    user.policyId = link::opc_ua::view_of("no-such-policy");
    UA_ExtensionObject_setValueNoDelete(&request.userIdentityToken, &user, &UA_TYPES[UA_TYPES_USERNAMEIDENTITYTOKEN]);
    __UA_Client_Service(client.get(), &request, &UA_TYPES[UA_TYPES_ACTIVATESESSIONREQUEST], &response,
                        &UA_TYPES[UA_TYPES_ACTIVATESESSIONRESPONSE]);
    CHECK(response.responseHeader.serviceResult != UA_STATUSCODE_GOOD);
    UA_ActivateSessionResponse_clear(&response);
  }
  REQUIRE(is_looked_at());
  CHECK(served.link().status().crowded_out == 0);
  CHECK(served.link().take_messages().empty());
  std::vector<std::unique_ptr<UaClient>> clients;
  while (clients.size() < link::opc_ua::ServerLimits::kLeastSessions) {
    clients.push_back(std::make_unique<UaClient>(served.endpoint()));
  }
  UA_Client* const one_more = UaClient::made();
  CHECK(UA_Client_connect(one_more, served.endpoint().c_str()) == UA_STATUSCODE_BADTOOMANYSESSIONS);
  UA_Client_delete(one_more);
  CHECK(soon([&] { return served.link().status().crowded_out == 1; }));
  const auto messages = served.link().take_messages();
  REQUIRE(messages.size() == 1);
  CHECK(messages[0].find("as many sessions as allowed") != std::string::npos);
}

TEST_CASE("While the link is cut no client gets an answer, and afterwards they go on") {
  ServedPlant served(tank().rows);
  served.run();
  UaClient client(served.endpoint());
  CHECK(soon([&] { return client.value<bool>("L_T_PUMP_I_STOP"); }));
  served.link().cut(true);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  UA_Client_getConfig(client.get())->timeout = 100;
  CHECK(client.status("L_T_PUMP_I_STOP") != UA_STATUSCODE_GOOD);
  served.link().cut(false);
  UaClient next(served.endpoint());
  CHECK(next.value<bool>("L_T_PUMP_I_STOP"));
}

TEST_CASE("A port that is in use is an error of the environment") {
  ServedPlant served(tank().rows);
  const auto second = link::open_link({served.link().url(), 0}, tank().rows);
  REQUIRE(std::holds_alternative<link::LinkError>(second));
  CHECK(std::get<link::LinkError>(second).kind == link::LinkError::Kind::environment);
  CHECK(std::get<link::LinkError>(second).message.find("is in use") != std::string::npos);
}
