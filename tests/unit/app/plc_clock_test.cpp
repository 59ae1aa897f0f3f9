// symplant run with plant time from a PLC's clock: which symbols can be one, and a Modbus client that counts it up.
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <nlohmann/json.hpp>
#include <streambuf>
#include <thread>

#include "app_support.hpp"
#include "support/raw_client.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::test {
namespace {

const std::string kCounted =
    "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n"
    "VAR_GLOBAL,L_P_D_I_A,,%IX2.0,BOOL,FALSE\n"
    "VAR_GLOBAL,L_P_D_O_A,,%QX0,BOOL,FALSE\n"
    "VAR_GLOBAL,PLC_MS,,%QW30,WORD,0\n"
    "VAR_GLOBAL,LEVEL,,%IW7,WORD,0\n"
    "VAR_GLOBAL,SPEED,,%QD20,REAL,0\n"
    "VAR_GLOBAL,L_P_T_O_FREE,,,INT,0\n";
const std::string kServer = "modbus-tcp-server://127.0.0.1:0";

MemoryFileSystem counted(const std::string& clock = "") {
  MemoryFileSystem files;
  files.files["l.csv"] = kCounted;
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["l.csv"], "links": [{"loss-after": "60s", "url": ")" +
                              kServer + "\"" + (clock.empty() ? "" : R"(, "clock": )" + clock) + "}]}";
  return files;
}

/// The message of a run that ends before it begins.
std::string refused(std::vector<std::string> arguments, const std::string& clock = "") {
  MemoryFileSystem files = counted(clock);
  arguments.insert(arguments.begin(), "run");
  const ToolRun run = run_tool(arguments, files);
  CHECK(run.code == 2);
  const std::size_t begin = run.err.find("error: ");
  return begin == std::string::npos ? run.err : run.err.substr(begin);
}

TEST_CASE("run --clock: A symbol that cannot be the PLC's clock is refused with the reason") {
  const auto refused_clock = [](const std::string& symbol) {
    return refused({"plant.json", "--clock", "plc:" + symbol});
  };
  CHECK(refused_clock("PLC_MX") == "error: symbol `PLC_MX` not found; did you mean `PLC_MS`?\n");
  CHECK(refused_clock("NOTHING_LIKE_IT") ==
        "error: symbol `NOTHING_LIKE_IT` not found; write the name of an operation that the PLC counts up\n");
  CHECK(refused_clock("level") ==
        "error: `LEVEL` is an event, which the plant writes; a clock is an operation, which the PLC counts up\n");
  CHECK(refused_clock("L_P_D_O_A").starts_with("error: `L_P_D_O_A` has the type BOOL; "));
  CHECK(refused_clock("SPEED").starts_with("error: `SPEED` has the type REAL; "));
  CHECK(refused_clock("L_P_T_O_FREE") ==
        "error: `L_P_T_O_FREE` has no address, so no link carries it: give it one, or a `number` in `links`\n");
}

TEST_CASE("run --clock: The PLC's clock needs a link to the PLC") {
  const std::string missing = "error: no link to a PLC carries `PLC_MS`: add one, `--link URL`\n";
  CHECK(refused({"l.csv", "--clock", "plc:PLC_MS"}) == missing);
  CHECK(refused({"plant.json", "--clock", "plc:PLC_MS", "--link", "loop:"}) == missing);
}

TEST_CASE("run --clock: An invalid unit is refused") {
  CHECK(contains(refused({"plant.json", "--clock", "plc:PLC_MS@0s"}), "`0s` is not the unit of a clock"));
  CHECK(contains(refused({"plant.json", "--clock", "plc:PLC_MS@2s"}), "`2s` is not the unit of a clock"));
  CHECK(contains(refused({"plant.json", "--clock", "plc:PLC_MS@fast"}), "`fast` is not a duration"));
  CHECK(contains(refused({"plant.json", "--clock", "plc:"}), "`plc:` is not a clock"));
}

TEST_CASE("run --rt-check: It counts cycles of the wall clock, so a PLC's clock is refused") {
  CHECK(
      refused({"plant.json", "--rt-check", "5"}, R"({"of": "PLC_MS"})") ==
      "error: `--rt-check` counts cycles of the wall clock, but plant time is that of `PLC_MS`: use `--clock real`\n");
}

TEST_CASE("run --clock real: The wall clock replaces the clock of plant.json") {
  MemoryFileSystem files = counted(R"({"of": "PLC_MS"})");
  const ToolRun run = run_tool({"run", "plant.json", "--clock", "real", "--until", "20ms"}, files);
  CHECK(run.code == 0);
  CHECK(contains(run.out, "running in real time, a cycle of 10 ms, until"));
  CHECK_FALSE(contains(run.out, "clock: "));
}

TEST_CASE("run: A clock of plant.json whose PLC has no link is reported, and the wall clock is used") {
  MemoryFileSystem files;
  files.files["l.csv"] = kCounted;
  files.files["b.csv"] = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\nVAR_GLOBAL,A_B_C_I_D,X1,,BOOL,FALSE\n";
  files.files["plant.json"] = R"({"symplant": 1,
    "symbols": [{"file": "l.csv", "controller": "PLC1"}, {"file": "b.csv", "controller": "PLC2"}],
    "links": [{"url": "loop:", "controller": "PLC1", "clock": {"of": "PLC_MS"}}]})";
  const ToolRun run = run_tool({"run", "plant.json", "--link", "PLC2=" + kServer, "--until", "20ms"}, files);
  CHECK(run.code == 0);
  CHECK(contains(run.err,
                 "warning: plant time does not follow the clock `PLC_MS`, since its PLC has no link in this run\n"));
  const ToolRun asked = run_tool({"run", "plant.json", "--link", "PLC2=" + kServer, "--clock", "plc:PLC_MS"}, files);
  CHECK(contains(asked.err, "error: no link to a PLC carries `PLC_MS`: add one, `--link PLC1=URL`\n"));
}

// --- a running plant and its PLC

/// Text that one thread writes and another waits for.
class WatchedText final : public std::streambuf {
 public:
  /// The text after `head`, up to the end of its line; empty if the program ends without it.
  std::string wait_for(const std::string& head) {
    std::unique_lock lock(mutex_);
    std::size_t at = std::string::npos;
    const auto found = [&] {
      at = text_.find(head);
      return ended_ || (at != std::string::npos && text_.find('\n', at) != std::string::npos);
    };
    written_.wait(lock, found);
    if (at == std::string::npos) return "";
    at += head.size();
    return text_.substr(at, text_.find('\n', at) - at);
  }
  void end() {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
    written_.notify_all();
  }
  std::string text() {
    const std::scoped_lock lock(mutex_);
    return text_;
  }

