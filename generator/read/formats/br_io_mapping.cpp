// Reads the I/O mapping of B&R Automation Studio (.iom): variables at channels of modules.
#include <optional>
#include <string>

#include "read/cells/lines.hpp"
#include "read/cells/padded.hpp"
#include "read/formats.hpp"
#include "read/rules/row_not_understood.hpp"
#include "read/table_builder.hpp"
#include "read/unique_names.hpp"

namespace symplant::read {

namespace {

constexpr std::size_t kBrSearchedBytes = 64 * 1024;

/// `::Task:var AT %IX."IF3.ST1".DigitalInput01;`, maybe with a comment.
struct Mapping {
  std::string_view task;  ///< empty: a variable of the whole PLC
  std::string_view name;
  std::string_view address;
  std::string_view comment;
};

std::optional<Mapping> mapping_of(std::string_view line) {
  if (!line.starts_with("::")) return std::nullopt;
  const std::size_t at = line.find(" AT ");
  const std::size_t end = line.find(';');
  if (at == line.npos || end == line.npos || end < at) return std::nullopt;
  Mapping mapping;
  mapping.name = without_blanks(line.substr(2, at - 2));
  if (const std::size_t colon = mapping.name.find(':'); colon != line.npos) {
    mapping.task = mapping.name.substr(0, colon);
    mapping.name.remove_prefix(colon + 1);
  }
  mapping.address = without_blanks(line.substr(at + 4, end - at - 4));
  const std::string_view rest = without_blanks(line.substr(end + 1));
  if (rest.starts_with("(*") && rest.ends_with("*)")) mapping.comment = without_blanks(rest.substr(2, rest.size() - 4));
  if (mapping.name.empty() || !mapping.address.starts_with('%')) return std::nullopt;
  return mapping;
}

bool is_other_line(std::string_view line) {
  return line.empty() || line == "VAR_CONFIG" || line == "END_VAR" || line.starts_with("(*") || line.starts_with("//");
}

int br_io_mapping_likelihood(std::string_view text) {
  LineReader lines(text.substr(0, kBrSearchedBytes));
  Line line;
  bool begun = false;
  while (lines.next(line)) {
    const std::string_view content = without_blanks(line.text);
    begun = begun || content == "VAR_CONFIG";
    if (begun && mapping_of(content)) return 97;
  }
  return 0;
}

std::optional<SymbolTable> read_br_io_mapping(const Reading& reading) {
  TableBuilder builder(reading, address::Notation::iec);
  LineReader lines(builder.text());
  Line line;
  while (lines.next(line)) {
    const std::string_view content = without_blanks(line.text);
    const auto mapping = mapping_of(content);
    if (!mapping) {
      if (!is_other_line(content)) {
        builder.report(kRowNotUnderstood,
                       "this line is no mapping and is left out; write `::NAME AT %IX.\"MODULE\".CHANNEL;`",
                       line.span());
      }
      continue;
    }
    ListRow& row = builder.add(line.span(), line.number);
    row.klass = "VAR_CONFIG";
    row.name = mapping->name;
    row.vendor_address = mapping->address;
    row.comment = mapping->comment;
    row.extra = builder.extra_for_scope(mapping->task);
  }
  qualify_repeated_names(builder);
  return builder.finish();
}

}  // namespace

const ReaderInfo kBrIoMapping{"br-iom", "B&R Automation Studio I/O mapping", br_io_mapping_likelihood,
                              read_br_io_mapping};

}  // namespace symplant::read
