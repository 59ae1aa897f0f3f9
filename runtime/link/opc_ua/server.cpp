// An OPC UA server of a plant, and the thread that serves its clients.
#include "symplant/link/opc_ua/server.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "symplant/link/image/words.hpp"
#include "symplant/link/net/listener.hpp"
#include "symplant/link/net/no_signals.hpp"
#include "symplant/link/opc_ua/server_nodes.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::link::opc_ua {

namespace {

using Clock = std::chrono::steady_clock;

/// Between two looks at the images, in ms: no client sees a change later than this after its cycle.
constexpr double kBetweenLooks = 2;
constexpr auto kBetweenSessionLooks = std::chrono::milliseconds(100);
constexpr auto kWhileCut = std::chrono::milliseconds(5);
constexpr std::size_t kMostChanges = 256;  ///< passed on before requests are looked at again
constexpr std::size_t kMostCommands = 64;  ///< that wait

void add(std::atomic<std::uint64_t>& count, std::uint64_t more) noexcept {
  count.fetch_add(more, std::memory_order_relaxed);
}

bool is_of_symbol(const Variable& variable) noexcept {
  return variable.kind == Variable::Kind::operation || variable.kind == Variable::Kind::event;
}

}  // namespace

Server::Server(const Shown& shown, net::HostPort bound)
    : shown_(shown),
      bound_(std::move(bound)),
      access_{messages_, std::nullopt, this},
      variables_(shown.tables, shown.map, shown.images, shown.plant, shown.initial),
      nodes_{shown.tables, shown.map, variables_.all(), shown.model_hash},
      malfunctions_(shown.tables),
      rewriting_(shown.map.size(Plane::operation_bits), shown.map.size(Plane::operation_numbers)),
      all_bits_(shown.map.size(Plane::operation_bits)),
      all_numbers_(shown.map.size(Plane::operation_numbers)),
      touched_{image::PositionSet(static_cast<std::uint32_t>(shown.map.points.size())),
               image::PositionSet(static_cast<std::uint32_t>(shown.map.points.size()))},
      commands_(kMostCommands) {
  all_bits_.add(0, shown.map.size(Plane::operation_bits));
  all_numbers_.add(0, shown.map.size(Plane::operation_numbers));
  for_variable_nodes(nodes_, [this](Variable&, const std::string& id) { ids_.push_back(id); });
}

std::variant<std::unique_ptr<Server>, LinkError> Server::start(ServerSettings settings, const LinkSettings& link,
                                                               const Shown& shown) {
  {
    // open62541 does not say why it cannot listen, nor which free port it found.
    auto listener = net::listen_on(settings.address);
    if (auto* error = std::get_if<LinkError>(&listener)) return std::move(*error);
    settings.address = std::get<net::Listener>(listener).bound;
  }
  std::unique_ptr<Server> server(new Server(shown, settings.address));
  if (auto error = server->prepare(settings, link)) return std::move(*error);
  const net::NoSignals blocked;
  try {
    server->thread_ = std::thread([&server = *server] { server.serve(); });
  } catch (const std::system_error& error) {
    return LinkError{LinkError::Kind::environment, std::string("cannot start the OPC UA server: ") + error.what()};
  }
  return server;
}

std::optional<LinkError> Server::prepare(const ServerSettings& settings, const LinkSettings& link) {
  const ServerLimits limits{variables_.all().size(), link.connections, link.idle};
  auto made = make_server(settings, limits, std::string(shown_.tables.name), access_);
  if (auto* error = std::get_if<LinkError>(&made)) return std::move(*error);
  server_ = std::move(std::get<OwnedServer>(made));
  UA_Server_getConfig(server_.get())->monitoredItemRegisterCallback = monitored;
  const auto failed = [](UA_StatusCode status) {
    return LinkError{LinkError::Kind::environment, "cannot start the OPC UA server: " + status_name(status)};
  };
  UA_StatusCode status = add_plant_nodes(server_.get(), nodes_, callbacks());
  if (status != UA_STATUSCODE_GOOD) return failed(status);
  // Ends the wait for requests when it is time to look at the images.
  status = UA_Server_addRepeatedCallback(
      server_.get(), [](UA_Server*, void*) {}, nullptr, kBetweenLooks, nullptr);
  if (status == UA_STATUSCODE_GOOD) status = UA_Server_run_startup(server_.get());
  if (status != UA_STATUSCODE_GOOD) return failed(status);
  own_access_ = false;
  serving_ = true;
  return std::nullopt;
}

Server::~Server() { stop(); }

void Server::stop() {
  stop_.store(true, std::memory_order_relaxed);
  if (thread_.joinable()) thread_.join();
}

LinkStatus Server::status() const noexcept {
  LinkStatus status;
  status.has_nodes = true;
  status.requests = requests_.load(std::memory_order_relaxed);
  status.exceptions = refused_.load(std::memory_order_relaxed);
  status.connections = connections_.load(std::memory_order_relaxed);
  status.crowded_out = crowded_out_.load(std::memory_order_relaxed);
  status.losses = losses_.load(std::memory_order_relaxed);
  return status;
}

