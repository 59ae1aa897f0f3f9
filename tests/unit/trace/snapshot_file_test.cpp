// Snapshots as files: another model, damage, a full disk.
#include "symplant/trace/snapshot_file.hpp"

#include <sys/resource.h>

#include <csignal>
#include <filesystem>

#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/strings.hpp"
#include "support/temporary_folder.hpp"
#include "symplant/trace/whole_file.hpp"

namespace symplant::test {
namespace {

constexpr std::uint64_t kModel = 0x0123'4567'89AB'CDEF;

trace::Snapshot snapshot_of(std::size_t bytes) {
  trace::Snapshot snapshot{std::vector<std::byte>(bytes), kModel, 1500 * tables::kMillisecond};
  for (std::size_t i = 0; i < bytes; ++i) snapshot.block[i] = static_cast<std::byte>(i * 7);
  return snapshot;
}

/// A folder with a snapshot of 1,000 bytes.
struct Saved {
  Saved() { REQUIRE(trace::write_snapshot(path, "cell", snapshot_of(1000)).empty()); }
  std::string error_of(const std::string& content) const {
    return trace::read_snapshot(folder.write("other.snapshot", content), kModel, 1000).error;
  }
  TemporaryFolder folder;
  std::string path = folder / "a.snapshot";
};

/// The process cannot write files of more bytes: as if the disk were full.
class FileLimit {
 public:
  explicit FileLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    REQUIRE(::getrlimit(RLIMIT_FSIZE, &before_) == 0);
    const rlimit limit{bytes, before_.rlim_max};
    REQUIRE(::setrlimit(RLIMIT_FSIZE, &limit) == 0);
  }
  ~FileLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_CASE("A snapshot file gives the state that was written") {
  const Saved saved;
  const trace::ReadSnapshot read = trace::read_snapshot(saved.path, kModel, 1000);
  CHECK(read.error.empty());
  CHECK(read.snapshot.block == snapshot_of(1000).block);
  CHECK(read.snapshot.time == 1500 * tables::kMillisecond);
}

TEST_CASE("A snapshot of another model is refused with both hashes") {
  const Saved saved;
  const std::string error = trace::read_snapshot(saved.path, 0xFEED, 1000).error;
  CHECK(contains(error, "is of another model: its model_hash is 0123456789abcdef (plant cell)"));
  CHECK(contains(error, "that of this plant 000000000000feed"));
  CHECK(contains(trace::read_snapshot(saved.path, kModel, 999).error, "another build of symplant"));
}

TEST_CASE("A snapshot that is cut, longer, or changed in any byte is refused") {
  const Saved saved;
  const std::string whole = read_bytes(saved.path);
  CHECK(saved.error_of(whole).empty());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    INFO(size);
    CHECK(!saved.error_of(whole.substr(0, size)).empty());
  }
  CHECK(contains(saved.error_of(whole.substr(0, whole.size() - 1)), "is damaged: make it again"));
  CHECK(contains(saved.error_of(whole + "x"), "is damaged"));
  for (std::size_t at = whole.find('\n') + 1; at < whole.size(); ++at) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    INFO(at);
    CHECK(contains(saved.error_of(changed), "is damaged"));
  }
}

TEST_CASE("A file that is not a snapshot is refused") {
  const Saved saved;
  for (const std::string& content :
       {std::string(), std::string("\n"), std::string("{}\n"), std::string("[1]\n"), std::string("null\n"),
        std::string("{\"symplant-snapshot\":1}\n"), std::string("{\"symplant-snapshot\":[[[\n"),
        std::string(100'000, '['), std::string("\0\xFF\x80\n", 4), std::string("Name,Address\nA,B\n")}) {
    CHECK(contains(saved.error_of(content), "is not a snapshot of symplant"));
  }
  CHECK(contains(trace::read_snapshot(saved.folder.path(), kModel, 1000).error, "is not a snapshot of symplant"));
  CHECK(contains(trace::read_snapshot(saved.folder / "none", kModel, 1000).error, "No such file"));
}

TEST_CASE("A snapshot for which the disk has no room leaves the earlier file") {
  const Saved saved;
  const std::string earlier = read_bytes(saved.path);
  std::string error;
  {
    const FileLimit limit(8192);
    error = trace::write_snapshot(saved.path, "cell", snapshot_of(100'000));
  }
  CHECK(contains(error, "cannot write the snapshot `" + saved.path + "`: "));
  CHECK(read_bytes(saved.path) == earlier);
  CHECK(!std::filesystem::exists(saved.path + ".part"));
}

TEST_CASE("A link to a device is written as it is, and stays a link") {
  if (!std::filesystem::exists("/dev/full")) return;
  const TemporaryFolder folder;
  const std::string path = folder / "full";
  std::filesystem::create_symlink("/dev/full", path);
  CHECK(contains(trace::write_whole_file(path, {"text"}), "No space left"));
  CHECK(std::filesystem::is_symlink(path));
  std::filesystem::create_symlink("/dev/null", folder / "null");
  CHECK(trace::write_whole_file(folder / "null", {"text"}).empty());
  CHECK(std::filesystem::is_symlink(folder / "null"));
}

}  // namespace
}  // namespace symplant::test
