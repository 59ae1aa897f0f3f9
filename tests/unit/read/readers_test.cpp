// Bad lists: one clear message, and nothing breaks.
#include "read/readers.hpp"

#include <unistd.h>

#include <filesystem>
#include <set>

#include "read_support.hpp"
#include "support/strings.hpp"

using namespace symplant;
using test::kGoldens;

TEST_CASE("A bad list gives a message with the fault, its location, and a hint") {
  const std::string folder = kGoldens + "bad/";
  for (const std::string& file : test::lists_in(folder)) {
    INFO(file);
    const test::Reading reading = test::read_golden(folder + file);
    CHECK(reading.table.has_value() != reading.diagnostics.has_errors());
    CHECK(reading.diagnostics.count(diag::Severity::error) <= 1);
    std::string text = diag::render_text(reading.diagnostics.all(), {.all = true});
    if (reading.table) text += "\n" + test::rows_as_text(*reading.table);
    test::check_golden(folder + file + ".expected.txt", text);
  }
}

TEST_CASE("A directory, a missing file and one without permission are reported by name") {
  const base::DiskFileSystem disk;
  const auto message_of = [&](const std::string& path) {
    diag::Diagnostics found;
    CHECK_FALSE(read::read_symbol_list(path, {}, disk, found));
    REQUIRE(found.all().size() == 1);
    CHECK(found.all()[0].rule->slug == "cannot-read-file");
    return found.all()[0].message;
  };
  const std::string folder = std::filesystem::temp_directory_path().string();
  CHECK(test::contains(message_of(folder), "`" + folder + "`: it is a directory"));
  CHECK(test::contains(message_of("none/such.csv"), "`none/such.csv`: there is no such file"));

  test::MemoryFileSystem memory;
  memory.faults["list.csv"] = "no permission";
  diag::Diagnostics found;
  CHECK_FALSE(read::read_symbol_list("list.csv", {}, memory, found));
  REQUIRE(found.all().size() == 1);
  CHECK(diag::render_text(found.all(), {.all = true}) ==
        "list.csv: error: cannot read `list.csv`: no permission [SP101 cannot-read-file]\n");
}

TEST_CASE("A format may be given by name, and an unknown one lists the known ones") {
  const std::string list = "Class,Identifier,MIT-Addr.\nVAR_GLOBAL,A,X1\n";
  CHECK(test::read_text(list, "list.csv", {"gx-iec", {}}).table);
  const test::Reading wrong = test::read_text(list, "list.csv", {"gx-eic", {}});
  CHECK_FALSE(wrong.table);
  REQUIRE(wrong.diagnostics.all().size() == 1);
  const std::string& message = wrong.diagnostics.all()[0].message;
  CHECK(test::contains(message, "unknown list format `gx-eic`; choose one of `gx-iec`, "));
  for (const read::ReaderInfo* reader : read::readers()) {
    CHECK(test::contains(message, "`" + std::string(reader->name) + "`"));
  }
}

TEST_CASE("A given format is used for any content") {
  const test::Reading reading = test::read_text("nothing of the kind\n", "list.csv", {"gx-iec", {}});
  CHECK_FALSE(reading.table);
  REQUIRE(reading.diagnostics.all().size() == 1);
  CHECK(reading.diagnostics.all()[0].rule->slug == "unknown-format");
}

TEST_CASE("An encoding may be given by name") {
  const std::string list("N\0a\0m\0e\0,\0C\0l\0a\0s\0s\0\n\0A\0,\0x\0\n\0", 30);
  const test::Reading reading = test::read_text(list, "list.csv", {"", text::Encoding::utf16le});
  REQUIRE(reading.table);
  CHECK(reading.table->decisions[1] == "encoding: utf-16le, as requested");
  CHECK_FALSE(test::read_text(list, "list.csv", {"", text::Encoding::utf8}).table);
}

TEST_CASE("Readers have unique names and titles") {
  std::set<std::string_view> names;
  std::set<std::string_view> titles;
  for (const read::ReaderInfo* reader : read::readers()) {
    INFO(reader->name);
    CHECK(names.insert(reader->name).second);
    CHECK(titles.insert(reader->title).second);
    CHECK(reader->likelihood("") == 0);
    CHECK(reader->likelihood("Dear Sir,\nhere is a letter.\n") == 0);
  }
  CHECK(names.count("gx-iec") == 1);
}
