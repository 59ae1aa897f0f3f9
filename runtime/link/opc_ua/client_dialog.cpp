// The conversation with a PLC that is an OPC UA server: its identity, and what is read.
#include "symplant/link/opc_ua/client_dialog.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "symplant/link/client/event_lanes.hpp"
#include "symplant/link/image/words.hpp"
#include "symplant/link/opc_ua/client_batches.hpp"
#include "symplant/link/opc_ua/messages.hpp"

namespace symplant::link::opc_ua {

using client::Fault;
using client::Identity;

namespace {

constexpr tables::Time kFirstLook = 500 * tables::kMillisecond;
constexpr tables::Time kLastLook = 30 * tables::kSecond;
constexpr tables::Time kLasting = 3 * tables::kSecond;  ///< a node without a value for so long is left out
constexpr std::uint16_t kWholeLane = 0xFFFF;

/// What is asked of a server, in this order.
constexpr std::array<UA_UInt32, 7> kServerNodes = {
    UA_NS0ID_SERVER_NAMESPACEARRAY,
    UA_NS0ID_SERVER_SERVERCAPABILITIES_OPERATIONLIMITS_MAXNODESPERREAD,
    UA_NS0ID_SERVER_SERVERCAPABILITIES_OPERATIONLIMITS_MAXNODESPERWRITE,
    UA_NS0ID_SERVER_SERVERCAPABILITIES_OPERATIONLIMITS_MAXNODESPERREGISTERNODES,
    UA_NS0ID_SERVER_SERVERSTATUS_BUILDINFO_MANUFACTURERNAME,
    UA_NS0ID_SERVER_SERVERSTATUS_BUILDINFO_PRODUCTNAME,
    UA_NS0ID_SERVER_SERVERSTATUS_BUILDINFO_SOFTWAREVERSION,
};
enum ServerNode : std::size_t { kNamespaceArray, kMaxRead, kMaxWrite, kMaxRegister, kManufacturer, kProduct, kVersion };

UA_ReadValueId value_of(const UA_NodeId& id) {
  UA_ReadValueId item;
  UA_ReadValueId_init(&item);
  item.nodeId = id;
  item.attributeId = UA_ATTRIBUTEID_VALUE;
  return item;
}

std::uint32_t number_or_zero(const UA_DataValue& value) {
  const bool is_number = UA_Variant_hasScalarType(&value.value, &UA_TYPES[UA_TYPES_UINT32]);
  return is_number ? *static_cast<const UA_UInt32*>(value.value.data) : 0;
}

std::string text_or_empty(const UA_DataValue& value) {
  if (!UA_Variant_hasScalarType(&value.value, &UA_TYPES[UA_TYPES_STRING])) return {};
  return of_peer(text_of(*static_cast<const UA_String*>(value.value.data)));
}

Namespaces namespaces_in(const UA_DataValue& value) {
  Namespaces namespaces;
  if (!UA_Variant_hasArrayType(&value.value, &UA_TYPES[UA_TYPES_STRING])) return namespaces;
  const auto* const texts = static_cast<const UA_String*>(value.value.data);
  for (std::size_t i = 0; i < value.value.arrayLength; ++i) namespaces.emplace_back(text_of(texts[i]));
  return namespaces;
}

/// Puts a number or bit of a node into an image.
void put(const ClientNode& node, std::uint64_t number, const client::Words& out) {
  if (has_bits(node.plane)) {
    image::set_bit(out.bits, node.position, number != 0);
  } else {
    out.numbers[node.position] = number;
  }
}

}  // namespace

ClientDialog::ClientDialog(const ClientSettings& settings, ClientSecurity security, ClientMap map, bool reads_only)
    : connection_(settings, std::move(security)),
      operations_(std::move(map.operations), false),
      events_(std::move(map.events), !reads_only),
      event_of_bit_(by_position(events_, Plane::event_bits, map.image.size(Plane::event_bits))),
      event_of_number_(by_position(events_, Plane::event_numbers, map.image.size(Plane::event_numbers))),
      numbers_(event_of_number_.size()),
      reported_out_(operations_.size()) {}

std::vector<std::size_t> ClientDialog::by_position(const ClientNodes& nodes, Plane plane, std::uint32_t size) {
  std::vector<std::size_t> result(size, kNoNode);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes.node(i).plane == plane) result[nodes.node(i).position] = i;
  }
  return result;
}

