// The tables of a plant as bytes: one list of members writes and reads them.
#include "symplant/fmi/tables_file.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <span>
#include <type_traits>

#include "symplant/tables/digest.hpp"
#include "symplant/tables/fields.hpp"
#include "symplant/tables/version.hpp"

namespace symplant::fmi {
namespace {

using tables::RowOf;

constexpr std::string_view kMark = "symplant tables\n";

template <RowOf<tables::TypeRow> Row, class Visit>
void members(Row& row, Visit& visit) {
  visit(row.operations), visit(row.events), visit(row.states), visit(row.rest), visit(row.actuation);
  visit(row.transitions), visit(row.enter), visit(row.leave), visit(row.operation_targets), visit(row.times);
  visit(row.travel);
}

/// The bit fields of a UnitRow in one number; it has the other members as they are.
template <RowOf<tables::UnitRow> Row, class Visit>
void members(Row& row, Visit& visit) {
  std::uint32_t packed = row.type | std::uint32_t{row.initial} << 23 | std::uint32_t{row.general} << 31;
  visit(packed), visit(row.operation_bit), visit(row.event_bit), visit(row.times);
  if constexpr (!std::is_const_v<Row>) {
    row.type = packed & 0x7F'FFFF;
    row.initial = packed >> 23 & 0xFF;
    row.general = 0;
    if (packed >> 31 != 0) row.general = 1;
  }
}

template <RowOf<tables::SymbolRow> Row, class Visit>
void members(Row& row, Visit& visit) {
  visit(row.index), visit(row.unit), visit(row.number), visit(row.row), visit(row.kind);
}

template <RowOf<tables::SymbolListRow> Row, class Visit>
void members(Row& row, Visit& visit) {
  visit(row.first_symbol), visit(row.controller);
}

template <RowOf<tables::MaterialTables> Tables, class Visit>
void members(Tables& t, Visit& visit) {
  visit(t.kinds), visit(t.tracks), visit(t.drives), visit(t.stops), visit(t.ends), visit(t.sensors), visit(t.places);
  visit(t.transfers), visit(t.work), visit(t.sources), visit(t.sensor_kinds), visit(t.source_kinds), visit(t.counters);
  visit(t.kind_names), visit(t.location_names), visit(t.transfer_names), visit(t.work_names), visit(t.source_names);
}

template <RowOf<tables::MalfunctionTables> Tables, class Visit>
void members(Tables& t, Visit& visit) {
  visit(t.rows), visit(t.effects), visit(t.units), visit(t.tracks), visit(t.forces), visit(t.sets), visit(t.names);
}

template <RowOf<tables::ValueTables> Tables, class Visit>
void members(Tables& t, Visit& visit) {
  visit(t.rows), visit(t.order), visit(t.changes), visit(t.signals), visit(t.formulas), visit(t.steps);
  visit(t.inputs), visit(t.numbers), visit(t.comparisons), visit(t.outputs), visit(t.names), visit(t.formula_texts);
}

template <RowOf<tables::PlantTables> Tables, class Visit>
void members(Tables& t, Visit& visit) {
  visit(t.name), visit(t.types), visit(t.units), visit(t.times), visit(t.random_times), visit(t.symbols);
  visit(t.lists), visit(t.initial_values), visit(t.shared_addresses), visit(t.disables), visit(t.conditions);
  visit(t.conditioned_units), visit(t.unit_watches), visit(t.operation_watches), visit(t.event_watches);
  visit(t.operation_value_watches), visit(t.event_value_watches), visit(t.requirements), visit(t.follows);
  visit(t.overruns), members(t.material, visit), visit(t.part_watches), members(t.malfunctions, visit);
  members(t.values, visit), visit(t.behaviour_units), visit(t.behaviour_values), visit(t.operation_bits);
  visit(t.event_bits), visit(t.operation_slots), visit(t.event_slots), visit(t.unit_names), visit(t.state_names);
  visit(t.symbol_names), visit(t.requirement_names), visit(t.behaviour_names), visit(t.list_names);
  visit(t.controller_names);
}

template <class Row, class Visit>
concept HasMembers = requires(Row& row, Visit& visit) {
  members(row, visit);
};

template <class Type>
concept Number = std::is_arithmetic_v<Type> || std::is_enum_v<Type>;

/// The unsigned integer with as many bytes as a number has.
template <std::size_t Bytes>
using Unsigned = std::conditional_t<
    Bytes == 1, std::uint8_t,
    std::conditional_t<Bytes == 2, std::uint16_t, std::conditional_t<Bytes == 4, std::uint32_t, std::uint64_t>>>;

class Writer {
 public:
  explicit Writer(std::string& bytes) : bytes_(bytes) {}