std::optional<LinkCommand> Server::take_command(bool frozen) noexcept {
  frozen_otherwise_.store(frozen, std::memory_order_relaxed);
  const LinkCommand* const first = commands_.front();
  if (first == nullptr) return std::nullopt;
  const LinkCommand command = *first;
  commands_.pop();
  return command;
}

// --- the server's thread

void Server::serve() {
  auto next_look = Clock::now();
  bool busy = false;
  while (!stop_.load(std::memory_order_relaxed)) {
    if (cut_.load(std::memory_order_relaxed)) {
      std::this_thread::sleep_for(kWhileCut);
      continue;
    }
    UA_Server_run_iterate(server_.get(), !busy);
    publish_writes();
    busy = write_changes();
    if (Clock::now() < next_look) continue;
    next_look = Clock::now() + kBetweenSessionLooks;
    look_at_sessions();
  }
  UA_Server_run_shutdown(server_.get());
}

/// After a loss, everything that was written is awaited again, and operations that went to zero are zero.
void Server::forget_operations() {
  if (!shown_.images.release(losses_.load(std::memory_order_relaxed))) return;
  rewriting_.begin(all_bits_, all_numbers_);
  written_ = true;
}

void Server::publish_writes() {
  forget_operations();
  if (!std::exchange(written_, false)) return;
  shown_.images.publish(rewriting_.complete());
}

/// Passes changes of variables on to the items that monitor them; returns whether there are more.
bool Server::write_changes() {
  own_access_ = true;
  const bool more = variables_.update(kMostChanges, [this](const Variable& variable) {
    UA_WriteValue change;
    UA_WriteValue_init(&change);
    change.nodeId = string_node(kPlantNamespace, ids_[static_cast<std::size_t>(&variable - variables_.all().data())]);
    change.attributeId = UA_ATTRIBUTEID_VALUE;
    change.value = variables_.value_of(variable);
    UA_Server_write(server_.get(), &change);
  });
  own_access_ = false;
  return more;
}

void Server::look_at_sessions() {
  const Sessions::Look look = sessions_.look(server_.get(), Clock::now());
  const std::size_t channels = UA_Server_getStatistics(server_.get()).scs.currentChannelCount;
  connections_.store(static_cast<std::uint32_t>(std::min(look.open, channels)), std::memory_order_relaxed);
  add(requests_, look.requests);
  if (look.live) heard_.fetch_add(1, std::memory_order_release);
  if (look.refused == 0) return;
  if (crowded_out_.fetch_add(look.refused, std::memory_order_relaxed) != 0) return;
  messages_.add("a client was refused, since there are as many sessions as allowed: set more `connections`");
}

void Server::on_read(const Variable& variable) noexcept {
  if (own_access_ || !is_of_symbol(variable)) return;
  touched_.read.add(variable.of, 1);
  heard_.fetch_add(1, std::memory_order_release);
}

UA_StatusCode Server::on_write(Variable& variable, const UA_NumericRange* range, const UA_DataValue& value) {
  if (own_access_) return UA_STATUSCODE_GOOD;
  if (range != nullptr || (value.hasStatus && value.status != UA_STATUSCODE_GOOD))
    return UA_STATUSCODE_BADWRITENOTSUPPORTED;
  const auto number = value.hasValue ? number_of(value.value, variable.type) : std::nullopt;
  if (!number) return UA_STATUSCODE_BADTYPEMISMATCH;
  forget_operations();
  const image::Point& point = shown_.map.points[variable.of];
  const image::Planes planes = shown_.images.planes();
  if (has_bits(point.plane)) {
    image::set_bit(planes.operation_bits, point.position, *number != 0);
  } else {
    planes.operation_numbers[point.position] = *number;
  }
  shown_.images.touch(point.plane, point.position, 1);
  rewriting_.wrote(has_bits(point.plane), point.position, 1);
  variables_.wrote(variable, *number);
  touched_.written.add(variable.of, 1);
  written_ = true;
  heard_.fetch_add(1, std::memory_order_release);
  return UA_STATUSCODE_GOOD;
}

UA_StatusCode Server::command(LinkCommand command) noexcept {
  return commands_.put(command) ? UA_STATUSCODE_GOOD : UA_STATUSCODE_BADRESOURCEUNAVAILABLE;
}

UA_StatusCode Server::on_malfunction(const UA_Variant& name, LinkCommand::Kind kind) {
  if (!UA_Variant_hasScalarType(&name, &UA_TYPES[UA_TYPES_STRING])) return UA_STATUSCODE_BADINVALIDARGUMENT;
  const std::string_view text = text_of(*static_cast<const UA_String*>(name.data));
  if (const auto number = malfunctions_.find(text)) return command({kind, *number});
  tables::NearestName nearest(text);
  for (const std::string_view known : tables::split_names(shown_.tables.malfunctions.names)) nearest.offer(known);
  messages_.add_once(Messages::Cause::malfunction,
                     "a client called a method with malfunction `" + of_peer(text) + "`, which was not found" +
                         (nearest.name().empty() ? "" : "; did you mean `" + std::string(nearest.name()) + "`?"));
  return UA_STATUSCODE_BADINVALIDARGUMENT;
}