Fault ClientDialog::open() {
  prepared_ = false;
  return connection_.open();
}

/// On a new connection: what the server is and allows, and all nodes.
Fault ClientDialog::prepare() {
  if (prepared_) return {};
  operations_.forget();
  events_.forget();
  if (Fault fault = ask_server()) return fault;
  if (Fault fault = operations_.resolve(connection_, namespaces_, limits_)) return fault;
  if (Fault fault = events_.resolve(connection_, namespaces_, limits_)) return fault;
  look_pause_ = kFirstLook;
  next_look_.reset();
  prepared_ = true;
  return {};
}

Fault ClientDialog::ask_server() {
  std::vector<UA_ReadValueId> items;
  items.reserve(kServerNodes.size());
  for (const UA_UInt32 node : kServerNodes) items.push_back(value_of(UA_NODEID_NUMERIC(0, node)));
  std::array<OwnedDataValue, kServerNodes.size()> values;
  std::uint32_t limit = 0;
  UA_StatusCode result = UA_STATUSCODE_GOOD;
  Fault fault = read_attributes(connection_, items, limit, result, [&](std::size_t first, std::span<UA_DataValue> got) {
    for (std::size_t i = 0; i < got.size(); ++i) std::swap(*values[first + i], got[i]);
  });
  if (fault) return fault;
  if (is_bad(result))
    return {Fault::Kind::transport, "the server gives no information on itself: " + status_text(result)};
  namespaces_ = namespaces_in(*values[kNamespaceArray]);
  limits_ = {number_or_zero(*values[kMaxRead]), number_or_zero(*values[kMaxWrite]),
             number_or_zero(*values[kMaxRegister])};
  identity_ = connection_.application();
  for (const ServerNode part : {kManufacturer, kProduct, kVersion}) {
    const std::string text = text_or_empty(*values[part]);
    if (!text.empty()) identity_ += (identity_.empty() ? "" : ", ") + text;
  }
  return {};
}

Identity ClientDialog::identify(Fault& fault) {
  fault = prepare();
  if (fault) return {};
  const auto usable = [](const ClientNodes& nodes) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) count += std::size_t{nodes.is_usable(i)};
    return std::to_string(count) + " of " + std::to_string(nodes.size());
  };
  const std::string certificate = connection_.security_note();
  return {.kind = Identity::Kind::unverifiable,
          .message = (identity_.empty() ? "the server does not identify itself" : "the server is `" + identity_ + "`") +
                     (certificate.empty() ? "" : "; " + certificate) + "; it has the nodes of " + usable(operations_) +
                     " operations and " + usable(events_) + " events, but nothing that says which plant it controls"};
}

/// From time to time at the nodes that cannot be exchanged: the PLC may have got another program.
Fault ClientDialog::look_again(tables::Time now) {
  if (!next_look_) next_look_ = now + look_pause_;
  if (now < *next_look_ || (!operations_.any_unusable() && !events_.any_unusable())) return {};
  if (Fault fault = operations_.resolve(connection_, namespaces_, limits_)) return fault;
  if (Fault fault = events_.resolve(connection_, namespaces_, limits_)) return fault;
  look_pause_ = std::min(2 * look_pause_, kLastLook);
  next_look_ = now + look_pause_;
  return {};
}

Fault ClientDialog::read(const client::Words& operations, tables::Time now) {
  if (Fault fault = prepare()) return fault;
  if (Fault fault = look_again(now)) return fault;
  Fault fault = read_all(operations_, operations);
  leave_out(now);
  return fault;
}

