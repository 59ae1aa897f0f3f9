// The guard on the whole cycle: reading and writing of links, the plant, its observers, and the sleep in between.
#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "rt/expect_nothing.hpp"
#include "support/plant_bench.hpp"
#include "symplant/exec/cycle.hpp"
#include "symplant/exec/real_time.hpp"
#include "symplant/exec/thread_faults.hpp"

namespace symplant::test {
namespace {

using tables::kMillisecond;
using Fault = void (*)();

/// A link that breaks a rule in one cycle.
class FaultyLink final : public exec::Exchange {
 public:
  FaultyLink(Fault reading, Fault writing) : reading_(reading), writing_(writing) {}

  void read_operations(plant::Plant&, tables::Time) noexcept override {
    if (++reads_ == 5 && reading_ != nullptr) reading_();
  }
  void write_events(const plant::Plant&, const exec::CycleStatus&) noexcept override {
    if (reads_ == 5 && writing_ != nullptr) writing_();
  }
  void leave() noexcept override { free(malloc(100)); }  // the end is not a cycle

 private:
  Fault reading_;
  Fault writing_;
  int reads_ = 0;
};

/// Observes instants, and allocates memory in one of them.
class FaultyObserver final : public engine::Observer {
  void instant(const engine::Instant&) noexcept override { kept_page = std::realloc(kept_page, 100); }
  void finding(const tables::Finding&) noexcept override {}

  void* kept_page = nullptr;
};

struct Watched {
  exec::GuardReport report;
  exec::ThreadFaults faults;
  exec::CycleStatistics statistics;

  std::vector<std::string> acts() const {
    std::vector<std::string> acts;
    for (const exec::Violation& violation : report.violations) acts.push_back(exec::act_of(violation));
    return acts;
  }
};

/// 20 cycles of 1 ms on the real clock.
Watched watched(std::vector<exec::Exchange*> links, engine::Observer* observer = nullptr) {
  static const BenchTables tables({"ARM_O_A1", "ARM_I_A1", "ARM_O_B2", "ARM_I_B2"}, {});
  plant::OwnedPlant plant(tables.rows);
  exec::MonotonicClock clock;
  const auto meter = std::make_unique<exec::CycleMeter>();
  const std::atomic<bool> stop{false};
  Watched result;
  result.report = exec::run_watched([&] {
    exec::set_up_real_time({});
    const exec::ThreadFaults before = exec::thread_faults();
    exec::run_cycles(plant, links, {.cycle = kMillisecond, .until = 20 * kMillisecond},
                     {.clock = clock, .meter = *meter, .stop = stop, .observer = observer});
    result.faults = exec::thread_faults() - before;
  });
  result.statistics = meter->statistics();
  return result;
}

std::mutex undriven;
void* volatile kept_page = nullptr;

void take_memory() { kept_page = std::malloc(1000); }
void take_lock() { const std::lock_guard lock(undriven); }
void write_nothing() { static_cast<void>(!write(-1, "x", 1)); }
void fault() {
  constexpr std::size_t kSize = 16 * 4096;
  void* const fresh = kept_page;
  for (std::size_t at = 0; at < kSize; at += 4096) static_cast<volatile char*>(fresh)[at] = 1;
}

TEST_CASE("A cycle with links on the real clock is clean, including its sleeps") {
  FaultyLink one(nullptr, nullptr);
  FaultyLink other(nullptr, nullptr);
  const Watched result = watched({&one, &other});
  CHECK(result.statistics.cycles == 20);
  CHECK(result.faults.pages() == 0);
  expect_nothing(result.report);
}

TEST_CASE("Memory that a link allocates while it reads is reported", "[planted]") {
  FaultyLink link(take_memory, nullptr);
  CHECK(watched({&link}).acts() == std::vector<std::string>{"heap: malloc"});
}

TEST_CASE("A lock that a link takes while it writes is reported", "[planted]") {
  FaultyLink sound(nullptr, nullptr);
  FaultyLink link(nullptr, take_lock);
  CHECK(watched({&sound, &link}).acts() == std::vector<std::string>{"lock: pthread_mutex_lock"});
}

TEST_CASE("A system call of a link is reported, the cycle's own sleeps are not", "[planted]") {
  FaultyLink link(nullptr, write_nothing);
  const Watched result = watched({&link});
  if (result.report.no_trap.empty()) CHECK(result.acts() == std::vector<std::string>{"system call: write"});
  expect_trap(result.report);
}

TEST_CASE("Faults of the cycle's observer are reported", "[planted]") {
  FaultyObserver observer;
  const Watched result = watched({}, &observer);
  REQUIRE(!result.report.violations.empty());
  CHECK(result.acts()[0] == "heap: realloc");
}

TEST_CASE("Memory from before the cycle is touched, so that the cycle's thread has no page faults on it") {
  // Larger than malloc's free blocks, so that no page was touched before.
  const std::size_t size = std::size_t{4} << 20;
  const std::unique_ptr<char[]> fresh(new char[size]);
  std::uint64_t faults = 1;
  std::thread thread([&] {
    exec::set_up_real_time({});
    const exec::ThreadFaults before = exec::thread_faults();
    volatile char* const memory = fresh.get();
    for (std::size_t at = 0; at < size; at += 4096) memory[at] = 1;
    faults = (exec::thread_faults() - before).pages();
  });
  thread.join();
  CHECK(faults == 0);
}

TEST_CASE("Memory directly above a thread's stack is touched, the stack itself is not") {
  pthread_attr_t defaults;
  std::size_t stack = 0;
  REQUIRE(pthread_getattr_default_np(&defaults) == 0);
  pthread_attr_getstacksize(&defaults, &stack);
  pthread_attr_destroy(&defaults);
  // As the kernel reports them: a guard page, then stack and memory as one mapping.
  constexpr std::size_t kPage = 4096;
  constexpr std::size_t kMore = 16 * kPage;
  const std::size_t size = kPage + stack + kMore;
  void* const fresh = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  REQUIRE(fresh != MAP_FAILED);
  madvise(fresh, size, MADV_NOHUGEPAGE);
  REQUIRE(mprotect(fresh, kPage, PROT_NONE) == 0);
  std::thread([] { exec::set_up_real_time({}); }).join();
  std::vector<unsigned char> resident(size / kPage);
  REQUIRE(mincore(fresh, size, resident.data()) == 0);
  munmap(fresh, size);
  const auto there = [](unsigned char page) { return (page & 1U) != 0; };
  CHECK(std::none_of(resident.begin(), resident.end() - 16, there));
  CHECK(std::all_of(resident.end() - 16, resident.end(), there));
}

TEST_CASE("A page that a link touches for the first time is counted", "[planted]") {
  void* const fresh = mmap(nullptr, std::size_t{16} * 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  REQUIRE(fresh != MAP_FAILED);
  madvise(fresh, std::size_t{16} * 4096, MADV_NOHUGEPAGE);
  kept_page = fresh;
  FaultyLink link([] { fault(); }, nullptr);
  const Watched populated = watched({&link});
  CHECK(populated.faults.pages() == 0);  // it existed before the first cycle
  madvise(fresh, std::size_t{16} * 4096, MADV_DONTNEED);
  FaultyLink late([] { madvise(kept_page, std::size_t{16} * 4096, MADV_DONTNEED); }, [] { fault(); });
  CHECK(watched({&late}).faults.pages() == 16);
  munmap(fresh, std::size_t{16} * 4096);
}

}  // namespace
}  // namespace symplant::test
