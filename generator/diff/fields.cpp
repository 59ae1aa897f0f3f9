// Compares two rows field by field.
#include "diff/fields.hpp"

#include "address/notation.hpp"
#include "model/classify.hpp"
#include "text/ascii.hpp"

namespace symplant::diff {
namespace {

bool same_dialect(const model::PlantList& a, const model::PlantList& b) {
  return a.table->notation == b.table->notation && a.radix.radix == b.radix.radix;
}

bool same_address(const model::PlantModel& before, const RowRef& a, const model::PlantModel& after, const RowRef& b) {
  const read::ListRow& old = a.in(before);
  const read::ListRow& now = b.in(after);
  const bool same_text = old.vendor_address == now.vendor_address && old.iec_address == now.iec_address;
  if (same_text && same_dialect(before.lists[a.list], after.lists[b.list])) return true;
  const auto was = address_of(before, a);
  const auto is = address_of(after, b);
  if (was && is) return *was == *is;
  return written_address(old) == written_address(now) && was.has_value() == is.has_value();
}

/// Whether two cells of one column have one address. A missing cell is no other address.
bool same_cell(std::string_view a, const address::Dialect& of_a, std::string_view b, const address::Dialect& of_b) {
  if (a.empty() || b.empty() || a == b) return true;
  const auto was = address::parse(a, of_a);
  const auto is = address::parse(b, of_b);
  return was && is && *was == *is;
}

bool same_initial(const read::ListRow& a, const read::ListRow& b) {
  if (a.initial == b.initial) return true;
  const auto type = read::data_type(a.type);
  if (!type || !same_type(a.type, b.type)) return false;
  const auto was = model::initial_value(a.initial, *type);
  const auto is = model::initial_value(b.initial, *type);
  return was && is && *was == *is;
}

/// Whether both columns of addresses agree, if both plants have both.
bool same_addresses(const model::PlantModel& before, const RowRef& a, const model::PlantModel& after, const RowRef& b) {
  const address::Dialect old_dialect = before.lists[a.list].dialect();
  const address::Dialect new_dialect = after.lists[b.list].dialect();
  const read::ListRow& old = a.in(before);
  const read::ListRow& now = b.in(after);
  return same_cell(old.vendor_address, old_dialect, now.vendor_address, new_dialect) &&
         same_cell(old.iec_address, old_dialect, now.iec_address, new_dialect);
}

/// Whether what only some formats have is the same; true for lists of two formats.
bool same_other(const model::PlantModel& before, const RowRef& a, const model::PlantModel& after, const RowRef& b) {
  const read::SymbolTable& old_table = *before.lists[a.list].table;
  const read::SymbolTable& new_table = *after.lists[b.list].table;
  if (old_table.title != new_table.title) return true;
  const read::ListRow& old = a.in(before);
  const read::ListRow& now = b.in(after);
  const read::RowExtra& old_extra = old_table.extra_of(old);
  const read::RowExtra& new_extra = new_table.extra_of(now);
  return old.klass == now.klass && old_extra.scope == new_extra.scope && old_extra.alias == new_extra.alias &&
         old_extra.parent_comment == new_extra.parent_comment;
}

}  // namespace

std::optional<address::Address> address_of(const model::PlantModel& plant, const RowRef& at) {
  const read::ListRow& row = at.in(plant);
  if (row.vendor_address.empty() && row.iec_address.empty()) return std::nullopt;
  return model::row_address(row, plant.lists[at.list].dialect()).address;
}

std::string_view written_address(const read::ListRow& row) {
  return row.vendor_address.empty() ? row.iec_address : row.vendor_address;
}

bool same_type(std::string_view a, std::string_view b) {
  if (text::equal_ignoring_case(a, b)) return true;
  const auto type = read::data_type(a);
  return type && type == read::data_type(b);
}

Fields differing_fields(const model::PlantModel& before, const RowRef& a, const model::PlantModel& after,
                        const RowRef& b) {
  const read::ListRow& old = a.in(before);
  const read::ListRow& now = b.in(after);
  Fields fields;
  if (old.name != now.name) fields.add(Field::name);
  if (!same_address(before, a, after, b)) fields.add(Field::address);
  if (!same_type(old.type, now.type)) fields.add(Field::type);
  if (!same_initial(old, now)) fields.add(Field::initial);
  if (old.comment != now.comment) fields.add(Field::comment);
  const bool moved = fields.has(Field::address);
  if (!same_other(before, a, after, b) || (!moved && !same_addresses(before, a, after, b))) fields.add(Field::other);
  return fields;
}

}  // namespace symplant::diff
