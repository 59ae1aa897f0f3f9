// Rules: cells of rows: names that repeat, directions, types and initial values, and lists without inputs and outputs.
#include <algorithm>
#include <array>
#include <utility>

#include "check/rule.hpp"
#include "model/classify.hpp"
#include "read/parts.hpp"
#include "read/types/data_types.hpp"
#include "symplant/tables/nearest.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

/// Where a text holds several lists, one after the other, below repeated headers: several_lists() reports that once, so
/// no other rule reports it for each row.
class Parts {
 public:
  explicit Parts(const PlantModel& plant) : plant_(plant) {
    for (const model::PlantList& list : plant.lists) {
      begins_.push_back(list.table->parts.empty() ? std::vector<std::size_t>()
                                                  : read::find_parts(*list.table, list.radix.radix));
    }
  }

  bool are_apart(const read::ListRow& one, const read::ListRow& other) const {
    const std::uint32_t list = plant_.list_of(one);
    return plant_.list_of(other) == list && part_of(list, one) != part_of(list, other);
  }

 private:
  std::ptrdiff_t part_of(std::uint32_t list, const read::ListRow& row) const {
    const auto number = static_cast<std::size_t>(&row - plant_.lists[list].table->rows.data());
    const std::vector<std::size_t>& begins = begins_[list];
    return std::upper_bound(begins.begin(), begins.end(), number) - begins.begin();
  }

  const PlantModel& plant_;
  std::vector<std::vector<std::size_t>> begins_;  // by list
};

void duplicate_symbol(const Find& find) {
  const Parts parts(find.plant);
  for (const auto& [first, second, same] : find.evidence.duplicates) {
    if (!same || parts.are_apart(*first, *second)) continue;
    find.at(*second, second->name)
        .see(*first, first->name, "first declared here")
        .say("`{}` is declared again, with the same address and type: this row is left out; delete it", second->name);
  }
}

void symbol_declared_differently(const Find& find) {
  const Parts parts(find.plant);
  bool has_parts_apart = false;
  for (const auto& [first, second, same] : find.evidence.duplicates) {
    if (same) continue;
    if (parts.are_apart(*first, *second)) {
      if (std::exchange(has_parts_apart, true)) continue;
      find.at(*second, second->name)
          .see(*first, first->name, "first declared here")
          .explains(Kind::address, first->name)
          .say(
              "`{}` is declared again in another list of this text, with another address or type, and maybe others "
              "are: give each `\"part\"` its `\"controller\"` in plant.json",
              second->name);
      continue;
    }
    Finding finding = find.at(*second, second->name);
    finding.see(*first, first->name, "first declared here").explains(Kind::address, first->name);
    for (const diag::Subject& subject : find.at(*first, first->name).as.subjects.about) {
      if (subject.kind == Kind::device) finding.explains(Kind::device, subject.name);
    }
    const bool of_other_list = find.plant.list_of(*first) != find.plant.list_of(*second);
    finding.say("`{}` is declared again with another address, type or controller: rename it, or delete the wrong row{}",
                second->name,
                of_other_list ? ", or give its list a `prefix` in plant.json, such as `\"prefix\": \"PLC2_\"`" : "");
  }
}

void direction_against_address(const Find& find, const Symbol& symbol) {
  const bool has_direction = symbol.address && symbol.address->area != address::Area::memory;
  if (!has_direction || !symbol.reading.is_named() || symbol.described) return;
  const bool output = symbol.address->area == address::Area::output;
  if ((symbol.named == Direction::operation) == output) return;
  Finding finding = find.at(symbol);
  finding.explains(Kind::device, symbol.reading.device_path())
      .explains(Kind::address, symbol.name())
      .follows(Kind::address, symbol.name());
  if (find.plant.levels() != nullptr) {  // other rules read names and do not write them
    finding.rename(symbol, symbol_name(symbol.reading.device_path(), symbol.direction, symbol.reading.task()));
  }
  if (find.plant.naming().direction.conflict_is_error) finding.as.severity = kError;
  const bool address_counts = (symbol.direction == Direction::operation) == output;
  finding.say("`{}` is an {} by its name and an {} by its address `{}`: the {} counts{}; correct one of them",
              symbol.name(), output ? "event" : "operation", output ? "operation" : "event", symbol.address_cell(),
              address_counts ? "address" : "name",
              symbol.account == model::Account::task_taken ? ", and another symbol has that task already" : "");
}

