// Rules: lists without inputs and outputs, or without devices.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

using model::InternalReason;

std::string count_of_rows(std::size_t count, std::string_view one, std::string_view several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

std::string internal_text(InternalReason reason, std::size_t count) {
  switch (reason) {
    case InternalReason::constant:
      return count_of_rows(count, "is a constant", "are constants");
    case InternalReason::memory:
      return count_of_rows(count, "has an address in the memory of the PLC", "have addresses in the memory of the PLC");
    case InternalReason::type:
      return count_of_rows(count, "has a type that no input or output has", "have types that no input or output has");
    case InternalReason::no_direction:
      break;
  }
  return count_of_rows(count, "has no address and no direction in its name",
                       "have no address and no direction in their names");
}

/// Whether a list is of a PLC whose inputs and outputs share an area.
bool has_shared_area(const model::PlantModel& plant) {
  return std::any_of(plant.lists.begin(), plant.lists.end(), [](const model::PlantList& list) {
    return list.table->notation == address::Notation::omron && list.table->io_words.ranges.empty();
  });
}

std::string io_advice(InternalReason reason, const model::PlantModel& plant) {
  switch (reason) {
    case InternalReason::constant:
      return "export the variables as well";
    case InternalReason::memory:
      if (has_shared_area(plant)) {
        return "the addresses of this PLC do not show which are inputs and outputs: give the words, such as `--cio "
               "inputs=0-99,outputs=100-199`, or `\"cio\"` in plant.json";
      }
      return "export the list that declares the inputs and outputs (X, Y, `%I`, `%Q`)";
    case InternalReason::type:
      return "write the type of each input and output, such as BOOL or INT";
    case InternalReason::no_direction:
      break;
  }
  return fmt::format("export the addresses as well, or name the symbols by `{}`", plant.rule_text());
}

/// The reasons, the most frequent one first.
std::array<InternalReason, model::kInternalReasons> reasons_by_count(const model::PlantModel& plant) {
  std::array<InternalReason, model::kInternalReasons> reasons{};
  for (std::size_t i = 0; i < reasons.size(); ++i) reasons[i] = static_cast<InternalReason>(i);
  std::stable_sort(reasons.begin(), reasons.end(), [&](InternalReason a, InternalReason b) {
    return plant.internal[static_cast<std::size_t>(a)] > plant.internal[static_cast<std::size_t>(b)];
  });
  return reasons;
}

void check_no_io(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (!plant.symbols.empty()) return;
  std::size_t rows = 0;
  const read::ListRow* first = nullptr;
  for (const model::PlantList& list : plant.lists) {
    rows += list.table->rows.size();
    if (first == nullptr && !list.table->rows.empty()) first = &list.table->rows.front();
  }
  if (first == nullptr) return;  // SP104 reports it
  const auto reasons = reasons_by_count(plant);
  std::string text;
  for (const InternalReason reason : reasons) {
    const std::size_t count = plant.internal[static_cast<std::size_t>(reason)];
    if (count != 0) text += (text.empty() ? "" : ", ") + internal_text(reason, count);
  }
  diagnostics.add(rule.info,
                  fmt::format("none of {} row{} is I/O: {}; {}", rows, rows == 1 ? "" : "s", text,
                              io_advice(reasons.front(), plant)),
                  location_of(plant, *first, first->name));
}

/// Why symbols are in no device, and how many of them.
struct Outside {
  std::size_t count = 0;
  std::string_view one;
  std::string_view several;
  std::string_view advice;
};

constexpr std::string_view kRename = "rename them by";

/// Indexes in reasons_outside().
enum OutsideBy : std::size_t { kByLevels, kByEmpty, kByDirection, kByCharacter, kByNumber, kBySize };

OutsideBy outside_by(const model::Symbol& symbol) {
  if (symbol.unmodelled == model::Unmodelled::numeric) return kByNumber;
  switch (symbol.reading.fault) {
    case name::NameFault::wrong_number_of_levels:
      return kByLevels;
    case name::NameFault::empty_level:
      return kByEmpty;
    case name::NameFault::direction_not_io:
      return kByDirection;
    case name::NameFault::illegal_character:
      return kByCharacter;
    case name::NameFault::none:
    case name::NameFault::not_linked:
      break;
  }
  return kBySize;
}

/// The reasons under a custom naming rule.
std::vector<Outside> reasons_unlinked(const model::PlantModel& plant) {
  std::vector<Outside> reasons{
      {0, "is matched by no rule", "are matched by no rule", "add rules to"},
      {0, "has no symbol to be paired with", "have no symbols to be paired with", "correct"},
      {0, "is ignored", "are ignored", "correct `ignore` of"},
      {0, "is in a device that is too large", "are in devices that are too large", "check the device level of"},
      {0, "has a role that is never paired, or is a number", "have roles that are never paired, or are numbers",
       "add rules for operations and events to"},
  };
  for (const model::Symbol& symbol : plant.symbols) {
    const model::Unmodelled by = symbol.unmodelled;
    const std::size_t reason = by == model::Unmodelled::no_rule          ? 0
                               : by == model::Unmodelled::unpaired       ? 1
                               : by == model::Unmodelled::ignored        ? 2
                               : by == model::Unmodelled::unit_too_large ? 3
                                                                         : 4;
    ++reasons[reason].count;
  }
  return reasons;
}

std::vector<Outside> reasons_outside(const model::PlantModel& plant) {
  std::vector<Outside> reasons{
      {0, "name has another number of levels", "names have another number of levels", kRename},
      {0, "name has an empty level", "names have an empty level", kRename},
      {0, "name has no direction", "names have no direction", kRename},
      {0, "name has a character that is neither letter nor digit",
       "names have characters that are neither letter nor digit", kRename},
      {0, "is a number", "are numbers", "add BOOL symbols named by"},
      {0, "is in a device that is too large", "are in devices that are too large",
       "check the device level of the names in"},
  };
  if (plant.pairing != nullptr) {
    reasons = reasons_unlinked(plant);
  } else {
    for (const model::Symbol& symbol : plant.symbols) ++reasons[outside_by(symbol)].count;
  }
  std::erase_if(reasons, [](const Outside& reason) { return reason.count == 0; });
  std::stable_sort(reasons.begin(), reasons.end(),
                   [](const Outside& a, const Outside& b) { return a.count > b.count; });
  return reasons;
}

void check_no_device(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (plant.symbols.empty() || !plant.units.empty()) return;
  const std::vector<Outside> reasons = reasons_outside(plant);
  std::string text;
  for (const Outside& reason : reasons) {
    text +=
        fmt::format("{}{} {}", text.empty() ? "" : ", ", reason.count, reason.count == 1 ? reason.one : reason.several);
  }
  const std::string other =
      plant.pairing != nullptr || reasons.front().advice != kRename
          ? ""
          : fmt::format(", or let `symplant infer {} -o naming.json` propose the rule of the list",
                        plant.lists[plant.symbols.front().list].name());
  diagnostics.add(rule.info,
                  fmt::format("none of {} I/O symbol{} is in a device: {}; {} `{}`{}; until then the symbols are "
                              "served, and nothing moves",
                              plant.symbols.size(), plant.symbols.size() == 1 ? "" : "s", text, reasons.front().advice,
                              plant.rule_text(), other),
                  location_of(plant, plant.symbols.front()));
}

}  // namespace

