// What a thread gets for its cycle, and what is reported if the system refuses.
#include "symplant/exec/real_time.hpp"

#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include "support/catch.hpp"
#include "support/strings.hpp"
#include "symplant/exec/thread_faults.hpp"

namespace symplant::test {
namespace {

using exec::Refusal;

/// On a separate thread, since the settings persist.
template <class Work>
void on_a_thread(Work work) {
  std::thread thread(work);
  thread.join();
}

TEST_CASE("By default a cycle's thread gets timers exact to a nanosecond, and nothing else") {
  std::vector<Refusal> refused;
  int slack = 0;
  int policy = -1;
  on_a_thread([&] {
    refused = exec::set_up_real_time({}).refused;
    slack = prctl(PR_GET_TIMERSLACK, 0UL, 0UL, 0UL, 0UL);
    policy = sched_getscheduler(0);
  });
  CHECK(refused.empty());
  CHECK(slack == 1);
  CHECK(policy == SCHED_OTHER);
}

TEST_CASE("A thread stays on the requested processor, and other threads stay where they are") {
  cpu_set_t before;
  sched_getaffinity(0, sizeof before, &before);
  int first = 0;
  while (!CPU_ISSET(static_cast<std::size_t>(first), &before)) ++first;
  cpu_set_t inside;
  std::vector<Refusal> refused;
  on_a_thread([&] {
    refused = exec::set_up_real_time({.cpu = first}).refused;
    sched_getaffinity(0, sizeof inside, &inside);
  });
  CHECK(refused.empty());
  CHECK(CPU_COUNT(&inside) == 1);
  CHECK(CPU_ISSET(static_cast<std::size_t>(first), &inside));
  cpu_set_t after;
  sched_getaffinity(0, sizeof after, &after);
  CHECK(CPU_EQUAL(&before, &after));
}

TEST_CASE("An unknown processor is rejected once, with the available ones") {
  std::vector<Refusal> refused;
  on_a_thread([&] { refused = exec::set_up_real_time({.cpu = 100'000}).refused; });
  REQUIRE(refused.size() == 1);
  CHECK(refused[0].option == "cpu");
  CHECK(contains(refused[0].message, "`--cpu 100000` is refused"));
  CHECK(contains(refused[0].message, "use one of "));
}

TEST_CASE("A priority is granted, or rejected once with a hint") {
  std::vector<Refusal> refused;
  int policy = -1;
  on_a_thread([&] {
    refused = exec::set_up_real_time({.priority = 5}).refused;
    policy = sched_getscheduler(0);
  });
  if (refused.empty()) {
    CHECK(policy == SCHED_FIFO);
    return;
  }
  REQUIRE(refused.size() == 1);
  CHECK(policy == SCHED_OTHER);
  CHECK(contains(refused[0].message, "ulimit -r 5"));
}

/// The latency request to the kernel's power management, in us; -1 if this program may not read it.
std::int32_t latency_asked_for() {
  std::int32_t latency = -1;
  std::ifstream("/dev/cpu_dma_latency", std::ios::binary).read(reinterpret_cast<char*>(&latency), sizeof latency);
  return latency;
}

TEST_CASE("Processors stay awake while the set-up exists, or that is rejected with a hint") {
  const std::int32_t before = latency_asked_for();
  exec::RealTimeSetup setup;
  on_a_thread([&] { setup = exec::set_up_real_time({.stay_awake = true}); });
  CHECK(setup.refused.empty() == (setup.awake != nullptr));
  if (setup.refused.empty()) {
    CHECK(latency_asked_for() == 0);
    setup.awake.reset();
    CHECK(latency_asked_for() == before);
    return;
  }
  REQUIRE(setup.refused.size() == 1);
  CHECK(setup.refused[0].option == "stay-awake");
  CHECK(contains(setup.refused[0].message, "allow the program to write /dev/cpu_dma_latency"));
}

TEST_CASE("A missing permission for the kernel's device is reported in one line") {
  const pid_t child = fork();
  if (child == 0) {
    if (geteuid() == 0 && setuid(65534) != 0) _exit(2);
    const exec::RealTimeSetup setup = exec::set_up_real_time({.stay_awake = true});
    const bool reported = setup.awake == nullptr && setup.refused.size() == 1 &&
                          contains(setup.refused[0].message, "`--stay-awake` is refused (");
    _exit(reported || (geteuid() != 65534 && setup.awake != nullptr) ? 0 : 1);
  }
  int status = -1;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(status == 0);
}

TEST_CASE("Page faults of a thread are counted") {
  std::uint64_t faults = 0;
  on_a_thread([&] {
    const exec::ThreadFaults before = exec::thread_faults();
    const std::size_t size = std::size_t{4} << 20;
    const std::unique_ptr<char[]> fresh(new char[size]);
    volatile char* const memory = fresh.get();
    for (std::size_t at = 0; at < size; at += 4096) memory[at] = 1;
    faults = (exec::thread_faults() - before).pages();
  });
  CHECK(faults > 0);
}

}  // namespace
}  // namespace symplant::test
