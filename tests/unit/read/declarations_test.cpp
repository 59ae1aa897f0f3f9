// Declarations in Structured Text: what belongs to a variable, and texts that are damaged or hostile.
#include "read/st/declarations.hpp"

#include "read_support.hpp"

using namespace symplant;
using test::kMany;
using test::repeated;

namespace {

test::Reading read_st(const std::string& text) {
  read::ReadOptions options;
  options.input_format = "st";
  return test::read_soon(text, "list.st", options);
}

std::string global(const std::string& declarations) { return "VAR_GLOBAL\n" + declarations + "\nEND_VAR\n"; }

/// The rows of a block, each as `NAME ADDRESS TYPE = INITIAL // COMMENT`, joined by `, `.
std::string parsed(const std::string& declarations) {
  const test::Reading reading = read_st(global(declarations));
  std::string rows;
  if (!reading.table) return rows;
  for (const read::ListRow& row : reading.table->rows) {
    rows.append(rows.empty() ? "" : ", ").append(row.name);
    if (!row.vendor_address.empty()) rows.append(" ").append(row.vendor_address);
    rows.append(" ").append(row.type);
    if (!row.initial.empty()) rows.append(" = ").append(row.initial);
    if (!row.comment.empty()) rows.append(" // ").append(row.comment);
  }
  return rows;
}

}  // namespace

TEST_CASE("Declarations of all forms are read") {
  CHECK(parsed("a:BOOL;") == "a BOOL");
  CHECK(parsed("a AT%IX0.0:BOOL:=TRUE;") == "a %IX0.0 BOOL = TRUE");
  CHECK(parsed("a at %q* : bool;") == "a %q* bool");
  CHECK(parsed("a, b AT %QW3, c : INT;").empty());
  CHECK(parsed("a, b AT %QW3 : INT;") == "a %QW3 INT, b %QW3 INT");
  CHECK(parsed("a : array[0..7,1..2]of array [*] of Lib.T;") == "a array[0..7,1..2]of array [*] of Lib.T");
  CHECK(parsed("a : STRING(80) := 'x;$';y'; b : WSTRING[5] := \"z;\";") ==
        "a STRING(80) = 'x;$';y', b WSTRING[5] = \"z;\"");
  CHECK(parsed("a : POINTER TO REFERENCE TO REF_TO T;") == "a POINTER TO REFERENCE TO REF_TO T");
  CHECK(parsed("a : (red, green) := green;") == "a (red, green) = green");
  CHECK(parsed("a : INT (0..9) := 3;") == "a INT (0..9) = 3");
  CHECK(parsed("a : TON(PT := T#1s, f(2));") == "a TON(PT := T#1s, f(2))");
  CHECK(parsed("a : T := (b := [1, 2(0)], c := ');');") == "a T = (b := [1, 2(0)], c := ');')");
  CHECK(parsed("`a b` : BOOL; \"c-d\" : \"User type\"; Größe : INT;") == "a b BOOL, c-d \"User type\", Größe INT");
  CHECK(parsed("a {attribute 'x' := ';'} (* ; *) AT {p} %IX1 // ;\n : BOOL;") == "a %IX1 BOOL // ;");
  CHECK(parsed("b AT a : ARRAY [0..1] OF BYTE;") == "b ARRAY [0..1] OF BYTE");
  CHECK(parsed("a\n:\nARRAY\n[0..1]\nOF\nBOOL\n;") == "a ARRAY [0..1] OF BOOL");
}

