// Reads real lists, which are not part of the project: SYMPLANT_CORPUS names their folder. Returns 77 (skipped)
// without.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "diag/text.hpp"
#include "read/readers.hpp"

namespace {

using symplant::diag::Diagnostics;

int faults = 0;

void check(bool good, const std::string& what) {
  if (good) return;
  std::printf("FAILED: %s\n", what.c_str());
  ++faults;
}

/// Reading any file gives a table with rows or an error that names the file.
void reads_or_says_why(const std::string& path) {
  Diagnostics diagnostics;
  const auto table = symplant::read::read_symbol_list(path, {}, symplant::base::DiskFileSystem(), diagnostics);
  check(table.has_value() != diagnostics.has_errors(), path + ": neither a table nor an error, or both");
  check(!table || !table->rows.empty(), path + ": a table without rows");
  std::printf("%s: %zu rows\n%s\n", path.c_str(), table ? table->rows.size() : 0,
              symplant::diag::render_text(diagnostics.all(), {.most = 2}).c_str());
}

void has_rows(const std::string& path, std::size_t rows) {
  Diagnostics diagnostics;
  const auto table = symplant::read::read_symbol_list(path, {}, symplant::base::DiskFileSystem(), diagnostics);
  check(table && table->rows.size() == rows, path + ": other rows than known");
}

/// A list in a code page: without its name it is rejected and the page is proposed first, with it all is read.
void proposes(const std::string& path, symplant::text::Encoding encoding) {
  const auto bytes = symplant::base::DiskFileSystem().read(path);
  check(bool(bytes), path + ": cannot be read");
  if (!bytes) return;
  const auto refused = symplant::text::decode(std::string(*bytes));
  check(!refused && !refused.error().guesses.empty() && refused.error().guesses.front().encoding == encoding,
        path + ": its code page is not proposed first");
  check(bool(symplant::text::decode(std::string(*bytes), &encoding)), path + ": not all of it is in its code page");
}

}  // namespace

int main() {
  const char* const corpus = std::getenv("SYMPLANT_CORPUS");
  if (corpus == nullptr || *corpus == '\0') {
    std::puts("SYMPLANT_CORPUS is not set: skipped");
    return 77;
  }
  const std::string folder = std::string(corpus) + "/";
  has_rows(folder + "mitsubishi/gxworks3_Global.csv", 25);
  has_rows(folder + "rockwell/HOOD_LOCAL_Tags.CSV", 671 + 1332 + 1076 + 671);  // tags, aliases, comments on I/O
  has_rows(folder + "rockwell/PAP_0322.L5K", 252 + 747);
  has_rows(folder + "rockwell/Plc_emulator.L5X", 60);
  has_rows(folder + "siemens/step7_symbols.asc", 313);
  has_rows(folder + "siemens/PLCTags.xml", 689);
  has_rows(folder + "siemens/tia_tagtable.xml", 210);
  has_rows(folder + "siemens/openness_SPREADER.xml", 8);
  has_rows(folder + "plcopen/openplc_plant.xml", 8);
  has_rows(folder + "beckhoff/GVL_IO.TcGVL", 20);
  has_rows(folder + "siemens/PLCTags.xlsx", 689);
  has_rows(folder + "siemens/PLCTags.sdf", 689);
  has_rows(folder + "mitsubishi/fx-trolley_COMMENT.csv", 582);
  has_rows(folder + "mitsubishi/gxworks2-body-line_COMMENT.csv", 14805);
  has_rows(folder + "mitsubishi/gxworks2-japanese_device_comments.csv", 57);
  has_rows(folder + "lselectric/xg5000_global.csv", 9731 - 32 + 700);  // 32 arrays on I/O have 700 elements
  has_rows(folder + "omron/cx-programmer.cxt", 8692);
  for (const char* file :
       {"mitsubishi/gxworks3_Global.csv", "lselectric/xg5000_global.csv", "mitsubishi/fx-trolley_COMMENT.csv",
        "beckhoff/GVL_IO.TcGVL", "siemens/PLCTags.xlsx", "siemens/step7_symbols.asc", "rockwell/hangul_Tags.csv"}) {
    reads_or_says_why(folder + file);
  }
  proposes(folder + "lselectric/xg5000_global.csv", symplant::text::Encoding::cp949);
  proposes(folder + "mitsubishi/GxWorks3.NoQuote3.EucKR.COMMENT.csv", symplant::text::Encoding::cp949);
  proposes(folder + "siemens/PLCTags.sdf", symplant::text::Encoding::cp1251);
  return faults == 0 ? 0 : 1;
}
