// A session with a PLC's OPC UA server.
#include "symplant/link/opc_ua/client_connection.hpp"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <open62541/client_config_default.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "symplant/link/client/steady_now.hpp"
#include "symplant/link/net/host_port.hpp"
#include "symplant/link/opc_ua/endpoints.hpp"
#include "symplant/link/opc_ua/messages.hpp"
#include "symplant/link/opc_ua/status_text.hpp"

namespace symplant::link::opc_ua {

using client::Fault;
using client::steady_now;

namespace {

constexpr auto kSlice = std::chrono::milliseconds(20);  ///< longest time until interrupt() acts
constexpr auto kToConnect = std::chrono::seconds(5);    ///< a small PLC takes seconds for the keys of a session
constexpr UA_UInt32 kFarewell = 200;                    ///< ms to close a session at the end
constexpr UA_UInt32 kLeastSession = 30'000;             ///< ms without a request until a server may drop the session
constexpr UA_UInt32 kPollsInSession = 3;

/// open62541 connects again by the address that the server has for itself, and after each failure. A server that closes
/// all connections must not be flooded with them.
constexpr int kMostAttempts = 2;

/// Statuses of an answer that end the session or the connection.
bool ends_session(UA_StatusCode status) {
  constexpr std::array kEnding = {UA_STATUSCODE_BADSESSIONIDINVALID,
                                  UA_STATUSCODE_BADSESSIONCLOSED,
                                  UA_STATUSCODE_BADSESSIONNOTACTIVATED,
                                  UA_STATUSCODE_BADSECURECHANNELCLOSED,
                                  UA_STATUSCODE_BADSECURECHANNELIDINVALID,
                                  UA_STATUSCODE_BADCONNECTIONCLOSED,
                                  UA_STATUSCODE_BADSERVERNOTCONNECTED,
                                  UA_STATUSCODE_BADSHUTDOWN,
                                  UA_STATUSCODE_BADTIMEOUT,
                                  UA_STATUSCODE_BADSERVERHALTED};
  return std::find(kEnding.begin(), kEnding.end(), status) != kEnding.end();
}

/// Statuses of a login that is refused.
bool is_login(UA_StatusCode status) {
  constexpr std::array kLogin = {UA_STATUSCODE_BADUSERACCESSDENIED, UA_STATUSCODE_BADIDENTITYTOKENREJECTED,
                                 UA_STATUSCODE_BADIDENTITYTOKENINVALID};
  return std::find(kLogin.begin(), kLogin.end(), status) != kLogin.end();
}

std::string numeric_host(const addrinfo& address) {
  std::array<char, NI_MAXHOST> text{};
  ::getnameinfo(address.ai_addr, address.ai_addrlen, text.data(), text.size(), nullptr, 0, NI_NUMERICHOST);
  return text.data();
}

/// The first certificate of a chain.
UA_ByteString leaf_of(const UA_ByteString& chain) {
  constexpr std::size_t kHeader = 4;  // SEQUENCE with a length of 16 bits
  if (chain.length < kHeader || chain.data[1] != 0x82) return chain;
  const std::size_t length = kHeader + (std::size_t{chain.data[2]} << 8 | chain.data[3]);
  return {std::min(length, chain.length), chain.data};
}

}  // namespace

ClientConnection::ClientConnection(const ClientSettings& settings, ClientSecurity security)
    : settings_(settings), security_(std::move(security)) {}

ClientConnection::~ClientConnection() { close(); }

std::string ClientConnection::url() const {
  return std::string(kClientScheme) + "://" + net::format_host_port(settings_.address) + settings_.path;
}

std::string ClientConnection::endpoint_url() const {
  return "opc.tcp://" + net::format_host_port(settings_.address) + settings_.path;
}

Fault ClientConnection::lost(std::string message) {
  healthy_ = false;
  return {Fault::Kind::transport, std::move(message)};
}

Fault ClientConnection::failed(Waited waited, const std::string& doing) {
  switch (waited) {
    case Waited::done:
      return {};
    case Waited::interrupted:
      healthy_ = false;
      return {Fault::Kind::interrupted};
    case Waited::timeout:
      return lost(doing + ": no answer; check the address, the cable, and that its OPC UA server is on");
    case Waited::lost:
      break;
  }
  // What to do about a refused login depends on the settings, see explain().
  return lost(doing + ": " + (is_login(status_) ? status_meaning(status_) : status_text(status_)));
}

template <class Done>
ClientConnection::Waited ClientConnection::wait(Done done, Clock::time_point deadline) {
  for (;;) {
    if (done()) return Waited::done;
    if (interrupted_.load(std::memory_order_relaxed)) return Waited::interrupted;
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0) {
      status_ = UA_STATUSCODE_BADTIMEOUT;
      return Waited::timeout;
    }
    status_ = UA_Client_run_iterate(client_.get(), static_cast<UA_UInt32>(std::min(left, kSlice).count()));
    if (status_ == UA_STATUSCODE_GOOD && attempts_ > kMostAttempts) status_ = closed_again();
    if (status_ != UA_STATUSCODE_GOOD) return done() ? Waited::done : Waited::lost;
  }
}

