// The project keeps its architecture rules; trees that break them are reported.
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

/// One file that is valid except for the given line, which is its third line.
Tree tree_of(const std::string& path, const std::string& line) {
  return {{path, "// A file for a test.\n#pragma once\n" + line + "\n"}};
}

}  // namespace

TEST_CASE("The source tree is found") {
  CHECK(house().size() > 100);
  CHECK(everything().size() > house().size());
}

TEST_CASE("No layer includes a higher layer") { CHECK(climbing_includes(house()) == Faults{}); }

TEST_CASE("Only the allowed layers include third parties") { CHECK(stray_third_parties(house()) == Faults{}); }

TEST_CASE("Every file states its purpose in its first line") { CHECK(missing_heads(everything()) == Faults{}); }

TEST_CASE("No file is longer than 500 lines") { CHECK(long_files(everything()) == Faults{}); }

TEST_CASE("An include of a higher layer is reported with file and line") {
  CHECK(climbing_includes(tree_of("generator/base/file.hpp", "#include \"app/options.hpp\"")) ==
        Faults{"generator/base/file.hpp:3: \"app/options.hpp\" climbs: `base` may not use it"});
  CHECK(climbing_includes(tree_of("generator/read/deep/file.cpp", "  #  include \"name/rule.hpp\"")).size() == 1);
  CHECK(climbing_includes(tree_of("runtime/tables/file.cpp", "#include \"symplant/link/link.hpp\"")) ==
        Faults{"runtime/tables/file.cpp:3: \"symplant/link/link.hpp\" climbs: `tables` may not use it"});
}

TEST_CASE("A layer may include itself and the layers below it") {
  CHECK(climbing_includes(tree_of("generator/emit/file.cpp", "#include \"emit/keys.hpp\"")).empty());
  CHECK(climbing_includes(tree_of("generator/emit/file.cpp", "#include \"text/ascii.hpp\"")).empty());
  CHECK(climbing_includes(tree_of("runtime/host/file.cpp", "#include \"symplant/tables/time.hpp\"")).empty());
  CHECK(climbing_includes(tree_of("runtime/tables/file.cpp", "#include \"symplant/tables/time.hpp\"")).empty());
}

TEST_CASE("Generator layers include only the allowed runtime layers") {
  const std::string core = "#include \"symplant/tables/tables.hpp\"";
  const std::string condition = "#include \"symplant/condition/parser.hpp\"";
  const std::string host = "#include \"symplant/host/run.hpp\"";
  for (const std::string floor : {"base", "diag", "address", "findings"}) {
    CHECK(climbing_includes(tree_of("generator/" + floor + "/file.cpp", core)).size() == 1);
  }
  for (const std::string floor : {"text", "read", "name", "description", "naming", "model", "lower", "check", "emit"}) {
    CHECK(climbing_includes(tree_of("generator/" + floor + "/file.cpp", core)).empty());
    CHECK(climbing_includes(tree_of("generator/" + floor + "/file.cpp", host)).size() == 1);
  }
  CHECK(climbing_includes(tree_of("generator/model/file.cpp", condition)).empty());
  CHECK(climbing_includes(tree_of("generator/emit/file.cpp", condition)).size() == 1);
  CHECK(climbing_includes(tree_of("generator/app/file.cpp", host)).empty());
}

TEST_CASE("The runtime does not include the generator") {
  CHECK(climbing_includes(tree_of("runtime/host/file.cpp", "#include \"base/ascii.hpp\"")).size() == 1);
}

TEST_CASE("A file or an include outside all layers is a fault") {
  CHECK(climbing_includes(tree_of("generator/attic/file.hpp", "")).size() == 1);
  CHECK(climbing_includes(tree_of("generator/base/file.hpp", "#include \"attic/file.hpp\"")).size() == 1);
  CHECK(climbing_includes(tree_of("generator/base/file.hpp", "#include \"beside.hpp\"")).size() == 1);
  CHECK(climbing_includes(tree_of("generator/app/file.hpp", "#include <symplant/tables/time.hpp>")).size() == 1);
}

TEST_CASE("A third party in a layer that must not use it is a fault") {
  CHECK(stray_third_parties(tree_of("generator/model/file.cpp", "#include <boost/spirit/home/x3.hpp>")).size() == 1);
  CHECK(stray_third_parties(tree_of("generator/name/file.cpp", "#include <boost/spirit/home/x3.hpp>")).empty());
  CHECK(stray_third_parties(tree_of("runtime/tables/file.cpp", "#include <CLI/App.hpp>")).size() == 1);
  CHECK(stray_third_parties(tree_of("runtime/trace/file.hpp", "#include <nlohmann/json.hpp>")).size() == 1);
  CHECK(stray_third_parties(tree_of("runtime/trace/file.cpp", "#include <nlohmann/json.hpp>")).empty());
}

TEST_CASE("A missing or too short header line is a fault") {
  CHECK(missing_heads({{"tests/a.cpp", "#include <string>\n"}}).size() == 1);
  CHECK(missing_heads({{"tests/a.cpp", "//\n"}}).size() == 1);
  CHECK(missing_heads({{"tests/a.cpp", ""}}).size() == 1);
  CHECK(missing_heads(tree_of("tests/a.cpp", "")).empty());

  std::string text;
  for (int line = 0; line < 500; ++line) text += "\n";
  CHECK(long_files({{"tests/a.cpp", text}}).empty());
  CHECK(long_files({{"tests/a.cpp", text + "\n"}}).size() == 1);
}

}  // namespace symplant::arch
