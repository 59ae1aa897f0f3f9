// An XML file as a tree of pugixml.
#include "read/xml/document.hpp"

#include <algorithm>
#include <functional>
#include <pugixml.hpp>
#include <utility>

#include "read/rules/document_type.hpp"
#include "read/rules/invalid_xml.hpp"
#include "read/xml/prolog.hpp"

namespace symplant::read::xml {

struct Tree {
  std::string_view source;
  std::string buffer;  ///< the source; parsing writes resolved texts into it, at their offsets
  pugi::xml_document document;

  Text located(const char* value) const {
    const std::string_view text(value);
    // Texts that are empty may be constants outside the buffer.
    const bool inside =
        std::less_equal<>()(buffer.data(), value) && std::less<>()(value, buffer.data() + buffer.size());
    return {text, inside ? static_cast<std::size_t>(value - buffer.data()) : std::string_view::npos};
  }
};

namespace {

constexpr std::size_t kMostMemory = 256UL * 1024 * 1024;
constexpr std::size_t kNodeBytes = 64;
constexpr std::size_t kAttributeBytes = 40;

pugi::xml_node node_of(void* node) { return pugi::xml_node(static_cast<pugi::xml_node_struct*>(node)); }

std::string_view without_prefix(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

/// Whether the text before the tag at `at` becomes a node: one that is all that an element has so far does not.
bool has_text_node(std::string_view text, std::size_t last_tag, std::size_t at) {
  const std::string_view between = text.substr(last_tag, at - last_tag);
  const std::size_t last = between.find_last_not_of(" \t\r\n");
  if (last == std::string_view::npos || between[last] == '>' || between.size() < 2) return false;
  const bool opens = between[1] != '/' && between[1] != '!' && between[1] != '?';
  return !opens || between.find("/>") != std::string_view::npos;
}

/// The memory that parsing needs: a copy of the text, elements, attributes, and texts next to elements.
std::size_t memory_for(std::string_view text) {
  std::size_t nodes = 0;
  std::size_t last_tag = 0;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    if (at + 1 < text.size() && text[at + 1] != '/') ++nodes;
    if (has_text_node(text, last_tag, at)) ++nodes;
    last_tag = at;
  }
  const auto attributes = static_cast<std::size_t>(std::count(text.begin(), text.end(), '='));
  return text.size() + nodes * kNodeBytes + attributes * kAttributeBytes;
}

const char* words_for(pugi::xml_parse_status status) {
  switch (status) {
    case pugi::status_bad_pi:
      return "a processing instruction or the XML declaration is never closed";
    case pugi::status_bad_comment:
      return "a comment is never closed";
    case pugi::status_bad_cdata:
      return "a CDATA section is never closed";
    case pugi::status_bad_start_element:
      return "a start tag is cut or has characters that no name has";
    case pugi::status_bad_attribute:
      return "an attribute has no value in quotes";
    case pugi::status_bad_end_element:
      return "an end tag is cut or has characters that no name has";
    case pugi::status_end_element_mismatch:
      return "an end tag does not match the element that is open, or is missing";
    case pugi::status_no_document_element:
      return "there is no element";
    default:
      return "a tag is not complete";
  }
}

void report_doctype(const Reading& reading, std::size_t offset) {
  const std::size_t begin = std::min(offset, reading.source->text().size());
  reading.diagnostics.add(
      kDocumentType,
      "the XML has a document type, which no export of a PLC tool has; delete it, or export the file again",
      {reading.source, reading.source->span_of(reading.source->text().substr(begin, 9))});
}

void report_status(const Reading& reading, const pugi::xml_parse_result& result) {
  const std::size_t size = reading.source->text().size();
  const std::size_t begin = std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)), size);
  reading.diagnostics.add(
      kInvalidXml, "the XML is not well-formed: " + std::string(words_for(result.status)) + "; export the file again",
      {reading.source, {begin, std::min(begin + 1, size)}});
}

}  // namespace

std::string_view Element::name() const { return without_prefix(node_of(node_).name()); }

