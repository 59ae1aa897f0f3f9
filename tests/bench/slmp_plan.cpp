// How long it takes to plan the requests of 10,000 points.
#include <benchmark/benchmark.h>

#include <random>
#include <set>
#include <string>

#include "symplant/link/slmp/plan.hpp"

namespace symplant::bench {
namespace {

using namespace link::slmp;

constexpr std::uint32_t kPoints = 10'000;
constexpr std::uint32_t kSpread = 8;  ///< a scattered point has on average this many numbers

/// Numbers in ascending order: all from 0 on, or random ones.
std::vector<std::uint32_t> numbers(bool scattered) {
  std::mt19937 random(1);
  std::set<std::uint32_t> drawn;
  while (drawn.size() < kPoints) {
    drawn.insert(scattered ? static_cast<std::uint32_t>(random() % (kSpread * kPoints))
                           : static_cast<std::uint32_t>(drawn.size()));
  }
  return {drawn.begin(), drawn.end()};
}

std::vector<Cell> word_cells(bool scattered) {
  std::vector<Cell> cells;
  for (const std::uint32_t number : numbers(scattered)) cells.push_back({*kind_of("D"), number});
  return cells;
}

std::vector<Cell> cells_of_bits(bool scattered) {
  std::set<Cell> cells;
  for (const std::uint32_t number : numbers(scattered)) cells.insert({*kind_of("M"), number / 16});
  return {cells.begin(), cells.end()};
}

std::vector<Bit> bits(bool scattered) {
  std::vector<Bit> all;
  for (const std::uint32_t number : numbers(scattered)) all.push_back({*kind_of("M"), number});
  return all;
}

struct Case {
  const char* name;
  Framing framing;
};

template <class Items, class Plan>
void add(const std::string& name, Items items_of, Plan plan) {
  for (const Case& one :
       {Case{"q", {.family = Family::q}}, Case{"l", {.family = Family::l}}, Case{"iqr", {.family = Family::iqr}},
        Case{"iqr, commands=iqr", {.commands = Commands::iqr, .family = Family::iqr}},
        Case{"fx5", {.family = Family::fx5}}}) {
    for (const bool scattered : {false, true}) {
      const auto run = [=](benchmark::State& state) {
        const auto items = items_of(scattered);
        const Limits limits = limits_of(one.framing);
        std::size_t requests = 0;
        for (auto _ : state) {
          const auto transfers = plan(items, limits);
          requests = transfers.size();
          benchmark::DoNotOptimize(transfers.data());
        }
        state.counters["requests"] = static_cast<double>(requests);
      };
      benchmark::RegisterBenchmark(("plan/" + name + "/" + (scattered ? "scattered/" : "dense/") + one.name).c_str(),
                                   run)
          ->Unit(benchmark::kMillisecond);
    }
  }
}

const bool kPlansRegistered = [] {
  add("read bits", cells_of_bits, plan_reads);
  add("write bits", bits, plan_bit_writes);
  add("write bits in words", cells_of_bits, plan_writes);
  add("read numbers", word_cells, plan_reads);
  add("write numbers", word_cells, plan_writes);
  return true;
}();

}  // namespace
}  // namespace symplant::bench