Fault ClientDialog::read_back(const client::Words& events, tables::Time /*now*/) {
  if (Fault fault = prepare()) return fault;
  return read_all(events_, events);
}

/// `rejected` if no node has a value, or the server has refused a request.
Fault ClientDialog::read_all(ClientNodes& nodes, const client::Words& out) {
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes.is_readable(i)) some.push_back(i);
  }
  if (some.empty()) {
    Fault fault = keep_alive();
    if (!fault && nodes.size() != 0) fault.kind = Fault::Kind::rejected;
    return fault;
  }
  std::vector<UA_ReadValueId> items;
  items.reserve(some.size());
  for (const std::size_t i : some) items.push_back(value_of(nodes.id(i)));
  UA_StatusCode result = UA_STATUSCODE_GOOD;
  bool any = false;
  std::size_t done = 0;
  Fault fault = read_attributes(connection_, items, limits_.read, result,
                                [&](std::size_t first, std::span<const UA_DataValue> values) {
                                  any = take(nodes, std::span(some).subspan(first, values.size()), values, out) || any;
                                  done = first + values.size();
                                });
  if (fault) return fault;
  if (is_bad(result)) {
    rejected_.fetch_add(1, std::memory_order_relaxed);
    for (const std::size_t i : std::span(some).subspan(done)) nodes.note(i, result);
  }
  return {any && !is_bad(result) ? Fault::Kind::none : Fault::Kind::rejected};
}

/// The values of one request. True if one of them is good.
bool ClientDialog::take(ClientNodes& nodes, std::span<const std::size_t> some, std::span<const UA_DataValue> values,
                        const client::Words& out) {
  bool any = false;
  for (std::size_t k = 0; k < some.size(); ++k) {
    const auto number = nodes.take(some[k], values[k]);
    if (!number) continue;
    any = true;
    put(nodes.node(some[k]), *number, out);
    if (observer_ != nullptr) put(nodes.node(some[k]), ~std::uint64_t{0}, observer_->marks());
  }
  if (observer_ != nullptr) observer_->answered(connection_.sent(), connection_.answered());
  return any;
}

/// A request for a session without nodes to read.
Fault ClientDialog::keep_alive() {
  const std::array items = {value_of(UA_NODEID_NUMERIC(0, UA_NS0ID_SERVER_SERVERSTATUS_STATE))};
  UA_StatusCode result = UA_STATUSCODE_GOOD;
  return read_attributes(connection_, items, limits_.read, result, [](std::size_t, std::span<UA_DataValue>) {});
}

/// Operations that have not had a value for kLasting, each once.
void ClientDialog::leave_out(tables::Time now) {
  for (std::size_t i = 0; i < operations_.size(); ++i) {
    if (!is_bad(operations_.status(i)) || reported_out_[i] || operations_.bad_for(i, now) < kLasting) continue;
    reported_out_[i] = true;
    const ClientNode& node = operations_.node(i);
    const tables::Refusal refusal = refusal_of(false, operations_.status(i));
    const bool bit = has_bits(node.plane);
    const std::uint32_t lane = bit ? node.position / client::kLaneBits : image::kLanesPerWord * node.position;
    const auto mask = static_cast<std::uint16_t>(bit ? 1U << (node.position % client::kLaneBits) : kWholeLane);
    left_out_.push_back({{{node.plane, lane}, mask, 0}, refusal});
  }
}

std::vector<client::Rejection> ClientDialog::take_rejections() {
  std::vector<client::Rejection> all = operations_.take_rejections();
  for (client::Rejection& one : events_.take_rejections()) all.push_back(std::move(one));
  return all;
}

std::vector<client::LeftOut> ClientDialog::take_left_out() { return std::exchange(left_out_, {}); }

std::string ClientDialog::functions() const {
  const auto limit = [](std::uint32_t most) { return most == 0 ? std::string("any number of") : std::to_string(most); };
  return "the server reads " + limit(limits_.read) + " nodes in a request, and writes " + limit(limits_.write);
}

}  // namespace symplant::link::opc_ua
