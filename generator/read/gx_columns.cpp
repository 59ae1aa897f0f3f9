// Finds the columns of a GX IEC list.
#include "read/gx_columns.hpp"

#include <algorithm>
#include <deque>
#include <vector>

#include "read/cells/csv.hpp"
#include "text/ascii.hpp"

namespace symplant::read {

namespace {

constexpr std::size_t kSearchedRows = 64;
constexpr std::size_t kSampledRows = 200;

struct Alias {
  GxField field;
  int rank;               ///< of two columns for one field the higher rank counts; of equal ranks the first
  std::string_view word;  ///< lower case, without blanks, dots, `-` and `_`
};

constexpr std::array kAliases{Alias{GxField::klass, 2, "class"},
                              Alias{GxField::name, 3, "identifier"},
                              Alias{GxField::name, 2, "labelname"},
                              Alias{GxField::name, 2, "variable"},
                              Alias{GxField::name, 1, "name"},
                              Alias{GxField::vendor_address, 3, "mitaddr"},
                              Alias{GxField::vendor_address, 3, "mitadr"},
                              Alias{GxField::vendor_address, 3, "mitaddress"},
                              Alias{GxField::vendor_address, 2, "fpaddress"},
                              Alias{GxField::vendor_address, 2, "assign(device/label)"},
                              Alias{GxField::vendor_address, 1, "device"},
                              Alias{GxField::iec_address, 3, "iecaddr"},
                              Alias{GxField::iec_address, 3, "iecadr"},
                              Alias{GxField::iec_address, 3, "iecaddress"},
                              Alias{GxField::iec_address, 1, "address"},
                              Alias{GxField::type, 2, "datatype"},
                              Alias{GxField::type, 1, "type"},
                              Alias{GxField::initial, 2, "initial"},
                              Alias{GxField::initial, 2, "initialvalue"},
                              Alias{GxField::initial, 1, "constant"},
                              Alias{GxField::comment, 2, "comment"},
                              Alias{GxField::comment, 1, "remark"}};

constexpr std::array<std::string_view, kGxFields> kFieldNames{"class", "identifier", "vendor address", "IEC address",
                                                              "type",  "initial",    "comment"};

constexpr std::array<std::string_view, 26> kTypes{"BIT",   "BOOL",   "BYTE",  "CHAR",  "COUNTER", "DATE",  "DINT",
                                                  "DT",    "DWORD",  "INT",   "LINT",  "LREAL",   "LWORD", "REAL",
                                                  "SINT",  "STRING", "TIME",  "TIMER", "TOD",     "UDINT", "UINT",
                                                  "ULINT", "USINT",  "WCHAR", "WORD",  "WSTRING"};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool is_letter(char c) { return text::upper(c) >= 'A' && text::upper(c) <= 'Z'; }
std::string header_word(std::string_view cell) {
  std::string word;
  if (cell.size() > 64) return word;
  for (const char c : cell) {
    if (c != ' ' && c != '.' && c != '-' && c != '_') word += lower(c);
  }
  return word;
}

std::string in_upper(std::string_view cell) {
  std::string text(cell);
  std::transform(text.begin(), text.end(), text.begin(), text::upper);
  return text;
}

/// VAR, VAR_GLOBAL, VAR_GLOBAL_CONSTANT ...
bool is_class(std::string_view cell) {
  if (cell.size() < 3 || cell.size() > 40) return false;
  const std::string word = in_upper(cell);
  return word == "VAR" || (word.starts_with("VAR_") && std::all_of(word.begin(), word.end(), [](char c) {
                             return is_letter(c) || c == '_' || c == ' ';
                           }));
}

bool is_type(std::string_view cell) {
  if (cell.size() > 100) return false;
  const std::string word = in_upper(cell.substr(0, cell.find_first_of(" ([")));
  return word == "ARRAY" || std::binary_search(kTypes.begin(), kTypes.end(), word);
}

/// The columns that a row would name if it were a header.
GxColumns named_columns(const CsvRow& row) {
  GxColumns columns;
  std::array<int, kGxFields> ranks{};
  for (std::size_t column = 0; column < row.cells.size(); ++column) {
    const std::string word = header_word(row.cells[column]);
    for (const Alias& alias : kAliases) {
      int& rank = ranks[static_cast<std::size_t>(alias.field)];
      if (alias.word != word || alias.rank <= rank) continue;
      rank = alias.rank;
      columns.set(alias.field, column);
    }
  }
  return columns;
}

/// `Name` and `Type` without another column could be of any table.
bool names_a_list(const GxColumns& columns, const CsvRow& row) {
  if (!columns.has(GxField::name)) return false;
  if (columns.has(GxField::klass) || columns.has(GxField::vendor_address) || columns.has(GxField::iec_address)) {
    return true;
  }
  return columns.has(GxField::type) && header_word(row.cell(columns[GxField::name])) != "name";
}

bool is_filled(std::string_view cell) { return !cell.empty(); }

/// A class and at least one other cell: a class without them is a line of a program.
bool is_classed(const CsvRow& row) {
  return std::any_of(row.cells.begin(), row.cells.end(), is_class) &&
         std::count_if(row.cells.begin(), row.cells.end(), is_filled) > 1;
}

/// The column with the most cells that are such; kNoColumn if no cell is.
std::size_t vote(const std::vector<CsvRow>& rows, const GxColumns& taken, bool (*is_such)(std::string_view)) {
  std::vector<std::size_t> votes;
  for (const CsvRow& row : rows) {
    if (votes.size() < row.cells.size()) votes.resize(row.cells.size());
    for (std::size_t i = 0; i < row.cells.size(); ++i) votes[i] += !taken.holds(i) && is_such(row.cells[i]) ? 1U : 0U;
  }
  const auto most = std::max_element(votes.begin(), votes.end());
  if (most == votes.end() || *most == 0) return kNoColumn;
  return static_cast<std::size_t>(most - votes.begin());
}

/// Whether the cell of that column can be a name in most rows of a sample.
bool holds_names(const std::vector<CsvRow>& rows, std::size_t column) {
  const auto names = std::count_if(rows.begin(), rows.end(), [&](const CsvRow& row) {
    const std::string_view cell = row.cell(column);
    return is_filled(cell) && !is_type(cell) && !looks_like_iec_address(cell);
  });
  return static_cast<std::size_t>(names) * 2 > rows.size();
}

/// Without a header: class, type and addresses by their content, the other columns by their position next to them.
GxColumns guessed_columns(const std::vector<CsvRow>& rows) {
  GxColumns columns;
  columns.set(GxField::klass, vote(rows, columns, is_class));
  // The name is next to the class and may look like an address (P1): it is taken before the addresses.
  const std::size_t beside = columns[GxField::klass] + 1;
  if (holds_names(rows, beside)) columns.set(GxField::name, beside);
  columns.set(GxField::iec_address, vote(rows, columns, looks_like_iec_address));
  columns.set(GxField::type, vote(rows, columns, is_type));
  if (!columns.has(GxField::name)) columns.set(GxField::name, vote(rows, columns, is_filled));
  columns.set(GxField::vendor_address, vote(rows, columns, looks_like_vendor_address));
  const std::size_t type = columns[GxField::type];
  if (type == kNoColumn) return columns;
  std::size_t next = type + 1;
  const auto next_free = [&] {
    while (columns.holds(next)) ++next;
    return next;
  };
  columns.set(GxField::initial, next_free());
  columns.set(GxField::comment, next_free());
  return columns;
}

std::vector<CsvRow> sample_rows(std::string_view text, const GxLayout& layout, std::deque<std::string>& arena) {
  std::vector<CsvRow> rows;
  CsvReader reader(text, layout.delimiter, arena, layout.rows_begin, layout.rows_line);
  CsvRow row;
  while (rows.size() < kSampledRows && reader.next(row)) {
    if (!row.blank()) rows.push_back(row);
  }
  return rows;
}

GxSearch search_by(std::string_view text, char delimiter) {
  GxSearch search;
  std::deque<std::string> arena;
  CsvReader reader(text, delimiter, arena);
  CsvRow row;
  for (std::size_t rows = 0; rows < kSearchedRows && reader.next(row); ++rows) {
    GxLayout layout;
    layout.delimiter = delimiter;
    layout.columns = named_columns(row);
    if (names_a_list(layout.columns, row)) {
      layout.header_line = row.line;
      layout.header_name = row.cell(layout.columns[GxField::name]);
      layout.rows_begin = reader.offset();
      layout.rows_line = reader.line();
      search.layout = std::move(layout);
      return search;
    }
    if (!search.nameless_header && !layout.columns.has(GxField::name) && layout.columns.count() >= 3) {
      search.nameless_header = row.whole;
    }
    if (search.nameless_header || !is_classed(row)) continue;
    layout.rows_begin = row.whole.begin;
    layout.rows_line = row.line;
    layout.columns = guessed_columns(sample_rows(text, layout, arena));
    search.layout = std::move(layout);
    return search;
  }
  search.unclosed_quote = reader.unclosed_quote();
  return search;
}

}  // namespace

bool GxColumns::holds(std::size_t column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

std::size_t GxColumns::count() const {
  return static_cast<std::size_t>(
      std::count_if(columns_.begin(), columns_.end(), [](std::size_t c) { return c != kNoColumn; }));
}

GxSearch find_gx_layout(std::string_view text) {
  const char likely = sniff_delimiter(text);
  GxSearch best = search_by(text, likely);
  for (const char delimiter : {'\t', ';', ','}) {
    if (best.layout) return best;
    if (delimiter == likely) continue;
    GxSearch other = search_by(text, delimiter);
    if (other.layout || (other.nameless_header && !best.nameless_header)) best = std::move(other);
  }
  return best;
}

bool looks_like_iec_address(std::string_view cell) {
  return cell.size() > 2 && cell[0] == '%' &&
         (text::upper(cell[1]) == 'I' || text::upper(cell[1]) == 'Q' || text::upper(cell[1]) == 'M');
}

bool looks_like_vendor_address(std::string_view cell) {
  if (cell.size() > 12) return false;
  std::size_t letters = 0;
  while (letters < cell.size() && is_letter(cell[letters])) ++letters;
  const std::string_view rest = cell.substr(std::min<std::size_t>(letters, 3));
  return letters > 0 && std::any_of(rest.begin(), rest.end(), text::is_digit) &&
         std::all_of(rest.begin(), rest.end(), [](char c) {
           return text::is_digit(c) || c == '.' || (text::upper(c) >= 'A' && text::upper(c) <= 'F');
         });
}

std::string describe(const GxColumns& columns) {
  std::string text;
  for (std::size_t i = 0; i < kGxFields; ++i) {
    const std::size_t column = columns[static_cast<GxField>(i)];
    if (column == kNoColumn) continue;
    if (!text.empty()) text += ", ";
    text.append(kFieldNames[i]).append(" ").append(std::to_string(column + 1));
  }
  return text;
}

}  // namespace symplant::read