/// open62541 waits without a limit for a PLC that does not read what is sent: the system then ends the connection. It
/// also waits for a name server: it gets the address instead of the name.
void ClientConnection::take_over_sockets(UA_ClientConfig& config) {
  for (UA_EventSource* source = config.eventLoop->eventSources; source != nullptr; source = source->next) {
    if (source->eventSourceType != UA_EVENTSOURCETYPE_CONNECTIONMANAGER) continue;
    auto* const manager = reinterpret_cast<UA_ConnectionManager*>(source);
    if (text_of(manager->protocol) != "tcp") continue;
    open_ = std::exchange(manager->openConnection, open_socket);
  }
}

UA_StatusCode ClientConnection::open_socket(UA_ConnectionManager* manager, const UA_KeyValueMap* parameters,
                                            void* client, void* context,
                                            UA_ConnectionManager_connectionCallback callback) {
  auto& self = *static_cast<ClientConnection*>(UA_Client_getContext(static_cast<UA_Client*>(client)));
  self.callback_ = callback;
  std::vector<UA_KeyValuePair> pairs(parameters->map, parameters->map + parameters->mapSize);  // views
  UA_String address = view_of(self.numeric_host_);
  for (UA_KeyValuePair& pair : pairs) {
    if (text_of(pair.key.name) != "address" || !UA_Variant_hasScalarType(&pair.value, &UA_TYPES[UA_TYPES_STRING]))
      continue;
    const bool is_host = text_of(*static_cast<const UA_String*>(pair.value.data)) == self.settings_.address.host;
    if (is_host) UA_Variant_setScalar(&pair.value, &address, &UA_TYPES[UA_TYPES_STRING]);
  }
  const UA_KeyValueMap changed{pairs.size(), pairs.data()};
  return self.open_(manager, &changed, client, context, take_event);
}

/// What happens at a connection, of which the number is the socket.
void ClientConnection::take_event(UA_ConnectionManager* manager, uintptr_t socket, void* client, void** context,
                                  UA_ConnectionState state, const UA_KeyValueMap* parameters, UA_ByteString message) {
  const auto& self = *static_cast<ClientConnection*>(UA_Client_getContext(static_cast<UA_Client*>(client)));
  if (state == UA_CONNECTIONSTATE_OPENING) {
    const auto limit = static_cast<unsigned>(std::max<tables::Time>(self.settings_.timeout / tables::kMillisecond, 1));
    ::setsockopt(static_cast<int>(socket), IPPROTO_TCP, TCP_USER_TIMEOUT, &limit, sizeof limit);
  }
  self.callback_(manager, socket, client, context, state, parameters, message);
}

/// Makes a client that is not connected.
Fault ClientConnection::prepare() {
  UA_ClientConfig config{};
  config.logging = silent();
  config.clientContext = this;
  config.stateCallback = watch;
  config.timeout = static_cast<UA_UInt32>(std::max<tables::Time>(settings_.timeout / tables::kMillisecond, 1));
  const tables::Time polls = kPollsInSession * settings_.times.poll / tables::kMillisecond;
  config.requestedSessionTimeout = static_cast<UA_UInt32>(std::max<tables::Time>(polls, kLeastSession));
  const UA_StatusCode status = security_.configure(config);
  if (status != UA_STATUSCODE_GOOD) {
    UA_ClientConfig_clear(&config);
    return lost("cannot make a client of OPC UA: " + status_text(status));
  }
  take_over_sockets(config);
  client_.reset(UA_Client_newWithConfig(&config));
  if (!client_) return lost("no memory for a client of OPC UA");
  healthy_ = true;
  attempts_ = 0;
  return {};
}

