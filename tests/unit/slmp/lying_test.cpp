// The SLMP link against a PLC whose replies are late, cut, foreign or missing: no wrong value, and no standstill.
#include <atomic>
#include <cstdlib>
#include <thread>
#include <utility>

#include "support/catch.hpp"
#include "support/slmp/lying_plc.hpp"
#include "symplant/link/link.hpp"
#include "unit/exec/cell.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using test::slmp::Distortion;
using test::slmp::LyingPlc;
using test::slmp::PlcMemory;

namespace {

constexpr std::uint32_t kFlags = 40;  ///< coils that all have the lowest bit of the counter

/// A plant that reads a counter of 32 bits, whose halves are equal in the PLC, and writes an event.
test::SymbolList counting_list() {
  test::SymbolList list;
  list.add_device("COUNT", test::SymbolList::kOut, "D20", tables::DataType::udint);
  for (std::uint32_t i = 0; i < kFlags; ++i) {
    list.add_device("FLAG" + std::to_string(i), test::SymbolList::kOut, "M" + std::to_string(i));
  }
  list.add_device("ECHO", test::SymbolList::kIn, "M500");
  return list;
}

/// The PLC's program: the counter and the flags change together in each scan.
void count(PlcMemory& memory) {
  const auto next = static_cast<std::uint16_t>(memory.word("D", 20) + 1);
  memory.set_dword("D", 20, std::uint32_t{next} << 16 | next);
  const bool odd = (next & 1) != 0;
  for (std::uint32_t i = 0; i < kFlags; ++i) memory.set_bit("M", i, odd);
}

test::slmp::PlcOptions counting_plc() {
  test::slmp::PlcOptions options;
  options.program = count;
  return options;
}

/// Cycles a plant with the link and looks at every value that it takes.
class Watcher {
 public:
  Watcher(std::uint16_t port, const std::string& parameters)
      : list_(counting_list()), tables_(list_.tables()), plant_(tables_) {
    link::LinkSettings settings;
    settings.word_order = link::WordOrder::low_first;
    auto opened = link::open_link(
        {"slmp://127.0.0.1:" + std::to_string(port) +
             "?family=iqr&poll=1ms&refresh=5ms&read-back=10ms&timer=0s&timeout=30ms&retry=1ms&" + parameters,
         0, settings},
        tables_);
    if (auto* error = std::get_if<link::LinkError>(&opened)) throw std::runtime_error(error->message);
    link_ = std::move(std::get<std::unique_ptr<link::Link>>(opened));
    plant_->advance_to(0);
    link_->write_events(*plant_, {});
    thread_ = std::thread([this] { run(); });
  }
  ~Watcher() {
    stop_ = true;
    thread_.join();
  }
  Watcher(const Watcher&) = delete;
  Watcher& operator=(const Watcher&) = delete;

  std::uint64_t news() const { return news_; }  ///< values of the counter that it saw
  std::uint64_t torn() const { return torn_; }
  std::uint64_t backward() const { return backward_; }

 private:
  void run() {
    while (!stop_) {
      link_->read_operations(*plant_, plant_->now());
      look();
      plant_->advance_to(plant_->now() + tables::kMillisecond);
      link_->write_events(*plant_, {});
      plant_->forget_changed_events();
      std::this_thread::yield();
    }
  }
  void look() {
    const auto value = static_cast<std::uint32_t>(plant_->operation_value(0));
    const auto low = static_cast<std::uint16_t>(value);
    if (value >> 16 != low) ++torn_;
    if (low == last_) return;
    ++news_;
    if (static_cast<std::uint16_t>(low - last_) > 0x8000) ++backward_;
    last_ = low;
  }

  test::SymbolList list_;
  tables::PlantTables tables_;
  test::OwnedPlant plant_;
  std::unique_ptr<link::Link> link_;
  std::uint16_t last_ = 0;
  std::atomic<std::uint64_t> news_{0};
  std::atomic<std::uint64_t> torn_{0};
  std::atomic<std::uint64_t> backward_{0};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

void converse(const std::string& parameters, std::uint64_t seed, std::size_t lies) {
  CAPTURE(parameters, seed);
  test::slmp::PlcOptions options = counting_plc();
  if (parameters.find("code=ascii") != std::string::npos) options.code = test::slmp::Code::ascii;
  LyingPlc plc(std::move(options), {.seed = seed, .lies_per_thousand = 300, .late_by = std::chrono::milliseconds(45)});
  const Watcher watcher(plc.port(), parameters);
  CHECK(plc.plc().wait_until([&] { return plc.lies() >= lies; }, std::chrono::seconds(60 + lies)));
  plc.lie_always(Distortion::honest);
  const std::uint64_t before = watcher.news();
  CHECK(plc.plc().wait_until([&] { return watcher.news() > before + 5; }));
  CHECK(watcher.torn() == 0);
  CHECK(watcher.backward() == 0);
  CHECK(plc.plc().log().writes_outside({{"M", 500, 1}}).empty());
}

/// The campaign sets the number of lies for each kind of connection by the environment, and each seed has a part of
/// them; otherwise a short run.
void survive(const std::string& parameters, std::uint64_t seed) {
  constexpr std::size_t kLiesOfSeed = 1000;
  const char* const text = std::getenv("SYMPLANT_LIES");
  std::size_t lies = text == nullptr ? 60 : static_cast<std::size_t>(std::strtoull(text, nullptr, 10));
  for (; lies > kLiesOfSeed; lies -= kLiesOfSeed, seed += kLiesOfSeed) converse(parameters, seed, kLiesOfSeed);
  converse(parameters, seed, lies);
}

}  // namespace

TEST_CASE("A lying PLC brings no torn or old value and no standstill, over TCP") {
  survive("frame=3e", 11);
  survive("frame=4e", 12);
}

TEST_CASE("A lying PLC brings no torn or old value and no standstill, over TCP in ASCII") {
  survive("frame=3e&code=ascii", 14);
}

TEST_CASE("A lying PLC brings no torn or old value and no standstill, over UDP with serial numbers") {
  survive("frame=4e&transport=udp", 13);
}