 protected:
  int_type overflow(int_type c) override {
    const char byte = traits_type::to_char_type(c);
    xsputn(&byte, 1);
    return c;
  }
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    const std::scoped_lock lock(mutex_);
    text_.append(bytes, static_cast<std::size_t>(count));
    written_.notify_all();
    return count;
  }

 private:
  std::mutex mutex_;
  std::condition_variable written_;
  std::string text_;
  bool ended_ = false;
};

/// The tool on a thread, with a server on a free port.
class RunningTool {
 public:
  explicit RunningTool(std::vector<std::string> arguments, MemoryFileSystem files)
      : arguments_(std::move(arguments)), files_(std::move(files)), thread_([this] { run(); }) {}
  ~RunningTool() {
    if (thread_.joinable()) thread_.join();
  }
  RunningTool(const RunningTool&) = delete;
  RunningTool& operator=(const RunningTool&) = delete;

  std::uint16_t port() {
    const std::string line = out_.wait_for("link modbus-tcp-server://127.0.0.1:");
    return line.empty() ? std::uint16_t{0} : static_cast<std::uint16_t>(std::stoi(line));
  }
  int join() {
    thread_.join();
    return code_;
  }
  std::string out() { return out_.text(); }
  std::string err() { return err_.text(); }

 private:
  void run() {
    std::vector<std::string> words{"symplant"};
    words.insert(words.end(), arguments_.begin(), arguments_.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    std::ostream out(&out_);
    std::ostream err(&err_);
    app::Context context{files_, out, err};
    code_ = app::run_tool(static_cast<int>(words.size()), argv.data(), context);
    out_.end();
  }

  std::vector<std::string> arguments_;
  MemoryFileSystem files_;
  WatchedText out_;
  WatchedText err_;
  int code_ = -1;
  std::thread thread_;
};

/// A PLC that is a Modbus client. It writes its counter, holding register 30, after each cycle of the plant.
class CountingPlc {
 public:
  explicit CountingPlc(std::uint16_t port) : client_(port) {}

