// The variables of a plant's FMU.
#include "symplant/fmi/variables.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "symplant/condition/type_info.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/tables/malfunction_numbers.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::fmi {
namespace {

using Kind = Variable::Kind;

/// 31 bits, since some importers keep references in signed integers.
std::uint32_t reference_of(std::string_view name, std::uint32_t attempt) noexcept {
  tables::Fnv1a64 hash;
  hash.text(name);
  if (attempt != 0) hash.u32(attempt);
  return static_cast<std::uint32_t>(hash.value() ^ hash.value() >> 32) & 0x7FFF'FFFF;
}

/// Whether only the importer changes it; the plant changes a value with `changes`, such as a counter.
bool is_parameter(const tables::ValueRow& row) noexcept {
  return row.kind == tables::ValueKind::parameter && row.changes.count == 0;
}

/// By symbol: whether it, or another one on its address, is driven.
std::vector<bool> driven_symbols(const tables::PlantTables& tables) {
  std::vector<std::uint32_t> leader(tables.symbols.size());
  for (std::uint32_t s = 0; s < leader.size(); ++s) leader[s] = s;
  for (const tables::SharedAddress& shared : tables.shared_addresses) leader[shared.symbol] = shared.leader;
  std::vector<bool> driven(leader.size());
  for (std::uint32_t s = 0; s < leader.size(); ++s) {
    if (tables.symbols[s].moved()) driven[leader[s]] = true;
  }
  for (std::uint32_t s = 0; s < leader.size(); ++s) driven[s] = driven[leader[s]];
  return driven;
}

}  // namespace

BaseType base_type(tables::DataType type) noexcept {
  if (type == tables::DataType::boolean) return BaseType::boolean;
  const condition::TypeInfo& info = condition::info_of(type);
  if (info.kind == tables::NumberKind::real || info.bits == 64) return BaseType::real;
  return info.bits == 32 && info.kind == tables::NumberKind::unsigned_integer ? BaseType::real : BaseType::integer;
}

Variables::Variables(const tables::PlantTables& tables) {
  add(Kind::seed, BaseType::integer, 0, "seed");
  const auto values = tables::split_names(tables.values.names);
  for (std::uint32_t v = 0; v < tables.values.rows.size(); ++v) {
    if (!is_parameter(tables.values.rows[v])) continue;
    add(Kind::parameter, BaseType::real, v, std::string(values[2 * std::size_t{v}]));
  }
  add_malfunctions(tables);
  add_symbols(tables);
  add_local(tables);
  number();
}

void Variables::add(Kind kind, BaseType type, std::uint32_t of, std::string name) {
  variables_.push_back({kind, type, of, 0, std::move(name)});
}

void Variables::add_malfunctions(const tables::PlantTables& tables) {
  const tables::MalfunctionNumbers numbers(tables);
  const auto written = tables::split_names(tables.malfunctions.names);
  const auto units = tables::split_names(tables.unit_names);
  const auto symbols = tables::split_names(tables.symbol_names);
  const auto add_ordinary = [&](std::uint32_t number, std::string_view of) {
    add(Kind::malfunction, BaseType::boolean, number,
        std::string(of).append(" ").append(numbers.ordinary_name(number)));
  };
  for (std::uint32_t m = 0; m < written.size(); ++m) {
    add(Kind::malfunction, BaseType::boolean, m, std::string(written[m]));
  }
  for (std::uint32_t u = 0; u < units.size(); ++u) {
    add_ordinary(numbers.stuck(u), units[u]);
    add_ordinary(numbers.slow(u), units[u]);
  }
  for (std::uint32_t s = 0; s < tables.symbols.size(); ++s) {
    if (!numbers.is_bool_event(s)) continue;
    add_ordinary(numbers.stuck(s, false), symbols[2 * std::size_t{s}]);
    add_ordinary(numbers.stuck(s, true), symbols[2 * std::size_t{s}]);
  }
}

void Variables::add_symbols(const tables::PlantTables& tables) {
  const auto names = tables::split_names(tables.symbol_names);
  const std::vector<bool> driven = driven_symbols(tables);
  std::vector<bool> follows(tables.symbols.size());
  for (const tables::SharedAddress& shared : tables.shared_addresses) follows[shared.symbol] = true;
  const auto add_all = [&](Kind kind, tables::Direction direction, std::string_view end, const auto& chosen) {
    for (std::uint32_t s = 0; s < tables.symbols.size(); ++s) {
      const tables::SymbolRow& row = tables.symbols[s];
      if (row.direction() != direction || !chosen(s)) continue;
      add(kind, base_type(row.type()), s, std::string(names[2 * std::size_t{s}]).append(end));
    }
  };
  add_all(Kind::operation, tables::Direction::operation, "", [&](std::uint32_t s) { return !follows[s]; });
  add_all(Kind::undriven_event, tables::Direction::event, ".set",
          [&](std::uint32_t s) { return !driven[s] && !follows[s]; });
  add_all(Kind::event, tables::Direction::event, "", [](std::uint32_t) { return true; });
  add_all(Kind::other_operation, tables::Direction::operation, "", [&](std::uint32_t s) { return follows[s]; });
}

