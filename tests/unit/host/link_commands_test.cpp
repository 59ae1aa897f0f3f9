// Commands that clients of a link give to a run.
#include "symplant/host/link_commands.hpp"

#include <deque>
#include <memory>

#include "support/catch.hpp"
#include "support/set_link.hpp"
#include "symplant/host/run_acts.hpp"
#include "unit/exec/cell.hpp"

namespace symplant::test {
namespace {

using Kind = link::LinkCommand::Kind;

/// A link whose commands a test gives.
class CommandingLink final : public link::Link {
 public:
  std::string url() const override { return "commands:"; }
  link::LinkStatus status() const noexcept override { return {}; }
  void read_operations(plant::Plant&, tables::Time) noexcept override {}
  void write_events(const plant::Plant&, const exec::CycleStatus&) noexcept override {}
  bool has_commands() const override { return true; }
  std::optional<link::LinkCommand> take_command(bool frozen) noexcept override {
    was_frozen = frozen;
    if (waiting.empty()) return std::nullopt;
    const link::LinkCommand command = waiting.front();
    waiting.pop_front();
    return command;
  }

  bool freezes_plant() const noexcept override { return freezes; }

  std::deque<link::LinkCommand> waiting;
  bool was_frozen = false;
  bool freezes = false;  ///< as a lost link whose `plant-on-loss` is `freeze`
};

/// Freezes the plant like a panel.
class FreezingStepper final : public exec::Stepper {
 public:
  explicit FreezingStepper(plant::Plant& plant) : plant_(plant) {}
  void advance_to(tables::Time time) noexcept override { plant_.advance_to(time); }
  bool frozen() const noexcept override { return is_frozen; }
  void hold() noexcept override { ++holds; }
  bool over() const noexcept override { return true; }

  bool is_frozen = false;
  int holds = 0;

 private:
  plant::Plant& plant_;
};

struct CommandBench {
  explicit CommandBench(bool with_stepper = false) {
    auto made = std::make_unique<CommandingLink>();
    link = made.get();
    links.push_back({"", {}, std::move(made)});
    recorder.attach(plant);
    commands.emplace(links, plant, recorder, with_stepper ? &stepper : nullptr);
    plant.advance_to(0, &recorder);
  }
  /// A cycle of 10 ms, as exec::run_cycles() does it.
  void cycle() {
    if (commands->frozen()) {
      commands->hold();
    } else {
      commands->advance_to(plant.now() + 10 * tables::kMillisecond);
    }
  }
  tables::Time now() const { return plant.now() / tables::kMillisecond; }

  tables::PlantTables tables = cell_tables();
  OwnedPlant owned{tables};
  plant::Plant& plant = *owned;
  trace::Recorder recorder{tables, 256};
  FreezingStepper stepper{plant};
  CommandingLink* link = nullptr;
  host::Links links;
  std::optional<host::LinkCommands> commands;
};

}  // namespace

TEST_CASE("A link freezes the plant, and lets it run again") {
  CommandBench bench;
  bench.cycle();
  bench.link->waiting = {{Kind::freeze}};
  bench.cycle();
  CHECK(bench.now() == 20);  // the command takes effect at the end of its cycle
  bench.cycle();
  CHECK(bench.now() == 20);
  bench.link->waiting = {{Kind::run}};
  bench.cycle();
  bench.cycle();
  CHECK(bench.now() == 30);
}

TEST_CASE("A link lets a frozen plant run for some cycles") {
  CommandBench bench;
  bench.link->waiting = {{Kind::freeze}};
  bench.cycle();
  const tables::Time frozen = bench.now();
  bench.link->waiting = {{Kind::step, 3}};
  for (int i = 0; i < 10; ++i) bench.cycle();
  CHECK(bench.now() == frozen + 30);
  CHECK(bench.commands->frozen());
}

TEST_CASE("A malfunction by a command starts also in a frozen plant, and the trace has it as an act by hand") {
  CommandBench bench;
  const std::uint32_t stuck = bench.plant.malfunction_numbers().stuck(cell::kAgvAtP1, false);
  bench.link->waiting = {{Kind::freeze}};
  bench.cycle();
  bench.link->waiting = {{Kind::start_malfunction, stuck}};
  bench.cycle();
  CHECK(bench.plant.malfunction(stuck).active);
  CHECK_FALSE(bench.plant.event(cell::kAgvAtP1));
  bench.link->waiting = {{Kind::end_malfunction, stuck}};
  bench.cycle();
  CHECK(bench.plant.event(cell::kAgvAtP1));
  std::vector<std::uint64_t> acts;
  bench.recorder.drain([&](const trace::Record& record) {
    if (record.kind == trace::Record::Kind::note && record.of == trace::kActNote) acts.push_back(record.value);
  });
  CHECK(acts == std::vector<std::uint64_t>{host::run_act(stuck, true, true), host::run_act(stuck, false, true)});
}

TEST_CASE("What else freezes the plant is not ended by a command, and the link learns of it") {
  CommandBench bench(true);
  bench.stepper.is_frozen = true;
  bench.link->waiting = {{Kind::run}};
  bench.cycle();
  CHECK(bench.commands->frozen());
  CHECK(bench.link->was_frozen);
  CHECK(bench.stepper.holds == 1);
  bench.stepper.is_frozen = false;
  bench.cycle();
  CHECK(bench.now() == 10);
  CHECK(bench.commands->over());
}

TEST_CASE("A link with commands learns that another link, lost, freezes the plant") {
  tables::PlantTables tables = cell_tables();
  OwnedPlant plant(tables);
  trace::Recorder recorder(tables, 256);
  host::Links links;
  auto commanding = std::make_unique<CommandingLink>();
  auto lost = std::make_unique<CommandingLink>();
  CommandingLink& commands = *commanding;
  CommandingLink& other = *lost;
  links.push_back({"", {}, std::move(commanding)});
  links.push_back({"", {}, std::move(lost)});
  host::LinkCommands stepper(links, *plant, recorder, nullptr);
  other.freezes = true;
  stepper.hold();
  CHECK(commands.was_frozen);
  other.freezes = false;
  stepper.hold();
  CHECK_FALSE(commands.was_frozen);
}

TEST_CASE("Links without commands need no stepper") {
  tables::PlantTables tables = cell_tables();
  OwnedPlant plant(tables);
  trace::Recorder recorder(tables, 256);
  host::Links links;
  links.push_back({"", {}, std::make_unique<SetLink>()});
  CHECK(host::LinkCommands(links, *plant, recorder, nullptr).empty());
}

TEST_CASE("The act of a malfunction is written as a scenario has it") {
  tables::PlantTables tables = cell_tables();
  const trace::PlantNames names(tables);
  const std::uint32_t stuck = tables::MalfunctionNumbers(tables).stuck(0);
  const std::string name = names.malfunction(stuck);
  CHECK(host::is_run_act(host::run_act(stuck, true, false)));
  CHECK_FALSE(host::is_run_act(7));
  const host::ActText start = host::text_of_run_act(host::run_act(stuck, true, false), names);
  CHECK(start.json == R"({"start":[")" + name + R"("]})");
  CHECK(start.by == "scenario");
  const host::ActText stop = host::text_of_run_act(host::run_act(stuck, false, true), names);
  CHECK(stop.json == R"({"stop":[")" + name + R"("]})");
  CHECK(stop.by == "hand");
}

}  // namespace symplant::test