text::Span Element::tag() const {
  if (node_ == nullptr) return {};
  const pugi::xml_node node = node_of(node_);
  const std::string_view source = tree_->source;
  const Text name = tree_->located(node.name());
  std::size_t at = name.offset + name.text.size();
  if (const pugi::xml_attribute last = node.last_attribute()) {
    const Text value = tree_->located(last.value());
    if (value.offset < source.size()) at = source.find(source[value.offset - 1], value.offset);  // the closing quote
  }
  return {name.offset - 1, std::min(source.find('>', at), source.size() - 1) + 1};
}

Text Element::attribute(const char* name) const {
  const pugi::xml_attribute found = node_of(node_).attribute(name);
  return found ? tree_->located(found.value()) : Text{};
}

Text Element::content(std::string& joined) const {
  Text only;
  bool several = false;
  const pugi::xml_node top = node_of(node_);
  pugi::xml_node last_parent;
  const auto take = [&](const char* value, pugi::xml_node parent) {
    if (*value == '\0') return;
    if (only.text.empty()) {
      only = tree_->located(value);
    } else {
      if (!several) joined.assign(only.text);
      several = true;
      if (parent != last_parent) joined += ' ';
      joined += value;
    }
    last_parent = parent;
  };
  for (pugi::xml_node at = top; at;) {
    take(at.value(), at.type() == pugi::node_element ? at : at.parent());
    pugi::xml_node next = at.first_child();
    while (!next && at != top) {
      next = at.next_sibling();
      if (!next) at = at.parent();
    }
    at = next;
  }
  return several ? Text{joined, only.offset} : only;
}

Element Element::parent() const { return {tree_, node_of(node_).parent().internal_object()}; }

Element Element::first_child() const {
  pugi::xml_node child = node_of(node_).first_child();
  while (child && child.type() != pugi::node_element) child = child.next_sibling();
  return {tree_, child.internal_object()};
}

Element Element::next_sibling() const {
  pugi::xml_node next = node_of(node_).next_sibling();
  while (next && next.type() != pugi::node_element) next = next.next_sibling();
  return {tree_, next.internal_object()};
}

Element Element::child(std::string_view name) const {
  Element child = first_child();
  while (child && child.name() != name) child = child.next_sibling();
  return child;
}

std::unique_ptr<Document> Document::parse(const Reading& reading) {
  const std::string_view source = reading.source->text();
  if (const auto doctype = read_prolog(source).doctype) {
    report_doctype(reading, *doctype);
    return nullptr;
  }
  if (memory_for(source) > kMostMemory) {
    reading.diagnostics.add(kInvalidXml,
                            "the XML would need more than 256 MiB of memory; export the symbols without the program",
                            {reading.source, {0, 1}});
    return nullptr;
  }
  auto tree = std::make_unique<Tree>();
  tree->source = source;
  tree->buffer.assign(source);
  // All texts stay at their offsets, with their line ends.
  constexpr unsigned kOptions =
      pugi::parse_cdata | pugi::parse_escapes | pugi::parse_embed_pcdata | pugi::parse_doctype;
  const pugi::xml_parse_result result =
      tree->document.load_buffer_inplace(tree->buffer.data(), tree->buffer.size(), kOptions, pugi::encoding_utf8);
  if (!result) {
    report_status(reading, result);
    return nullptr;
  }
  for (const pugi::xml_node node : tree->document.children()) {
    if (node.type() != pugi::node_doctype) continue;
    report_doctype(reading, tree->located(node.value()).offset);
    return nullptr;
  }
  return std::unique_ptr<Document>(new Document(std::move(tree)));
}

Document::Document(std::unique_ptr<Tree> tree) : tree_(std::move(tree)) {}
Document::~Document() = default;

Element Document::root() const { return {tree_.get(), tree_->document.document_element().internal_object()}; }

Element Walk::next() {
  at_ = next_;
  if (!at_) return at_;
  const Element inner = at_.first_child();
  next_ = inner ? inner : after(at_);
  return at_;
}

Element Walk::after(Element element) const {
  while (element && element != top_) {
    if (const Element sibling = element.next_sibling()) return sibling;
    element = element.parent();
  }
  return {};
}

}  // namespace symplant::read::xml