const Rule kNoIo{
    {"SP318", "no-io", diag::Severity::error, "no row of the plant's lists is an input or output",
     R"(The lists have rows, but none is an input or output of the PLC. A row is I/O if it has an address of the PLC's inputs or
outputs (X, Y, `%I`, `%Q`), or no address and a name with a direction (`EXLINE_MB_AGV_I_P1`). Constants, addresses in the
PLC's memory (M, D, `%M`) and types such as TIME or STRING are internal. The message counts the rows by reason.

**What the model loses.** Everything: there is no symbol, no device and nothing to put on a link. Nothing is written.

**How to fix it.** Export the list with its address columns, or export the list that declares the inputs and outputs. If the
list is of an Omron PLC, say which words of the CIO area are inputs and outputs: `--cio inputs=0-99,outputs=100-199`. If it has no
addresses, give its names the form of the naming rule, `LINE_PROC_DEV_I|O_TASK`.
)"},
    check_no_io};

const Rule kNoDevice{
    {"SP415", "no-device", diag::Severity::error, "the plant has I/O symbols and no device",
     R"(The lists have I/O symbols, but none of them is in a device. Devices are made from BOOL symbols whose names have the form of
the naming rule, `LINE_PROC_DEV_I|O_TASK`: `EXLINE_MB_AGV_O_P1` and `EXLINE_MB_AGV_I_P1` are an operation and an event of the
device `EXLINE_MB_AGV`. The message counts the symbols by reason.
Under a custom naming rule devices are made from operations and events that the rule pairs.

**What the model loses.** All behavior. The symbols would be on the links, but nothing drives an input and no output has an
effect.

**How to fix it.** Let symplant propose the naming rule of the list: `symplant infer LIST -o naming.json`, then `symplant check
LIST --naming naming.json`. Or rename the symbols by the rule. The other commands still serve the symbols. If you want a plant of plain signals, set `"check": { "severity": { "no-device": "note" } }` in
plant.json.
)"},
    check_no_device};

}  // namespace symplant::check
