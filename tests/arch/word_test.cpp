// The texts of the project keep to its words; texts that do not are found.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "arch/arch_rules.hpp"
#include "arch/word_rules.hpp"
#include "support/catch.hpp"

namespace symplant::arch {
namespace {

namespace fs = std::filesystem;

std::string read_bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Where a banned word is right: the beginning of a path, a blank, a part of the line in lower case.
const std::vector<std::string>& exceptions() {
  static const std::vector<std::string> all{// Plain English, everywhere.
                                            " in the same way", " of its own unit", " there is none", " there are none",
                                            // Keys and classes that files of users and style sheets have.
                                            "generator/view/svg.cpp .way{", "generator/view/svg.cpp class=\"way",
                                            "generator/view/svg.cpp class=\\\"way"};
  return all;
}

bool is_checked(const std::string& path) {
  if (path.starts_with("tests/golden/") || path.starts_with("tests/fuzz/crashes/")) return false;
  for (const std::string ending : {".cpp", ".hpp", ".md", ".mustache", ".cmake", "CMakeLists.txt", ".sh"}) {
    if (path.ends_with(ending)) return true;
  }
  return path.starts_with("scripts/");
}

const Tree& all_texts() {
  static const Tree tree = [] {
    Tree texts;
    const fs::path root = SYMPLANT_ROOT;
    const auto add = [&](const fs::path& path) {
      const std::string name = fs::relative(path, root).generic_string();
      if (is_checked(name)) texts.push_back({name, read_bytes(path)});
    };
    for (const std::string folder : {"docs", "examples", "generator", "runtime", "scripts", "templates", "tests"}) {
      for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        if (entry.is_regular_file()) add(entry.path());
      }
    }
    for (const std::string file : {"README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "CMakeLists.txt"}) {
      add(root / file);
    }
    return texts;
  }();
  return tree;
}

const std::vector<BannedWord>& words() {
  static const std::vector<BannedWord> all =
      read_banned_words(read_bytes(fs::path(SYMPLANT_ROOT) / "tests/arch/words.txt"));
  return all;
}

/// How many banned words a file has.
std::size_t found_in(const std::string& path, const std::string& text) {
  return banned_words({{path, text}}, words(), {}).size();
}

const std::string kWord = std::string("to") + "ld";  // or this file would be at fault

}  // namespace

TEST_CASE("No script pipes into a command that closes the pipe early") {
  Tree scripts;
  for (const File& file : all_texts()) {
    if (file.path.ends_with(".sh") || file.path.starts_with("scripts/")) scripts.push_back(file);
  }
  CHECK(scripts.size() > 50);
  CHECK(closed_pipes(scripts) == Faults{});
  CHECK(closed_pipes({{"a.sh", "set -o pipefail\nlist | grep -qF -- x || fail\nlist |head -1\n"}}).size() == 2);
  CHECK(closed_pipes({{"a.sh", "list | grep x >/dev/null\ngrep -q x file | sed -n 1p\n"}}).empty());
}

TEST_CASE("Docs, messages and comments keep to the project's words") {
  CHECK(words().size() > 20);
  CHECK(all_texts().size() > 300);
  CHECK(banned_words(all_texts(), words(), exceptions()) == Faults{});
}

TEST_CASE("A banned word is found in prose, comments and messages, with file, line and replacement") {
  CHECK(banned_words({{"docs/a.md", "One.\nThe user is " + kWord + ".\n"}}, words(), {}) ==
        Faults{"docs/a.md:2: `" + kWord + "`: write reported"});
  CHECK(found_in("runtime/a.cpp", "int a;  // is " + kWord + "\n") == 1);
  CHECK(found_in("runtime/a.cpp", "/* one\n" + kWord + " */\n") == 1);
  CHECK(found_in("generator/a.cpp", "f(\"was " + kWord + "\");\n") == 1);
  CHECK(found_in("generator/a.cpp", "f(R\"(was\n" + kWord + ")\");\n") == 1);
  CHECK(found_in("tests/a.cpp", "TEST_CASE(\"It is " + kWord + "\") {\n") == 1);
  CHECK(found_in("templates/a.mustache", "It is " + kWord + ".\n") == 1);
  CHECK(found_in("scripts/test", "# It is " + kWord + ".\n") == 1);
  CHECK(found_in("docs/a.md", "It Is\n" + std::string("IS NO") + "NE of them.\n") == 1);
}

TEST_CASE("Code, words within words and the inputs of tests do not count") {
  CHECK(found_in("docs/a.md", "Call `" + kWord + "`.\n\n```sh\n" + kWord + "\n```\n[x](" + kWord + ".md)\n") == 0);
  CHECK(found_in("docs/a.md", "un" + kWord + " " + kWord + "-x\n") == 0);
  CHECK(found_in("tests/a.cpp", "f(\"" + kWord + "\"); int " + kWord + ";\n") == 0);
  CHECK(found_in("runtime/a.cpp", "int " + kWord + " = '\"'; // \"\n") == 0);
}

TEST_CASE("An exception counts for its path and its line only") {
  const Tree tree{{"docs/a.md", "As " + kWord + " before.\n" + kWord + "\n"}};
  CHECK(banned_words(tree, words(), {"docs/a.md as " + kWord}).size() == 1);
  CHECK(banned_words(tree, words(), {"docs/b.md as " + kWord}).size() == 2);
}

}  // namespace symplant::arch