void type_against_address(const Find& find, const Symbol& symbol) {
  const int bits = model::data_type_bits(symbol.type);
  if (!symbol.address || bits == static_cast<int>(symbol.address->size)) return;
  find.at(symbol, symbol.row->type)
      .explains(Kind::address, symbol.name())
      .lacks(symbol.name(), symbol.reading.device_path())
      .say("`{}` is {}, {} bit{}, but its address `{}` has {}: it is on no link; correct type or address",
           symbol.name(), model::data_type_name(symbol.type), bits, bits == 1 ? "" : "s", symbol.address_cell(),
           static_cast<int>(symbol.address->size));
}

void initial_not_understood(const Find& find, const Symbol& symbol) {
  if (symbol.initial_known) return;
  find.at(symbol, symbol.row->initial)
      .explains(Kind::symbol, symbol.name())
      .say("`{}` is not a value of type {}: `{}` starts {}; correct it or leave it empty", symbol.row->initial,
           model::data_type_name(symbol.type), symbol.name(),
           symbol.type == tables::DataType::boolean ? "off" : "at 0");
}

void operation_initial_ignored(const Find& find, const Symbol& symbol) {
  const bool bit = symbol.type == tables::DataType::boolean;
  if (symbol.direction == Direction::event || !bit || symbol.initial == 0) return;
  find.at(symbol, symbol.row->initial)
      .follows(Kind::address, symbol.name())
      .say("`{}` has Initial TRUE, but starts off: only the PLC writes operations; remove the initial value",
           symbol.name());
}

/// What the levels of a row's name say.
struct NameLevels {
  std::string_view path;  ///< of its device; empty if the name or the naming rule has no levels
  Direction direction{};
};

NameLevels name_levels(const PlantModel& plant, std::string_view name) {
  const name::LevelRule* const rule = plant.levels();
  if (rule == nullptr || !rule->has_path) return {};
  const name::LevelReading reading = name::read_levels(*rule, name);
  if (reading.fault != name::NameFault::none || reading.direction == nullptr || !reading.direction->says) return {};
  const std::string_view device = reading.of(name::Level::device);
  return {name.substr(0, static_cast<std::size_t>(device.data() + device.size() - name.data())),
          *reading.direction->says};
}

/// Whether a type is an elementary one that no I/O symbol has, or a typing mistake of one. Else it is a structure, as
/// of PROFIdrive.
bool is_elementary(std::string_view type) {
  constexpr auto kOthers = std::to_array<std::string_view>(
      {"TIME", "LTIME",         "S5TIME", "DATE",    "LDATE", "TOD",   "LTOD",    "TIME_OF_DAY", "DT",  "LDT",
       "DTL",  "DATE_AND_TIME", "STRING", "WSTRING", "WCHAR", "TIMER", "COUNTER", "POINTER",     "ANY", "VARIANT"});
  const std::string_view word = type.substr(0, type.find_first_of("[( "));
  if (std::ranges::any_of(kOthers, [&](std::string_view other) { return text::equal_ignoring_case(other, word); })) {
    return true;
  }
  tables::NearestName nearest(type);
  for (int i = 0; i <= static_cast<int>(tables::DataType::lreal); ++i) {
    nearest.offer(read::data_type_name(static_cast<tables::DataType>(i)));
  }
  return !nearest.name().empty();
}

