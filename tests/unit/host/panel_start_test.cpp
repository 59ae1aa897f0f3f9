// Starting a run with a panel or from a snapshot: exit codes and messages.
#include <fmt/format.h>

#include <filesystem>
#include <sstream>
#include <utility>
#include <variant>

#include "support/plant_bench.hpp"
#include "support/strings.hpp"
#include "support/temporary_folder.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/run.hpp"
#include "symplant/link/net/listener.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::test {
namespace {

struct Started {
  int code;
  std::string out;
  std::string err;
};

const std::vector<std::string> kDoor = {"DOOR_I_SHUT1", "DOOR_I_OPEN2"};

/// A vehicle, and a folder for files.
struct Vehicle {
  explicit Vehicle(const std::vector<std::string>& names = {"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AGV_O_P1"})
      : tables(names) {
    options.until = tables::kSecond;
  }
  Started run() const {
    std::ostringstream out;
    std::ostringstream err;
    const int code = host::run({.tables = tables.rows}, options, out, err);
    return {code, out.str(), err.str()};
  }
  /// The outcome of a run with a panel whose token is in a file with this text.
  Started run_with_token(const std::string& text) {
    options.panel = panel::PanelOptions{.address = "127.0.0.1:0", .token_file = folder.write("token", text)};
    return run();
  }

  std::string model_hash() const { return fmt::format("{:016x}", tables::model_hash(tables.rows)); }

  BenchTables tables;
  TemporaryFolder folder;
  host::RunOptions options;
};

TEST_CASE("A panel's token must be in a file, and hard to guess") {
  Vehicle vehicle;
  CHECK(vehicle.run_with_token(std::string(32, 'a') + "\n").code == host::kGood);
  for (const std::string& text :
       {std::string(31, 'a'), std::string(257, 'a'), std::string(31, 'a') + "\"", std::string("short words only")}) {
    const Started started = vehicle.run_with_token(text);
    CHECK(started.code == host::kBadInput);
    CHECK(contains(started.err, "is not 32 to 256 letters, digits, `-` or `_`; make one with `openssl rand -hex 16`"));
  }
  const Started empty = vehicle.run_with_token("");
  CHECK(empty.code == host::kBadInput);
  CHECK(contains(empty.err, "error: panel: cannot read a token from `" + vehicle.folder / "token" + "`"));
  vehicle.options.panel->token_file = vehicle.folder / "none";
  CHECK(vehicle.run().code == host::kBadInput);
  vehicle.options.panel->token_file = vehicle.folder.path();
  CHECK(vehicle.run().code == host::kBadInput);
}

TEST_CASE("A port in use gives 3, and is named with what to do") {
  const auto listener = link::net::listen_on({"127.0.0.1", 0});
  REQUIRE(std::holds_alternative<link::net::Listener>(listener));
  const std::string port = std::to_string(std::get<link::net::Listener>(listener).bound.port);
  Vehicle vehicle;
  vehicle.options.panel = panel::PanelOptions{.address = port};
  const Started started = vehicle.run();
  CHECK(started.code == host::kEnvironment);
  CHECK(contains(started.err, "error: panel: port " + port + " is in use on `127.0.0.1`"));
  vehicle.options.panel->address = "no-port";
  CHECK(vehicle.run().code == host::kBadInput);
}

TEST_CASE("The folder of a panel's files is created, or the run does not start") {
  Vehicle vehicle;
  vehicle.options.panel = panel::PanelOptions{.address = "127.0.0.1:0", .files = vehicle.folder / "a/b"};
  CHECK(vehicle.run().code == host::kGood);
  CHECK(std::filesystem::is_directory(vehicle.folder / "a/b"));
  vehicle.options.panel->files = vehicle.folder.write("file", "x");
  const Started started = vehicle.run();
  CHECK(started.code == host::kEnvironment);
  CHECK(contains(started.err, "error: cannot use `" + vehicle.folder / "file" + "` as a folder of the panel: "));
  vehicle.options.panel->files = vehicle.folder / "file/below";
  CHECK(vehicle.run().code == host::kEnvironment);
}

TEST_CASE("A run is saved at its end, and another one starts from there") {
  Vehicle vehicle;
  vehicle.options.save = vehicle.folder / "end.snapshot";
  CHECK(vehicle.run().code == host::kGood);
  vehicle.options.resume = std::exchange(vehicle.options.save, "");
  vehicle.options.until = 3 * tables::kSecond;
  const Started later = vehicle.run();
  CHECK(later.code == host::kGood);
  CHECK(contains(later.out, "ended at 3 s"));
}

TEST_CASE("A snapshot of another model, a cut one, and another file give 2") {
  Vehicle vehicle;
  vehicle.options.save = vehicle.folder / "end.snapshot";
  CHECK(vehicle.run().code == host::kGood);
  const auto resumed = [&](const std::string& path) {
    Vehicle other(kDoor);
    other.options.resume = path;
    return other.run();
  };
  const Started other = resumed(vehicle.options.save);
  CHECK(other.code == host::kBadInput);
  CHECK(contains(other.err, vehicle.model_hash()));
  CHECK(contains(other.err, Vehicle(kDoor).model_hash()));
  std::filesystem::resize_file(vehicle.options.save, std::filesystem::file_size(vehicle.options.save) - 1);
  vehicle.options.resume = std::exchange(vehicle.options.save, "");
  const Started cut = vehicle.run();
  CHECK(cut.code == host::kBadInput);
  CHECK(contains(cut.err, "is damaged: make it again"));
  CHECK(resumed(vehicle.folder.write("garbage", "\x01garbage\n")).code == host::kBadInput);
  CHECK(resumed(vehicle.folder / "none").code == host::kBadInput);
}

TEST_CASE("A state that cannot be saved at the end gives 3") {
  Vehicle vehicle;
  vehicle.options.save = "/no/such/folder/end.snapshot";
  const Started missing = vehicle.run();
  CHECK(missing.code == host::kEnvironment);
  CHECK(contains(missing.err, "error: cannot write the snapshot `/no/such/folder/end.snapshot`: No such file"));
  if (!std::filesystem::exists("/dev/full")) return;
  std::filesystem::create_symlink("/dev/full", vehicle.folder / "full");
  vehicle.options.save = vehicle.folder / "full";
  const Started full = vehicle.run();
  CHECK(full.code == host::kEnvironment);
  CHECK(contains(full.err, "No space left on device"));
}

}  // namespace
}  // namespace symplant::test
