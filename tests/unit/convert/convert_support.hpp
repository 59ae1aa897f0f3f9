// Lists in memory, read and written, for the tests of conversions.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "convert/writers.hpp"
#include "diag/text.hpp"
#include "read/readers.hpp"
#include "support/catch.hpp"

namespace symplant::convert {

/// The symbols of a list; the test fails if it cannot be read.
inline std::shared_ptr<const Symbols> symbols_of_text(const std::string& path, std::string bytes,
                                                      std::optional<address::Radix> xy = {}) {
  diag::Diagnostics diagnostics;
  auto table = read::read_symbol_list(path, std::move(bytes), {}, diagnostics);
  INFO(diag::render_text(diagnostics.all(), {}));
  REQUIRE(table.has_value());
  const List list{std::make_shared<const read::SymbolTable>(std::move(*table)), {}, xy};
  return std::make_shared<const Symbols>(symbols_of({&list, 1}));
}

/// What a conversion makes.
struct Made {
  std::string text;
  Written written;
  Report report;
};

inline Made convert_to(const std::string& writer, const std::shared_ptr<const Symbols>& symbols,
                       const std::string& dialect = "codesys", std::optional<address::Radix> xy = {}) {
  Made made;
  const auto output = write(*find_writer(writer), {symbols, *find_dialect(dialect), xy, made.report});
  REQUIRE(bool(output));
  made.text = base::text_of(output->text);
  made.written = output->written;
  return made;
}

/// A list of GX IEC Developer with these rows, as its columns are: MIT-Addr., IEC-Addr., Type, Initial, Comment.
inline std::shared_ptr<const Symbols> gx_list(const std::string& rows, std::optional<address::Radix> xy = {}) {
  return symbols_of_text("list.txt", "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n" + rows, xy);
}

}  // namespace symplant::convert
