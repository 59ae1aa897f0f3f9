// Renders templates with kainjow's mustache. No other file includes that library.
#include "emit/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <kainjow/mustache.hpp>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "emit/keys.hpp"

namespace symplant::emit {
namespace {

namespace mustache = kainjow::mustache;

/// Encloses, in the rendered frame, the number of a row source: the rows are inserted there when the text is read.
constexpr char kMark = '\x01';

using Keys = std::set<std::string, std::less<>>;

/// The library copies what is put into an object or a list, with all that it holds, and gives it back as const only. So
/// each object and list is put in empty and filled afterwards.
mustache::data& to_fill(const mustache::data& put_in) {
  return const_cast<mustache::data&>(put_in);  // NOLINT(cppcoreguidelines-pro-type-const-cast): it is not const itself
}

/// Only keys that the template uses: most templates use few of them, and the device types may be many.
void fill(mustache::data& data, const View& view, const Keys& used, std::vector<RowSource>& sources) {
  for (const auto& [key, text] : view.texts) {
    if (used.contains(key)) data.set(key, text);
  }
  for (const auto& [key, source] : view.rows) {
    if (!used.contains(key)) continue;
    data.set(key, kMark + std::to_string(sources.size()) + kMark);
    sources.push_back(source);
  }
  for (const auto& [key, items] : view.lists) {
    if (!used.contains(key)) continue;
    data.set(key, mustache::data{mustache::data::type::list});
    mustache::data& list = to_fill(*data.get(key));
    for (std::size_t i = 0; i < items.size(); ++i) list.push_back(mustache::data{});  // a list that grows copies, too
    for (std::size_t i = 0; i < items.size(); ++i) fill(to_fill(list.list_value()[i]), items[i], used, sources);
  }
}

/// The first fault of a template's tags, if there is one; adds their keys to `used`. The library leaves unknown keys
/// empty and reports no lines: it would accept a user's template with a misspelled key.
std::optional<TemplateError> fault_of(const Template& text, Keys& used) {
  struct Section {
    std::string key;
    std::size_t line;
  };
  std::vector<Section> open_sections;
  const auto open_lists = [&] {
    std::vector<std::string> lists;
    if (text.name == kOwnFile) lists.emplace_back("behaviours");
    for (const Section& section : open_sections) lists.push_back(section.key);
    return lists;
  };
  std::string_view rest = text.text;
  for (std::size_t open = rest.find("{{"); open != rest.npos; open = rest.find("{{")) {
    rest.remove_prefix(open + 2);
    const auto before = text.text.substr(0, static_cast<std::size_t>(rest.data() - text.text.data()));
    const auto line = 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    const std::size_t close = rest.find("}}");
    if (close == rest.npos) return TemplateError{line, "a tag is not closed: write `}}` after its key"};
    std::string_view key = rest.substr(0, close);
    rest.remove_prefix(close + 2);
    const char kind = key.empty() ? ' ' : key.front();
    if (kind == '!') continue;
    if (std::string_view("{#^/& ").find(kind) != std::string_view::npos && !key.empty()) key.remove_prefix(1);
    while (!key.empty() && key.front() == ' ') key.remove_prefix(1);
    while (!key.empty() && key.back() == ' ') key.remove_suffix(1);
    const std::string name(key);
    used.insert(name);
    if (kind != '/') {
      if (std::string fault = fault_of_key(key, open_lists(), kind == '#' || kind == '^'); !fault.empty())
        return TemplateError{line, fault};
    }
    if (kind == '#' || kind == '^') open_sections.push_back({name, line});
    if (kind != '/') continue;
    if (open_sections.empty() || open_sections.back().key != name) {
      return TemplateError{
          line, fmt::format("`{{{{/{0}}}}}` closes a list that is not open: write `{{{{#{0}}}}}` before it", name)};
    }
    open_sections.pop_back();
  }
  if (open_sections.empty()) return std::nullopt;
  const Section& section = open_sections.back();
  return TemplateError{section.line,
                       "`" + section.key + "` is opened and not closed: write `{{/" + section.key + "}}` after it"};
}

/// Replaces the line end of a tag that is alone on its line; the library itself removes only some of these line ends.
constexpr char kNoLineEnd = '\x02';

/// The template with the line ends marked after lines that only open or close a list, or hold a comment.
std::string with_tag_lines_marked(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end);
    result += line;
    const bool tag = line.size() > 5 && line.starts_with("{{") && std::string_view("#^/!").find(line[2]) != line.npos;
    if (tag && line.ends_with("}}\n") && line.find("{{", 2) == line.npos) result.back() = kNoLineEnd;
  }
  return result;
}

void put_rows(const RowSource& source, base::TextSink& sink) {
  RowWriter rows(sink);
  source(rows);
  rows.finish();
}

/// Writes the frame with each mark replaced by its rows.
void put_together(std::string_view frame, const std::vector<RowSource>& sources, base::TextSink& sink) {
  for (;;) {
    const std::size_t mark = frame.find(kMark);
    if (const std::string_view before = frame.substr(0, mark); !before.empty()) sink.put(before);
    if (mark == frame.npos) return;
    frame.remove_prefix(mark + 1);
    std::size_t number = 0;
    const char* const end = std::from_chars(frame.data(), frame.data() + frame.size(), number).ptr;
    put_rows(sources[number], sink);
    frame.remove_prefix(static_cast<std::size_t>(end - frame.data()) + 1);
  }
}

}  // namespace

base::Result<base::TextSource, TemplateError> render(const Template& text, const View& view) {
  Keys used;
  if (auto fault = fault_of(text, used)) return *fault;
  for (const char control : {kMark, kNoLineEnd}) {
    const std::size_t found = text.text.find(control);
    if (found == text.text.npos) continue;
    const std::string_view before = text.text.substr(0, found);
    return TemplateError{1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')),
                         fmt::format("the control character U+000{} is not allowed here: remove it", int{control})};
  }
  mustache::mustache made{with_tag_lines_marked(text.text)};
  if (!made.is_valid()) return TemplateError{1, made.error_message()};
  made.set_custom_escape([](const std::string& encoded) { return encoded; });
  std::vector<RowSource> sources;
  mustache::data data;
  fill(data, view, used, sources);
  std::string frame = made.render(data);
  frame.erase(std::remove(frame.begin(), frame.end(), kNoLineEnd), frame.end());
  return base::TextSource([frame = std::move(frame), sources = std::move(sources)](base::TextSink& sink) {
    put_together(frame, sources, sink);
  });
}

}  // namespace symplant::emit
