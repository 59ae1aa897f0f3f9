// URLs of links that go to a PLC.
#include "symplant/link/url.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

namespace symplant::link {

namespace {

constexpr std::string_view kRepeated = "map";  ///< the key that may be there several times

LinkError url_error(std::string message) { return {LinkError::Kind::usage, std::move(message)}; }

/// The text with its `%XX` replaced; nothing if one is not complete.
std::optional<std::string> decoded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      result += text[i];
      continue;
    }
    unsigned byte = 0;
    const std::string_view digits = text.substr(i + 1, 2);
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
    if (digits.size() != 2 || error != std::errc() || stop != digits.data() + 2) return std::nullopt;
    result += static_cast<char>(byte);
    i += 2;
  }
  return result;
}

/// Reads `key=value`; an error if it is not that, or the key was there before.
std::optional<LinkError> add_parameter(std::string_view text, std::vector<UrlParameter>& parameters) {
  const std::string shown = "`" + std::string(text) + "`";
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string_view::npos) return url_error(shown + " is not a setting: write KEY=VALUE");
  const auto value = decoded(text.substr(equals + 1));
  if (!value) return url_error(shown + " has a `%` without two hexadecimal digits: write `%25` for a percent sign");
  const std::string key(text.substr(0, equals));
  const auto before = std::find_if(parameters.begin(), parameters.end(), [&](const auto& p) { return p.key == key; });
  if (before != parameters.end() && key != kRepeated) {
    return url_error("`" + key + "` is set twice, to `" + before->value + "` and `" + *value + "`: remove one");
  }
  parameters.push_back({key, *value});
  return std::nullopt;
}

}  // namespace

std::variant<std::vector<UrlParameter>, LinkError> parse_parameters(std::string_view query) {
  std::vector<UrlParameter> parameters;
  while (!query.empty()) {
    const std::size_t end = query.find('&');
    if (auto error = add_parameter(query.substr(0, end), parameters)) return std::move(*error);
    query = end == std::string_view::npos ? std::string_view() : query.substr(end + 1);
  }
  return parameters;
}

std::variant<ParsedUrl, LinkError> parse_url(std::string_view rest, std::string_view scheme) {
  if (rest.substr(0, 2) != "//") {
    return url_error("`" + std::string(rest) + "` after `" + std::string(scheme) +
                     ":` is not an address: give //HOST:PORT");
  }
  const std::size_t question = rest.find('?');
  auto address = net::parse_host_port(rest.substr(2, question == std::string_view::npos ? question : question - 2));
  if (auto* error = std::get_if<LinkError>(&address)) return std::move(*error);
  if (std::get<net::HostPort>(address).port == 0) {
    return url_error("port 0 is not a port of a PLC: give the one in its parameters");
  }
  auto parameters = parse_parameters(question == std::string_view::npos ? "" : rest.substr(question + 1));
  if (auto* error = std::get_if<LinkError>(&parameters)) return std::move(*error);
  return ParsedUrl{std::move(std::get<net::HostPort>(address)),
                   std::move(std::get<std::vector<UrlParameter>>(parameters))};
}

}  // namespace symplant::link
