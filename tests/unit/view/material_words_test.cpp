// Tests of the lines that describe a material flow.
#include "elements/material/words.hpp"
#include "view_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("Lengths are shown in the largest unit that leaves no zero before the point") {
  CHECK(view::length_text(0) == "0 mm");
  CHECK(view::length_text(7) == "7 um");
  CHECK(view::length_text(1'500) == "1.5 mm");
  CHECK(view::length_text(20'000) == "20 mm");
  CHECK(view::length_text(3'500'000) == "3.5 m");
}

TEST_CASE("A plant without material has no lines") { CHECK(view::material_lines(described_cell().plant()).empty()); }

TEST_CASE("Every element of a material flow is a line, with its conditions") {
  const CompiledText made = plant_with_material();
  CHECK(view::material_lines(made.plant()) ==
        std::vector<std::string>{"kind raw: 200 mm, code 1", "kind done: 200 mm", "track CV1: 2 m, gap 10 mm",
                                 "  drive up to 1 m, 400 mm/s, forward when L_P_CV.RUN",
                                 "  drive up to 2 m, L_P_CV_O_SPEED times 10 mm/s, backward when L_P_CV.RUN",
                                 "  stop at 500 mm, when L_P_CV.RUN",
                                 "  sensor at 300 mm: L_P_PE_I_ON, sees raw, inverted", "  end: FIX, when L_P_CV.RUN",
                                 "  end: out", "place FIX: holds 2", "  sensor L_P_NR_I_CODE, reads the number",
                                 "transfer pick: CV1@1 m to out, when L_P_CV.RUN, once",
                                 "work mill: raw to done at FIX, when L_P_CV.RUN",
                                 "source feed: raw at CV1, every 1 s, first at 1 s, at most 3"});
}

}  // namespace
}  // namespace symplant::test