  template <class Value>
  void operator()(const Value& value) {
    if constexpr (Number<Value>) {
      auto bits = std::bit_cast<Unsigned<sizeof(Value)>>(value);
      for (std::size_t i = 0; i < sizeof bits; ++i) {
        bytes_.push_back(static_cast<char>(static_cast<std::uint64_t>(bits) >> (8 * i)));
      }
    } else if constexpr (tables::Meant<Value>) {
      (*this)(value.value);
    } else if constexpr (HasMembers<const Value, Writer>) {
      members(value, *this);
    } else {
      fields(value, *this);
    }
  }
  void operator()(std::string_view text) {
    (*this)(std::uint64_t{text.size()});
    bytes_ += text;
  }
  template <class Row>
  void operator()(std::span<const Row> rows) {
    (*this)(std::uint64_t{rows.size()});
    for (const Row& row : rows) (*this)(row);
  }

 private:
  std::string& bytes_;
};

using Memory = std::vector<std::unique_ptr<std::byte[]>>;

/// Reads what Writer wrote. After the end of the bytes it reads zeros and empty tables.
class Reader {
 public:
  Reader(std::string_view bytes, Memory& memory) : rest_(bytes), memory_(memory) {}

  std::string_view rest() const { return rest_; }
  bool at_end() const { return !failed_ && rest_.empty(); }

  template <class Value>
  void operator()(Value& value) {
    if constexpr (Number<Value>) {
      const std::string_view bytes = take(sizeof(Value));
      std::uint64_t bits = 0;
      for (std::size_t i = 0; i < bytes.size(); ++i)
        bits |= std::uint64_t{static_cast<std::uint8_t>(bytes[i])} << 8 * i;
      if constexpr (std::is_same_v<Value, bool>) {
        value = bits != 0;
      } else {
        value = std::bit_cast<Value>(static_cast<Unsigned<sizeof(Value)>>(bits));
      }
    } else if constexpr (HasMembers<Value, Reader>) {
      members(value, *this);
    } else {
      fields(value, *this);
    }
  }
  template <tables::Meant Field>
  void operator()(Field field) {
    (*this)(field.value);
  }
  void operator()(std::string_view& text) {
    const std::string_view bytes = take(count());
    if (bytes.empty()) return;
    void* const copy = allocate(bytes.size());
    std::memcpy(copy, bytes.data(), bytes.size());
    text = {static_cast<const char*>(copy), bytes.size()};
  }
  template <class Row>
  void operator()(std::span<const Row>& rows) {
    static_assert(std::is_trivially_destructible_v<Row> && alignof(Row) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);
    const std::size_t size = count();
    if (size == 0) return;
    Row* const read = static_cast<Row*>(allocate(size * sizeof(Row)));
    for (std::size_t i = 0; i < size; ++i) (*this)(*new (read + i) Row{});
    rows = {read, size};
  }

 private:
  /// A number of rows or bytes. Each row has at least one byte, so a larger number is damage.
  std::size_t count() {
    std::uint64_t count = 0;
    (*this)(count);
    if (count > rest_.size()) fail();
    return failed_ ? 0 : static_cast<std::size_t>(count);
  }
  void* allocate(std::size_t bytes) { return memory_.emplace_back(new std::byte[bytes]).get(); }
  std::string_view take(std::size_t bytes) {
    if (bytes > rest_.size()) fail();
    const std::string_view taken = rest_.substr(0, failed_ ? 0 : bytes);
    rest_.remove_prefix(taken.size());
    return taken;
  }
  void fail() {
    failed_ = true;
    rest_ = {};
  }

  std::string_view rest_;
  Memory& memory_;
  bool failed_ = false;
};

}  // namespace

std::string write_tables(const tables::PlantTables& tables) {
  std::string body;
  Writer body_writer(body);
  members(tables, body_writer);
  std::string bytes(kMark);
  Writer writer(bytes);
  writer(static_cast<std::uint32_t>(tables::kTablesVersion));
  writer(tables::digest_of(body));
  return bytes + body;
}

std::variant<std::unique_ptr<const LoadedTables>, std::string> LoadedTables::read(std::string_view bytes) {
  if (bytes.substr(0, kMark.size()) != kMark) return "it is not a file of tables";
  std::unique_ptr<LoadedTables> loaded(new LoadedTables());
  Reader reader(bytes.substr(kMark.size()), loaded->memory_);
  std::uint32_t version = 0;
  std::uint64_t digest = 0;
  reader(version);
  if (version != static_cast<std::uint32_t>(tables::kTablesVersion)) {
    return "its tables have the layout " + std::to_string(version) + ", this library reads " +
           std::to_string(tables::kTablesVersion);
  }
  reader(digest);
  if (digest != tables::digest_of(reader.rest())) return "it is damaged";
  members(loaded->tables_, reader);
  if (!reader.at_end()) return "it is damaged";
  return std::unique_ptr<const LoadedTables>(std::move(loaded));
}

}  // namespace symplant::fmi
