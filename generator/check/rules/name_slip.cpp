// SP205 name-slip: a word in a name differs by a slip from the one that is meant.
#include <fmt/format.h>

#include "check/rules.hpp"
#include "check/spelling/slips.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kNameSlipPage =
    R"(A line, process, device or task is written with a letter more, less or other, or with two neighbours exchanged, than the word
that is meant: `CLAPM1` for `CLAMP1`. Digits are never a slip: `CLAMP1` and `CLAMP2` are two devices.

It is told where the list itself speaks for it: the device that is meant lacks just this symbol (its siblings, the devices
whose names differ in digits alone, have it, or its other direction is there), and nobody expects it where it stands; or the
word is rare, and the one that is meant is at least eight times as common (a task: four times) and has nothing there yet.

**What the model loses.** The symbol becomes a device, or a state, of its own. The device that is meant lacks an operation, and
the PLC's command moves nothing, or it lacks an event, and the PLC waits for it in vain. Patterns of plant.json pass the
symbol by.

**How to fix it.** Write the word that is meant. Where two words are meant, leave the finding out by `check.ignore` in
plant.json.
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

void check_name_slip(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const Slip& slip : find_slips(plant, subject.classes)) {
    const model::Symbol& first = plant.symbols[slip.symbols.front()];
    std::vector<std::string> names = about(first);
    std::vector<diag::Related> related;
    if (slip.meant_device != model::kNone && slip.level != name::Level::task) {
      const model::Symbol& known = plant.symbols[subject.classes.first_symbol(slip.meant_device)];
      related.push_back({location_of(plant, known), "the device that is meant"});
    }
    names.push_back(slip.meant_path);
    for (std::size_t i = 1; i < slip.symbols.size(); ++i) {
      const model::Symbol& other = plant.symbols[slip.symbols[i]];
      related.push_back({location_of(plant, other), "here too"});
      for (std::string& name : about(other)) names.push_back(std::move(name));
    }
    diag::Location location = location_of(plant, first);
    if (location.span.end - location.span.begin == first.name().size()) {
      const auto begin = static_cast<std::size_t>(slip.written.data() - first.name().data());
      location.span = {location.span.begin + begin, location.span.begin + begin + slip.written.size()};
    }
    diagnostics.add(rule.info, std::move(names),
                    fmt::format("`{}` differs by a slip from `{}`, {}; write `{}` if that is meant", slip.written,
                                slip.meant, reason(slip), slip.meant),
                    std::move(location), std::move(related));
  }
}

}  // namespace

const Rule kNameSlip{{"SP205", "name-slip", diag::Severity::warning,
                      "a word in a name differs by a slip from the one that is meant", kNameSlipPage},
                     check_name_slip};

}  // namespace symplant::check