TEST_CASE("The comment of a variable is after it, in it, or above it") {
  CHECK(parsed("a : BOOL; // after") == "a BOOL // after");
  CHECK(parsed("a : BOOL; (* after *) // second") == "a BOOL // after");
  CHECK(parsed("// above\na : BOOL; /* after */") == "a BOOL // after");
  CHECK(parsed("// above\na (* in *) : BOOL;") == "a BOOL // in");
  CHECK(parsed("// too far\n// above\na : BOOL;") == "a BOOL // above");
  CHECK(parsed("// above\n{pragma}\n{other}\na : BOOL;") == "a BOOL // above");
  CHECK(parsed("// heading\n\na : BOOL;") == "a BOOL");
  CHECK(parsed("// heading\n{pragma}\n\na : BOOL;") == "a BOOL");
  CHECK(parsed("a : BOOL; // a's\nb : BOOL;") == "a BOOL // a's, b BOOL");
  CHECK(parsed("a : BOOL; // a's\n// b's\nb : BOOL;") == "a BOOL // a's, b BOOL // b's");
  CHECK(parsed("a : BOOL; (* a's *) b : BOOL; (* b's *)") == "a BOOL // a's, b BOOL // b's");
  CHECK(parsed("a : BOOL; (* two\r\n   lines *)\r\nb : BOOL;") == "a BOOL // two lines, b BOOL");
  CHECK(parsed("// b : BOOL;\na : BOOL;") == "a BOOL");
  CHECK(parsed("(**** framed ****)\na : BOOL;") == "a BOOL // framed");
  CHECK(parsed("/// documentation\na : BOOL;") == "a BOOL // documentation");
}

TEST_CASE("A part that is commented out gives no symbols, with comments and pragmas in it") {
  CHECK(parsed("a : BOOL;\n(*\n(* b *)\n{attribute 'x' := ';'}\nb : BOOL; // (* not\n*)\n*)\nc : BOOL;") ==
        "a BOOL, c BOOL");
  CHECK(parsed("/* a : BOOL; */ // b : BOOL;\nc : BOOL;") == "c BOOL");
  CHECK(parsed("a : BOOL; // (* b : BOOL;\nc : BOOL;") == "a BOOL // (* b : BOOL;, c BOOL");
}

TEST_CASE("The kind of a block is the class of its rows") {
  const auto classes_of = [](const std::string& text) {
    const test::Reading reading = read_st(text);
    std::string classes;
    if (!reading.table) return classes;
    for (const read::ListRow& row : reading.table->rows) classes.append(row.klass).append(" ");
    return classes;
  };
  CHECK(classes_of("var_global constant a : INT; end_var") == "VAR_GLOBAL_CONSTANT ");
  CHECK(classes_of("VAR_GLOBAL RETAIN PERSISTENT a : INT; END_VAR") == "VAR_GLOBAL_RETAIN_PERSISTENT ");
  CHECK(classes_of("VAR_GLOBAL retain : INT; END_VAR VAR_GLOBAL persistent, b : INT; END_VAR") ==
        "VAR_GLOBAL VAR_GLOBAL VAR_GLOBAL ");
  CHECK(classes_of("PROGRAM p VAR_TEMP a AT %IX0 : BOOL; b : BOOL; END_VAR END_PROGRAM") == "VAR_TEMP ");
  CHECK(classes_of("VAR_EXTERNAL a AT %IX0 : BOOL; END_VAR VAR_ACCESS b : c : BOOL; END_VAR").empty());
}

TEST_CASE("A declaration that cannot be read is one warning, and the next one is read") {
  for (const std::string broken : {"x;",
                                   "x BOOL;",
                                   ": BOOL;",
                                   "x : ;",
                                   "x : BOOL := ;",
                                   "x : BOOL INT;",
                                   "x AT : BOOL;",
                                   "x AT % : BOOL;",
                                   "x : ARRAY [0..1 OF BOOL;",
                                   "x : ARRAY [0..1] BOOL;",
                                   "1x : BOOL;",
                                   "x, : BOOL;",
                                   "x : 'BOOL';",
                                   "x y : BOOL;",
                                   "x : BOOL := 'open;\n",
                                   "\"open : BOOL;\n",
                                   "%IX0.0 : BOOL;",
                                   "x : POINTER BOOL;",
                                   ") : BOOL;",
                                   "}",
                                   "x : T];"}) {
    INFO(broken);
    const std::string text = broken == "}" ? "} : BOOL;" : broken;
    const test::Reading reading = read_st(global("a : BOOL;\n" + text + "\nb : BOOL;"));
    REQUIRE(reading.table);
    REQUIRE(reading.table->rows.size() == 2);
    CHECK(reading.table->rows[1].name == "b");
    REQUIRE(reading.diagnostics.all().size() == 1);
    CHECK(reading.diagnostics.all()[0].rule->slug == "row-not-understood");
    CHECK(reading.table->source->position(reading.diagnostics.all()[0].location.span.begin).line == 3);
  }
}