void Variables::add_local(const tables::PlantTables& tables) {
  const auto units = tables::split_names(tables.unit_names);
  for (std::uint32_t u = 0; u < units.size(); ++u) {
    add(Kind::state, BaseType::enumeration, u, std::string(units[u]).append(".state"));
    add(Kind::moving, BaseType::boolean, u, std::string(units[u]).append(".moving"));
  }
  const auto locations = tables::split_names(tables.material.location_names);
  for (std::uint32_t l = 0; l < locations.size(); ++l) {
    add(Kind::parts, BaseType::integer, l, std::string(locations[l]).append(".parts"));
  }
  const auto values = tables::split_names(tables.values.names);
  for (std::uint32_t v = 0; v < tables.values.rows.size(); ++v) {
    const tables::ValueRow& row = tables.values.rows[v];
    if (is_parameter(row)) continue;
    for (std::uint32_t i = 0; i < row.outputs; ++i) {
      std::string name(values[2 * std::size_t{v}]);
      if (row.outputs > 1) name.append("[").append(std::to_string(i + 1)).append("]");
      add(Kind::output, BaseType::real, row.output + i, std::move(name));
    }
  }
  const auto written = tables::split_names(tables.malfunctions.names);
  for (std::uint32_t m = 0; m < written.size(); ++m) {
    add(Kind::active, BaseType::boolean, m, std::string(written[m]).append(".active"));
  }
  add(Kind::short_pulses, BaseType::integer, 0, "short pulses");
  add(Kind::violations, BaseType::integer, 0, "violated requirements");
}

/// A reference is a digest of the name alone, so that it stays when other variables come or go. Of two with the same
/// digest the later one takes another attempt: symbols come first, and malfunctions, which are many, last.
void Variables::number() {
  std::vector<std::uint32_t> order(variables_.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto rank = [&](std::uint32_t i) {
    const Kind kind = variables_[i].kind;
    return kind == Kind::operation || kind == Kind::event ? 0 : kind == Kind::malfunction ? 2 : 1;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return rank(a) < rank(b); });
  std::unordered_set<std::string_view> names;
  std::unordered_set<std::uint32_t> taken;
  for (const std::uint32_t i : order) {
    Variable& variable = variables_[i];
    if (!names.insert(variable.name).second && repeated_.empty()) repeated_ = variable.name;
    std::uint32_t attempt = 0;
    do variable.reference = reference_of(variable.name, attempt++);
    while (!taken.insert(variable.reference).second);
    by_reference_.push_back({variable.reference, i});
  }
  std::sort(by_reference_.begin(), by_reference_.end(),
            [](const Entry& a, const Entry& b) { return a.reference < b.reference; });
}

std::optional<std::uint32_t> Variables::find(std::uint32_t reference) const noexcept {
  const auto found =
      std::lower_bound(by_reference_.begin(), by_reference_.end(), reference,
                       [](const Entry& entry, std::uint32_t sought) { return entry.reference < sought; });
  if (found == by_reference_.end() || found->reference != reference) return std::nullopt;
  return found->variable;
}

std::string guid_of(const tables::PlantTables& tables, const Variables& variables) {
  tables::Fnv1a64 digest;
  for (const Variable& variable : variables.all()) {
    digest.text(variable.name);
    digest.u32(variable.reference);
    digest.byte(static_cast<std::uint8_t>(variable.type));
    digest.byte(static_cast<std::uint8_t>(variable.kind));
  }
  tables::PlantTables plain = tables;
  plain.values.compiled = {};  // the user's formulas do not change the interface
  const std::uint64_t first = tables::model_hash(plain);
  const std::uint64_t second = digest.value();
  std::array<char, 39> text{};
  std::snprintf(text.data(), text.size(), "{%08x-%04x-%04x-%04x-%012llx}", static_cast<unsigned>(first >> 32),
                static_cast<unsigned>(first >> 16 & 0xFFFF), static_cast<unsigned>(first & 0xFFFF),
                static_cast<unsigned>(second >> 48), static_cast<unsigned long long>(second & 0xFFFF'FFFF'FFFF));
  return text.data();
}

}  // namespace symplant::fmi
