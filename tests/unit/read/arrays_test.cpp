// Arrays: their declarations, and the rows of their elements.
#include "read/types/array_type.hpp"
#include "read/types/expand_arrays.hpp"
#include "read_support.hpp"
#include "support/catch.hpp"

using namespace symplant;
using test::Reading;

namespace {

std::string declared(std::string_view type) {
  const auto array = read::parse_array_type(type);
  if (!array) return "none";
  std::string text(array->element);
  for (const auto& dimension : array->dimensions) {
    text += " " + std::to_string(dimension.first) + ".." + std::to_string(dimension.last);
  }
  return text;
}

/// "NAME address; ..." of a list with one row of this address and type. The first cells are those of a MELSEC list.
std::string elements(const std::string& vendor, const std::string& iec, const std::string& type,
                     const read::ReadOptions& options = {}) {
  const Reading reading =
      test::read_text("Class\tIdentifier\tMIT-Addr.\tIEC-Addr.\tType\tInitial\tComment\nVAR_GLOBAL\tA\t" + vendor +
                          "\t" + iec + "\t" + type + "\t5\tgate\n",
                      "list.csv", options);
  REQUIRE(reading.table);
  std::string text;
  for (const read::ListRow& row : reading.table->rows) {
    CHECK(row.line == 2);
    CHECK(row.comment == "gate");
    text.append(text.empty() ? "" : "; ").append(row.name).append(" ").append(row.vendor_address);
    text.append(row.iec_address);
    if (row.type != type) CHECK(row.initial.empty());
  }
  return text;
}

/// A table in another notation with one row.
std::string elements_in(address::Notation notation, std::string_view address, std::string_view type) {
  read::SymbolTable table;
  table.source = std::make_shared<text::SourceFile>("list", "");
  table.notation = notation;
  read::ListRow row{};
  row.name = "A";
  row.vendor_address = address;
  row.type = type;
  table.rows.push_back(row);
  diag::Diagnostics diagnostics;
  read::expand_arrays(table, address::Radix::hexadecimal, diagnostics);
  std::string text;
  for (const read::ListRow& made : table.rows) {
    text.append(text.empty() ? "" : "; ").append(made.name).append(" ").append(made.vendor_address);
  }
  return text;
}

}  // namespace

