// Reads files and replaces them as a whole.
#include "base/file_system.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/memory_file_system.hpp"
#include "support/strings.hpp"

namespace fs = std::filesystem;
namespace test = symplant::test;
using symplant::base::DiskFileSystem;

namespace {

/// A separate folder for each test.
class Folder {
 public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "symplant-test-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::size_t size() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
  }

 private:
  fs::path path_;
};

}  // namespace

TEST_CASE("Written content is read back, including NUL bytes") {
  const Folder folder;
  DiskFileSystem disk;
  const std::string content("a\0b\n", 4);
  const auto wrote = disk.write(folder / "new/deep/file.txt", content);
  REQUIRE(wrote);
  CHECK(*wrote);
  const auto back = disk.read(folder / "new/deep/file.txt");
  REQUIRE(back);
  CHECK(*back == content);
}

TEST_CASE("Unchanged content keeps the file and its time") {
  const Folder folder;
  DiskFileSystem disk;
  REQUIRE(disk.write(folder / "f", "same"));
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(folder / "f", old);
  const auto again = disk.write(folder / "f", "same");
  REQUIRE(again);
  CHECK_FALSE(*again);
  CHECK(fs::last_write_time(folder / "f") == old);
  const auto changed = disk.write(folder / "f", "diff");
  REQUIRE(changed);
  CHECK(*changed);
  CHECK(fs::last_write_time(folder / "f") != old);
}

TEST_CASE("Replacing a file leaves no temporary file and keeps its permissions") {
  const Folder folder;
  DiskFileSystem disk;
  REQUIRE(disk.write(folder / "f", "one"));
  fs::permissions(folder / "f", fs::perms(0750));
  REQUIRE(disk.write(folder / "f", "two"));
  CHECK(folder.size() == 1);
  CHECK(fs::status(folder / "f").permissions() == fs::perms(0750));
}