void ClientConnection::watch(UA_Client* client, UA_SecureChannelState channel, UA_SessionState /*session*/,
                             UA_StatusCode /*status*/) {
  if (channel != UA_SECURECHANNELSTATE_HEL_SENT) return;
  ++static_cast<ClientConnection*>(UA_Client_getContext(client))->attempts_;
}

/// Why the server has probably closed all attempts: open62541 does not pass on a reason in the answer to a secure one.
UA_StatusCode ClientConnection::closed_again() const {
  return is_secure_ ? UA_STATUSCODE_BADSECURITYCHECKSFAILED : UA_STATUSCODE_BADCONNECTIONCLOSED;
}

/// Connects to the endpoint; with a login if `token` is not null.
Fault ClientConnection::start(const UA_EndpointDescription& endpoint, const UA_UserTokenPolicy* token) {
  if (Fault fault = prepare()) return fault;
  is_secure_ = endpoint.securityMode != UA_MESSAGESECURITYMODE_NONE;
  UA_ClientConfig& config = *UA_Client_getConfig(client_.get());
  UA_EndpointDescription_copy(&endpoint, &config.endpoint);
  if (token != nullptr) UA_UserTokenPolicy_copy(token, &config.userTokenPolicy);
  const std::string url = endpoint_url();
  status_ = token == nullptr ? UA_Client_connectSecureChannelAsync(client_.get(), url.c_str())
                             : UA_Client_connectAsync(client_.get(), url.c_str());
  const auto connected = [&] {
    UA_SecureChannelState channel{};
    UA_SessionState session{};
    UA_Client_getState(client_.get(), &channel, &session, nullptr);
    return token == nullptr ? channel == UA_SECURECHANNELSTATE_OPEN : session == UA_SESSIONSTATE_ACTIVATED;
  };
  const Waited waited = status_ == UA_STATUSCODE_GOOD ? wait(connected, until_) : Waited::lost;
  return failed(waited, "no connection to " + net::format_host_port(settings_.address));
}

/// Asks over a connection without security, as every server allows.
Fault ClientConnection::ask_endpoints(Endpoints& endpoints) {
  const std::string url = endpoint_url();
  const std::string none = "http://opcfoundation.org/UA/SecurityPolicy#None";
  UA_EndpointDescription plain;
  UA_EndpointDescription_init(&plain);
  plain.endpointUrl = view_of(url);
  plain.securityMode = UA_MESSAGESECURITYMODE_NONE;
  plain.securityPolicyUri = view_of(none);
  UA_GetEndpointsRequest request;
  UA_GetEndpointsRequest_init(&request);
  request.endpointUrl = view_of(url);
  Fault fault;
  UA_StatusCode result = UA_STATUSCODE_GOOD;
  // open62541 may connect a second time, by the address that the server has for itself, which cancels the request.
  constexpr int kTimes = 2;
  for (int time = 0; time < kTimes; ++time) {
    fault = start(plain, nullptr);
    if (!fault) fault = call(request, UA_TYPES_GETENDPOINTSREQUEST, endpoints, result);
    if (!fault || fault.kind == Fault::Kind::interrupted || status_ == UA_STATUSCODE_BADTIMEOUT) break;
  }
  if (!fault && is_bad(result)) fault = lost("the server does not list its endpoints: " + status_text(result));
  close();
  return fault;
}

/// Says more on a session that was not begun.
void ClientConnection::explain(Fault& fault) const {
  const SecuritySettings& security = settings_.security;
  if (is_login(status_) && security.user.empty()) {
    fault.message +=
        "; the server does not accept a link without a user: give `user=NAME&password-file=FILE` and "
        "`security=encrypt`";
  } else if (is_login(status_)) {
    fault.message += "; the server does not accept the user `" + security.user +
                     "`: check `user` and the password in `password-file`";
  } else if (security.security != Security::none) {
    fault.message += "; the certificate of this link is " + security_.own_fingerprint();
  }
}

