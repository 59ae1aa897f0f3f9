// SP205 name-slip: a word in a name looks like a typo of the one that is meant.
#include <fmt/format.h>

#include "check/rules.hpp"
#include "check/spelling/slips.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kNameSlipPage =
    R"(A line, process, device or task is written with a letter more, less or other, or with two neighbors exchanged, than the word
that is meant: `CLAPM1` for `CLAMP1`. Digits are never a slip: `CLAMP1` and `CLAMP2` are two devices. Neither is another letter
in a code of up to four letters (`PB1`, `PL1`), an axis or a side (`PBLX`, `PBLY`), or a word that has no symbol of this
direction. A single symbol whose code is rare is one, though.

The list itself must give evidence. One of these holds:

- The device that is meant lacks exactly this symbol (its siblings, the devices whose names differ in digits only, have it, or its
  other side is there), and the device as written is not expected to have it.
- The word is rare. The one that is meant is at least eight times as common (a task: four times) and has nothing there yet.
- Two devices differ only in their line or process and complement each other: one has just the operations or events that the
  other lacks, such as `EXCELL_MB_AGV_I_P1` and `EXLINE_MB_AGV_O_P1`, `EXLINE_MB_AGV_O_P2`, `EXLINE_MB_AGV_I_P2`.

**What the model loses.** The symbol becomes a separate device, or a separate state. The device that is meant lacks an
operation, so that the PLC's command has no effect, or it lacks an event, so that the PLC waits in vain. Patterns of plant.json
do not match the symbol.

**How to fix it.** Write the word that is meant. If both words are meant, ignore the finding by `check.ignore` in plant.json.
)";

std::string reason(const Slip& slip) {
  const bool one = slip.symbols.size() == 1;
  if (slip.why == Slip::Why::lacks) {
    return fmt::format("and `{}` lacks just {}", slip.meant_path, one ? "this symbol" : "these symbols");
  }
  const auto have = [&](std::string_view level) {
    return fmt::format("which {} devices have for their {}{}", slip.others, level,
                       level == "process" ? ", digits apart" : "");
  };
  switch (slip.level) {
    case name::Level::line:
      return have("line");
    case name::Level::process:
      return have("process");
    case name::Level::task:
      return fmt::format("which {} symbols have for their task", slip.others);
    default:
      return slip.others == 1 ? "which another device is called, digits apart"
                              : fmt::format("which {} devices are called, digits apart", slip.others);
  }
}

/// The text with the word that is meant. `at` is the index of the word that is written.
std::string corrected(std::string_view text, std::size_t at, const Slip& slip) {
  if (at + slip.written.size() > text.size()) return std::string(text);  // a device's path, the slip is in the task
  return std::string(text).replace(at, slip.written.size(), slip.meant);
}

/// The symbols as written, and the device that is meant. Explains the devices that are written, and what is missing in
/// those that are meant.
diag::Subjects about_slip(const model::PlantModel& plant, const Slip& slip) {
  const model::Symbol& first = plant.symbols[slip.symbols.front()];
  const auto at = static_cast<std::size_t>(slip.written.data() - first.name().data());
  diag::Subjects subjects = about(first);
  subjects.about.push_back(device(slip.meant_path));
  for (const std::uint32_t s : slip.symbols) {
    const model::Symbol& symbol = plant.symbols[s];
    if (s != slip.symbols.front()) {
      for (diag::Subject& subject : about(symbol).about) subjects.about.push_back(std::move(subject));
    }
    subjects.explains.push_back(device(symbol.reading.device_path));
    const std::string meant_path = corrected(symbol.reading.device_path, at, slip);
    explain_missing(subjects, corrected(symbol.name(), at, slip), meant_path, symbol.direction);
  }
  return subjects;
}

std::string slip_message(const model::PlantModel& plant, const Slip& slip) {
  if (slip.why != Slip::Why::complements) {
    return fmt::format("`{}` looks like a typo of `{}`, {}; write `{}` if that is meant", slip.written, slip.meant,
                       reason(slip), slip.meant);
  }
  const model::Symbol& first = plant.symbols[slip.symbols.front()];
  const std::string_view path = first.reading.device_path;
  return slip.symbols.size() == 1
             ? fmt::format(
                   "`{}` is the only symbol of `{}`, and just the one that `{}` lacks: if they are one device, "
                   "write `{}` or `{}` in all names",
                   first.name(), path, slip.meant_path, slip.meant, slip.written)
             : fmt::format(
                   "`{}` has just the {}s that `{}` lacks: if they are one device, write `{}` or `{}` in all "
                   "names",
                   path, direction_text(first.direction), slip.meant_path, slip.meant, slip.written);
}

void check_name_slip(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const Slip& slip : find_slips(plant, subject.classes)) {
    const model::Symbol& first = plant.symbols[slip.symbols.front()];
    std::vector<diag::Related> related;
    if (slip.meant_device != model::kNone && slip.level != name::Level::task) {
      const model::Symbol& known = plant.symbols[subject.classes.first_symbol(slip.meant_device)];
      const bool unknown = slip.why == Slip::Why::complements;
      related.push_back({location_of(plant, known), unknown ? "the other device" : "the device that is meant"});
    }
    for (std::size_t i = 1; i < slip.symbols.size(); ++i) {
      const model::Symbol& other = plant.symbols[slip.symbols[i]];
      related.push_back({location_of(plant, other), "here too"});
    }
    diag::Location location = location_of(plant, first);
    if (location.span.end - location.span.begin == first.name().size()) {
      const auto begin = static_cast<std::size_t>(slip.written.data() - first.name().data());
      location.span = {location.span.begin + begin, location.span.begin + begin + slip.written.size()};
    }
    diag::Diagnostic& finding = diagnostics.add(rule.info, about_slip(plant, slip), slip_message(plant, slip),
                                                std::move(location), std::move(related));
    const auto at = static_cast<std::size_t>(slip.written.data() - first.name().data());
    for (const std::uint32_t s : slip.symbols) {
      const model::Symbol& symbol = plant.symbols[s];
      finding.renames.push_back(rename_of(symbol, corrected(symbol.name(), at, slip), slip.why == Slip::Why::lacks));
    }
  }
}

}  // namespace

const Rule kNameSlip{{"SP205", "name-slip", diag::Severity::warning,
                      "a word in a name looks like a typo of the one that is meant", kNameSlipPage, diag::Rank::name},
                     check_name_slip};

}  // namespace symplant::check
