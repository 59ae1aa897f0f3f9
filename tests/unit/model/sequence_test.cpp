// Sequence numbers and the order of S.
#include "model/sequence.hpp"

#include "model_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("The decimal digits at a task's end are its sequence number") {
  CHECK(model::sequence_number("RUN2") == "2");
  CHECK(model::sequence_number("P10") == "10");
  CHECK(model::sequence_number("P") == "");
  CHECK(model::sequence_number("2P") == "");
  CHECK(model::sequence_number("P2X3") == "3");
  CHECK(model::sequence_number("42") == "42");
  CHECK(model::sequence_number("P007") == "7");
  CHECK(model::sequence_number("P000") == "0");
}

TEST_CASE("Sequence numbers of 30 digits are compared as numbers") {
  const std::string less = "P99999999999999999999999999999";
  const std::string more = "P100000000000000000000000000000";
  const auto compare = [](std::string_view a, std::string_view b) {
    return model::compare_sequence(model::sequence_number(a), model::sequence_number(b));
  };
  CHECK(compare(less, more) < 0);
  CHECK(compare(more, less) > 0);
  CHECK(compare("P2", "P10") < 0);
  CHECK(compare("A007", "B7") == 0);
  CHECK(compare("A0", "A1") < 0);
  CHECK(compare("A0000000000000000000000000000001", "A2") < 0);
}

TEST_CASE("S is sorted by sequence number, for any order of rows") {
  const Analysed list = analyse_rows(bits({"L_P_D_I_C10", "L_P_D_O_C10", "L_P_D_I_B2", "L_P_D_O_B2", "L_P_D_I_A1"}));
  CHECK(states_text(unit_of(list)) == "A1 B2 C10");
}

TEST_CASE("S is sorted by numbers of 30 digits, too") {
  const Analysed list =
      analyse_rows(bits({"L_P_D_I_B100000000000000000000000000000", "L_P_D_I_A99999999999999999999999999999",
                         "L_P_D_I_C000000000000000000000000000001"}));
  CHECK(states_text(unit_of(list)) ==
        "C000000000000000000000000000001 A99999999999999999999999999999 B100000000000000000000000000000");
}

TEST_CASE("Numbered states precede those without a number, which are sorted by first row") {
  const Analysed list = analyse_rows(bits({"L_P_D_I_Z", "L_P_D_I_A", "L_P_D_O_M", "L_P_D_I_R2", "L_P_D_O_Q1"}));
  CHECK(states_text(unit_of(list)) == "Q1 R2 Z A M");
}

TEST_CASE("Equal numbers are sorted by first row, of operation or event") {
  const Analysed list = analyse_rows(bits({"L_P_D_O_B2", "L_P_D_I_A02", "L_P_D_I_C2", "L_P_D_I_B2", "L_P_D_I_X1"}));
  CHECK(states_text(unit_of(list)) == "X1 B2 A02 C2");
  const Analysed other = analyse_rows(bits({"L_P_D_I_C2", "L_P_D_O_B2", "L_P_D_O_C2", "L_P_D_I_B2", "L_P_D_I_X1"}));
  CHECK(states_text(unit_of(other)) == "X1 C2 B2");
}

TEST_CASE("A state keeps the digits of its name") {
  const Analysed list = analyse_rows(bits({"L_P_D_O_RUN02", "L_P_D_I_RUN02", "L_P_D_I_IDLE01", "L_P_D_O_IDLE01"}));
  CHECK(states_text(unit_of(list)) == "IDLE01 RUN02");
}

TEST_CASE("Tasks of only digits are numbered states") {
  const Analysed list = analyse_rows(bits({"L_P_D_O_2", "L_P_D_I_2", "L_P_D_I_1", "L_P_D_O_1"}));
  CHECK(states_text(unit_of(list)) == "1 2");
  CHECK(initial_text(unit_of(list)) == "1");
}

}  // namespace
}  // namespace symplant::test
