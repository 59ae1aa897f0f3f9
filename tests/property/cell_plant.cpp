// Random plants whose names are read by a custom naming rule.
#include "property/cell_plant.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "property/random_unit.hpp"

namespace symplant::property {
namespace {

using name::ArchetypeModel;
using name::ArchetypeRole;

name::SymbolRule rule(std::string pattern) {
  name::SymbolRule made;
  made.patterns.push_back({name::Source::name, std::move(pattern)});
  return made;
}

name::Archetype archetype(std::string name, ArchetypeModel model,
                          std::vector<std::pair<ArchetypeRole, std::string>> texts) {
  name::Archetype made;
  made.name = std::move(name);
  made.model = model;
  made.texts = std::move(texts);
  return made;
}

class CellWriter {
 public:
  explicit CellWriter(Dice& dice) : dice_(dice) {}

  PlantText write() {
    text_.naming = dice_.percent(25) ? "sequence" : "cell";
    const std::size_t devices = 1 + dice_.below(6);
    for (std::size_t i = 0; i < devices; ++i) device("S" + std::to_string(dice_.below(2)), std::to_string(i));
    if (dice_.percent(20)) row("KA1", true);
    if (dice_.percent(40)) row("B1", false);
    if (dice_.percent(30)) row("B2", false);
    follow();
    text_.description.inverted = random_inverted(dice_, text_.rows);
    if (dice_.percent(30)) dice_.shuffle(text_.rows);
    description::Defaults& defaults = text_.description.defaults;
    defaults.travel = random_time(dice_);
    defaults.dwell = random_time(dice_);
    if (dice_.percent(50)) defaults.overrun = random_overrun(dice_);
    if (dice_.percent(30)) defaults.actuation = static_cast<tables::Actuation>(dice_.below(4));
    return std::move(text_);
  }

 private:
  void row(std::string name, bool operation) {
    const std::string initial = dice_.percent(operation ? 3 : 8) ? "TRUE" : "";
    text_.rows.push_back({std::move(name), (operation ? "%QX" : "%IX") + std::to_string(next_++), "BOOL", initial});
  }
  void maybe(const std::string& name, bool operation, unsigned percent) {
    if (dice_.percent(percent)) row(name, operation);
  }

  /// New inputs, and one that is a linked sensor without this.
  void follow() {
    for (const std::string name : {"F1", "F2"}) {
      if (!dice_.percent(30) || text_.rows.empty()) continue;
      text_.description.follow.push_back({name, (dice_.percent(30) ? "not " : "") + dice_.pick(text_.rows).name});
      row(name, false);
    }
    const auto follows_itself = [](const description::GivenFollow& given) { return given.condition.ends_with("B1"); };
    const auto& follow = text_.description.follow;
    const bool linked =
        std::any_of(text_.rows.begin(), text_.rows.end(), [](const Row& row) { return row.name == "B1"; });
    if (linked && dice_.percent(40) && std::none_of(follow.begin(), follow.end(), follows_itself)) {
      text_.description.follow.push_back({"B1", text_.rows.front().name});
    }
  }

  void device(const std::string& process, const std::string& number) {
    switch (dice_.below(3)) {
      case 0:
        return cylinder(process, "CLAMP" + number);
      case 1:
        return robot("RB" + number);
      default:
        return machine("MC" + number);
    }
  }

  void cylinder(const std::string& process, const std::string& name) {
    const std::string rest = dice_.percent(50) ? "RET" : "DOWN";
    const std::string other = rest == "RET" ? "ADV" : "UP";
    maybe(process + "_SOL_" + name + "_" + other, true, 95);
    maybe(process + "_SOL_" + name + "_" + rest, true, 60);
    for (const std::string& state : {rest, other}) {
      maybe(process + "_LS_" + name + "_" + state, false, 60);
      maybe(process + "_LS_" + name + "_" + state + "1", false, 40);
      maybe(process + "_LS_" + name + "_LH_" + state, false, 30);
    }
  }

  void robot(const std::string& name) {
    for (const std::string x : {"A", "B"}) {
      maybe(name + "_SEL_" + x, true, 40);
      maybe(name + "_SEL_" + x + "_ECHO", false, 70);
      maybe(name + "_TEST_" + x, true, 25);
      maybe(name + "_TEST_" + x + "_NOT", false, 80);
    }
    maybe(name + "_GO", true, 60);
    maybe(name + "_BUSY", false, 60);
    maybe(name + "_COMP", false, 80);
    maybe(name + "_COMP_ACK", true, 60);
    maybe(name + "_RST", true, 30);
    maybe(name + "_HEALTHY", false, 50);
  }

  void machine(const std::string& name) {
    maybe(name + "_RAISE", true, 70);
    maybe(name + "_LOWER", true, 50);
    maybe(name + "_HIGH", false, 60);
    maybe(name + "_LOW", false, 60);
    maybe(name + "_PUMP", true, 60);
    maybe(name + "_PUMP_FB", false, 80);
    for (const std::string job : {"JOB1", "JOB2", "JOB3"}) {
      maybe(name + "_" + job + "_CMD", true, 40);
      maybe(name + "_" + job + "_END", false, 60);
    }
  }

  Dice& dice_;
  PlantText text_;
  std::size_t next_ = 0;
};

}  // namespace

name::Naming naming_of(std::string_view name) {
  name::Naming naming;
  naming.rules.push_back(rule("{process}_{class}_{device...}_{task:known}"));
  naming.rules.back().fan_out = true;
  naming.rules.push_back(rule("{device}_{task...}"));
  naming.tasks.sequence = name == "sequence";
  naming.links = {{"KA1", "B1", "UP"}, {"", "B2", "DOWN"}};
  auto echo = archetype("sel", ArchetypeModel::mirror,
                        {{ArchetypeRole::operation, "SEL {x}"}, {ArchetypeRole::event, "SEL {x} ECHO"}});
  echo.delay = 50 * tables::kMillisecond;
  auto inverted = archetype("test", ArchetypeModel::mirror,
                            {{ArchetypeRole::operation, "TEST {x}"}, {ArchetypeRole::event, "TEST {x} NOT"}});
  inverted.inverted = true;
  auto work = archetype("work", ArchetypeModel::handshake,
                        {{ArchetypeRole::start, "GO"},
                         {ArchetypeRole::busy, "BUSY"},
                         {ArchetypeRole::done, "COMP"},
                         {ArchetypeRole::ack, "COMP ACK"},
                         {ArchetypeRole::reset, "RST"}});
  work.takes = 200 * tables::kMillisecond;
  auto lift = archetype("lift", ArchetypeModel::two_position,
                        {{ArchetypeRole::a, "LOWER"},
                         {ArchetypeRole::b, "RAISE"},
                         {ArchetypeRole::at_a, "LOW"},
                         {ArchetypeRole::at_b, "HIGH"}});
  lift.takes = 100 * tables::kMillisecond;
  auto pump =
      archetype("pump", ArchetypeModel::contactor, {{ArchetypeRole::on, "PUMP"}, {ArchetypeRole::is_on, "PUMP FB"}});
  pump.delay = 150 * tables::kMillisecond;
  auto healthy = archetype("healthy", ArchetypeModel::constant, {{ArchetypeRole::event, "HEALTHY"}});
  naming.archetypes = {echo, inverted, work, lift, pump, healthy};
  return naming;
}

PlantText cell_plant(Dice& dice) { return CellWriter(dice).write(); }

}  // namespace symplant::property
