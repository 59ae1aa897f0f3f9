// Every table of the engine as generated code.
#include "dosing.hpp"
#include "emit/encode.hpp"
#include "emit/model_text.hpp"
#include "emit/row_writer.hpp"
#include "emit_support.hpp"
#include "everything.hpp"
#include "lower/lower.hpp"

namespace symplant::test {
namespace {

Emitted emit_model(const model::PlantModel& plant) { return emitted(plant, lower::lower(plant)); }

TEST_CASE("Rows passed on in chunks equal the stored rows, wherever the chunks end") {
  class Parts final : public base::TextSink {
   public:
    void put(std::string_view part) override {
      ++count;
      text.append(part);
    }
    std::string text;
    int count = 0;
  } parts;
  const auto write = [](emit::RowWriter& rows) {
    for (int i = 0; i < 100'000; ++i) rows.text("?").comment("?/a?\\\xC3\xA4").literal("b?\"").number(i).text("\n");
    rows.comment(std::string(1'000'000, '?')).text("\n");
  };
  emit::RowWriter kept;
  write(kept);
  emit::RowWriter handed_on(parts);
  write(handed_on);
  handed_on.finish();
  CHECK(parts.count > 10);
  CHECK((parts.text == kept.take()));
}

TEST_CASE("The generated files of a plant with rows in every table equal the compiled goldens") {
  for (const Emitted::File& file : emit_model(everything()->plant).files) {
    check_golden(kSource + "/tests/golden/emit/everything/" + file.name, file.content);
  }
}

TEST_CASE("The generated files of a plant with behaviors equal the goldens, compiled with the user classes") {
  const CompiledText text = dosing();
  REQUIRE(text.compiled);
  const Emitted result = emit_model(text.plant());
  for (const Emitted::File& file : result.files) {
    check_golden(kSource + "/tests/golden/emit/dosing/" + file.name, file.content);
  }
  REQUIRE(result.own_files.size() == 1);
  CHECK(result.own_files[0].name == "WeighingScale_behavior.hpp");
  check_golden(kSource + "/tests/golden/emit/dosing/own/" + result.own_files[0].name, result.own_files[0].content);
}

TEST_CASE("Tables without rows are omitted") {
  const std::string tables =
      file_of(emit_list(list_text(bits({"L_P_D_O_A1", "L_P_D_I_A1"})), "a.csv"), "tables_gen.cpp");
  for (const char* table : {"kRandomTimes", "kInitialValues", "kSharedAddresses", "kDisables", "kConditions", "Watch",
                            "kRequirement", "kBehaviour", "plant.disables", "plant.requirement_names"}) {
    INFO(table);
    CHECK_FALSE(contains(tables, table));
  }
}

TEST_CASE("Rows have comments about their content, conditions as in a description") {
  const std::string tables = file_of(emit_model(everything()->plant), "tables_gen.cpp");
  for (const char* row : {
           "// -1: L_P_AGV, d_ext(P2, O_P1) = P1\n",
           "// l_disable of L_P_MC in RUN2: L_P_STOPPER\n",
           "// 0: L_P_MC, d_ext(IDLE1, O_RUN2) = RUN2: L_P_AGV.P2 and not (L_P_STOPPER.moving or 'STOP?<U+003F>/')\n",
           "// 1: L_P_MC, d_int(RUN2) = IDLE1: LEVEL < -5 or SPEED >= 1.5\n",
           "// 2: L_P_STOPPER, input part<U+000A>: L_P_AGV_O_P1 and ",
           "// 4: answers, after: L_P_AGV.P2\n",
           "// 5: answers, expect: L_P_MC.RUN2\n",
           " of condition 2\n",
           "// L_P_STOPPER.moving\n",
           "// HALT<U+005C> follows STOP?<U+003F>/\n",
           "// LEVEL < -5\n",
           "// L_P_STOPPER, MyStopper<U+005C>\n",
       }) {
    INFO(row);
    CHECK(contains(tables, row));
  }
}

TEST_CASE("A class documents the conditions of its transitions and the events that its states switch") {
  const std::string types = file_of(emit_model(everything()->plant), "types_gen.hpp");
  for (const char* row : {
           "if (x == Operation::O_P2) return go(State::P2, dt_to_P2).once();\n",
           "if (x == Operation::O_RUN2) return go(State::RUN2, dt_to_RUN2).when(Guard::to_RUN2);\n",
           "    to_RUN2,  // when: L_P_AGV.P2 and not (L_P_STOPPER.moving or 'STOP?<U+003F>/')\n",
           "case State::RUN2: return go(State::IDLE1, dt_to_IDLE1).when(Guard::to_IDLE1);\n",
           "static constexpr Moves spring_return(State a) noexcept {",
           "case State::RUN2: return on(Event::I_RUN2, Event::I_BUSY3);\n",
           "case State::RUN2: return off(Event::I_RUN2, Event::I_BUSY3);\n",
       }) {
    INFO(row);
    CHECK(contains(types, row));
  }
}

TEST_CASE("A class has the name from the description, before any device gets that name") {
  model::PlantModel plant = model_of({"L_P_STOP_O_A1", "L_P_STOP_I_A1", "L_P_D_O_B1", "L_P_D_I_B1", "L_P_E_I_ON"});
  description::DeviceDescription described;
  described.type = "STOP";
  plant.units[1].described = &described;
  plant.units[2].described = &described;
  const std::string types = file_of(emit_model(plant), "types_gen.hpp");
  CHECK(contains(types, "/// L_P_STOP\nclass STOP_3 : "));
  CHECK(contains(types, "/// L_P_D\nclass STOP : "));
  CHECK(contains(types, "/// L_P_E\nclass STOP_2 : "));
}

TEST_CASE("A very long condition is cut between two characters") {
  model::PlantModel plant = model_of({"L_P_\xC3\x84\xC3\x96\xC3\x9C_I_\xC3\xA4"});
  Tree tree{Tree::Kind::any, false, {}, {}};
  for (int i = 0; i < 1000; ++i) tree.children.push_back(settled(0, 1));
  for (int shift = 0; shift < 2; ++shift) {
    const std::string text = emit::short_condition_text(shift == 0 ? tree : !tree, plant);
    CHECK(text.size() < 180);
    CHECK(text.ends_with(" ..."));
    const std::string comment = emit::comment_text(text);
    CHECK_FALSE(contains(comment, "<U+FFFD>"));
  }
}

}  // namespace
}  // namespace symplant::test
