// Plans of requests: within every limit, complete, and as few as possible.
#include "symplant/link/slmp/plan.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "support/catch.hpp"

using namespace symplant::link::slmp;

namespace {

using Random = std::mt19937_64;

std::uint32_t below(Random& random, std::uint32_t size) { return static_cast<std::uint32_t>(random() % size); }

Kind kind(const char* name) { return *kind_of(name); }

/// Runs of random lengths and gaps in some devices.
std::vector<Cell> random_cells(Random& random) {
  std::set<Cell> cells;
  const std::uint32_t gap = 1 + below(random, 400);
  const std::uint32_t run = 1 + below(random, 60);
  for (const char* name : {"X", "Y", "M", "D", "W", "TS"}) {
    if (below(random, 3) == 0) continue;
    std::uint32_t at = below(random, 50);
    for (std::uint32_t runs = below(random, 60); runs > 0; --runs) {
      for (std::uint32_t k = below(random, run) + 1; k > 0; --k) cells.insert({kind(name), at++});
      at += below(random, gap) + 1;
    }
  }
  return {cells.begin(), cells.end()};
}

struct Case {
  Framing framing;
  Limits limits = limits_of(framing);
};

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const Family family : {Family::q, Family::l, Family::iqr, Family::fx5}) {
    for (const Code code : {Code::binary, Code::ascii}) {
      for (const Commands commands : {Commands::ql, Commands::iqr}) {
        if (commands == Commands::iqr && family != Family::iqr) continue;
        cases.push_back({{.code = code, .commands = commands, .family = family}});
      }
    }
  }
  return cases;
}

/// What is wrong with a request of words, by the limits of SH-080008; empty if nothing.
std::string fault_of(const Transfer& transfer, const Limits& limits, bool write) {
  std::uint32_t points = 0;
  std::uint32_t weight = 0;
  bool after = false;  // a span that must come last was there
  for (const Span& span : transfer.spans) {
    if (span.count == 0) return "an empty span";
    points += span.count;
    weight += span.count == 1 ? kRandomWord : kRandomDouble;
    const bool last = transfer.access == Access::random ? span.count == 2 : info_of(span.kind).bit;
    if (after && !last) return "spans in the wrong order";
    after = last;
    if (transfer.access != Access::batch && info_of(span.kind).batch_only) return "a timer outside of a batch";
    if (transfer.access == Access::random && span.count > 2) return "a long span in random access";
  }
  const auto count = static_cast<std::uint32_t>(transfer.spans.size());
  switch (transfer.access) {
    case Access::batch:
      return count != 1 || points > limits.words ? "a batch is too long" : "";
    case Access::random:
      return (write ? weight > limits.random_write : count > limits.random_reads) ? "too many random words" : "";
    case Access::blocks:
      return count > limits.blocks || points + (write ? limits.block_cost * count : 0) > limits.block_points
                 ? "too many blocks"
                 : "";
  }
  return "";
}

/// How often each cell is in the plan; checks the limits.
std::map<Cell, int> covered(const std::vector<Transfer>& plan, const std::vector<Cell>& cells, const Limits& limits,
                            bool write) {
  std::map<Cell, int> times;
  for (const Transfer& transfer : plan) {
    const std::string fault = fault_of(transfer, limits, write);
    if (!fault.empty()) FAIL(fault);
    for (const Span& span : transfer.spans) {
      if (cells[span.item] != Cell{span.kind, span.first}) FAIL("a span names the wrong item");
      for (std::uint32_t k = 0; k < span.count; ++k) ++times[{span.kind, span.first + k}];
    }
  }
  return times;
}

/// The fewest requests for cells of one device, by trying everything: batches and random access, no blocks.
std::size_t fewest_reads(const std::vector<Cell>& cells, const Limits& limits, std::size_t from = 0,
                         std::uint32_t random = 0) {
  if (from == cells.size()) return (random + limits.random_reads - 1) / limits.random_reads;
  const bool pair = from + 1 < cells.size() && cells[from + 1].word == cells[from].word + 1;
  std::size_t best = fewest_reads(cells, limits, from + (pair ? 2 : 1), random + 1);
  if (pair) best = std::min(best, fewest_reads(cells, limits, from + 1, random + 1));
  for (std::size_t end = from + 1; end <= cells.size(); ++end) {
    if (cells[end - 1].word - cells[from].word >= limits.words) break;
    best = std::min(best, 1 + fewest_reads(cells, limits, end, random));
  }
  return best;
}

}  // namespace