TEST_CASE("Arrays of elementary types are declared in several forms") {
  CHECK(declared("ARRAY [0..7] OF BOOL") == "BOOL 0..7");
  CHECK(declared("ARRAY[0..1, 0..3] OF INT") == "INT 0..1 0..3");
  CHECK(declared("Array[0..7] of Bool") == "Bool 0..7");
  CHECK(declared("array [ -3 .. 3 ] of Word [Signed]") == "Word [Signed] -3..3");
  CHECK(declared("BOOL(0..9)") == "BOOL 0..9");
  CHECK(declared("Bit(0..9)") == "Bit 0..9");
  CHECK(declared("DINT[9]") == "DINT 0..8");
  CHECK(declared("DINT[2,3]") == "DINT 0..1 0..2");
  CHECK(declared("BOOL[32]") == "BOOL 0..31");
  CHECK(declared("INT[1..4]") == "INT 1..4");
  for (const char* type :
       {"BOOL", "", "[4]", "STRING(32)", "STRING[32]", "Word[Signed]", "ARRAY [7..0] OF BOOL", "ARRAY [0..7] OF TON",
        "ARRAY [0..7] OF ARRAY [0..1] OF BOOL", "ARRAY [] OF BOOL", "ARRAY [0..N] OF BOOL", "DINT[0]", "DINT[-1]",
        "BOOL(0..9", "ARRAY [0..7]", "FLOAT (Single Precision)", "ARRAY [0..99999999999999999999] OF BOOL",
        "INT[1,1,1,1,1,1,1,1,1]"}) {
    INFO(type);
    CHECK(declared(type) == "none");
  }
  CHECK(declared("BOOL[" + std::string(100'000, '1') + "]") == "none");
}

TEST_CASE("An array of inputs or outputs has a row for each element") {
  CHECK(elements("Y0E", "", "ARRAY [0..2] OF BOOL") == "A[0] Y0E; A[1] Y0F; A[2] Y10");
  CHECK(elements("", "%QX0.7", "ARRAY [1..2] OF BOOL") == "A[1] %QX0.7; A[2] %QX1.0");
  CHECK(elements("", "%IW64", "ARRAY[0..1, 0..1] OF INT") == "A[0,0] %IW64; A[0,1] %IW65; A[1,0] %IW66; A[1,1] %IW67");
  CHECK(elements("K4X0", "", "INT[2]") == "A[0] K4X0; A[1] K4X10");
  CHECK(elements("", "%I*", "ARRAY [0..1] OF INT") == "A[0] %I*; A[1] %I*");
}

TEST_CASE("Elements of a MELSEC array count in the radix of the list, or by their IEC addresses") {
  read::ReadOptions octal;
  octal.xy = address::Radix::octal;
  CHECK(elements("X7", "", "BOOL[2]", octal) == "A[0] X7; A[1] X10");
  CHECK(elements("X10", "%IX8", "BOOL[2]") == "A[0] %IX8; A[1] %IX9");
}

TEST_CASE("Elements of SIMATIC words are two bytes further") {
  CHECK(elements_in(address::Notation::siemens, "%IW64", "Array[0..1] of Int") == "A[0] %IW64; A[1] %IW66");
  CHECK(elements_in(address::Notation::siemens, "E 0.7", "Array[0..1] of Bool") == "A[0] E 0.7; A[1] %I1.0");
  CHECK(elements_in(address::Notation::rockwell, "Local:1:I.Data", "DINT[2]") == "A Local:1:I.Data");
}

TEST_CASE("Other rows of arrays stay as they are") {
  CHECK(elements("M0", "", "ARRAY [0..2] OF BOOL") == "A M0");
  CHECK(elements("", "", "ARRAY [0..2] OF BOOL") == "A ");
  CHECK(elements("X0", "", "ARRAY [0..2] OF INT") == "A X0");
  CHECK(elements("X0", "", "ARRAY [0..2] OF TON") == "A X0");
  CHECK(elements("", "%IX1.2.3", "ARRAY [0..2] OF BOOL") == "A %IX1.2.3");
}

TEST_CASE("Arrays have at most 4,096 elements, and all of a list 65,536, with a warning") {
  std::string text = "Class\tIdentifier\tMIT-Addr.\tIEC-Addr.\tType\tInitial\n";
  for (int i = 0; i < 18; ++i) {
    text +=
        "VAR_GLOBAL\tA" + std::to_string(i) + "\t\t%IX" + std::to_string(10'000 * i) + "\tARRAY [1..4097] OF BOOL\t\n";
  }
  const Reading reading = test::read_text(text);
  REQUIRE(reading.table);
  CHECK(reading.table->rows.size() == 65'536);
  CHECK(reading.table->rows.back().name == "A15[4096]");
  REQUIRE(reading.diagnostics.all().size() == 18);
  CHECK(reading.diagnostics.all().front().message ==
        "`A0` is `ARRAY [1..4097] OF BOOL`: its elements after the first 4096 are left out, since an array may have "
        "4096; "
        "declare what is wired of the others as symbols of elementary types");
  CHECK(reading.diagnostics.all().back().message ==
        "`A17` is `ARRAY [1..4097] OF BOOL`: all of its elements are left out, since the arrays of a list may have "
        "65536; "
        "declare what is wired of the others as symbols of elementary types");
  CHECK(reading.diagnostics.all().back().rule->id == "SP119");
}

TEST_CASE("An array that ends after the last address is cut there") {
  CHECK(elements_in(address::Notation::modbus, "165535", "BOOL[4]") == "A[0] 165535; A[1] 165536");
}
