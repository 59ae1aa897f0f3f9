// Which symbols of two lists are one symbol, and what changed in them.
#include "diff_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("diff: Equal lists have no difference") {
  const Two two = compared("A,X0,BOOL,a\nB,,BOOL,b\n", "A,X0,BOOL,a\nB,,BOOL,b\n");
  CHECK(two.difference.empty());
  CHECK(words(two).empty());
}

TEST_CASE("diff: Symbols are added and removed by name") {
  CHECK(words(compared("A,X0,BOOL,a\nB,X1,BOOL,b\n", "A,X0,BOOL,a\nC,X2,BOOL,c\n")) == Texts{"+C", "-B"});
}

TEST_CASE("diff: A symbol of one name is moved, retyped, and has another initial value, comment or class") {
  CHECK(words(compared("A,X0,BOOL,a\n", "A,X1,BOOL,a\n")) == Texts{"A>A address"});
  CHECK(words(compared("A,D0,INT,a\n", "A,D0,DINT,b\n")) == Texts{"A>A type comment"});
  const auto rows = [](const std::string& initial, const std::string& klass) {
    return std::vector<Row>{{"A", "X0", "BOOL", initial, "", klass}};
  };
  CHECK(words(compared_rows(rows("FALSE", "VAR_GLOBAL"), rows("TRUE", "VAR_GLOBAL"))) == Texts{"A>A initial"});
  CHECK(words(compared_rows(rows("FALSE", "VAR_GLOBAL"), rows("FALSE", "VAR_GLOBAL_CONSTANT"))) == Texts{"A>A other"});
}

TEST_CASE("diff: Two spellings of one value are no difference") {
  CHECK(words(compared("A,X01F,BOOL,a\nW,D5,INT,\n", "A,x1f,Bool,a\nW,D05,int,\n")).empty());
  const auto initial = [](const std::string& text) { return std::vector<Row>{{"A", "X0", "BOOL", text}}; };
  CHECK(words(compared_rows(initial(""), initial("FALSE"))).empty());
  CHECK(words(compared_rows(initial("1"), initial("TRUE"))).empty());
}

TEST_CASE("diff: One address in the notations of two tools is one address") {
  const auto of = [](const std::string& cells) { return analyse_text("Name,Address,Type\n" + cells); };
  CHECK(words(compared(of("A,%IX31,BOOL\nB,%QX0,BOOL\n"),
                       analyse_rows({{"A", "X1F", "BOOL", ""}, {"B", "Y0", "BOOL", ""}})))
            .empty());
}

TEST_CASE("diff: X and Y that count in another base are other addresses") {
  const std::vector<Row> rows{{"A", "X7"}, {"B", "X10"}};
  const Two two = compared(analyse_rows(rows, address::Radix::octal), analyse_rows(rows, address::Radix::hexadecimal));
  CHECK(words(two) == Texts{"B>B address"});
}

TEST_CASE("diff: A second address that changes alone is another column") {
  const auto rows = [](const std::string& vendor, const std::string& iec) {
    return std::vector<Row>{{"A", vendor, "BOOL", "FALSE", iec}};
  };
  CHECK(words(compared_rows(rows("X1", "%IX1"), rows("X2", "%IX1"))) == Texts{"A>A other"});
  CHECK(words(compared_rows(rows("X1", "%IX1"), rows("X1", "%IX2"))) == Texts{"A>A address"});
  CHECK(words(compared_rows(rows("X1", "%IX1"), rows("X2", "%IX2"))) == Texts{"A>A address"});
  CHECK(words(compared_rows(rows("X1", "%IX1"), rows("X01", ""))).empty());
}

TEST_CASE("diff: A symbol with another name on one address is renamed") {
  CHECK(words(compared("A,X0,BOOL,a\n", "B,X0,BOOL,b\n")) == Texts{"A>B name comment"});
  CHECK(words(compared("A,X0F,BOOL,a\n", "B,XF,BOOL,a\n")) == Texts{"A>B name"});
  CHECK(words(compared("A,M0,BOOL,a\n", "B,D0,BOOL,a\n")) == Texts{"+B", "-A"});
}

TEST_CASE("diff: The name counts before the address: two symbols that change places are moved") {
  CHECK(words(compared("A,X0,BOOL,\nB,X1,BOOL,\n", "A,X1,BOOL,\nB,X0,BOOL,\n")) == Texts{"A>A address", "B>B address"});
}