TEST_CASE("A text written in parts is compared meanwhile, and only a difference is written") {
  const Folder folder;
  DiskFileSystem disk;
  const auto made_of = [](std::vector<std::string> parts) {
    return [parts](symplant::base::TextSink& sink) {
      for (const std::string& part : parts) sink.put(part);
    };
  };
  const std::string large(200'000, 'x');  // more than one read
  const std::string path = folder / "deep/f";
  const auto changes = [&](const std::vector<std::string>& parts) {
    std::string whole;
    for (const std::string& part : parts) whole += part;
    const auto wrote = disk.write_made(path, made_of(parts));
    REQUIRE(wrote);
    REQUIRE(*disk.read(path) == whole);
    CHECK(disk.holds(path, made_of({whole})));
    CHECK_FALSE(disk.holds(path, made_of({whole, "+"})));
    CHECK_FALSE(disk.holds(path, made_of({whole.substr(0, whole.size() - 1)})));
    CHECK(std::distance(fs::directory_iterator(folder / "deep"), fs::directory_iterator()) == 1);
    return *wrote;
  };
  CHECK(changes({"one", large, "three"}));
  CHECK_FALSE(changes({"on", "e" + large, "", "three"}));
  CHECK(changes({"one", large, "thre"}));            // shorter
  CHECK(changes({"one", large, "thre", "e", "r"}));  // longer
  CHECK(changes({"one", large + "!", "three"}));     // differs from the middle on
  CHECK(changes({"two"}));
  CHECK_FALSE(disk.holds(folder / "nothing", made_of({})));
  CHECK(*disk.write_made(folder / "empty", made_of({})));
  CHECK_FALSE(*disk.write_made(folder / "empty", made_of({""})));
}

TEST_CASE("A text that cannot be written completely leaves the file unchanged, and no temporary file") {
  const Folder folder;
  DiskFileSystem disk;
  REQUIRE(disk.write(folder / "f", "one"));
  const auto throwing = [](symplant::base::TextSink& sink) {
    sink.put("one and a half");
    throw std::runtime_error("no more");
  };
  CHECK_THROWS(disk.write_made(folder / "f", throwing));
  CHECK(*disk.read(folder / "f") == "one");
  CHECK(folder.size() == 1);
}

TEST_CASE("A symbolic link stays, and its target is replaced") {
  const Folder folder;
  DiskFileSystem disk;
  REQUIRE(disk.write(folder / "f", "one"));
  fs::create_symlink("f", folder / "link");
  REQUIRE(disk.write(folder / "link", "two"));
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(*disk.read(folder / "f") == "two");
}

TEST_CASE("A file that is not regular is written to and not replaced") {
  // A pipe of the test: replacing it does no harm, unlike replacing one of the machine's devices.
  const Folder folder;
  const std::string pipe = folder / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  REQUIRE(reader >= 0);
  DiskFileSystem disk;
  CHECK(disk.write(pipe, "anything"));
  CHECK(fs::is_fifo(pipe));
  std::array<char, 16> got{};
  CHECK(::read(reader, got.data(), got.size()) == 8);
  CHECK(std::string(got.data()) == "anything");
  ::close(reader);
}

TEST_CASE("A missing file, a directory and a file used as a folder are errors with their names") {
  const Folder folder;
  DiskFileSystem disk;
  const auto missing = disk.read(folder / "none");
  REQUIRE_FALSE(missing);
  CHECK(missing.error().message == "cannot read `" + (folder / "none") + "`: there is no such file or folder");
  const auto directory = disk.read(folder / "");
  REQUIRE_FALSE(directory);
  CHECK(test::contains(directory.error().message, "it is a directory"));
  CHECK_FALSE(disk.write(folder / "", "x"));
  REQUIRE(disk.write(folder / "f", "x"));
  const auto below = disk.write(folder / "f/g", "x");
  REQUIRE_FALSE(below);
  CHECK_THAT(below.error().message, Catch::Matchers::StartsWith("cannot write `" + (folder / "f/g") + "`: "));
}

TEST_CASE("Without permission nothing is read, written or left over") {
  const Folder folder;
  DiskFileSystem disk;
  REQUIRE(disk.write(folder / "sub/f", "old"));
  fs::permissions(folder / "sub/f", fs::perms::none);
  fs::permissions(folder / "sub", fs::perms(0500));
  // The superuser may do everything; then there is nothing to test.
  if (::geteuid() != 0) {
    const auto unread = disk.read(folder / "sub/f");
    REQUIRE_FALSE(unread);
    CHECK_THAT(unread.error().message, Catch::Matchers::EndsWith("no permission"));
    CHECK_FALSE(disk.write(folder / "sub/f", "new"));
  }
  fs::permissions(folder / "sub", fs::perms(0700));
  fs::permissions(folder / "sub/f", fs::perms(0600));
  CHECK(std::distance(fs::directory_iterator(folder / "sub"), fs::directory_iterator()) == 1);
}

TEST_CASE("A user file is written once and never changed again, whatever it is") {
  const Folder folder;
  DiskFileSystem disk;
  CHECK(*disk.write_new(folder / "new/mine", "first"));
  CHECK_FALSE(*disk.write_new(folder / "new/mine", "second"));
  CHECK(*disk.read(folder / "new/mine") == "first");
  CHECK(std::distance(fs::directory_iterator(folder / "new"), fs::directory_iterator()) == 1);
  fs::create_symlink(folder / "nowhere", folder / "link");
  CHECK_FALSE(*disk.write_new(folder / "link", "x"));
  CHECK(disk.exists(folder / "link"));
  CHECK_FALSE(disk.exists(folder / "nowhere"));
  CHECK_FALSE(*disk.write_new(folder / "new", "x"));
  CHECK_THAT(disk.write_new(folder / "new/mine/below", "x").error().message,
             Catch::Matchers::StartsWith("cannot write `" + (folder / "new/mine/below") + "`: "));
}

TEST_CASE("The file system for tests behaves the same") {
  symplant::test::MemoryFileSystem memory;
  CHECK_FALSE(memory.read("a"));
  CHECK(*memory.write("a", "x"));
  CHECK_FALSE(*memory.write("a", "x"));
  CHECK(*memory.read("a") == "x");
  CHECK_FALSE(*memory.write_new("a", "y"));
  CHECK(*memory.write_new("b", "y"));
  memory.faults["a"] = "no permission";
  CHECK(memory.read("a").error().message == "cannot read `a`: no permission");
}