void type_of_no_io(const Find& find) {
  std::vector<const model::TypelessIo*> structures;
  for (const model::TypelessIo& io : find.evidence.typeless_io) {
    if (!is_elementary(io.row->type)) {
      structures.push_back(&io);
      continue;
    }
    find.at(*io.row, io.row->type)
        .lacks(io.row->name, name_levels(find.plant, io.row->name).path)
        .say("`{}` is no type of an input or output, so `{}` on `{}` is left out; write BOOL, or the number's type",
             io.row->type, io.row->name, io.address_cell);
  }
  if (structures.empty()) return;
  const model::TypelessIo& first = *structures.front();
  Finding finding = find.at(*first.row, first.row->type);
  std::vector<std::string_view> types;
  for (const model::TypelessIo* io : structures) {
    finding.lacks(io->row->name, name_levels(find.plant, io->row->name).path);
    if (io != &first && finding.as.related.size() < 8) finding.see(*io->row, io->row->type, "another one");
    if (std::ranges::find(types, io->row->type) == types.end()) types.push_back(io->row->type);
  }
  const bool one = structures.size() == 1;
  finding.say(
      "`{}` on `{}`{} {} a structure as type (`{}`{}), and {} left out; list the elements, each with its address",
      first.row->name, first.address_cell, one ? "" : fmt::format(" and {} more", structures.size() - 1),
      one ? "has" : "have", types.front(), types.size() == 1 ? "" : fmt::format(" and {} more", types.size() - 1),
      one ? "is" : "are");
}

void io_name_in_memory(const Find& find) {
  const PlantModel& plant = find.plant;
  if (plant.units.empty()) return;  // the names have the form by accident
  if (plant.internal[static_cast<std::size_t>(model::InternalReason::memory)] == 0) return;
  if (plant.levels() == nullptr) return;
  for (const model::PlantList& list : plant.lists) {
    for (const read::ListRow& row : list.table->rows) {
      const model::RowAddress address = model::row_address(row, list.dialect());
      if (!address.address || address.address->area != address::Area::memory || address.contradicts) continue;
      const NameLevels reading = name_levels(plant, row.name);
      if (reading.path.empty() || row.klass.find("CONSTANT") != std::string_view::npos) continue;
      find.at(row, address.cell)
          .lacks(row.name, reading.path)
          .say(
              "`{}` is an {} by its name, but its address `{}` is memory: the row is left out; correct the name or the "
              "address",
              row.name, reading.direction == Direction::operation ? "operation" : "event", address.cell);
    }
  }
}

void no_io(const Find& find) {
  const PlantModel& plant = find.plant;
  if (!plant.symbols.empty()) return;
  std::size_t rows = 0;
  const read::ListRow* first = nullptr;
  bool shared_area = false;  // of inputs, outputs and memory
  for (const model::PlantList& list : plant.lists) {
    rows += list.table->rows.size();
    if (first == nullptr && !list.table->rows.empty()) first = &list.table->rows.front();
    shared_area =
        shared_area || (list.table->notation == address::Notation::omron && list.table->io_words.ranges.empty());
  }
  if (first == nullptr) return;  // SP104 reports it
  std::string text;
  for (std::size_t i = 0; i < model::kInternalReasons; ++i) {
    if (plant.internal[i] == 0) continue;
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ",
                        model::internal_reason_text(static_cast<model::InternalReason>(i)), plant.internal[i]);
  }
  find.at(location_of(plant, *first, first->name))
      .say("none of {} row{} is I/O: {}; export the list of inputs and outputs, with addresses and types{}", rows,
           rows == 1 ? "" : "s", text,
           shared_area ? ", and say which words are inputs and outputs, such as `--cio inputs=0-99,outputs=100-199`"
                       : fmt::format(", or name the symbols by `{}`", plant.rule_text()));
}

void several_lists(const Find& find) {
  const PlantModel& plant = find.plant;
  std::vector<std::vector<std::string_view>> followers(plant.lists.size());
  for (const Symbol& symbol : plant.symbols) {
    if (symbol.leader != kNone) followers[symbol.list].push_back(symbol.name());
  }
  for (const auto& pair : find.evidence.driven_twice) {
    followers[plant.symbols[pair[0]].list].push_back(plant.symbols[pair[0]].name());
  }
  for (std::uint32_t i = 0; i < plant.lists.size(); ++i) {
    const read::SymbolTable& table = *plant.lists[i].table;
    if (table.parts.empty() && followers[i].size() < 8) continue;  // fewer are doubles, not another list
    Finding finding = find.at(location_of(plant, table.rows.front(), table.rows.front().name));
    for (const std::size_t begin : read::find_parts(table, plant.lists[i].radix.radix)) {
      if (begin < table.rows.size()) finding.see(table.rows[begin], table.rows[begin].name, "a list begins here");
    }
    if (finding.as.related.empty()) continue;
    for (const std::string_view name : followers[i]) finding.explains(Kind::address, name);
    finding.say("this text holds {} lists ({}), read as one: give each `\"part\"` its `\"controller\"` in plant.json",
                finding.as.related.size() + 1,
                table.parts.empty() ? "the addresses start over" : "a header or a PLC begins again");
  }
}

