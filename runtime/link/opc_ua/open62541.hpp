// open62541 with owners of its values; only for .cpp files of this folder and for tests.
#pragma once

#include <open62541/plugin/log.h>
#include <open62541/types.h>
#include <open62541/types_generated.h>
#include <open62541/types_generated_handling.h>
#include <open62541/util.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace symplant::link::opc_ua {

/// Owns a value of a type of open62541, which is UA_TYPES[type].
template <class T, std::size_t type>
class Owned {
 public:
  Owned() noexcept { UA_init(&value_, &UA_TYPES[type]); }
  /// Takes over what the value owns.
  explicit Owned(const T& value) noexcept : value_(value) {}
  Owned(Owned&& other) noexcept : Owned() { std::swap(value_, other.value_); }
  Owned& operator=(Owned&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() { UA_clear(&value_, &UA_TYPES[type]); }

  T* get() noexcept { return &value_; }
  const T* get() const noexcept { return &value_; }
  T& operator*() noexcept { return value_; }
  const T& operator*() const noexcept { return value_; }
  T* operator->() noexcept { return &value_; }
  const T* operator->() const noexcept { return &value_; }

 private:
  T value_;
};

using OwnedString = Owned<UA_String, UA_TYPES_STRING>;
using OwnedBytes = Owned<UA_ByteString, UA_TYPES_BYTESTRING>;
using OwnedNodeId = Owned<UA_NodeId, UA_TYPES_NODEID>;
using OwnedVariant = Owned<UA_Variant, UA_TYPES_VARIANT>;
using OwnedDataValue = Owned<UA_DataValue, UA_TYPES_DATAVALUE>;

/// The text as open62541 reads it; valid as long as `text`. open62541 does not change it.
inline UA_String view_of(std::string_view text) noexcept {
  return {text.size(), reinterpret_cast<UA_Byte*>(const_cast<char*>(text.data()))};
}

/// The text of a string; valid as long as the string.
inline std::string_view text_of(const UA_String& string) noexcept {
  return {reinterpret_cast<const char*>(string.data), string.length};
}

/// A string node id; valid as long as `text`.
inline UA_NodeId string_node(std::uint16_t ns, std::string_view text) noexcept {
  UA_NodeId id = UA_NODEID_NULL;
  id.namespaceIndex = ns;
  id.identifierType = UA_NODEIDTYPE_STRING;
  id.identifier.string = view_of(text);
  return id;
}

/// "BadNodeIdUnknown".
inline std::string status_name(UA_StatusCode status) { return UA_StatusCode_name(status); }

/// A logger that drops everything: what a user has to know are messages of the link. May be shared by any number of
/// clients and servers, of any thread.
inline UA_Logger* silent() noexcept {
  static UA_Logger logger{nullptr, nullptr, nullptr};
  return &logger;
}

}  // namespace symplant::link::opc_ua