TEST_CASE("A block without its end is one warning, and the next one is read") {
  const test::Reading reading = read_st("VAR_GLOBAL\n a : BOOL;\nVAR_GLOBAL\n b : BOOL;\nEND_VAR");
  REQUIRE(reading.table);
  CHECK(reading.table->rows.size() == 2);
  CHECK(reading.diagnostics.all().size() == 1);
}

TEST_CASE("An apostrophe in a pragma or a comment hides no declaration") {
  CHECK(parsed("{warning don't}\na : BOOL;") == "a BOOL");
  CHECK(parsed("(* don't *) a : BOOL; // can't\nb : BOOL;") == "a BOOL // can't, b BOOL");
  CHECK(parsed("{ not closed\na : BOOL;\nb : BOOL;") == "b BOOL");
}

TEST_CASE("A comment that would not be closed with nesting ends at the first end mark") {
  const test::Reading reading = read_st(global("a : BOOL; (* see (* above *)\nb : BOOL;"));
  REQUIRE(reading.table);
  CHECK(reading.table->rows.size() == 2);
  REQUIRE(reading.diagnostics.all().size() == 1);
  CHECK(reading.diagnostics.all()[0].rule->slug == "unclosed-comment");
}

TEST_CASE("Deep nesting and many faults are read in time") {
  CHECK(parsed("a : T := " + repeated("[(", kMany) + repeated(")]", kMany) + ";\nb : BOOL;").substr(0, 4) == "a T,");
  CHECK(parsed("a : " + repeated("ARRAY [0..1] OF ", 2000) + "BOOL; b : BOOL;").size() > 30'000);
  read_st(global(repeated("(* ", kMany) + repeated("*) ", kMany) + "a : BOOL;"));
  read_st(global(repeated("(* ", kMany) + "a : BOOL;"));
  read_st(global("a " + repeated("(*(**)", kMany) + " : BOOL; b : BOOL;"));
  read_st(global(repeated("a : BOOL := (", kMany)));
  read_st(global(repeated("{'", kMany) + "a : BOOL;"));
  read_st(global(repeated("a : BOOL := '\n", kMany)));
  read_st(global(repeated("a, ", kMany) + "b : BOOL; // " + std::string(1 << 20, 'c')));
  read_st(global("a : " + repeated("T.", kMany) + "T;"));
  read_st(global("a : " + repeated("POINTER TO ", kMany) + ";"));
  read_st("PROGRAM " + std::string(1 << 20, 'p') + "\n" + repeated("VAR a AT %IX0.0 : BOOL; END_VAR\n", 20'000));
  read_st(repeated("VAR_GLOBAL CONSTANT\n", kMany));
  read_st(global(repeated("\n", 1 << 20) + "a : BOOL;" + repeated("\n // c", kMany)));
}

TEST_CASE("Structured Text is recognized by its first block, and lists that name a class are not") {
  CHECK(read::declarations_likelihood("VAR_GLOBAL\n a : BOOL;\nEND_VAR") > 90);
  CHECK(read::declarations_likelihood("(* c *) {attribute 'x'}\nPROGRAM p\nVAR\n a : BOOL;\nEND_VAR") > 90);
  CHECK(read::declarations_likelihood("VAR_GLOBAL\nEND_VAR") > 50);
  for (const char* const list :
       {"VAR_GLOBAL,A,X1,%IX1,BOOL\nVAR_GLOBAL,B,X2,%IX2,BOOL\n", "VAR_GLOBAL;A;%IX0;X0;BOOL;;\"a : b;\"\n",
        "VAR_GLOBAL\tA\tX1\t%IX1\tBOOL\nVAR_GLOBAL\tB\tX2\t%IX2\tBOOL\n", "Class,Identifier\nVAR_GLOBAL,A",
        "IF a THEN b := 1; END_IF", ""}) {
    INFO(list);
    CHECK(read::declarations_likelihood(list) == 0);
  }
}
