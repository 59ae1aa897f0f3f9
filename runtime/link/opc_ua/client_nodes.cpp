// The nodes of one direction on a connection.
#include "symplant/link/opc_ua/client_nodes.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "symplant/condition/compare.hpp"
#include "symplant/link/opc_ua/client_batches.hpp"
#include "symplant/link/opc_ua/data_types.hpp"
#include "symplant/link/opc_ua/status_text.hpp"
#include "symplant/link/url_values.hpp"

namespace symplant::link::opc_ua {

using client::Fault;

namespace {

/// What is read of each node, in this order.
constexpr std::array kAttributes = {UA_ATTRIBUTEID_DATATYPE, UA_ATTRIBUTEID_VALUERANK, UA_ATTRIBUTEID_USERACCESSLEVEL,
                                    UA_ATTRIBUTEID_VALUE};
enum Attribute : std::size_t { kDataType, kValueRank, kUserAccessLevel, kValue };

using tables::DataType;

/// A word of bits has no sign, but some PLCs offer it as a number with a sign.
constexpr std::optional<DataType> with_sign(DataType type) {
  switch (type) {
    case DataType::byte:
      return DataType::sint;
    case DataType::word:
      return DataType::int_;
    case DataType::dword:
      return DataType::dint;
    case DataType::lword:
      return DataType::lint;
    default:
      return std::nullopt;
  }
}

bool is_unknown(UA_StatusCode status) {
  return status == UA_STATUSCODE_BADNODEIDUNKNOWN || status == UA_STATUSCODE_BADNODEIDINVALID;
}

bool is_good(const UA_DataValue& value) { return !is_bad(value.status); }

/// The type of a node by its value, or else by its attribute if that is a type with values. Null: not known.
const UA_DataType* type_of(const UA_DataValue& value, const UA_DataValue& type) {
  if (is_good(value) && value.hasValue && value.value.type != nullptr) return value.value.type;
  if (!is_good(type) || !UA_Variant_hasScalarType(&type.value, &UA_TYPES[UA_TYPES_NODEID])) return nullptr;
  const UA_DataType* const found = UA_findDataType(static_cast<const UA_NodeId*>(type.value.data));
  return found != nullptr && found->typeKind <= UA_DATATYPEKIND_DOUBLE ? found : nullptr;
}

bool is_array(const UA_DataValue& value, const UA_DataValue& rank) {
  if (is_good(value) && value.hasValue && value.value.type != nullptr) return !UA_Variant_isScalar(&value.value);
  return is_good(rank) && UA_Variant_hasScalarType(&rank.value, &UA_TYPES[UA_TYPES_INT32]) &&
         *static_cast<const UA_Int32*>(rank.value.data) >= 0;
}

/// Whether the user's access level lacks a bit; false if the server does not have the attribute.
bool lacks(const UA_DataValue& level, UA_Byte bit) {
  return is_good(level) && UA_Variant_hasScalarType(&level.value, &UA_TYPES[UA_TYPES_BYTE]) &&
         (*static_cast<const UA_Byte*>(level.value.data) & bit) == 0;
}

std::string type_words(DataType type, const UA_DataType& found) {
  return "the symbol is " + std::string(condition::type_name(type)) + ", which is " + data_type_of(type).typeName +
         ", the node is " + found.typeName;
}

/// A node id as open62541 has it; nothing if it is not valid.
std::optional<OwnedNodeId> id_of(const NodeId& node, std::uint16_t space) {
  OwnedNodeId id;
  id->namespaceIndex = space;
  const UA_String text = view_of(node.identifier);
  switch (node.kind) {
    case 'i':
      std::from_chars(node.identifier.data(), node.identifier.data() + node.identifier.size(), id->identifier.numeric);
      return id;
    case 's':
      id->identifierType = UA_NODEIDTYPE_STRING;
      UA_String_copy(&text, &id->identifier.string);
      return id;
    case 'g':
      id->identifierType = UA_NODEIDTYPE_GUID;
      if (UA_Guid_parse(&id->identifier.guid, text) != UA_STATUSCODE_GOOD) return std::nullopt;
      return id;
    default:
      id->identifierType = UA_NODEIDTYPE_BYTESTRING;
      if (UA_ByteString_fromBase64(&id->identifier.byteString, &text) != UA_STATUSCODE_GOOD) return std::nullopt;
      return id;
  }
}

}  // namespace

ClientNodes::ClientNodes(std::vector<ClientNode> nodes, bool writes)
    : nodes_(std::move(nodes)), writes_(writes), states_(nodes_.size()) {}

void ClientNodes::forget() {
  states_.clear();
  states_.resize(nodes_.size());
}

bool ClientNodes::any_unusable() const {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (!is_usable(i)) return true;
  }
  return false;
}

