// Texts that hold several lists one after the other.
#include "read/parts.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_set>
#include <utility>

namespace symplant::read {

namespace {

constexpr std::size_t kAhead = 16;  ///< rows that decide
constexpr std::size_t kFewest = 8;  ///< fewer rows with an address are no list

/// Rows with an I/O address, and a key of it.
struct Addressed {
  std::size_t row;
  std::uint64_t key;
};

std::uint64_t key_of(const address::Address& address) {
  return (address.number * 2 + (address.plain ? 1 : 0)) * 0x9E37'79B9'7F4A'7C15 ^
         (static_cast<std::uint64_t>(address.area) << 8 | static_cast<std::uint64_t>(address.size));
}

std::vector<Addressed> addressed_rows(const SymbolTable& table, address::Radix radix) {
  std::vector<Addressed> rows;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const ListRow& row = table.rows[i];
    const auto found = row.iec_address.empty() ? address::parse(row.vendor_address, {table.notation, radix})
                                               : address::parse_iec(row.iec_address);
    if (found && found->area != address::Area::memory) rows.push_back({i, key_of(*found)});
  }
  return rows;
}

/// Whether most of the rows from `at` on have addresses that are in use.
bool starts_over(const std::vector<Addressed>& rows, std::size_t at, const std::unordered_set<std::uint64_t>& used) {
  const std::size_t end = std::min(rows.size(), at + kAhead);
  if (end - at < kFewest || used.size() < kFewest) return false;
  const auto again =
      std::count_if(rows.begin() + static_cast<std::ptrdiff_t>(at), rows.begin() + static_cast<std::ptrdiff_t>(end),
                    [&](const Addressed& row) { return used.count(row.key) != 0; });
  return static_cast<std::size_t>(again) * 5 >= (end - at) * 4;
}

}  // namespace

std::vector<std::size_t> find_parts(const SymbolTable& table, address::Radix radix) {
  if (!table.parts.empty()) return table.parts;
  std::vector<std::size_t> begins;
  const std::vector<Addressed> rows = addressed_rows(table, radix);
  std::unordered_set<std::uint64_t> used;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (used.count(rows[i].key) != 0 && starts_over(rows, i, used)) {
      begins.push_back(rows[i].row);
      used.clear();
    }
    used.insert(rows[i].key);
  }
  return begins;
}

bool keep_part(SymbolTable& table, std::size_t part, const std::vector<std::size_t>& begins) {
  if (part == 0 || part > begins.size() + 1) return false;
  const auto offset = [&](std::size_t row) { return table.rows.begin() + static_cast<std::ptrdiff_t>(row); };
  if (part <= begins.size()) table.rows.erase(offset(begins[part - 1]), table.rows.end());
  if (part > 1) table.rows.erase(table.rows.begin(), offset(begins[part - 2]));
  table.parts.clear();
  return true;
}

}  // namespace symplant::read
