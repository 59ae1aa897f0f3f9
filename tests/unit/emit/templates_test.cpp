// The templates: a contract of keys, and reported faults.
#include <set>
#include <sstream>

#include "emit/keys.hpp"
#include "emit/render.hpp"
#include "emit_support.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::test {
namespace {

std::string key_table() {
  std::string text = "| key | within | holds |\n|---|---|---|\n";
  for (const emit::Key& key : emit::keys()) {
    text.append("| `").append(key.key).append("` |");
    std::istringstream lists{std::string(key.in)};
    for (std::string list, before = " "; lists >> list; before = ", ") text.append(before + "`" + list + "`");
    text.append(" | ").append(key.list ? "a list: " : "").append(key.meaning).append(" |\n");
  }
  return text;
}

TEST_CASE("templates/README.md is the contract: its table lists the keys") {
  const std::string path = kSource + "/templates/README.md";
  const std::string begin_mark = "<!-- keys -->\n";
  const std::string end_mark = "<!-- end of keys -->";
  const std::string readme = read_bytes(path);
  const std::size_t begin = readme.find(begin_mark);
  const std::size_t end = readme.find(end_mark);
  REQUIRE(begin != std::string::npos);
  REQUIRE(end != std::string::npos);
  check_golden(path, readme.substr(0, begin + begin_mark.size()) + "\n" + key_table() + "\n" + readme.substr(end));
}

TEST_CASE("The templates in the tool are the files in templates/") {
  CHECK(emit::embedded_templates().size() == 9);
  for (const emit::Template& own : emit::embedded_templates()) {
    INFO(own.name);
    CHECK(own.text == read_bytes(kSource + "/templates/" + std::string(own.name) + ".mustache"));
  }
}

TEST_CASE("Every key is used in a built-in template or in that of the example") {
  std::vector<std::string> texts{read_bytes(kSource + "/examples/structured-text/templates/plant.st.mustache")};
  for (const emit::Template& own : emit::embedded_templates()) texts.emplace_back(own.text);
  const std::set<std::string_view> general{"device_count", "dt",   "number",  "from",     "once",
                                           "priority",     "task", "leaving", "by_itself"};  // for others
  for (const emit::Key& key : emit::keys()) {
    INFO(key.key);
    bool used = general.contains(key.key);
    for (const std::string& text : texts) {
      for (const char* opening : {"{{", "{{{", "{{#"})
        used = used || contains(text, opening + std::string(key.key) + "}}");
    }
    CHECK(used);
  }
}

/// The output of a custom template for main_gen.cpp, or its error.
std::string with_template(const std::string& text) {
  const CompiledText compiled = compile_rows(bits({"L_P_D_O_A1", "L_P_D_I_A1"}));
  const TemporaryFolder folder;
  const std::string path = folder.write("main_gen.cpp.mustache", text);
  const Emitted result = emitted(compiled.plant(), compiled.tables(), {folder.path()});
  if (result.errors.empty()) {
    CHECK(result.inputs == std::vector<std::string>{path});
    return file_of(result, "main_gen.cpp");
  }
  CHECK(result.errors.size() == 1);
  CHECK(result.errors[0].find(path) == 0);
  return result.errors[0].substr(path.size());
}

TEST_CASE("A template may use keys, comments and braces") {
  CHECK(with_template("{{! mine }}{{plant}} {{ unit_count }} {{{list}}} {{&namespace}} {{open}}{{close}}") ==
        "symbols 1 symbols.csv symbols {}");
}

TEST_CASE("A key that is unknown, outside its list, or misspelled is reported with file and line") {
  CHECK(with_template("a\nb\n{{planet}}").find(":3: `planet` is not a key: see templates/README.md for the keys") == 0);
  CHECK(with_template("{{symbol_rows}}").find(":1: `symbol_rows` is not a key") == 0);
  CHECK(with_template("{{Plant}}").find(":1: `Plant`") == 0);
  CHECK(with_template("{{}}").find(":1: ") == 0);
  CHECK(with_template("a\n\x01 b").find(":2: the control character U+0001 is not allowed here") == 0);
  CHECK(with_template("a\x02").find(":1: the control character U+0002 is not allowed here") == 0);
  CHECK(with_template("\n{{#planets}}{{/planets}}").find(":2: `planets`") == 0);
  CHECK(with_template("\n\n{{> part}}").find(":3: ") == 0);
  CHECK(with_template("{{types}}").find(":1: `types` is a list: write `{{#types}} ... {{/types}}`") == 0);
  CHECK(with_template("{{#plant}}x{{/plant}}").find(":1: `plant` is a text, not a list: write `{{plant}}`") == 0);
  CHECK(with_template("\n{{class}}") ==
        ":2: `class` is known only within a list: write it between `{{#types}}` and `{{/types}}`");
  CHECK(with_template("{{#types}}{{#states}}{{class}}.{{name}} {{/states}}{{/types}}") == "D.NOT_A1 D.A1 ");
}

TEST_CASE("A folder may hold templates for further files, and nothing else") {
  const CompiledText compiled = compile_rows(bits({"L_P_D_O_A1", "L_P_D_I_A1"}));
  const TemporaryFolder folder;
  folder.write("b.puml.mustache", "{{#types}}\n@startuml {{class}}\n{{/types}}\n");
  folder.write("a.st.mustache", "{{plant}}");
  folder.write(".hidden", "");
  const Emitted result = emitted(compiled.plant(), compiled.tables(), {folder.path()});
  CHECK(result.errors.empty());
  CHECK(file_of(result, "a.st") == "symbols");
  CHECK(file_of(result, "b.puml") == "@startuml D\n");
  CHECK(result.files.size() == 10);
  CHECK(result.inputs.size() == 2);
  folder.write("notes.txt", "");
  const Emitted refused = emitted(compiled.plant(), compiled.tables(), {folder.path()});
  REQUIRE(refused.errors.size() == 1);
  CHECK(
      contains(refused.errors[0], "notes.txt: not a template, so it would not be used: name it `notes.txt.mustache`"));
}

TEST_CASE("An unclosed tag is reported with its line") { CHECK(with_template("\n\n{{plant").find(":3: ") == 0); }

TEST_CASE("A list that is not closed, or closed without being open, is reported with its line") {
  CHECK(with_template("\n{{#types}}").find(":2: `types` is opened and not closed") == 0);
  CHECK(with_template("\n\n{{/types}}").find(":3: `{{/types}}` closes a list that is not open") == 0);
  CHECK(with_template("{{#types}}\n{{#states}}\n{{/types}}{{/states}}").find(":3: ") == 0);
}

}  // namespace
}  // namespace symplant::test
