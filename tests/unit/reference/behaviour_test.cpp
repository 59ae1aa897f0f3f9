// Random times and user code.
#include "bench.hpp"
#include "split_mix.hpp"

namespace symplant::test {
namespace {

using reference::View;

TEST_CASE("SplitMix64 starts as published") { CHECK(split_mix_output(0) == 0xE220A8397B1DCDAF); }

TEST_CASE("Seed, unit, transition and count determine a uniform time") {
  Said said;
  said.device("l_p_a").transitions = {transition("P1", "P2"), transition("P2", "P1")};
  said.device("l_p_a").transitions[1].takes = description::Duration{description::Duration::Kind::uniform, 0, 999};
  Bench bench(said, bits({"l_p_a_o_P1", "l_p_a_o_P2", "l_p_a_i_P1", "l_p_a_i_P2"}));
  bench.plant.reset(42);
  for (std::uint64_t k = 0; k < 3; ++k) {
    bench.plant.set_state(0, 1);
    bench.plant.set_operation(0, 1);
    bench.plant.advance_to(bench.plant.now() + 1);
    // At now() the operation was not on yet; the instant after it sampled it.
    __extension__ using Wide = unsigned __int128;
    const std::uint64_t r = split_mix_output(42 ^ fnv_of("L_P_A") ^ (1ULL << 32) ^ k);
    const auto drawn = static_cast<tables::Time>(static_cast<Wide>(r) * 1000 >> 64);
    CHECK(bench.plant.save().units[0].whole == drawn);
    bench.plant.set_operation(0, 0);
    bench.plant.set_state(0, 0);
    bench.plant.advance_to(bench.plant.now() + tables::kSecond);
  }
}

struct Memory {
  std::uint64_t woken;
};

void entered(View& view, std::uint8_t state) noexcept {
  if (state == 1) view.wake_at(view.now() + 10 * kMs);
}
void woken(View& view) noexcept {
  ++view.memory<Memory>().woken;
  view.set_event(0, !view.event(0));
}
std::uint8_t wanted(View& view) noexcept { return view.memory<Memory>().woken == 1 ? 0 : tables::kNoState; }
tables::Time takes(View&, std::uint16_t transition) noexcept { return transition == 0xFFFF ? 7 * kMs : 20 * kMs; }

TEST_CASE("A behavior wakes when it requested it, and its wanted state needs no command") {
  Said said;
  said.device("L_P_A").behaviour = "Mine";
  reference::Behaviour mine;
  mine.memory_size = sizeof(Memory);
  mine.entered = &entered;
  mine.woken = &woken;
  mine.wanted = &wanted;
  mine.takes = &takes;
  Bench bench({"A_O_P2", "A_I_P1", "A_I_P2", "A_I_P3", "A_O_P1"}, said, {{"Mine", mine}});
  bench.set("A_O_P2", true).at(0).set("A_O_P2", false).at(20);
  CHECK(bench.state("A") == "P2");
  bench.at(29).changes();
  bench.at(30);
  CHECK(bench.state("A") == "P2->P1");
  CHECK(bench.changes() == "30:A_I_P1=1 30:A_I_P2=0");
  CHECK(bench.at(37).state("A") == "P1");
}

}  // namespace
}  // namespace symplant::test
