// The project keeps to its house; trees that do not are found out.
#include <string>

#include "arch/arch_rules.hpp"
#include "support/catch.hpp"

namespace symplant::arch {
namespace {

const Tree& house() {
  static const Tree tree = read_tree(SYMPLANT_ROOT, {"generator", "runtime"});
  return tree;
}

const Tree& everything() {
  static const Tree tree = read_tree(SYMPLANT_ROOT, {"generator", "runtime", "examples", "tests"});
  return tree;
}

/// One file that is well but for the line given, which is its third.
Tree tree_of(const std::string& path, const std::string& line) {
  return {{path, "// A file for a test.\n#pragma once\n" + line + "\n"}};
}

}  // namespace

TEST_CASE("The tree is there to be looked at") {
  CHECK(house().size() > 100);
  CHECK(everything().size() > house().size());
}

TEST_CASE("No include climbs") { CHECK(climbing_includes(house()) == Faults{}); }

TEST_CASE("Third parties stay on the floors that may see them") { CHECK(stray_third_parties(house()) == Faults{}); }

TEST_CASE("Every file says in its first line what it is for") { CHECK(missing_heads(everything()) == Faults{}); }

TEST_CASE("No file is longer than 400 lines") { CHECK(long_files(everything()) == Faults{}); }

TEST_CASE("A climbing include is named with file and line") {
  CHECK(climbing_includes(tree_of("generator/base/file.hpp", "#include \"app/options.hpp\"")) ==
        Faults{"generator/base/file.hpp:3: \"app/options.hpp\" climbs: `base` may not use it"});
  CHECK(climbing_includes(tree_of("generator/read/deep/file.cpp", "  #  include \"name/rule.hpp\"")).size() == 1);
  CHECK(climbing_includes(tree_of("runtime/tables/file.cpp", "#include \"symplant/link/link.hpp\"")) ==
        Faults{"runtime/tables/file.cpp:3: \"symplant/link/link.hpp\" climbs: `tables` may not use it"});
}

TEST_CASE("A floor may use itself and what is below") {
  CHECK(climbing_includes(tree_of("generator/emit/file.cpp", "#include \"emit/keys.hpp\"")).empty());
  CHECK(climbing_includes(tree_of("generator/emit/file.cpp", "#include \"text/ascii.hpp\"")).empty());
  CHECK(climbing_includes(tree_of("runtime/host/file.cpp", "#include \"symplant/tables/time.hpp\"")).empty());
  CHECK(climbing_includes(tree_of("runtime/tables/file.cpp", "#include \"symplant/tables/time.hpp\"")).empty());
}

TEST_CASE("The generator's floors use of the runtime what the house lets them") {
  const std::string core = "#include \"symplant/tables/tables.hpp\"";
  const std::string condition = "#include \"symplant/condition/parser.hpp\"";
  const std::string host = "#include \"symplant/host/run.hpp\"";
  for (const std::string floor : {"base", "text", "diag", "address", "read", "name", "findings"}) {
    CHECK(climbing_includes(tree_of("generator/" + floor + "/file.cpp", core)).size() == 1);
  }
  for (const std::string floor : {"description", "model", "lower", "check", "emit"}) {
    CHECK(climbing_includes(tree_of("generator/" + floor + "/file.cpp", core)).empty());
    CHECK(climbing_includes(tree_of("generator/" + floor + "/file.cpp", host)).size() == 1);
  }
  CHECK(climbing_includes(tree_of("generator/model/file.cpp", condition)).empty());
  CHECK(climbing_includes(tree_of("generator/emit/file.cpp", condition)).size() == 1);
  CHECK(climbing_includes(tree_of("generator/app/file.cpp", host)).empty());
}

TEST_CASE("The runtime uses nothing of the generator") {
  CHECK(climbing_includes(tree_of("runtime/host/file.cpp", "#include \"base/ascii.hpp\"")).size() == 1);
}

TEST_CASE("A file or an include on no floor is a fault") {
  CHECK(climbing_includes(tree_of("generator/attic/file.hpp", "")).size() == 1);
  CHECK(climbing_includes(tree_of("generator/base/file.hpp", "#include \"attic/file.hpp\"")).size() == 1);
  CHECK(climbing_includes(tree_of("generator/base/file.hpp", "#include \"beside.hpp\"")).size() == 1);
  CHECK(climbing_includes(tree_of("generator/app/file.hpp", "#include <symplant/tables/time.hpp>")).size() == 1);
}

TEST_CASE("A third party out of place is a fault") {
  CHECK(stray_third_parties(tree_of("generator/read/file.cpp", "#include <boost/spirit/home/x3.hpp>")).size() == 1);
  CHECK(stray_third_parties(tree_of("generator/name/file.cpp", "#include <boost/spirit/home/x3.hpp>")).empty());
  CHECK(stray_third_parties(tree_of("runtime/tables/file.cpp", "#include <CLI/App.hpp>")).size() == 1);
  CHECK(stray_third_parties(tree_of("runtime/trace/file.hpp", "#include <nlohmann/json.hpp>")).size() == 1);
  CHECK(stray_third_parties(tree_of("runtime/trace/file.cpp", "#include <nlohmann/json.hpp>")).empty());
}

TEST_CASE("A file without a head, or too long a one, is a fault") {
  CHECK(missing_heads({{"tests/a.cpp", "#include <string>\n"}}).size() == 1);
  CHECK(missing_heads({{"tests/a.cpp", "//\n"}}).size() == 1);
  CHECK(missing_heads({{"tests/a.cpp", ""}}).size() == 1);
  CHECK(missing_heads(tree_of("tests/a.cpp", "")).empty());

  std::string text;
  for (int line = 0; line < 400; ++line) text += "\n";
  CHECK(long_files({{"tests/a.cpp", text}}).empty());
  CHECK(long_files({{"tests/a.cpp", text + "\n"}}).size() == 1);
}

}  // namespace symplant::arch
