// SP318 no-io: no row of the plant's lists is an input or output.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kNoIoPage =
    R"(The lists have rows, but none is an input or output of the PLC. A row is I/O if it has an address of the PLC's inputs or
outputs (X, Y, `%I`, `%Q`), or no address and a name with a direction (`EXLINE_MB_AGV_I_P1`). Constants, addresses in the
PLC's memory (M, D, `%M`) and types such as TIME or STRING are internal. The message counts the rows by reason.

**What the model loses.** Everything: there is no symbol, no device and nothing to put on a link. Nothing is written.

**How to fix it.** Export the list with its address columns, or export the list that declares the inputs and outputs. If the
list is of an Omron PLC, say which words of the CIO area are inputs and outputs: `--cio inputs=0-99,outputs=100-199`. If it has no
addresses, give its names the form of the naming rule, `LINE_PROC_DEV_I|O_TASK`.
)";

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

}  // namespace

const Rule kNoIo{
    {"SP318", "no-io", diag::Severity::error, "no row of the plant's lists is an input or output", kNoIoPage},
    check_no_io};

}  // namespace symplant::check