TEST_CASE("A plan to read holds every cell, within the limits of each family") {
  Random random(1);
  for (int round = 0; round < 60; ++round) {
    const std::vector<Cell> cells = random_cells(random);
    for (const Case& one : all_cases()) {
      const auto times = covered(plan_reads(cells, one.limits), cells, one.limits, false);
      for (const Cell& cell : cells) {
        if (times.find(cell) == times.end()) FAIL("a cell is not read");
      }
    }
  }
  SUCCEED();
}

TEST_CASE("A plan to write holds every cell once and nothing else, within the limits of each family") {
  Random random(2);
  for (int round = 0; round < 60; ++round) {
    const std::vector<Cell> cells = random_cells(random);
    for (const Case& one : all_cases()) {
      const auto times = covered(plan_writes(cells, one.limits), cells, one.limits, true);
      CHECK(times.size() == cells.size());
      for (const Cell& cell : cells) {
        if (times.find(cell) == times.end() || times.at(cell) != 1) FAIL("a cell is not written once");
      }
    }
  }
}

TEST_CASE("A plan to write bits holds every bit once and nothing else, within the limits of each family") {
  Random random(3);
  for (int round = 0; round < 60; ++round) {
    std::vector<Bit> bits;
    for (const Cell& cell : random_cells(random)) {
      if (info_of(cell.kind).bit) bits.push_back({cell.kind, cell.word});
    }
    for (const Case& one : all_cases()) {
      std::map<Bit, int> times;
      for (const Transfer& transfer : plan_bit_writes(bits, one.limits)) {
        const bool batch = transfer.access == Access::batch;
        CHECK((batch ? transfer.spans.size() == 1 : transfer.spans.size() <= one.limits.random_bits));
        for (const Span& span : transfer.spans) {
          if (batch ? span.count > one.limits.bits : span.count != 1) FAIL("too many bits in a row");
          if (bits[span.item] != Bit{span.kind, span.first}) FAIL("a span names the wrong item");
          for (std::uint32_t k = 0; k < span.count; ++k) ++times[{span.kind, span.first + k}];
        }
      }
      CHECK(times.size() == bits.size());
      CHECK(std::all_of(times.begin(), times.end(), [](const auto& entry) { return entry.second == 1; }));
    }
  }
}

TEST_CASE("Without block access no plan to read has fewer requests") {
  Random random(4);
  Limits small;
  small.blocks = 0;
  for (int round = 0; round < 400; ++round) {
    small.words = 1 + below(random, 6);
    small.random_reads = 1 + below(random, 4);
    std::set<Cell> set;
    for (std::uint32_t n = 1 + below(random, 6); n > 0; --n) set.insert({kind("D"), below(random, 40)});
    const std::uint32_t run = below(random, 6);  // where a batch is better than random access
    for (std::uint32_t n = 0; n < run; ++n) set.insert({kind("D"), 50 + n});
    const std::vector<Cell> cells(set.begin(), set.end());
    const auto plan = plan_reads(cells, small);
    covered(plan, cells, small, false);
    CHECK(plan.size() == fewest_reads(cells, small));
  }
}

TEST_CASE("Block access never needs more requests than batches and random access") {
  Random random(5);
  for (int round = 0; round < 60; ++round) {
    const std::vector<Cell> cells = random_cells(random);
    Limits with = limits_of({.family = Family::iqr});
    Limits without = with;
    without.blocks = 0;
    CHECK(plan_reads(cells, with).size() <= plan_reads(cells, without).size());
    CHECK(plan_writes(cells, with).size() <= plan_writes(cells, without).size());
  }
}

TEST_CASE("A dense image is one request, two areas far apart are one random request") {
  std::vector<Cell> dense;
  for (std::uint32_t word = 0; word < 960; ++word) dense.push_back({kind("Y"), word});
  CHECK(plan_reads(dense, limits_of({})).size() == 1);
  dense.push_back({kind("Y"), 960});
  CHECK(plan_reads(dense, limits_of({})).size() == 2);

  const std::vector<Cell> apart = {{kind("Y"), 0}, {kind("D"), 5000}, {kind("D"), 5001}};
  const auto plan = plan_reads(apart, limits_of({}));
  REQUIRE(plan.size() == 1);
  CHECK(plan.front().access == Access::random);
  CHECK(plan.front().spans.size() == 2);
  CHECK(plan.front().spans.back().count == 2);
}
