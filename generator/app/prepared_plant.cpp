// The parts of a compiled plant that a running plant needs.
#include "app/prepared_plant.hpp"

#include <fmt/format.h>

#include <utility>

namespace symplant::app {
namespace {

/// Whether a symbol would be in a device without a fault of the list.
bool is_faulty(const model::PlantModel& plant, name::Account account) {
  return account == name::Account::task_taken || account == name::Account::unit_too_large ||
         (account == name::Account::no_rule && plant.levels() != nullptr);
}

/// Lines about what the tables do not contain: rows that are not I/O, and symbols in no device.
std::vector<std::string> more(const model::PlantModel& plant) {
  std::vector<std::string> lines;
  std::string internal;
  std::size_t count = 0;
  for (std::size_t i = 0; i < model::kInternalReasons; ++i) {
    if (plant.internal[i] == 0) continue;
    count += plant.internal[i];
    internal += fmt::format("{}{} {}", internal.empty() ? "" : ", ", plant.internal[i],
                            model::internal_reason_text(static_cast<model::InternalReason>(i)));
  }
  if (count != 0) lines.push_back(fmt::format("internal: {} rows ({})", count, internal));
  std::size_t numeric = 0;
  std::size_t faulty = 0;
  std::size_t outside = 0;  // by a custom naming rule
  std::size_t follows = 0;
  std::size_t sensors = 0;
  std::size_t signals = 0;
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.unit_of_device() != model::kNone) continue;
    if (symbol.account == model::Account::numeric) {
      ++numeric;
    } else if (symbol.account == model::Account::follows) {
      ++follows;
    } else if (symbol.account == model::Account::senses_parts) {
      ++sensors;
    } else if (symbol.account == model::Account::shows_value) {
      ++signals;
    } else {
      ++(is_faulty(plant, symbol.account) ? faulty : outside);
    }
  }
  if (outside != 0) {
    lines.push_back(fmt::format(
        "in no device: {} by the naming rule, which pairs them with nothing; the links still carry them", outside));
  }
  if (follows != 0) lines.push_back(fmt::format("in no device: {} driven by a condition (`follow`)", follows));
  if (sensors != 0) lines.push_back(fmt::format("in no device: {} driven by parts (sensors of `material`)", sensors));
  if (signals != 0) lines.push_back(fmt::format("in no device: {} driven by formulas (`signals`)", signals));
  if (numeric != 0)
    lines.push_back(fmt::format(
        "in no device: {} numeric, since only BOOL symbols form states; the links still carry them", numeric));
  if (faulty != 0)
    lines.push_back(
        fmt::format("in no device: {} with faults, see `symplant check`; the links still carry them", faulty));
  return lines;
}

}  // namespace

PreparedPlant::PreparedPlant(Compiled compiled, const std::string& plant_file)
    : tables_(std::move(compiled.tables)),
      rows_(tables_.tables()),
      description_(compiled.plant.description),
      view_(compiled.plant, plant_file),
      programs_(*description_, plant_file),
      controllers_(std::move(compiled.plant.links)),
      more_(more(compiled.plant)),
      inputs_(compiled.plant.input_files()),
      more_views_(more_.begin(), more_.end()),
      input_views_(inputs_.begin(), inputs_.end()) {
  for (const description::LinkDescription& link : description_->links) links_.push_back({link.controller, link.url});
  for (const model::ControllerLink& link : controllers_) settings_.push_back(link.settings());
  for (const description::GivenCheck::Ignore& entry : description_->check.ignore) {
    if (!entry.finding.empty()) ignored_.push_back({entry.finding, entry.symbols, entry.until});
  }
}

host::PlantProgram PreparedPlant::program(const tables::PlantTables& tables) const {
  return {.tables = tables,
          .links = links_,
          .programs = programs_.rows(),
          .link_settings = settings_,
          .more = more_views_,
          .ignored = ignored_,
          .view = view_.view(),
          .inputs = input_views_};
}

}  // namespace symplant::app