TEST_CASE("diff: Of several symbols on one address, type and comment decide which is renamed") {
  CHECK(words(compared("A,X0,BOOL,one\nB,X0,BOOL,two\n", "C,X0,BOOL,two\nD,X0,BOOL,one\n")) ==
        Texts{"B>C name", "A>D name"});
  CHECK(words(compared("A,X0,BOOL,\nB,X0,BOOL,\n", "C,X0,BOOL,\nD,X0,BOOL,\n")) == Texts{"+C", "+D", "-A", "-B"});
  CHECK(words(compared("A,X0,BOOL,\n", "C,X0,BOOL,\nD,X0,BOOL,\n")) == Texts{"+C", "+D", "-A"});
  CHECK(words(compared("A,X0,BOOL,\nB,X0,BOOL,\n", "C,X0,BOOL,\n")) == Texts{"+C", "-A", "-B"});
  CHECK(words(compared("A,X0,BOOL,one\nB,X0,BOOL,two\n", "C,X0,BOOL,two\nD,X0,BOOL,three\n")) ==
        Texts{"B>C name", "A>D name comment"});
}

TEST_CASE("diff: A symbol without an address is renamed if its type and comment are those of one other symbol") {
  CHECK(words(compared("A,,BOOL,door\nK,X0,BOOL,\n", "B,,BOOL,door\nK,X0,BOOL,\n")) == Texts{"A>B name"});
  CHECK(words(compared("A,,BOOL,\nK,X0,BOOL,\n", "B,,BOOL,\nK,X0,BOOL,\n")) == Texts{"+B", "-A"});
  CHECK(words(compared("A,,INT,door\nK,X0,BOOL,\n", "B,,BOOL,door\nK,X0,BOOL,\n")) == Texts{"+B", "-A"});
  CHECK(words(compared("A,,BOOL,door\nC,,BOOL,door\nK,X0,BOOL,\n", "B,,BOOL,door\nK,X0,BOOL,\n")) ==
        Texts{"+B", "-A", "-C"});
}

TEST_CASE("diff: Rows of one name are paired by their addresses, then in their order") {
  CHECK(words(compared("A,X0,BOOL,\nA,X1,BOOL,\n", "A,X1,BOOL,\nA,X0,BOOL,\n")).empty());
  CHECK(words(compared("A,X0,BOOL,\nA,X1,BOOL,\n", "A,X1,BOOL,\nA,X5,BOOL,\n")) == Texts{"A>A address"});
  CHECK(words(compared("A,X0,BOOL,\n", "A,X0,BOOL,\nA,X1,BOOL,\n")) == Texts{"+A"});
}

TEST_CASE("diff: A name belongs to its scope, and a symbol may change its scope") {
  const auto list = [](const std::string& rows) { return analyse_text("Name,Address,Type,Scope\n" + rows); };
  CHECK(words(compared(list("A,X0,BOOL,P\nA,X1,BOOL,Q\n"), list("A,X5,BOOL,Q\nA,X0,BOOL,P\n"))) ==
        Texts{"A>A address"});
  CHECK(words(compared(list("A,X0,BOOL,P\nA,X1,BOOL,Q\n"), list("A,X5,BOOL,Q\nA,X6,BOOL,P\n"))) ==
        Texts{"A>A address", "A>A address"});
  CHECK(words(compared(list("A,,BOOL,P\nB,X1,BOOL,P\n"), list("A,,BOOL,Q\nB,X1,BOOL,P\n"))) == Texts{"A>A other"});
}

TEST_CASE("diff: Names of different controllers are different, unless a plant has only one") {
  const std::string list = "Name,Address,Type,Comment\nA,X0,BOOL,\n";
  const auto plant = [&](const std::string& a, const std::string& b) {
    std::vector<GivenList> lists{{"a.csv", list, a}};
    if (!b.empty()) lists.push_back({"b.csv", "Name,Address,Type,Comment\nB,X0,BOOL,\n", b});
    return analyse_lists(lists);
  };
  CHECK(words(compared(plant("P1", "P2"), plant("P2", "P1"))) == Texts{"B>A name", "A>B name"});
  CHECK(words(compared(plant("P1", "P2"), plant("P1", "P2"))).empty());
  CHECK(words(compared(plant("P1", ""), plant("", ""))).empty());
}

}  // namespace
}  // namespace symplant::test
