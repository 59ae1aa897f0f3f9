// Declarations of variables in IEC 61131-3, as structured text and PLCopen XML have them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "convert/names.hpp"
#include "convert/writer.hpp"

namespace symplant::convert {

struct Declaration {
  std::string_view name;
  std::string address;  ///< %IX0.0, %I* or empty
  std::string type;
  std::string initial;  ///< a literal; empty without a value
  std::string_view comment;
};

/// Variables that are declared together.
struct DeclarationGroup {
  std::string_view title;  ///< "inputs"
  Kind kind;
  bool located;                        ///< all have addresses; false if the dialect does not separate them
  std::vector<std::uint32_t> symbols;  ///< at least one, in the order of the rows
};

/// All decisions about the variables of a plant. They are made twice: when the losses are reported, and when a
/// declaration is written.
class Declarations {
 public:
  /// Reports all losses except those of comments.
  explicit Declarations(const Writing& writing);

  const Dialect& dialect() const { return dialect_; }
  const Symbols& symbols() const { return *symbols_; }
  const std::vector<DeclarationGroup>& groups() const { return groups_; }
  const Written& written() const { return written_; }
  Declaration operator[](std::uint32_t symbol) const;

 private:
  void report(const Symbol& symbol, const std::string& type, Report& report) const;
  std::optional<std::string> type_of(const Symbol& symbol) const;
  std::string address_of(const Symbol& symbol) const;
  void group(Kind kind, std::string_view title, const std::vector<std::uint32_t>& declared);

  std::shared_ptr<const Symbols> symbols_;
  const Dialect& dialect_;
  Written written_;
  std::optional<Names> names_;
  std::vector<DeclarationGroup> groups_;
};

}  // namespace symplant::convert