Fault ClientConnection::open() {
  close();
  until_ = Clock::now() + std::max<std::chrono::nanoseconds>(kToConnect, std::chrono::nanoseconds(settings_.timeout));
  Fault fault = connect();
  until_ = Clock::time_point::max();
  if (fault) close();
  return fault;
}

/// Asks at the first address of the host that answers.
Fault ClientConnection::find_server(Endpoints& endpoints) {
  const auto resolved = net::resolve(settings_.address, SOCK_STREAM, false);
  if (const auto* error = std::get_if<LinkError>(&resolved)) {
    return lost("no connection to " + net::format_host_port(settings_.address) + ": " + error->message);
  }
  Fault fault;
  for (const addrinfo* one : net::ipv4_first(std::get<net::Addresses>(resolved).get())) {
    numeric_host_ = numeric_host(*one);
    fault = ask_endpoints(endpoints);
    if (!fault || fault.kind == Fault::Kind::interrupted || Clock::now() >= until_) break;
  }
  return fault;
}

Fault ClientConnection::connect() {
  Endpoints endpoints;
  if (Fault fault = find_server(endpoints)) return fault;
  std::string problem;
  const auto chosen =
      choose_endpoint(std::span(endpoints->endpoints, endpoints->endpointsSize), settings_.security, problem);
  if (!chosen) return lost(std::move(problem));
  UA_EndpointDescription endpoint = *chosen->endpoint;  // a view
  endpoint.serverCertificate = leaf_of(endpoint.serverCertificate);
  if (problem = security_.check(endpoint.serverCertificate); !problem.empty()) return lost(std::move(problem));
  application_ = of_peer(text_of(endpoint.server.applicationName.text));
  Fault fault = start(endpoint, chosen->token);
  if (!fault) {
    UA_Client_getConfig(client_.get())->noReconnect = true;
    security_.accept(endpoint.serverCertificate);
  } else if (fault.kind == Fault::Kind::transport) {
    explain(fault);
  }
  return fault;
}

void ClientConnection::close() noexcept {
  pending_ = {};
  if (!client_) return;
  UA_Client_getConfig(client_.get())->timeout = kFarewell;
  if (!healthy_) UA_Client_disconnectSecureChannelAsync(client_.get());
  client_.reset();
}

/// Takes over the contents of an answer.
void ClientConnection::receive(UA_Client* /*client*/, void* connection, UA_UInt32 /*request*/, void* response) {
  Pending& pending = static_cast<ClientConnection*>(connection)->pending_;
  pending.done = true;
  if (pending.response == nullptr) return;
  std::memcpy(pending.response, response, pending.size);
  std::memset(response, 0, pending.size);
}

Fault ClientConnection::transact(const void* request, const UA_DataType& request_type, void* response,
                                 const UA_DataType& response_type) {
  if (!client_) return lost("there is no connection");
  pending_ = {response, response_type.memSize, false};
  const auto deadline = std::min(until_, Clock::now() + std::chrono::nanoseconds(settings_.timeout));
  const tables::Time sent = steady_now();
  status_ = __UA_Client_AsyncService(client_.get(), request, &request_type, receive, &response_type, this, nullptr);
  const Waited waited = status_ == UA_STATUSCODE_GOOD ? wait([this] { return pending_.done; }, deadline) : Waited::lost;
  pending_ = {};
  if (waited == Waited::timeout) return lost("the PLC does not answer any more; connecting again");
  if (waited != Waited::done) return failed(waited, "connection lost");
  const UA_StatusCode status = static_cast<const UA_ResponseHeader*>(response)->serviceResult;
  if (ends_session(status)) {
    status_ = status;
    return lost("connection lost: " + status_text(status));
  }
  requests_.fetch_add(1, std::memory_order_relaxed);
  sent_ = sent;
  at_ = steady_now();
  return {};
}

}  // namespace symplant::link::opc_ua
