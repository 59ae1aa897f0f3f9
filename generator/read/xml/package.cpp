// Packages of AutomationML.
#include "read/xml/package.hpp"

#include <algorithm>
#include <charconv>
#include <pugixml.hpp>
#include <utility>
#include <vector>

#include "text/ascii.hpp"

namespace symplant::read::xml {

namespace {

constexpr std::string_view kExtension = ".aml";
const std::string kRelations = "_rels/.rels";

/// Archives of macOS have a second, binary file for each.
bool is_document(std::string_view path) {
  return path.size() > kExtension.size() && !path.starts_with("__MACOSX/") &&
         text::equal_ignoring_case(path.substr(path.size() - kExtension.size()), kExtension);
}

/// The path that a relation names: a URI, relative to the package.
std::string path_of(std::string_view uri) {
  if (uri.starts_with("./")) uri.remove_prefix(2);
  if (uri.starts_with('/')) uri.remove_prefix(1);
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    int code = 0;
    const std::string_view digits = uri.substr(i + 1, 2);
    const char* const end = digits.data() + digits.size();
    if (uri[i] == '%' && digits.size() == 2 && std::from_chars(digits.data(), end, code, 16).ptr == end) {
      path += static_cast<char>(code);
      i += 2;
    } else {
      path += uri[i];
    }
  }
  return path;
}

/// The root that the relations name; empty if they name none.
std::string named_root(const std::string& relations) {
  pugi::xml_document document;
  if (!document.load_buffer(relations.data(), relations.size())) return {};
  for (const pugi::xml_node& relation : document.document_element().children()) {
    if (!std::string_view(relation.attribute("Type").value()).ends_with("/RootDocument")) continue;
    return path_of(relation.attribute("Target").value());
  }
  return {};
}

}  // namespace

bool is_automationml_package(std::string_view bytes) {
  if (!Archive::is_one(bytes)) return false;
  const auto archive = Archive::open(bytes, "package");
  return archive && std::ranges::any_of(archive->paths(), is_document);
}

base::Result<PackedDocument, ArchiveFault> read_automationml_package(std::string_view bytes) {
  auto archive = Archive::open(bytes, "package");
  if (!archive) return archive.error();
  std::vector<std::string> paths = archive->paths();
  std::erase_if(paths, [](const std::string& path) { return !is_document(path); });
  std::string root;
  if (archive->has(kRelations)) {
    const auto relations = archive->whole(kRelations);
    if (!relations) return relations.error();
    root = named_root(*relations);
  }
  if (root.empty() && paths.size() == 1) root = paths.front();
  if (root.empty()) return ArchiveFault{"the package has several documents, and no relation names the root"};
  auto document = archive->whole(root);
  if (!document) return document.error();
  return PackedDocument{std::move(root), std::move(*document)};
}

}  // namespace symplant::read::xml
