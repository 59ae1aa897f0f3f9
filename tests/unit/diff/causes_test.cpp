// Common causes: words replaced in names, addresses shifted, types replaced, devices changed alike.
#include "diff/causes.hpp"

#include "diff_support.hpp"

namespace symplant::test {
namespace {

using Cause = diff::Cause;

std::string replaced(std::string_view before, std::string_view after) {
  const auto [was, is] = diff::replaced_words(before, after);
  return fmt::format("{}>{}", was, is);
}

/// `count kind before>after` for each cause.
Texts texts(const std::vector<Cause>& causes) {
  const Texts kinds{"added", "removed", "replaced", "shifted", "retyped", "modelled"};
  Texts all;
  for (const Cause& cause : causes) {
    all.push_back(fmt::format("{} {} {}>{}", cause.members.size(), kinds[static_cast<std::size_t>(cause.kind)],
                              cause.before, cause.after));
  }
  return all;
}

/// Rows `NAME0`, `NAME1` ... at an address each: `%` in `name` and `address` is the number.
std::string rows(const std::string& name, const std::string& address, int first, int count,
                 const std::string& type = "BOOL") {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const auto with = [&](std::string part, int number) {
      if (const auto at = part.find('%'); at != part.npos) part.replace(at, 1, std::to_string(number));
      return part;
    };
    text += with(name, i) + "," + with(address, first + i) + "," + type + ",\n";
  }
  return text;
}

TEST_CASE("diff: What was replaced in a name is whole words") {
  CHECK(replaced("S201_CL1", "S301_CL1") == "S201>S301");
  CHECK(replaced("L1_S201_CL1", "L1_S301_CL1") == "S201>S301");
  CHECK(replaced("S201_CL1", "LINE_S201_CL1") == ">LINE_");
  CHECK(replaced("A_B_C", "A_C") == "B_>");
  CHECK(replaced("A1_B1_C", "A2_B2_C") == "A1_B1>A2_B2");
  CHECK(replaced("A", "B") == "A>B");
  CHECK(replaced("A_A", "A_A_A") == ">_A");
  CHECK(replaced("", "A") == ">A");
  CHECK(replaced("\xC3\xA4"
                 "1_X",
                 "\xC3\xB6"
                 "1_X") ==
        "\xC3\xA4"
        "1>\xC3\xB6"
        "1");
}

TEST_CASE("diff: A word that is replaced in four names is one cause, in three it is not") {
  const Two four = compared(rows("S1_D%", "X%", 0, 4), rows("S2_D%", "X%", 0, 4));
  CHECK(texts(four.difference.symbol_causes) == Texts{"4 replaced S1>S2"});
  CHECK(four.difference.symbol_causes.front().members == std::vector<std::uint32_t>{0, 1, 2, 3});
  CHECK(texts(compared(rows("S1_D%", "X%", 0, 3), rows("S2_D%", "X%", 0, 3)).difference.symbol_causes).empty());
}

TEST_CASE("diff: Words with any number are one cause, if the number stays") {
  CHECK(texts(compared(rows("S1_CL%", "X%", 0, 4), rows("S1_CX%", "X%", 0, 4)).difference.symbol_causes) ==
        Texts{"4 replaced CL#>CX#"});
  CHECK(texts(compared(rows("S7_D%", "X%", 0, 4), rows("T7_D%", "X%", 0, 4)).difference.symbol_causes) ==
        Texts{"4 replaced S7>T7"});
  CHECK(texts(compared(rows("S2%_D", "X%", 0, 4), rows("S3%_D", "X%", 0, 4)).difference.symbol_causes).empty());
}

TEST_CASE("diff: Names that come together are a cause only if their beginning is new") {
  CHECK(texts(compared("S9_K,X0,BOOL,\n", "S9_K,X0,BOOL,\n" + rows("S9_D%", "X%", 1, 4)).difference.symbol_causes)
            .empty());
  CHECK(texts(compared("L_S8_K,X0,BOOL,\n", "L_S8_K,X0,BOOL,\n" + rows("L_S9_D%", "X%", 1, 4))
                  .difference.symbol_causes) == Texts{"4 added >L_S9"});
  CHECK(texts(compared("L_S90_K,X0,BOOL,\n", "L_S90_K,X0,BOOL,\n" + rows("L_S9_D%", "X%", 1, 4))
                  .difference.symbol_causes) == Texts{"4 added >L_S9"});
}

TEST_CASE("diff: Addresses that move by one distance are one cause, by area") {
  CHECK(texts(compared(rows("A%", "X%", 0, 5) + rows("B%", "Y%", 0, 4), rows("A%", "X%", 4, 5) + rows("B%", "Y%", 4, 4))
                  .difference.symbol_causes) ==
        Texts{"5 shifted inputs>+4 addresses", "4 shifted outputs>+4 addresses"});
  CHECK(texts(compared(rows("A%", "D%", 10, 4, "INT"), rows("A%", "D%", 9, 4, "INT")).difference.symbol_causes) ==
        Texts{"4 shifted memory>-1 word"});
}

TEST_CASE("diff: Addresses of bytes and bits move by bytes, or by bits") {
  const auto list = [](const std::string& byte, int bit) {
    std::string text = "Name,Data Type,Logical Address,Comment\n";
    for (int i = 0; i < 4; ++i) text += fmt::format("A{},Bool,%I{}.{},\n", i, byte, i + bit);
    return analyse_text(text);
  };
  CHECK(texts(compared(list("1", 0), list("3", 0)).difference.symbol_causes) == Texts{"4 shifted inputs>+2 bytes"});
  CHECK(texts(compared(list("1", 0), list("1", 2)).difference.symbol_causes) == Texts{"4 shifted inputs>+2 bits"});
}

TEST_CASE("diff: Types that are replaced, and names that come and go together, are one cause") {
  CHECK(texts(compared(rows("A%", "D%", 0, 4, "INT"), rows("A%", "D%", 0, 4, "WORD")).difference.symbol_causes) ==
        Texts{"4 retyped INT>WORD"});
  CHECK(texts(compared("K,X0,BOOL,\n", "K,X0,BOOL,\n" + rows("S9_D%", "X%", 1, 4)).difference.symbol_causes) ==
        Texts{"4 added >S9"});
  CHECK(texts(compared("K,X0,BOOL,\n" + rows("S9_D%", "X%", 1, 4), "K,X0,BOOL,\n").difference.symbol_causes) ==
        Texts{"4 removed S9>"});
}

TEST_CASE("diff: Devices that change alike are one cause") {
  std::vector<std::string> before;
  std::vector<std::string> after;
  for (const std::string device : {"L_P_A", "L_P_B", "L_P_C", "L_P_D"}) {
    for (const char* const task : {"_O_P1", "_O_P2", "_I_P1", "_I_P2"}) before.push_back(device + task);
    for (const char* const task : {"_O_P1", "_O_P2", "_I_P1", "_I_P2", "_I_P3"}) after.push_back(device + task);
  }
  CHECK(texts(compared_rows(bits(before), bits(after)).difference.device_causes) == Texts{"4 modelled >"});
}

}  // namespace
}  // namespace symplant::test
