// Assigns columns to their contents.
#include "read/cells/columns.hpp"

#include "read/cells/layout.hpp"
#include "read/formats.hpp"
#include "support/catch.hpp"

using namespace symplant::read;

TEST_CASE("Columns are recognized by any of their names, ignoring case, blanks and dots") {
  const auto search = find_gx_layout("class ; IDENTIFIER;Mit Addr;iec-addr. ;TYPE;Initial;Comment\n");
  REQUIRE(search.layout);
  CHECK(describe(search.layout->columns) ==
        "class 1, identifier 2, vendor address 3, IEC address 4, type 5, initial 6, comment 7");
  CHECK(search.layout->header_line == 1U);
}

TEST_CASE("The better of two names for one column counts") {
  const auto search = find_gx_layout("Class,Name,Identifier,Constant,Initial Value,Remark,Comment\n");
  REQUIRE(search.layout);
  CHECK(describe(search.layout->columns) == "class 1, identifier 3, initial 5, comment 7");
}

TEST_CASE("Without a header the class column and the content identify the columns") {
  const auto search = find_gx_layout("1,VAR_GLOBAL,A,%IX1,X1,BOOL,FALSE,left\n2,VAR_GLOBAL,B,,D5,INT,0,right\n");
  REQUIRE(search.layout);
  CHECK_FALSE(search.layout->header_line);
  CHECK(describe(search.layout->columns) ==
        "class 2, identifier 3, vendor address 5, IEC address 4, type 6, initial 7, comment 8");
}

TEST_CASE("Without a header the class may be in any column, and names may look like addresses") {
  const auto last = find_gx_layout("P1;X1;%IX1;BOOL;VAR_GLOBAL\nP2;Y2;%QX2;BOOL;VAR_GLOBAL\n");
  REQUIRE(last.layout);
  CHECK(describe(last.layout->columns) == "class 5, identifier 1, vendor address 2, IEC address 3, type 4");
  const auto alike = find_gx_layout("VAR_GLOBAL;P1;X1;BOOL\nVAR_GLOBAL;P2;Y2;BOOL\n");
  REQUIRE(alike.layout);
  CHECK(describe(alike.layout->columns) == "class 1, identifier 2, vendor address 3, type 4");
}

TEST_CASE("A program, a letter or another table is not such a list") {
  CHECK(kGxIec.likelihood("VAR_GLOBAL\n a : BOOL;\nEND_VAR\n") == 0);
  CHECK(kGxIec.likelihood("Dear Sir, here is a list.\n") == 0);
  CHECK(kGxIec.likelihood("TYPE,SCOPE,NAME,DESCRIPTION,DATATYPE\nTAG,,a,,BOOL\n") == 0);
  CHECK(kGxIec.likelihood("Device,Comment\nX1,left\n") == 0);
  CHECK(kGxIec.likelihood("") == 0);
}

TEST_CASE("The paper's own header is the likeliest") {
  CHECK(kGxIec.likelihood("Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n") == 90);
  CHECK(kGxIec.likelihood("Class,Name,Type\n") == 60);
  CHECK(kGxIec.likelihood("VAR_GLOBAL,A,X1\n") == 50);
  CHECK(kGxIec.likelihood("Class,MIT-Addr.,Type\n") == 10);
}

TEST_CASE("Addresses are recognized by their form") {
  CHECK(looks_like_iec_address("%IX1"));
  CHECK(looks_like_iec_address("%mw0.5"));
  CHECK_FALSE(looks_like_iec_address("%Z1"));
  CHECK_FALSE(looks_like_iec_address("X1"));
  CHECK(looks_like_vendor_address("X0001"));
  CHECK(looks_like_vendor_address("Y0A0"));
  CHECK(looks_like_vendor_address("ZR81499"));
  CHECK(looks_like_vendor_address("D10.5"));
  CHECK_FALSE(looks_like_vendor_address("BOOL"));
  CHECK_FALSE(looks_like_vendor_address("DEAD"));
  CHECK_FALSE(looks_like_vendor_address("FALSE"));
  CHECK(looks_like_vendor_address("LDT10"));
  CHECK_FALSE(looks_like_vendor_address("LIMIT1"));
  CHECK_FALSE(looks_like_vendor_address("%IX1"));
  CHECK_FALSE(looks_like_vendor_address("12"));
}
