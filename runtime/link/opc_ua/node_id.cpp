// Node ids of OPC UA as texts, and templates of them.
#include "symplant/link/opc_ua/node_id.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace symplant::link::opc_ua {

namespace {

constexpr const char* kForm =
    "write a node id, such as ns=3;s=\"IO\".\"{symbol}\", ns=2;s={address} or nsu=URI;s={symbol}";

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return number;
}

bool is_hexadecimal(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

/// 8-4-4-4-12 hexadecimal digits.
bool is_guid(std::string_view text) {
  constexpr std::string_view kPattern = "xxxxxxxx-xxxx-xxxx-xxxx-xxxxxxxxxxxx";
  return text.size() == kPattern.size() &&
         std::equal(text.begin(), text.end(), kPattern.begin(),
                    [](char c, char pattern) { return pattern == '-' ? c == '-' : is_hexadecimal(c); });
}

bool is_base64(std::string_view text) {
  constexpr std::size_t kGroup = 4;
  const std::string_view digits = text.substr(0, text.find('='));
  const bool known = std::all_of(digits.begin(), digits.end(), [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' || c == '/';
  });
  const std::string_view padding = text.substr(digits.size());
  return known && !digits.empty() && text.size() % kGroup == 0 && padding.size() <= 2 &&
         padding.find_first_not_of('=') == padding.npos;
}

bool fits(char kind, std::string_view identifier) {
  switch (kind) {
    case 'i':
      return number_in<std::uint32_t>(identifier).has_value();
    case 's':
      return !identifier.empty();
    case 'g':
      return is_guid(identifier);
    case 'b':
      return is_base64(identifier);
    default:
      return false;
  }
}

}  // namespace

std::optional<NodeId> parse_node_id(std::string_view text) {
  NodeId node;
  const std::size_t end = text.find(';');
  const std::string_view space = text.substr(0, end == text.npos ? 0 : end);
  if (space.starts_with("nsu=")) {
    node.uri = space.substr(4);
    if (node.uri.empty()) return std::nullopt;
    text.remove_prefix(end + 1);
  } else if (space.starts_with("ns=")) {
    const auto number = number_in<std::uint16_t>(space.substr(3));
    if (!number) return std::nullopt;
    node.space = *number;
    text.remove_prefix(end + 1);
  }
  if (text.size() < 2 || text[1] != '=') return std::nullopt;
  node.kind = text[0];
  node.identifier = text.substr(2);
  if (!fits(node.kind, node.identifier)) return std::nullopt;
  return node;
}

std::string node_id_text(const NodeId& node) {
  const std::string space = !node.uri.empty() ? "nsu=" + node.uri + ";"
                            : node.space != 0 ? "ns=" + std::to_string(node.space) + ";"
                                              : std::string();
  return space + node.kind + "=" + node.identifier;
}

std::string fill_template(std::string_view text, std::string_view symbol, std::string_view address) {
  const std::array<std::pair<std::string_view, std::string_view>, 2> values{
      {{"{symbol}", symbol}, {"{address}", address}}};
  std::string filled;
  while (!text.empty()) {
    const auto found =
        std::find_if(values.begin(), values.end(), [&](const auto& value) { return text.starts_with(value.first); });
    if (found == values.end()) {
      filled += text.front();
      text.remove_prefix(1);
    } else {
      filled += found->second;
      text.remove_prefix(found->first.size());
    }
  }
  return filled;
}

std::string template_problem(std::string_view text) {
  const std::string rest = fill_template(text, "", "");
  if (const std::size_t brace = rest.find('{'); brace != rest.npos) {
    return "`" + rest.substr(brace, rest.find('}', brace) - brace + 1) + "` is not known: use {symbol} and {address}";
  }
  // Digits, so that a template of numbers is valid, too.
  return parse_node_id(fill_template(text, "1", "1")) ? std::string() : kForm;
}

}  // namespace symplant::link::opc_ua
