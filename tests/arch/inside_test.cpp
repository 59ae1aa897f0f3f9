// docs/inside.md agrees with the sources: the chart of layers, the walk of a symbol. No units include in a circle.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "arch/arch_rules.hpp"
#include "support/catch.hpp"

namespace symplant::arch {
namespace {

namespace fs = std::filesystem;

const std::string kPage = std::string(SYMPLANT_ROOT) + "/docs/inside.md";

const Tree& sources() {
  static const Tree tree = read_tree(SYMPLANT_ROOT, {"generator", "runtime"});
  return tree;
}

std::string page() {
  std::ifstream file(kPage, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// What is between two marks.
std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  REQUIRE(begin != text.npos);
  const std::size_t end = text.find(to, begin + from.size());
  REQUIRE(end != text.npos);
  return text.substr(begin + from.size(), end - begin - from.size());
}

/// The files that a text names in back-ticks.
std::vector<std::string> files_in(const std::string& text) {
  std::vector<std::string> files;
  for (std::size_t at = text.find('`'); at != text.npos;) {
    const std::size_t end = text.find('`', at + 1);
    if (end == text.npos) break;
    const std::string code = text.substr(at + 1, end - at - 1);
    if (code.ends_with(".cpp") || code.ends_with(".hpp")) files.push_back(code);
    at = text.find('`', end + 1);
  }
  return files;
}

/// The order of the walk: down the generator's layers, then the runtime's.
std::size_t depth_of(const std::string& file) {
  const std::vector<std::string> order{
      "generator/app",  "generator/base",        "generator/text",    "generator/address", "generator/read",
      "generator/name", "generator/description", "generator/pairing", "generator/model",   "generator/lower",
      "runtime/host",   "runtime/exec",          "runtime/plant",     "runtime/engine",    "runtime/link"};
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (layer_of(file) == order[i]) return i;
  }
  FAIL("`" + file + "` is in no layer of the walk");
  return 0;
}

}  // namespace

TEST_CASE("No units include each other in a circle") { CHECK(include_loops(sources()) == Faults{}); }

TEST_CASE("A circle of units is found, through headers and sources") {
  const Tree circle{{"generator/a/x.hpp", "#include \"a/y.hpp\"\n"},
                    {"generator/a/y.hpp", ""},
                    {"generator/a/y.cpp", "#include \"a/z.hpp\"\n"},
                    {"generator/a/z.hpp", "#include \"a/x.hpp\"\n"},
                    {"generator/a/own.cpp", "#include \"a/own.hpp\"\n#include \"a/x.hpp\"\n"}};
  CHECK(include_loops(circle) == Faults{"generator/a/x, generator/a/y, generator/a/z"});
  CHECK(include_loops({{"runtime/a/x.cpp", "#include \"symplant/a/x.hpp\"\n"}}).empty());
}

TEST_CASE("The chart leaves out what follows") {
  const Tree tree{{"generator/a/x.hpp", "#include \"b/x.hpp\"\n#include \"c/x.hpp\"\n"},
                  {"generator/b/x.hpp", "#include \"c/x.hpp\"\n"},
                  {"generator/c/x.hpp", ""}};
  CHECK(layer_chart(tree) ==
        "flowchart TD\n  subgraph generator\n    g_a[a]\n    g_b[b]\n    g_c[c]\n  end\n  subgraph runtime\n  end\n"
        "  g_a --> g_b\n  g_b --> g_c\n");
}

TEST_CASE("docs/inside.md shows the layers as the includes have them") {
  const std::string from = "<!-- layers -->\n```mermaid\n";
  const std::string to = "```\n";
  const std::string chart = layer_chart(sources());
  std::string text = page();
  if (std::getenv("SYMPLANT_UPDATE_GOLDENS") != nullptr) {
    const std::size_t begin = text.find(from) + from.size();
    text.replace(begin, text.find(to, begin) - begin, chart);
    std::ofstream(kPage, std::ios::binary) << text;
  }
  CHECK(between(text, from, to) == chart);
}

TEST_CASE("The walk in docs/inside.md names each file once, and goes down only") {
  const std::vector<std::string> files = files_in(between(page(), "<!-- walk -->", "<!-- end of walk -->"));
  CHECK(files.size() > 20);
  std::set<std::string> named;
  std::size_t depth = 0;
  for (const std::string& file : files) {
    INFO(file);
    CHECK(fs::exists(fs::path(SYMPLANT_ROOT) / file));
    CHECK(named.insert(file).second);
    CHECK(depth_of(file) >= depth);
    depth = depth_of(file);
  }
}

TEST_CASE("What docs/inside.md names in `How to add something` exists") {
  const std::string text = between(page(), "<!-- how to add -->", "<!-- end of how to add -->");
  std::size_t named = 0;
  for (std::size_t at = text.find('`'); at != text.npos; at = text.find('`', at + 1)) {
    const std::size_t end = text.find('`', at + 1);
    const std::string path = text.substr(at + 1, end - at - 1);
    at = end;
    if (path.find('/') == path.npos) continue;
    INFO(path);
    CHECK(fs::exists(fs::path(SYMPLANT_ROOT) / path));
    ++named;
  }
  CHECK(named > 20);
}

}  // namespace symplant::arch