constexpr Rule kRowRules[] = {
    {"SP301", "duplicate-symbol", kWarning, duplicate_symbol, "a symbol is declared twice, identically",
     "Two rows have one name, address and type. The case of ASCII letters does not count, as in PLC tools.",
     "Nothing: the first row counts.", "Delete one of the rows."},
    {"SP302", "symbol-declared-differently", kError, symbol_declared_differently, "two different rows have one name",
     "Two rows have one name, but differ in address, type or controller. Names are unique across a plant.",
     "The plant cannot be built: whichever row counted, the program might mean the other.",
     "Rename one of the symbols, or delete the wrong row.", Rank::row, For::all, diag::Effect::no_plant_yet},
    {"SP305", "direction-against-address", kWarning, direction_against_address, "name and address differ in direction",
     "`..._I_...` has the address of an output (Y, `%Q`), or `..._O_...` that of an input (X, `%I`).",
     "The address counts, since it is wired. If it is wrong, the device lacks a symbol. If the device has a symbol of "
     "that direction and task, the later row is in no device.",
     "Correct one of them. A naming rule may give the name priority, or make this an error.", Rank::direction},
    {"SP306", "type-against-address", kWarning, type_against_address, "a type needs another size of address",
     "A BOOL on `%IW5`, an INT on `X0010`.",
     "The symbol is in the model, but on no link: its register or bit is unknown.",
     "BOOL goes with X, Y, `%IX`, `%QX`; 16-bit types with `%IW`, `%QW`; 32-bit types with `%ID`.", Rank::row},
    {"SP310", "initial-not-understood", kWarning, initial_not_understood, "an initial value cannot be read",
     "BOOL takes TRUE, FALSE, 1 or 0; numbers are written like 5, -3, 16#1F, K5, H1F or 1.5 and must fit their type.",
     "The symbol starts off, or at 0, so its device may start in another state.", "Correct the cell, or empty it.",
     Rank::value},
    {"SP311", "operation-initial-ignored", kNote, operation_initial_ignored, "an operation has an initial value",
     "The PLC writes operations (its outputs): they start off until a PLC, a scenario or a person sets them."},
    {"SP313", "type-of-no-io", kWarning, type_of_no_io, "an input or output has a type that no I/O symbol has",
     "It is not one of BOOL, SINT to LINT, USINT to ULINT, BYTE to LWORD, REAL and LREAL: it is misspelled, or a "
     "structure, "
     "as of a PROFIdrive telegram. All structures of a plant are one finding.",
     "The symbol: the row counts as internal.",
     "Correct the type, or move the cells back. List the elements of a structure.", Rank::row},
    {"SP318", "no-io", kError, no_io, "no row of the plant's lists is an input or output",
     "A row is I/O if it has an address of inputs or outputs (X, Y, `%I`, `%Q`), or no address and a name with a "
     "direction. Constants, memory (M, D, `%M`) and types such as TIME are internal.",
     "Everything.", "Export addresses, or the list of inputs and outputs. Omron: `--cio inputs=0-99,outputs=100-199`."},
    {"SP323", "io-name-in-memory", kWarning, io_name_in_memory, "an input or output is in the PLC's memory",
     "A name with a direction, `LINE_PROC_DEV_I_TASK`, has the address `M100` or `%MX0.3`.",
     "The row is left out: memory belongs to the program. The device lacks the symbol.",
     "Write the wired address, or none, and place the symbol with `map` in `links`.", Rank::address, For::levels},
    {"SP330", "several-lists", kWarning, several_lists, "a text holds several lists one after the other",
     "The header occurs again, or most of the next rows have I/O addresses that rows before them have.",
     "All rows are read as one PLC's, and symbols of one address are kept equal.",
     "In plant.json: `\"symbols\": [{ \"file\": \"a.csv\", \"part\": 1, \"controller\": \"A\" }, ...]`.",
     Rank::address},
};

}  // namespace

std::span<const Rule> row_rules() { return kRowRules; }

}  // namespace symplant::check
