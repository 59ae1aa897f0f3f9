// What a writer of a format takes, and its row in the table of writers.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "address/address.hpp"
#include "base/result.hpp"
#include "base/text_source.hpp"
#include "convert/dialects.hpp"
#include "convert/report.hpp"
#include "convert/symbols.hpp"

namespace symplant::convert {

struct Writing {
  std::shared_ptr<const Symbols> symbols;
  const Dialect& dialect;
  std::optional<address::Radix> xy;  ///< how X and Y count, if the user says so
  Report& report;
};

/// What is in the output.
struct Written {
  std::size_t symbols = 0;
  std::size_t inputs = 0;
  std::size_t outputs = 0;

  void add(const Symbol& symbol) {
    ++symbols;
    inputs += symbol.kind == Kind::input ? 1U : 0U;
    outputs += symbol.kind == Kind::output ? 1U : 0U;
  }
};

struct Output {
  base::TextSource text;
  Written written;
};

/// Why nothing can be written, and what to do.
struct WriteError {
  std::string message;
};

/// One format. `write` adds to the report what the format cannot hold.
struct WriterInfo {
  std::string_view name;       ///< for --to: "gx-iec"
  std::string_view title;      ///< "GX IEC Developer 7 global variable list"
  std::string_view extension;  ///< of files that have this format without --to: ".csv"
  bool has_dialects;
  bool is_text;  ///< it can be shown on a terminal
  base::Result<Output, WriteError> (*write)(const Writing& writing);
};

}  // namespace symplant::convert
