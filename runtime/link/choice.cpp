// Assigns links to the controllers whose symbols they carry.
#include "symplant/link/choice.hpp"

#include <algorithm>
#include <optional>

#include "symplant/link/kinds.hpp"
#include "symplant/link/names.hpp"
#include "symplant/tables/ascii.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::link {
namespace {

using Names = std::vector<std::string_view>;

std::optional<std::uint32_t> find(const Names& names, std::string_view wanted) {
  const auto found = std::find_if(names.begin(), names.end(),
                                  [&](std::string_view name) { return tables::equal_ignoring_case(name, wanted); });
  if (found == names.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - names.begin());
}

std::string text_of(const Names& names, std::uint32_t controller) {
  if (controller >= names.size() || names[controller].empty()) return "the controller without a name";
  return "controller `" + std::string(names[controller]) + "`";
}

/// "`PLC1`, `PLC2`": the controllers with a name, which a link can name.
std::string known(const Names& names) {
  std::string text;
  for (const std::string_view name : names) {
    if (!name.empty()) text.append(text.empty() ? "`" : ", `").append(name).append("`");
  }
  return text;
}

LinkError usage(std::string message) { return {LinkError::Kind::usage, std::move(message)}; }

LinkError unknown(const Names& names, const LinkRequest& request) {
  const std::string what = "controller `" + request.controller + "` not found; ";
  tables::NearestName nearest(request.controller);
  for (const std::string_view name : names) nearest.offer(name);
  if (!nearest.name().empty()) return usage(what + "did you mean `" + std::string(nearest.name()) + "`?");
  const std::string there = known(names);
  if (!there.empty()) return usage(what + "this plant has " + there);
  return usage(what + "this plant's controller has no name, give only the URL");
}

std::variant<LinkChoice, LinkError> choose(const Names& names, const LinkRequest& request) {
  if (!request.controller.empty()) {
    if (const auto found = find(names, request.controller)) return LinkChoice{request.url, *found};
    return unknown(names, request);
  }
  if (names.size() <= 1) return LinkChoice{request.url, 0};
  if (is_loop(request.url)) return LinkChoice{request.url, kAllControllers};
  if (const auto unnamed = find(names, "")) return LinkChoice{request.url, *unnamed};
  return usage("`" + request.url + "` does not say which controller it links: write `" + std::string(names.front()) +
               "=" + request.url + "`; this plant has " + known(names));
}

}  // namespace

LinkRequest parse_request(std::string_view text) {
  const std::size_t equals = text.substr(0, text.find(':')).find('=');
  if (equals == std::string_view::npos) return {"", std::string(text)};
  return {std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

bool is_loop(std::string_view url) {
  const Kind* const kind = kind_of(url);
  return kind != nullptr && !kind->real && rest_of(url).empty();
}

bool has_fixed_port(std::string_view url) { return !is_loop(url) && !url.substr(0, url.find('?')).ends_with(":0"); }

std::string controller_text(const tables::PlantTables& tables, std::uint32_t controller) {
  return text_of(tables::split_names(tables.controller_names), controller);
}

std::variant<std::vector<LinkChoice>, LinkError> choose_links(const tables::PlantTables& tables,
                                                              std::span<const LinkRequest> requests) {
  const Names names = tables::split_names(tables.controller_names);
  std::vector<LinkChoice> choices;
  for (const LinkRequest& request : requests) {
    auto choice = choose(names, request);
    if (auto* error = std::get_if<LinkError>(&choice)) return std::move(*error);
    auto& chosen = std::get<LinkChoice>(choice);
    if (!is_loop(chosen.url)) {
      const auto other = std::find_if(choices.begin(), choices.end(), [&](const LinkChoice& before) {
        return !is_loop(before.url) && before.controller == chosen.controller;
      });
      if (other != choices.end()) {
        return usage(text_of(names, chosen.controller) + " has two links, `" + other->url + "` and `" + chosen.url +
                     "`: both would write its operations, remove one");
      }
    }
    const auto same = std::find_if(choices.begin(), choices.end(),
                                   [&](const LinkChoice& before) { return before.url == chosen.url; });
    if (same != choices.end() && has_fixed_port(chosen.url)) {
      return usage(text_of(names, same->controller) + " and " + text_of(names, chosen.controller) +
                   " both have the link `" + chosen.url + "`: give each its own port");
    }
    choices.push_back(std::move(chosen));
  }
  return choices;
}

}  // namespace symplant::link
