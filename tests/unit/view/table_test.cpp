// The table: which parts of a model it shows.
#include "view_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("The table shows everything in a description") {
  const std::string table = render(described_cell(), "table").text;
  for (const char* row : {
           "L_P_AGV: latched, starts in P1 (as the description says)\n",
           "L_Q_STOPPER1: spring, starts in RET (its rest state), returns to RET\n",
           "inferred: one operation and two events: a single solenoid\n",
           "DOCK: no symbol\n",
           "(P1, O_P2) -> P2, takes 2 s  [given]\n",
           "(P2, O_P1) -> P1, takes 1.8 s to 2.2 s  [given]\n",
           "(P2, O_CHARGE, once) -> DOCK, takes 4 s (sigma 100 ms)  [given]\n",
           "(P1, O_CHARGE) -> P2, when not (L_P_MC.RUN2 or L_Q_DOOR.OPEN1) and LEVEL < 2.5, takes 1 s  [given]\n",
           "(RUN2, by itself) -> IDLE1, after 5 s  [given]\n",
           "(ADV, spring) -> RET, takes 800 ms  [given]\n",
           "DOCK: I_BUSY on\n",
           "DOCK: I_BUSY off\n",
           "RUN2: L_P_AGV, L_Q_DOOR\n",
           "disabled by L_P_MC.RUN2\n",
           "behaviour   MyStopper\n",
           "input part: L_P_AGV.P2 and not L_P_AGV.moving\n",
           "value L_Q_STOPPER1_I_WEIGHT\n",
           "required    no machining without part\n",
           "no machining without part: never L_P_MC.RUN2 and not L_P_AGV.P2\n",
           "machine starts: after L_P_AGV.P2, expect L_P_MC_O_RUN2 within 500 ms\n",
           "5 devices, 31 I/O symbols, 3 of them in no device\n",
           "  2: numeric: states come from BOOL symbols only\n",
           "  1: its name does not follow the naming rule\n",
       }) {
    INFO(row);
    CHECK(contains(table, row));
  }
}

TEST_CASE("The table shows how a spring returns, also without a description") {
  const std::string table = render(compile_rows(bits({"L_P_C_O_ADV", "L_P_C_I_ADV", "L_P_C_I_RET"})), "table").text;
  CHECK(contains(table, "spring      (ADV) -> RET, takes 1 s\n"));
}

TEST_CASE("The table shows conditions about parts, and counts the symbols of sensors") {
  const std::string table = render(cell_with_parts(), "table").text;
  CHECK(contains(table, "P.part and not P.parts > 1 or P.raw"));
  CHECK(contains(table, "never empty: never P.parts = 0 or P.parts < 0\n"));
  CHECK(contains(table, "  1: driven by a sensor of parts\n"));
}

TEST_CASE("Every format accepts a plant with parts") {
  for (const view::Format& format : view::formats()) {
    INFO(format.name);
    CHECK_FALSE(render(cell_with_parts(), format.name).text.empty());
  }
}

TEST_CASE("No name sends a control character to the terminal") {
  const std::string table = render(hostile_cell(), "table").text;
  CHECK(contains(table, "]]>--\\N;<U+202E>%%<U+000A>"));
  CHECK_FALSE(contains(table, "\xE2\x80\xAE"));
}

}  // namespace
}  // namespace symplant::test