void ClientNodes::note(std::size_t i, UA_StatusCode status, std::string detail) {
  State& state = states_[i];
  if (!is_bad(status)) {
    state.status = UA_STATUSCODE_GOOD;
    return;
  }
  if (!is_bad(state.status)) state.since.reset();
  if (is_unknown(status)) state.readable = state.writable = false;
  state.status = status;
  state.detail = std::move(detail);
}

tables::Time ClientNodes::bad_for(std::size_t i, tables::Time now) {
  std::optional<tables::Time>& since = states_[i].since;
  if (!since) since = now;
  return now - *since;
}

std::optional<std::uint64_t> ClientNodes::take(std::size_t i, const UA_DataValue& value) {
  if (is_bad(value.status)) {
    // An event that was not written yet may have no value.
    if (!writes_ || is_unknown(value.status)) note(i, value.status);
    return std::nullopt;
  }
  const auto number = number_of(value.value, states_[i].type);
  if (number) {
    if (is_usable(i)) note(i, UA_STATUSCODE_GOOD);
  } else if (value.value.type == nullptr) {
    note(i, UA_STATUSCODE_BADWAITINGFORINITIALDATA);
  } else {
    note(i, UA_STATUSCODE_BADTYPEMISMATCH, type_words(nodes_[i].type, *value.value.type));
  }
  return number;
}

Fault ClientNodes::resolve(ClientConnection& connection, const Namespaces& namespaces, OperationLimits& limits) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!is_usable(i) && make_id(i, namespaces)) open.push_back(i);
  }
  if (Fault fault = examine(connection, open, limits)) return fault;
  std::erase_if(open, [&](std::size_t i) { return !states_[i].readable && !states_[i].writable; });
  return register_nodes(connection, open, limits);
}

bool ClientNodes::make_id(std::size_t i, const Namespaces& namespaces) {
  const NodeId& node = nodes_[i].id;
  std::uint16_t space = node.space;
  if (!node.uri.empty()) {
    const auto found = std::find(namespaces.begin(), namespaces.end(), node.uri);
    if (found == namespaces.end()) {
      note(i, UA_STATUSCODE_BADNODEIDUNKNOWN, "the server does not have the namespace");
      return false;
    }
    space = static_cast<std::uint16_t>(found - namespaces.begin());
  }
  auto id = id_of(node, space);
  if (!id) {
    note(i, UA_STATUSCODE_BADNODEIDINVALID);
    return false;
  }
  states_[i].id = std::move(*id);
  return true;
}

/// Reads the attributes of some nodes.
Fault ClientNodes::examine(ClientConnection& connection, std::span<const std::size_t> some, OperationLimits& limits) {
  std::vector<UA_ReadValueId> items;
  for (const std::size_t i : some) {
    for (const auto attribute : kAttributes) {
      UA_ReadValueId& item = items.emplace_back();
      item.nodeId = *states_[i].id;
      item.attributeId = static_cast<UA_UInt32>(attribute);
    }
  }
  std::vector<OwnedDataValue> values(items.size());
  UA_StatusCode result = UA_STATUSCODE_GOOD;
  std::size_t done = 0;
  Fault fault =
      read_attributes(connection, items, limits.read, result, [&](std::size_t first, std::span<UA_DataValue> got) {
        for (std::size_t k = 0; k < got.size(); ++k) std::swap(*values[first + k], got[k]);
        done = first + got.size();
      });
  if (fault) return fault;
  const std::size_t complete = done / kAttributes.size();
  for (std::size_t k = 0; k < complete; ++k) {
    judge(some[k], std::span(values).subspan(k * kAttributes.size(), kAttributes.size()));
  }
  for (const std::size_t i : some.subspan(complete)) note(i, result);
  return {};
}

