// Node ids of OPC UA as texts, and templates of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace symplant::link::opc_ua {

/// A node id as its text has it: `ns=3;s="IO"."START"`, `nsu=URI;i=5`.
struct NodeId {
  std::string uri;          ///< of the namespace; empty: `space` is its number
  std::uint16_t space = 0;  ///< number of the namespace
  char kind = 's';          ///< i: number, s: text, g: GUID, b: bytes in base64
  std::string identifier;   ///< as in the text, not empty
  friend bool operator==(const NodeId&, const NodeId&) = default;
};

/// Nothing if the text is not a node id: `ns=NUMBER;` or `nsu=URI;` or neither, then `i=`, `s=`, `g=` or `b=`.
/// O(length).
std::optional<NodeId> parse_node_id(std::string_view text);

/// The text of which parse_node_id() makes this.
std::string node_id_text(const NodeId& node);

/// The template with its `{symbol}` and `{address}` replaced. O(length).
std::string fill_template(std::string_view text, std::string_view symbol, std::string_view address);

/// Why a text is not a template of node ids, and what to write; empty if it is one.
std::string template_problem(std::string_view text);

}  // namespace symplant::link::opc_ua
