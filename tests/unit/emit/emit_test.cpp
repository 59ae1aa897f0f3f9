// The plant as C++ files: the same bytes each time, and the elements of the paper.
#include "emit_support.hpp"

namespace symplant::test {
namespace {

std::string excell() { return read_bytes(kSource + "/examples/excell/excell.csv"); }

TEST_CASE("The generated files of the paper's cell equal the goldens") {
  for (const Emitted::File& file : emit_list(excell(), "excell.csv").files) {
    check_golden(kSource + "/tests/golden/emit/excell/" + file.name, file.content);
  }
}

TEST_CASE("Equal lists give equal bytes") {
  const Emitted a = emit_list(excell(), "excell.csv");
  const Emitted b = emit_list(excell(), "excell.csv");
  REQUIRE(a.files.size() == 8);
  for (std::size_t i = 0; i < a.files.size(); ++i) CHECK(a.files[i].content == b.files[i].content);
}

TEST_CASE("The path of the list is not in the files") {
  const Emitted here = emit_list(excell(), "excell.csv");
  const Emitted there = emit_list(excell(), "/some/where/else/excell.csv");
  for (std::size_t i = 0; i < here.files.size(); ++i) CHECK(here.files[i].content == there.files[i].content);
}

TEST_CASE("Every file has a notice of ownership and a note to regenerate it") {
  for (const Emitted::File& file : emit_list(excell(), "excell.csv").files) {
    INFO(file.name);
    CHECK(contains(file.content, "Do not edit: regenerate it."));
    CHECK(contains(file.content, "This code is yours: the license of symplant does not extend to what it generates."));
  }
}

TEST_CASE("A class has the eight elements by the paper's names, each signal with its list and row") {
  const std::string types = file_of(emit_list(excell(), "excell.csv"), "types_gen.hpp");
  for (const char* part : {"enum class State", "kI{", "kO{", "kS{", "d_ext(", "d_int(", "l_enter(", "l_leave(",
                           "l_disable(", "excell.csv:4"}) {
    INFO(part);
    CHECK(contains(types, part));
  }
}

TEST_CASE("Many devices of one type make one class that names the first twenty") {
  std::vector<std::string> names;
  for (int i = 0; i < 30; ++i) {
    const std::string path = "L_P_RBT" + std::to_string(i);
    for (const char* task : {"_O_A1", "_I_A1", "_O_B2", "_I_B2"}) names.push_back(path + task);
  }
  const std::string types = file_of(emit_list(list_text(bits(names)), "many.csv"), "types_gen.hpp");
  CHECK(types.find("class RBT : public symplant::tables::IoModel {") != std::string::npos);
  CHECK(types.find("\nclass ") == types.rfind("\nclass "));
  CHECK(contains(types, "/// L_P_RBT19\n/// and 10 more\n"));
}

TEST_CASE("A plant of numbers only, or of unmodelled symbols only, is generated, too") {
  CHECK(emit_list(list_text({{"LEVEL", "", "INT", "-5", "%IW1"}}), "numbers.csv").errors.empty());
  CHECK(emit_list(list_text({{"START", "X1"}}), "one.csv").errors.empty());
}

}  // namespace
}  // namespace symplant::test