// --- what open62541 calls, in the server's thread

UA_StatusCode Server::read(UA_Server* server, const UA_NodeId* /*session*/, void* /*session_context*/,
                           const UA_NodeId* /*node*/, void* context, UA_Boolean /*with_time*/,
                           const UA_NumericRange* range, UA_DataValue* value) {
  const auto& variable = *static_cast<const Variable*>(context);
  if (range != nullptr) {
    value->hasStatus = true;
    value->status = UA_STATUSCODE_BADINDEXRANGENODATA;  // all values are scalars
    return UA_STATUSCODE_GOOD;
  }
  Server& self = of(server);
  self.on_read(variable);
  *value = self.variables_.value_of(variable);
  if (!self.serving_) value->status = UA_STATUSCODE_GOOD;  // no node can be added with a bad value
  return UA_STATUSCODE_GOOD;
}

UA_StatusCode Server::write(UA_Server* server, const UA_NodeId* /*session*/, void* /*session_context*/,
                            const UA_NodeId* /*node*/, void* context, const UA_NumericRange* range,
                            const UA_DataValue* value) {
  Server& self = of(server);
  const UA_StatusCode status = self.on_write(*static_cast<Variable*>(context), range, *value);
  if (status != UA_STATUSCODE_GOOD) add(self.refused_, 1);
  return status;
}

void Server::monitored(UA_Server* /*server*/, const UA_NodeId* /*session*/, void* /*session_context*/,
                       const UA_NodeId* /*node*/, void* context, UA_UInt32 attribute, UA_Boolean removed) {
  if (context == nullptr || attribute != UA_ATTRIBUTEID_VALUE) return;
  auto& variable = *static_cast<Variable*>(context);
  removed ? --variable.monitored : ++variable.monitored;
}

/// The callback of a method: `act(server, inputs, outputs)`.
template <auto act>
UA_StatusCode Server::call(UA_Server* server, const UA_NodeId* /*session*/, void* /*session_context*/,
                           const UA_NodeId* /*method*/, void* /*method_context*/, const UA_NodeId* /*object*/,
                           void* /*object_context*/, std::size_t /*inputs*/, const UA_Variant* inputs,
                           std::size_t /*outputs*/, UA_Variant* outputs) {
  Server& self = of(server);
  const UA_StatusCode status = (self.*act)(inputs, outputs);
  if (status != UA_STATUSCODE_GOOD) add(self.refused_, 1);
  return status;
}

UA_StatusCode Server::start_malfunction(const UA_Variant* inputs, UA_Variant* /*outputs*/) {
  return on_malfunction(*inputs, LinkCommand::Kind::start_malfunction);
}

UA_StatusCode Server::end_malfunction(const UA_Variant* inputs, UA_Variant* /*outputs*/) {
  return on_malfunction(*inputs, LinkCommand::Kind::end_malfunction);
}

/// A freeze stays when its client leaves, so the user must know of it.
UA_StatusCode Server::freezing(LinkCommand given) {
  const UA_StatusCode status = command(given);
  if (status == UA_STATUSCODE_GOOD && !std::exchange(freezes_, true)) {
    messages_.add(Messages::Cause::freeze, given.kind == LinkCommand::Kind::freeze
                                               ? "a client froze the plant; its method Run ends this"
                                               : "a client steps the plant, and so froze it; its method Run ends this");
  }
  return status;
}

UA_StatusCode Server::freeze(const UA_Variant* /*inputs*/, UA_Variant* /*outputs*/) {
  return freezing({LinkCommand::Kind::freeze});
}

UA_StatusCode Server::run(const UA_Variant* /*inputs*/, UA_Variant* outputs) {
  const UA_StatusCode status = command({LinkCommand::Kind::run});
  const UA_Boolean frozen = frozen_otherwise_.load(std::memory_order_relaxed);
  if (status != UA_STATUSCODE_GOOD) return status;
  freezes_ = false;
  return UA_Variant_setScalarCopy(outputs, &frozen, &UA_TYPES[UA_TYPES_BOOLEAN]);
}

UA_StatusCode Server::step(const UA_Variant* inputs, UA_Variant* /*outputs*/) {
  if (!UA_Variant_hasScalarType(inputs, &UA_TYPES[UA_TYPES_UINT32])) return UA_STATUSCODE_BADINVALIDARGUMENT;
  const UA_UInt32 cycles = *static_cast<const UA_UInt32*>(inputs->data);
  if (cycles == 0) return UA_STATUSCODE_BADINVALIDARGUMENT;
  return freezing({LinkCommand::Kind::step, cycles});
}

NodeCallbacks Server::callbacks() {
  return {.variable = {read, write},
          .start_malfunction = call<&Server::start_malfunction>,
          .end_malfunction = call<&Server::end_malfunction>,
          .freeze = call<&Server::freeze>,
          .run = call<&Server::run>,
          .step = call<&Server::step>};
}

}  // namespace symplant::link::opc_ua
