// Packages of AutomationML.
#include "read/xml/package.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <utility>
#include <vector>

#include "text/ascii.hpp"

namespace symplant::read::xml {

namespace {

constexpr std::string_view kExtension = ".aml";
const std::string kRelations = "_rels/.rels";

bool is_document(std::string_view path) {
  return path.size() > kExtension.size() &&
         text::equal_ignoring_case(path.substr(path.size() - kExtension.size()), kExtension);
}

/// The root that the relations name; empty if they name none.
std::string named_root(const std::string& relations) {
  pugi::xml_document document;
  if (!document.load_buffer(relations.data(), relations.size())) return {};
  for (const pugi::xml_node& relation : document.document_element().children()) {
    if (!std::string_view(relation.attribute("Type").value()).ends_with("/RootDocument")) continue;
    const std::string_view target = relation.attribute("Target").value();
    return std::string(target.substr(target.starts_with('/') ? 1 : 0));
  }
  return {};
}

}  // namespace

bool is_automationml_package(std::string_view bytes) {
  if (!Archive::is_one(bytes) || bytes.find(kExtension) == std::string_view::npos) return false;
  const auto archive = Archive::open(bytes, "package");
  return archive && std::ranges::any_of(archive->paths(), is_document);
}

base::Result<PackedDocument, ArchiveFault> read_automationml_package(std::string_view bytes) {
  auto archive = Archive::open(bytes, "package");
  if (!archive) return archive.error();
  const std::vector<std::string> paths = archive->paths();
  const auto first = std::ranges::find_if(paths, is_document);
  if (first == paths.end()) return ArchiveFault{"the package has no AutomationML document"};
  std::string root;
  if (archive->has(kRelations)) {
    const auto relations = archive->whole(kRelations);
    if (!relations) return relations.error();
    root = named_root(*relations);
  }
  if (!archive->has(root)) root = *first;
  auto document = archive->whole(root);
  if (!document) return document.error();
  return PackedDocument{std::move(root), std::move(*document)};
}

}  // namespace symplant::read::xml
