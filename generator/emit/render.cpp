// Templates by kainjow's mustache, which is seen here only.
#include "emit/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <optional>
#include <vector>

#include "emit/keys.hpp"

namespace symplant::emit {
namespace {

namespace mustache = kainjow::mustache;

mustache::data to_data(const View& view) {
  mustache::data data;
  for (const auto& [key, text] : view.texts) data.set(key, text);
  for (const auto& [key, items] : view.lists) {
    mustache::data list{mustache::data::type::list};
    for (const View& item : items) list << to_data(item);
    data.set(key, list);
  }
  return data;
}

/// What is wrong with a template's tags; nothing where all is well. The library leaves unknown keys empty and knows no
/// lines; a template of the user's with a slip in it must not be taken for good.
std::optional<TemplateError> fault_of(const Template& text) {
  struct Section {
    std::string key;
    std::size_t line;
  };
  std::vector<Section> open_sections;
  std::string_view rest = text.text;
  for (std::size_t open = rest.find("{{"); open != rest.npos; open = rest.find("{{")) {
    rest.remove_prefix(open + 2);
    const auto before = text.text.substr(0, static_cast<std::size_t>(rest.data() - text.text.data()));
    const auto line = 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    const std::size_t close = rest.find("}}");
    if (close == rest.npos) return TemplateError{line, "a tag is opened and not closed: write `}}` behind its key"};
    std::string_view key = rest.substr(0, close);
    rest.remove_prefix(close + 2);
    const char kind = key.empty() ? ' ' : key.front();
    if (kind == '!') continue;
    if (std::string_view("{#^/& ").find(kind) != std::string_view::npos && !key.empty()) key.remove_prefix(1);
    while (!key.empty() && key.front() == ' ') key.remove_prefix(1);
    while (!key.empty() && key.back() == ' ') key.remove_suffix(1);
    const std::string name(key);
    if (!is_key(text.name, key)) {
      return TemplateError{line,
                           "`" + name + "` is no key of this template: see templates/README.md for those that are"};
    }
    if (kind == '#' || kind == '^') open_sections.push_back({name, line});
    if (kind != '/') continue;
    if (open_sections.empty() || open_sections.back().key != name) {
      return TemplateError{line,
                           fmt::format("`{{{{/{0}}}}}` closes what is not open: write `{{{{#{0}}}}}` before it", name)};
    }
    open_sections.pop_back();
  }
  if (open_sections.empty()) return std::nullopt;
  const Section& section = open_sections.back();
  return TemplateError{section.line,
                       "`" + section.key + "` is opened and not closed: write `{{/" + section.key + "}}` behind it"};
}

}  // namespace

base::Result<std::string, TemplateError> render(const Template& text, const View& view) {
  if (auto fault = fault_of(text)) return *fault;
  mustache::mustache made{std::string(text.text)};
  if (!made.is_valid()) return TemplateError{1, made.error_message()};
  made.set_custom_escape([](const std::string& encoded) { return encoded; });
  return made.render(to_data(view));
}

}  // namespace symplant::emit
