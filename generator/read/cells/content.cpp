// Finds columns by the content of their cells.
#include "read/cells/content.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <unordered_set>

#include "address/notation.hpp"
#include "text/ascii.hpp"

namespace symplant::read {

namespace {

using address::Area;
using address::Notation;

constexpr std::size_t kLongestCellOfNames = 128;

bool is_filled(std::string_view cell) { return !cell.empty(); }

bool has_letter(std::string_view cell) {
  return std::any_of(cell.begin(), cell.end(), [](char c) {
    return (text::upper(c) >= 'A' && text::upper(c) <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
  });
}

bool is_truth(std::string_view cell) {
  return text::equal_ignoring_case(cell, "true") || text::equal_ignoring_case(cell, "false");
}

/// TRUE, 0, 16#FF, T#30s, K100: what an initial value may be, and no text.
bool is_value(std::string_view cell) {
  if (is_truth(cell)) return true;
  return !cell.empty() && cell.find(' ') == std::string_view::npos &&
         (text::is_digit(cell.front()) || cell.front() == '-' || cell.front() == '[' ||
          cell.find('#') != std::string_view::npos ||
          (cell.size() > 1 && text::is_digit(cell[1]) &&
           std::string_view("KHE").find(cell.front()) != std::string_view::npos));
}

bool is_text(std::string_view cell) { return has_letter(cell) && !is_truth(cell) && !is_type(cell) && !is_value(cell); }

bool is_identifier_like(std::string_view cell) {
  return has_letter(cell) && cell.find_first_of(" ,;") == std::string_view::npos;
}

/// The area of a cell that is an address in a notation whose addresses are recognized by their form.
std::optional<Area> area_of(std::string_view cell) {
  if (cell.size() > kLongestCellOfNames || address::address_strength(cell) == 0) return std::nullopt;
  for (const Notation notation : {Notation::iec, Notation::siemens, Notation::melsec, Notation::rockwell}) {
    if (const auto found = address::parse(cell, {notation})) return found->area;
  }
  return std::nullopt;
}

/// What the cells of a column look like.
struct Look {
  std::size_t rows = 0;
  std::size_t filled = 0;
  std::size_t distinct = 0;
  std::size_t addresses = 0;
  std::size_t io = 0;
  std::size_t identifiers = 0;
  std::size_t types = 0;
  std::size_t texts = 0;
  std::size_t too_long = 0;
  std::size_t digits = 0;  ///< cells with a digit
  bool percent = false;    ///< its addresses begin with `%`

  bool holds_addresses() const { return io > 0 && addresses * 10 >= filled * 8; }
  /// Words, as a column `Device` of the plant's devices has them: an address has a digit.
  bool holds_no_address() const { return addresses == 0 && digits * 2 < filled; }
  bool holds_names() const {
    return filled > 0 && filled * 10 >= rows * 9 && distinct * 100 >= filled * 95 && too_long == 0 &&
           texts * 10 >= filled * 8 && !holds_addresses();
  }
  bool holds_types() const { return types > 0 && types * 10 >= filled * 8 && filled * 2 >= rows; }
  /// `Type` is a header of other columns, too: DI and DO, or the kind of a sensor.
  bool holds_other_kinds() const { return filled > 0 && types == 0; }
  double identifier_share() const {
    return filled == 0 ? 0 : static_cast<double>(identifiers) / static_cast<double>(filled);
  }
};

Look look_at(const std::vector<CsvRow>& rows, std::size_t column) {
  Look look;
  std::unordered_set<std::string_view> distinct;
  look.rows = rows.size();
  for (const CsvRow& row : rows) {
    const std::string_view cell = row.cell(column);
    if (!is_filled(cell)) continue;
    ++look.filled;
    distinct.insert(cell);
    if (const auto area = area_of(cell)) {
      ++look.addresses;
      look.io += *area != Area::memory ? 1U : 0U;
      look.percent = look.percent || cell.front() == '%';
    }
    look.identifiers += is_identifier_like(cell) ? 1U : 0U;
    look.types += is_type(cell) ? 1U : 0U;
    look.texts += is_text(cell) ? 1U : 0U;
    look.digits += std::any_of(cell.begin(), cell.end(), text::is_digit) ? 1U : 0U;
    look.too_long += cell.size() > kLongestCellOfNames ? 1U : 0U;
  }
  look.distinct = distinct.size();
  return look;
}

/// The width of the widest row, within reason.
std::size_t width_of(const std::vector<CsvRow>& rows) {
  std::size_t width = 0;
  for (const CsvRow& row : rows) width = std::max(width, row.cells.size());
  return std::min<std::size_t>(width, 256);
}

std::vector<Look> look_at_all(const std::vector<CsvRow>& rows) {
  std::vector<Look> looks;
  const std::size_t width = width_of(rows);
  for (std::size_t column = 0; column < width; ++column) looks.push_back(look_at(rows, column));
  return looks;
}

/// The column with the most cells that are such; kNoColumn if no cell is.
std::size_t vote(const std::vector<CsvRow>& rows, const Columns& taken, bool (*is_such)(std::string_view)) {
  std::vector<std::size_t> votes(width_of(rows));
  for (const CsvRow& row : rows) {
    for (std::size_t i = 0; i < std::min(votes.size(), row.cells.size()); ++i) {
      votes[i] += !taken.holds(i) && is_such(row.cells[i]) ? 1U : 0U;
    }
  }
  const auto most = std::max_element(votes.begin(), votes.end());
  if (most == votes.end() || *most == 0) return kNoColumn;
  return static_cast<std::size_t>(most - votes.begin());
}

/// Whether the cell of that column can be a name in most rows of a sample.
bool can_hold_names(const std::vector<CsvRow>& rows, std::size_t column) {
  const auto names = std::count_if(rows.begin(), rows.end(), [&](const CsvRow& row) {
    const std::string_view cell = row.cell(column);
    return is_filled(cell) && !is_type(cell) && !looks_like_iec_address(cell);
  });
  return static_cast<std::size_t>(names) * 2 > rows.size();
}

/// The column next to the type, if its cells are values. Empty ones are not: nothing would be lost or gained.
void add_initial(const std::vector<CsvRow>& rows, Columns& columns) {
  if (columns.has(Field::initial) || !columns.has(Field::type)) return;
  std::size_t next = columns[Field::type] + 1;
  while (columns.holds(next)) ++next;
  bool any = false;
  for (const CsvRow& row : rows) {
    const std::string_view cell = row.cell(next);
    if (is_filled(cell) && !is_value(cell)) return;
    any = any || is_filled(cell);
  }
  if (any) columns.set(Field::initial, next);
}

/// The column with the most different texts: one that repeats few words is of another kind.
void add_comment(const std::vector<CsvRow>& rows, const std::vector<Look>& looks, Columns& columns) {
  if (columns.has(Field::comment)) return;
  std::vector<std::set<std::string_view>> texts(looks.size());
  for (const CsvRow& row : rows) {
    for (std::size_t i = 0; i < std::min(texts.size(), row.cells.size()); ++i) {
      if (!columns.holds(i) && is_text(row.cells[i])) texts[i].insert(row.cells[i]);
    }
  }
  const auto most =
      std::max_element(texts.begin(), texts.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  if (most == texts.end() || most->empty()) return;
  const auto column = static_cast<std::size_t>(most - texts.begin());
  const Look& look = looks[column];
  const bool one_word = look.distinct == 1 && look.filled > 3;  // `GLOBAL` in each row
  if (look.texts * 2 > look.filled && !one_word) columns.set(Field::comment, column);
}

/// Takes the column that serves best, if it is clearly better than the second.
template <class Serves>
std::optional<Rivals> take(Field field, const std::vector<Look>& looks, Columns& columns, Serves serves) {
  constexpr double kClearly = 0.4;
  std::size_t best = kNoColumn;
  std::size_t second = kNoColumn;
  const auto share = [&](std::size_t column) { return looks[column].identifier_share(); };
  for (std::size_t i = 0; i < looks.size(); ++i) {
    if (columns.holds(i) || !serves(looks[i])) continue;
    if (best == kNoColumn || share(i) > share(best)) {
      second = best;
      best = i;
    } else if (second == kNoColumn || share(i) > share(second)) {
      second = i;
    }
  }
  if (best == kNoColumn) return std::nullopt;
  if (second != kNoColumn && share(best) - share(second) < kClearly) {
    return Rivals{field, std::min(best, second), std::max(best, second)};
  }
  columns.set(field, best);
  return std::nullopt;
}

}  // namespace

Columns classed_columns(const std::vector<CsvRow>& rows) {
  Columns columns;
  columns.set(Field::klass, vote(rows, columns, is_class));
  // The name is next to the class and may look like an address (P1): it is taken before the addresses.
  const std::size_t next = columns[Field::klass] + 1;
  if (can_hold_names(rows, next)) columns.set(Field::name, next);
  columns.set(Field::iec_address, vote(rows, columns, looks_like_iec_address));
  columns.set(Field::type, vote(rows, columns, is_type));
  if (!columns.has(Field::name)) columns.set(Field::name, vote(rows, columns, is_filled));
  columns.set(Field::vendor_address, vote(rows, columns, looks_like_vendor_address));
  add_initial(rows, columns);
  add_comment(rows, look_at_all(rows), columns);
  return columns;
}

std::optional<Rivals> complete_by_content(const std::vector<CsvRow>& rows, Columns& columns) {
  const std::vector<Look> looks = look_at_all(rows);
  for (const Field field : {Field::vendor_address, Field::iec_address}) {
    if (columns.has(field) && columns[field] < looks.size() && looks[columns[field]].holds_no_address())
      columns.set(field, kNoColumn);
  }
  if (!columns.has_address()) {
    for (const bool percent : {true, false}) {
      const Field field = percent ? Field::iec_address : Field::vendor_address;
      const auto rivals = take(field, looks, columns,
                               [&](const Look& look) { return look.holds_addresses() && look.percent == percent; });
      if (rivals) return rivals;
    }
  }
  if (!columns.has(Field::name)) {
    if (auto rivals = take(Field::name, looks, columns, [](const Look& look) { return look.holds_names(); }))
      return rivals;
  }
  if (columns.has(Field::type) && columns[Field::type] < looks.size() &&
      looks[columns[Field::type]].holds_other_kinds())
    columns.set(Field::type, kNoColumn);
  if (!columns.has(Field::type)) {
    for (std::size_t i = 0; i < looks.size(); ++i) {
      if (!columns.has(Field::type) && !columns.holds(i) && looks[i].holds_types()) columns.set(Field::type, i);
    }
  }
  add_comment(rows, looks, columns);
  return std::nullopt;
}

std::optional<std::size_t> better_by_content(const std::vector<CsvRow>& rows, const Rivals& rivals) {
  const Look first = look_at(rows, rivals.first);
  const Look second = look_at(rows, rivals.second);
  const auto serves = [&](const Look& look) {
    return rivals.field == Field::name ? look.holds_names() : look.holds_addresses();
  };
  if (serves(first) != serves(second)) return serves(first) ? rivals.first : rivals.second;
  if (rivals.field != Field::name) return std::nullopt;
  const double difference = first.identifier_share() - second.identifier_share();
  if (difference > -0.4 && difference < 0.4) return std::nullopt;
  return difference > 0 ? rivals.first : rivals.second;
}

}  // namespace symplant::read
