// Addresses in the notations of the targets.
#include "convert/addresses.hpp"

#include <string>

#include "convert_support.hpp"

namespace symplant::convert {
namespace {

/// The address of the first symbol of a list with one row.
std::string in(const AddressForm& form, const std::string& mitsubishi, const std::string& iec = "") {
  return address_in(gx_list("VAR_GLOBAL,A," + mitsubishi + "," + iec + ",,,\n")->all.front(), form);
}

/// The same for a table with an IEC address.
std::string of_iec(const AddressForm& form, const std::string& iec) {
  const auto symbols = symbols_of_text("a.st", "VAR_GLOBAL\n  a AT " + iec + " : WORD;\nEND_VAR\n");
  return address_in(symbols->all.front(), form);
}

}  // namespace

TEST_CASE("A bit is written as its number, or as byte and bit") {
  CHECK(in(kGxIecForm, "X1F") == "%IX31");
  CHECK(in(kCodesysForm, "X1F") == "%IX3.7");
  CHECK(in(kOpenPlcForm, "Y0") == "%QX0.0");
  CHECK(in(kTwinCatForm, "Y10") == "%QX2.0");
  CHECK(in(kSiemensForm, "X1F") == "%I3.7");
}

TEST_CASE("Words count in words, or in bytes for TwinCAT and SIMATIC") {
  CHECK(in(kGxIecForm, "", "%IW5") == "%IW5");
  CHECK(in(kCodesysForm, "", "%IW5") == "%IW5");
  CHECK(in(kOpenPlcForm, "", "%QD3") == "%QD3");
  CHECK(in(kTwinCatForm, "", "%QD3") == "%QD12");
  CHECK(in(kSiemensForm, "", "%IW5") == "%IW10");
  CHECK(in(kSiemensForm, "", "%IB5") == "%IB5");
}

TEST_CASE("Long words have an address where the target has such addresses") {
  CHECK(in(kOpenPlcForm, "", "%IL2") == "%IL2");
  CHECK(in(kCodesysForm, "", "%IL2").empty());
  CHECK(in(kSiemensForm, "", "%IL2").empty());
}

TEST_CASE("Addresses of several parts and numbers beyond 64 bits have no equivalent") {
  CHECK(in(kCodesysForm, "", "%IX1.2.3").empty());
  CHECK(in(kGxIecForm, "", "%IW5.3").empty());
  CHECK(in(kSiemensForm, "", "%IW18446744073709551615").empty());
  CHECK(in(kCodesysForm, "", "").empty());
}

TEST_CASE("A bit of a word is the bit of that number") {
  CHECK(in(kCodesysForm, "", "%IW5.12") == "%IX11.4");
  CHECK(in(kSiemensForm, "", "%QW1410.1") == "%Q2820.1");
}

TEST_CASE("Words of SIMATIC at odd bytes, and groups of MELSEC bits, have an address where words begin at any byte") {
  const auto siemens = [](const AddressForm& form, const std::string& text) {
    const auto symbols =
        symbols_of_text("list.sdf", "\"A\",\"" + text + "\",\"Word\",\"True\",\"True\",\"False\",\"\",\"\",\"True\"\n");
    return address_in(symbols->all.front(), form);
  };
  CHECK(siemens(kSiemensForm, "%IW65") == "%IW65");
  CHECK(siemens(kTwinCatForm, "%IW65") == "%IW65");
  CHECK(siemens(kCodesysForm, "%IW64") == "%IW32");
  CHECK(siemens(kCodesysForm, "%IW65").empty());
  CHECK(siemens(kOpenPlcForm, "%IW65").empty());
  CHECK(in(kCodesysForm, "K4X10") == "%IW1");
  CHECK(in(kSiemensForm, "K4X8") == "%IW1");
  CHECK(in(kCodesysForm, "K4X8").empty());
}

TEST_CASE("A CIO word that the user declares as inputs has addresses") {
  diag::Diagnostics diagnostics;
  read::ReadOptions options;
  options.io_words.ranges.push_back({1000, 1099, address::Area::input});
  auto table =
      read::read_symbol_list("a.csv", "Name,Address,Type\nA,1052.02,BOOL\nB,1100.00,BOOL\n", options, diagnostics);
  REQUIRE(table.has_value());
  const List list{std::make_shared<const read::SymbolTable>(std::move(*table)), {}, {}};
  const Symbols symbols = symbols_of({&list, 1});
  CHECK(symbols.all[0].kind == Kind::input);
  CHECK(address_in(symbols.all[0], kCodesysForm) == "%IX2104.2");
  CHECK(symbols.all[1].kind == Kind::internal);
  CHECK(address_in(symbols.all[1], kCodesysForm).empty());
}

TEST_CASE("Memory of MELSEC has no equivalent, memory of IEC lists has") {
  CHECK(in(kCodesysForm, "M500", "%MX0.500").empty());
  CHECK(in(kSiemensForm, "D10").empty());
  CHECK(of_iec(kCodesysForm, "%MW5") == "%MW5");
  CHECK(of_iec(kSiemensForm, "%MW5") == "%MW10");
  CHECK(of_iec(kSiemensForm, "%MX3.5") == "%M3.5");
  CHECK(of_iec(kGxIecForm, "%MW5").empty());
}

TEST_CASE("A MELSEC device counts in the base that the user gives") {
  const auto device = [](const char* text, address::Radix radix) {
    return melsec_device(*address::parse_iec(text), radix);
  };
  CHECK(device("%IX31", address::Radix::hexadecimal) == "X1F");
  CHECK(device("%IX31", address::Radix::octal) == "X37");
  CHECK(device("%QX8", address::Radix::octal) == "Y10");
  CHECK(device("%QW8", address::Radix::octal).empty());
}

}  // namespace symplant::convert
