// What rules share.
#include "check/rule.hpp"

#include <algorithm>

#include "text/ascii.hpp"
#include "text/shape.hpp"

namespace symplant::check {
namespace {

/// About a row that may be left out. Its shape is that of the text by which people know it: its name, or its comment if
/// the list has addresses for names.
diag::Subjects subjects_of(const read::ListRow& row) {
  const bool by_comment = row.is_named_by_address() && !row.comment.empty();
  return {{{Kind::symbol, std::string(row.name)}}, {}, {}, text::shape_of(by_comment ? row.comment : row.name)};
}

}  // namespace

Finding& Finding::see(diag::Location location, std::string text) {
  as.related.push_back({std::move(location), std::move(text)});
  return *this;
}

Finding& Finding::see(const read::ListRow& row, std::string_view cell, std::string text) {
  return see(location_of(plant, row, cell), std::move(text));
}

Finding& Finding::also(Kind kind, std::string_view name) {
  as.subjects.about.push_back({kind, std::string(name)});
  return *this;
}

Finding& Finding::explains(Kind kind, std::string_view name) {
  as.subjects.explains.push_back({kind, std::string(name)});
  return *this;
}

Finding& Finding::follows(Kind kind, std::string_view name) {
  as.subjects.follows.push_back({kind, std::string(name)});
  return *this;
}

Finding& Finding::lacks(std::string_view name, std::string_view path) {
  return explains(Kind::missing, name).explains(Kind::model, path);
}

Finding& Finding::rename(const Symbol& symbol, std::string to, bool safe) {
  as.renames.push_back({std::string(symbol.name()), std::move(to), std::string(symbol.written_address()), safe});
  return *this;
}

Finding Find::at(diag::Location location, diag::Subjects subjects) const {
  return {plant, diagnostics, {&rule, rule.severity, {}, std::move(location), {}, std::move(subjects)}};
}

Finding Find::at(const read::ListRow& row, std::string_view cell) const {
  const std::uint32_t list = plant.list_of(row);
  const auto symbol = std::lower_bound(
      plant.symbols.begin(), plant.symbols.end(), &row,
      [&](const Symbol& a, const read::ListRow* wanted) { return a.list != list ? a.list < list : a.row < wanted; });
  if (symbol != plant.symbols.end() && symbol->row == &row) return at(*symbol, cell);
  return at(location_of(plant, row, cell), subjects_of(row));
}

Finding Find::at(const Symbol& symbol, std::string_view cell) const {
  return at(location_of(plant, *symbol.row, cell), about(symbol));
}

diag::Subjects about(const Symbol& symbol) {
  diag::Subjects subjects = subjects_of(*symbol.row);
  if (symbol.reading.is_named()) {
    subjects.about.push_back({Kind::device, std::string(symbol.reading.device_path())});
  }
  return subjects;
}

diag::Location location_of(const PlantModel& plant, const read::ListRow& row, std::string_view cell) {
  const auto& source = plant.lists[plant.list_of(row)].table->source;
  return {source, cell.empty() ? row.whole : source->span_of(cell, row.whole)};
}

diag::Location location_of(const description::Pointer& pointer, diag::Location fallback) {
  fallback.pointer = pointer.text();
  return fallback;
}

std::string symbol_name(std::string_view path, Direction direction, std::string_view task) {
  return fmt::format("{}_{}_{}", path, direction == Direction::operation ? 'O' : 'I', task);
}

std::string class_name(std::string_view device) { return text::to_upper(text::shape_of(device)); }

}  // namespace symplant::check
