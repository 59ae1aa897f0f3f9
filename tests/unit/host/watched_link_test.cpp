// Links whose losses are reported: findings, and what behaviors see.
#include "symplant/host/watched_link.hpp"

#include <array>

#include "support/malfunction_bench.hpp"
#include "support/set_link.hpp"
#include "symplant/engine/behaviour.hpp"
#include "symplant/link/link.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::test {
namespace {

using exec::LinkState;

constexpr std::uint8_t kP2 = 1;

/// Without a good link, the device goes to P2 automatically.
std::uint8_t safe_place(engine::BehaviourView& view) noexcept { return view.quality() ? tables::kNoState : kP2; }

constexpr std::array<engine::Behaviour, 1> kBehaviours = {engine::Behaviour{.wanted = safe_place}};

/// A device with a behavior, and a link that carries a controller's symbols; the plant's only controller is 0.
struct Bench {
  explicit Bench(std::uint32_t carries) {
    auto made = std::make_unique<SetLink>();
    link = made.get();
    links.push_back({"", {"", carries, {}}, std::move(made)});
    watched = std::make_unique<host::WatchedLinks>(links, plant, recorder);
    recorder.attach(plant);
  }
  static Reported reported() {
    Reported reported;
    reported.device("A").behaviour = "Safe";
    return with_malfunctions(R"({"name":"cable","lose":true})", reported);
  }
  /// A cycle of 10 ms with the link in this state.
  void cycle(LinkState state) {
    link->now = state;
    watched->exchanges().front()->read_operations(plant, 0);
    plant.advance_to(plant.now() + 10 * kMs, &recorder);
  }
  std::string found() {
    std::string text;
    recorder.drain([&](const trace::Record& record) {
      if (record.kind != trace::Record::Kind::finding || !trace::is_of_link(record.finding)) return;
      text.append(text.empty() ? "" : ", ").append(trace::finding_name(record.finding));
      text += " of " + std::to_string(record.of) + " at " + trace::seconds(record.time);
    });
    return text;
  }

  BenchTables tables{{"A_O_P1", "A_I_P1", "A_O_P2", "A_I_P2"}, reported()};
  plant::OwnedPlant plant{tables.rows, kBehaviours};
  trace::Recorder recorder{tables.rows, 256};
  SetLink* link = nullptr;
  host::Links links;
  std::unique_ptr<host::WatchedLinks> watched;
};

TEST_CASE("A link that is lost and comes back is reported, once each time") {
  Bench bench(0);
  for (const LinkState state : {LinkState::waiting, LinkState::waiting, LinkState::live, LinkState::live}) {
    bench.cycle(state);
  }
  CHECK(bench.found().empty());
  for (const LinkState state : {LinkState::lost, LinkState::lost, LinkState::live, LinkState::live}) {
    bench.cycle(state);
  }
  CHECK(bench.found() == "link lost of 0 at 0.04 s, link back of 0 at 0.06 s");
  bench.cycle(LinkState::lost);
  CHECK(bench.found() == "link lost of 0 at 0.08 s");
}

TEST_CASE("A behavior sees that the link of its operations is not good") {
  Bench bench(0);
  bench.cycle(LinkState::live);
  CHECK_FALSE(bench.plant.unit(0).moving);
  bench.cycle(LinkState::lost);
  CHECK(bench.plant.unit(0).moving);
  CHECK(bench.plant.unit(0).target == kP2);
}

TEST_CASE("A behavior sees from the first instant that the PLC has not been heard yet") {
  Bench bench(0);
  bench.plant.advance_to(0, &bench.recorder);
  CHECK(bench.plant.unit(0).moving);
}

TEST_CASE("A malfunction cuts the link of its controller while it is active, and no other") {
  Bench bench(0);
  Bench other(1);
  const auto cycle = [&] {
    bench.cycle(LinkState::live);
    other.cycle(LinkState::live);
  };
  cycle();
  CHECK_FALSE(bench.link->is_cut);
  bench.plant.start_malfunction(0);
  other.plant.start_malfunction(0);
  cycle();
  CHECK(bench.link->is_cut);
  CHECK_FALSE(other.link->is_cut);
  bench.plant.stop_malfunction(0);
  cycle();
  CHECK_FALSE(bench.link->is_cut);
}

TEST_CASE("A behavior ignores a link that carries none of its operations") {
  Bench bench(1);
  bench.cycle(LinkState::live);
  bench.cycle(LinkState::lost);
  CHECK(bench.found() == "link lost of 0 at 0.01 s");
  CHECK_FALSE(bench.plant.unit(0).moving);
}

/// The findings `event too short` of a device that is in P2 for 10 ms, in a run with a link and a cycle of 20 ms.
std::size_t short_events_on(const std::string& url, std::uint32_t carries) {
  const BenchTables tables(
      {"A_O_P2", "A_I_P1", "A_I_P2"},
      Reported().on_command("A", "P1", "P2", fixed(0)).by_itself("A", "P2", "P1", fixed(10 * kMs)));
  plant::OwnedPlant plant(tables.rows);
  plant.reset(0, 20 * kMs);
  auto opened = link::open_link({url, carries, {}}, tables.rows);
  REQUIRE(std::holds_alternative<std::unique_ptr<link::Link>>(opened));
  host::Links links;
  links.push_back({"", {url, carries, {}}, std::get<std::unique_ptr<link::Link>>(std::move(opened))});
  trace::Recorder recorder(tables.rows, 256);
  const host::WatchedLinks watched(links, plant, recorder);
  plant.advance_to(0);
  plant.set_operation(tables.rows.symbols[tables.symbol("A_O_P2")].index, true);
  plant.advance_to(100 * kMs);
  plant.advance_to(200 * kMs);
  std::size_t count = 0;
  for (tables::Finding finding; plant.take_finding(finding);) {
    count += finding.kind == tables::FindingKind::event_too_short ? 1U : 0U;
  }
  return count;
}

TEST_CASE("An event that is on for less than a cycle is too short, but not on a link that knows what is read") {
  CHECK(short_events_on("loop:", link::kAllControllers) == 1);
  CHECK(short_events_on("modbus-tcp-server://127.0.0.1:0", 0) == 0);
}

}  // namespace
}  // namespace symplant::test
