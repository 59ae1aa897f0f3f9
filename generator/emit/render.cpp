// Templates by kainjow's mustache, which is seen here only.
#include "emit/render.hpp"

#include <algorithm>
#include <kainjow/mustache.hpp>

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

/// The library leaves unknown keys empty; a template of the user's with a slip in it must not be taken for good.
const TemplateError* unknown_key(const Template& text, TemplateError& error) {
  std::string_view rest = text.text;
  for (std::size_t open = rest.find("{{"); open != rest.npos; open = rest.find("{{")) {
    const auto line = [&] {
      const auto before = text.text.substr(0, static_cast<std::size_t>(rest.data() - text.text.data()));
      return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    };
    rest.remove_prefix(open + 2);
    const std::size_t close = rest.find("}}");
    if (close == rest.npos) {
      error = {line(), "a tag is opened and not closed: write `}}` behind its key"};
      return &error;
    }
    std::string_view key = rest.substr(0, close);
    rest.remove_prefix(close + 2);
    if (!key.empty() && key.front() == '!') continue;
    while (!key.empty() && (key.front() == '{' || key.front() == '#' || key.front() == '^' || key.front() == '/' ||
                            key.front() == '&' || key.front() == ' ')) {
      key.remove_prefix(1);
    }
    while (!key.empty() && key.back() == ' ') key.remove_suffix(1);
    if (is_key(text.name, key)) continue;
    error = {line(),
             "`" + std::string(key) + "` is no key of this template: see templates/README.md for those that are"};
    return &error;
  }
  return nullptr;
}

}  // namespace

base::Result<std::string, TemplateError> render(const Template& text, const View& view) {
  TemplateError error;
  if (unknown_key(text, error) != nullptr) return error;
  mustache::mustache made{std::string(text.text)};
  if (!made.is_valid()) return TemplateError{1, made.error_message()};
  made.set_custom_escape([](const std::string& encoded) { return encoded; });
  return made.render(to_data(view));
}

}  // namespace symplant::emit