  /// Writes the counter, then waits until the heartbeat of the plant (input register 101) has changed. False when the
  /// plant has ended.
  bool write(std::uint16_t value) {
    const auto high = static_cast<std::uint8_t>(value >> 8);
    const auto low = static_cast<std::uint8_t>(value & 0xFF);
    client_.send({0, 1, 0, 0, 0, 6, 1, 6, 0, 30, high, low});
    if (client_.receive(12).size() != 12) return ended();
    for (const std::uint16_t before = heartbeat_; heartbeat_ == before;) {
      client_.send({0, 2, 0, 0, 0, 6, 1, 4, 0, 101, 0, 1});
      const Bytes answer = client_.receive(11);
      if (answer.size() != 11) return ended();
      heartbeat_ = static_cast<std::uint16_t>(answer[9] << 8 | answer[10]);
    }
    return true;
  }

 private:
  /// False. Ends a plant that has answered wrongly instead of ending.
  bool ended() const {
    if (!client_.is_closed()) std::raise(SIGTERM);
    return false;
  }

  RawClient client_;
  std::uint16_t heartbeat_ = 0;
};

TEST_CASE("run: A PLC that counts takes the plant with it, over the wrap of its counter and a restart") {
  TemporaryFolder folder;
  RunningTool tool({"run", "plant.json", "--cycle", "1ms", "--until", "1s", "--stats", folder / "stats.json",
                    "--findings", folder / "findings.jsonl"},
                   counted(R"({"of": "PLC_MS"})"));
  CountingPlc plc(tool.port());
  std::uint16_t counter = 65'300;
  int written = 0;
  while (plc.write(counter)) {
    counter = static_cast<std::uint16_t>(counter + 20);
    if (++written == 30) counter = static_cast<std::uint16_t>(counter + 30'000);
  }
  CHECK(tool.join() == 0);
  CHECK(contains(tool.out(),
                 "running in real time, a cycle of 1 ms, plant time from `PLC_MS` (16 bits, 1 ms), until 1 s\n"));
  CHECK(contains(tool.out(), "ended at 1 s: "));
  CHECK(contains(tool.out(), "findings: clock restarted (1)\n"));
  CHECK(contains(tool.err(), "clock restarted: PLC output %QW30, symbol PLC_MS (l.csv:4), its value jumped"));
  CHECK(contains(read_bytes(folder / "findings.jsonl"), R"("finding":"clock restarted","of":"PLC_MS")"));
  const auto stats = nlohmann::json::parse(read_bytes(folder / "stats.json"));
  const auto& clock = stats.at("plc_clock");
  CHECK(stats.at("plant_time") == tables::kSecond);
  CHECK(clock.at("of") == "PLC_MS");
  CHECK(clock.at("bits") == 16);
  CHECK(clock.at("unit") == tables::kMillisecond);
  CHECK(clock.at("restarts") == 1);
  CHECK(clock.at("values").get<int>() > 30);
  CHECK(clock.at("values").get<int>() <= written + 1);
  CHECK(clock.at("phase_error").at("max").get<tables::Time>() <= 100 * tables::kMillisecond);
  CHECK(contains(tool.out(), "the PLC's clock: "));
}

TEST_CASE("run --clock plc: The unit on the command line goes before that of plant.json") {
  RunningTool tool({"run", "plant.json", "--clock", "plc:plc_ms@10ms", "--cycle", "1ms", "--until", "1s"},
                   counted(R"({"of": "PLC_MS", "unit": "100us"})"));
  CountingPlc plc(tool.port());
  std::uint16_t counter = 1;
  while (plc.write(counter)) ++counter;
  CHECK(tool.join() == 0);
  CHECK(contains(tool.out(), "plant time from `PLC_MS` (16 bits, 10 ms)"));
  CHECK(counter >= 100);
}

}  // namespace
}  // namespace symplant::test
