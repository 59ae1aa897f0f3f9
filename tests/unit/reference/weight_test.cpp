// Automatic transitions with a weight.
#include "bench.hpp"
#include "split_mix.hpp"

namespace symplant::test {
namespace {

/// From LOOK1 by chance to one of the others, and back after 10 ms.
Said chances(std::vector<std::uint32_t> weights) {
  Said said;
  auto& transitions = said.device("L_P_A").transitions;
  for (std::uint32_t i = 0; i < weights.size(); ++i) {
    const std::string to = "S" + std::to_string(i + 2);
    transitions.push_back(automatic("S1", to, 10 * kMs));
    transitions.back().numbers.weight = weights[i];
  }
  for (std::uint32_t i = 0; i < weights.size(); ++i) {
    transitions.push_back(automatic("S" + std::to_string(i + 2), "S1", 10 * kMs));
  }
  return said;
}

const std::vector<std::string> kStates = {"A_I_S1", "A_I_S2", "A_I_S3", "A_I_S4"};

/// The index of the share in which draw k of a transition of unit L_P_A falls.
std::uint32_t share(std::uint64_t seed, std::uint64_t transition, std::uint64_t k,
                    const std::vector<std::uint32_t>& weights) {
  std::uint64_t sum = 0;
  for (const std::uint32_t weight : weights) sum += weight;
  const std::uint64_t bits = split_mix_output(seed ^ fnv_of("L_P_A") ^ (transition << 32) ^ k);
  __extension__ using Wide = unsigned __int128;
  auto drawn = static_cast<std::uint64_t>(static_cast<Wide>(bits) * sum >> 64);
  std::uint32_t index = 0;
  while (drawn >= weights[index]) drawn -= weights[index++];
  return index;
}

TEST_CASE("The seed decides which of the ready automatic transitions with a weight fires") {
  const std::vector<std::uint32_t> weights = {3, 1, 2};
  std::string all;
  for (const std::uint64_t seed : {0U, 7U}) {
    Bench bench(kStates, chances(weights));
    bench.plant.reset(seed);
    for (std::uint64_t k = 0; k < 20; ++k) {
      const std::string wanted = "S" + std::to_string(share(seed, 0, k, weights) + 2);
      CHECK(bench.at(static_cast<tables::Time>(20 * k + 10)).state("A") == wanted);
      all += wanted;
    }
  }
  for (const std::string state : {"S2", "S3", "S4"}) CHECK(all.find(state) != std::string::npos);
}

TEST_CASE("Only ready transitions with a weight take part, the first ready one counts the draw") {
  Said said = chances({5, 5, 5});
  said.device("L_P_A").transitions[0].when = "L_P_B.ON";
  std::vector<std::string> names = kStates;
  names.emplace_back("B_I_ON");
  Bench bench(names, said);
  for (std::uint64_t k = 0; k < 10; ++k) {
    const std::string wanted = "S" + std::to_string(share(0, 1, k, {5, 5}) + 3);
    CHECK(bench.at(static_cast<tables::Time>(20 * k + 10)).state("A") == wanted);
  }
}

TEST_CASE("A first ready transition without a weight fires") {
  Bench bench(kStates, chances({0, 1000000, 1000000}));
  for (tables::Time t = 10; t < 200; t += 20) CHECK(bench.at(t).state("A") == "S2");
}

TEST_CASE("Transitions without a weight behind the first take no part") {
  Bench bench(kStates, chances({1, 0, 1}));
  for (std::uint64_t k = 0; k < 10; ++k) {
    const std::string wanted = share(0, 0, k, {1, 1}) == 0 ? "S2" : "S4";
    CHECK(bench.at(static_cast<tables::Time>(20 * k + 10)).state("A") == wanted);
  }
}

TEST_CASE("One candidate is drawn too, between `after` and `takes`") {
  Said said;
  said.device("L_P_A").transitions = {automatic("S1", "S2"), automatic("S2", "S1", 10 * kMs)};
  auto& given = said.device("L_P_A").transitions[0];
  given.numbers.weight = 4;
  given.after = given.takes = description::Duration{description::Duration::Kind::uniform, 0, 999};
  Bench bench({"A_I_S1", "A_I_S2"}, said);
  const auto drawn = [](std::uint64_t k) {
    __extension__ using Wide = unsigned __int128;
    return static_cast<tables::Time>(static_cast<Wide>(split_mix_output(fnv_of("L_P_A") ^ k)) * 1000 >> 64);
  };
  bench.plant.advance_to(drawn(0));
  CHECK(bench.plant.save().units[0].whole == drawn(2));
  CHECK(bench.plant.save().units[0].transitions[0].draws == 3);
  CHECK(bench.plant.counters[reference::Counted::weight_of_one] == 1);
}

}  // namespace
}  // namespace symplant::test
