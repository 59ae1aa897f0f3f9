// An XML file: its elements, attributes and texts, with their offsets in the file.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "read/reader.hpp"

namespace symplant::read::xml {

/// A piece of the file with its entities resolved. It is valid as long as its document.
struct Text {
  std::string_view text;
  std::size_t offset = std::string_view::npos;  ///< where it begins in the file; npos for an absent text
};

struct Tree;

/// An element, or nothing: all members of nothing return nothing. Names are compared without prefixes of namespaces.
class Element {
 public:
  Element() = default;
  Element(const Tree* tree, void* node) : tree_(tree), node_(node) {}

  explicit operator bool() const { return node_ != nullptr; }
  friend bool operator==(const Element&, const Element&) = default;

  std::string_view name() const;
  /// The start tag of the element in the file. O(length of the tag).
  text::Span tag() const;

  Text attribute(const char* name) const;
  /// The text in the element and the elements in it. If it has several pieces, they are joined in `joined`, with a
  /// blank between pieces of different elements. O(size of the element).
  Text content(std::string& joined) const;

  Element parent() const;
  Element first_child() const;
  Element next_sibling() const;
  /// The first child of that name; O(children).
  Element child(std::string_view name) const;

 private:
  const Tree* tree_ = nullptr;
  void* node_ = nullptr;
};

class Document {
 public:
  /// Nothing, with an error (SP112, SP113), for a file that is not well-formed, has a document type, or would need
  /// more than 256 MiB. No entity is ever read from another file.
  static std::unique_ptr<Document> parse(const Reading& reading);
  ~Document();

  Element root() const;

 private:
  explicit Document(std::unique_ptr<Tree> tree);

  std::unique_ptr<Tree> tree_;
};

/// The elements below one element, in the order of the file. Needs no stack, however deep they are nested.
class Walk {
 public:
  explicit Walk(Element top) : top_(top), next_(top.first_child()) {}

  /// Nothing at the end.
  Element next();
  /// Skips the elements in the element that next() returned.
  void skip_content() { next_ = after(at_); }

 private:
  Element after(Element element) const;

  Element top_;
  Element at_;
  Element next_;
};

}  // namespace symplant::read::xml
