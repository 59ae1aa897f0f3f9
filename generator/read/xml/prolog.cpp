// What an XML text shows before its content.
#include "read/xml/prolog.hpp"

#include <algorithm>

namespace symplant::read::xml {

namespace {

constexpr std::size_t kPrologBytes = 64 * 1024;

/// The offset after the next `end`; the text's size if there is none.
std::size_t after(std::string_view text, std::string_view end, std::size_t from) {
  const std::size_t found = text.find(end, from);
  return found == std::string_view::npos ? text.size() : found + end.size();
}

/// The offset after a document type declaration, whose internal part is in brackets.
std::size_t after_doctype(std::string_view text, std::size_t from) {
  const std::size_t mark = std::min(text.find_first_of("[>", from), text.size());
  if (mark < text.size() && text[mark] == '[') return after(text, ">", after(text, "]", mark));
  return std::min(mark + 1, text.size());
}

std::string_view local_name_at(std::string_view text, std::size_t from) {
  const std::size_t end = std::min(text.find_first_of(" \t\r\n/>", from), text.size());
  const std::string_view name = text.substr(from, end - from);
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

}  // namespace

Prolog read_prolog(std::string_view text) {
  text = text.substr(0, kPrologBytes);
  Prolog prolog;
  std::size_t at = 0;
  for (;;) {
    at = text.find_first_not_of(" \t\r\n", at);
    if (at == std::string_view::npos || text[at] != '<') return prolog;
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<?")) {
      at = after(text, "?>", at);
    } else if (rest.starts_with("<!--")) {
      at = after(text, "-->", at);
    } else if (rest.starts_with("<!")) {
      prolog.doctype = at;
      at = after_doctype(text, at);
    } else {
      prolog.root = local_name_at(text, at + 1);
      prolog.head = rest;
      return prolog;
    }
  }
}

}  // namespace symplant::read::xml