/// Whether a node can be exchanged.
void ClientNodes::judge(std::size_t i, std::span<const OwnedDataValue> attributes) {
  const UA_DataValue& value = *attributes[kValue];
  if (!is_good(*attributes[kDataType]) && !is_good(value)) return note(i, attributes[kDataType]->status);
  if (!has_type(i, attributes)) return;
  const UA_DataValue& level = *attributes[kUserAccessLevel];
  states_[i].readable = !lacks(level, UA_ACCESSLEVELMASK_READ) && value.status != UA_STATUSCODE_BADUSERACCESSDENIED;
  states_[i].writable = !lacks(level, UA_ACCESSLEVELMASK_WRITE);
  const UA_StatusCode refused = writes_ ? UA_STATUSCODE_BADNOTWRITABLE : UA_STATUSCODE_BADNOTREADABLE;
  note(i, is_usable(i) ? UA_STATUSCODE_GOOD : refused);
}

bool ClientNodes::has_type(std::size_t i, std::span<const OwnedDataValue> attributes) {
  const DataType wanted = nodes_[i].type;
  const UA_DataType* const found = type_of(*attributes[kValue], *attributes[kDataType]);
  if (is_array(*attributes[kValue], *attributes[kValueRank])) {
    note(i, UA_STATUSCODE_BADTYPEMISMATCH, "the node is an array");
    return false;
  }
  states_[i].type = wanted;
  if (found == nullptr || found == &data_type_of(wanted)) return true;
  if (const auto other = with_sign(wanted); other && found == &data_type_of(*other)) {
    states_[i].type = *other;
    return true;
  }
  note(i, UA_STATUSCODE_BADTYPEMISMATCH, type_words(wanted, *found));
  return false;
}

/// A server finds registered nodes faster. One that does not register them is used with their own ids.
Fault ClientNodes::register_nodes(ClientConnection& connection, std::span<const std::size_t> some,
                                  OperationLimits& limits) {
  UA_StatusCode result = UA_STATUSCODE_GOOD;
  return in_batches(some.size(), limits.register_nodes, result,
                    [&](std::size_t first, std::size_t count, UA_StatusCode& answer) {
                      std::vector<UA_NodeId> ids;
                      for (const std::size_t i : some.subspan(first, count)) ids.push_back(*states_[i].id);
                      UA_RegisterNodesRequest request;
                      UA_RegisterNodesRequest_init(&request);
                      request.nodesToRegister = ids.data();
                      request.nodesToRegisterSize = ids.size();
                      Owned<UA_RegisterNodesResponse, UA_TYPES_REGISTERNODESRESPONSE> response;
                      Fault fault = connection.call(request, UA_TYPES_REGISTERNODESREQUEST, response, answer);
                      if (fault || is_bad(answer) || response->registeredNodeIdsSize != count) return fault;
                      for (std::size_t k = 0; k < count; ++k) {
                        std::swap(*states_[some[first + k]].id, response->registeredNodeIds[k]);
                      }
                      return fault;
                    });
}

std::vector<client::Rejection> ClientNodes::take_rejections() {
  std::map<UA_StatusCode, std::vector<std::size_t>> fresh;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    State& state = states_[i];
    if (!is_bad(state.status) || state.status == state.announced) continue;
    state.announced = state.status;
    fresh[state.status].push_back(i);
  }
  std::vector<client::Rejection> rejections;
  rejections.reserve(fresh.size());
  for (const auto& [status, some] : fresh) {
    rejections.push_back({answer_of(status), refusal_of(writes_, status), words_of(status, some)});
  }
  return rejections;
}

/// "2 operations are not read: `A` (ns=3;s=A), `B` (ns=3;s=B): BadNodeIdUnknown (...): ...".
std::string ClientNodes::words_of(UA_StatusCode status, std::span<const std::size_t> some) const {
  constexpr std::size_t kNamed = 3;
  const bool events = is_event(nodes_[some.front()].plane);
  std::string text = std::to_string(some.size()) + (events ? " event" : " operation") +
                     (some.size() == 1 ? " is" : "s are") + (writes_ ? " not written: " : " not read: ");
  for (std::size_t k = 0; k < std::min(some.size(), kNamed); ++k) {
    const ClientNode& node = nodes_[some[k]];
    const std::string& detail = states_[some[k]].detail;
    text += (k == 0 ? "" : ", ") + ticked_text(node.symbol) + " (" + node_id_text(node.id) +
            (detail.empty() ? "" : ", " + detail) + ")";
  }
  return text + (some.size() > kNamed ? ", ..." : "") + ": " + status_text(status);
}

}  // namespace symplant::link::opc_ua
