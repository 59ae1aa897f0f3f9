// Formulas as compiled code give the bits of the formulas that `symplant run` works out, and yours replace them.
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "compiled_formulas/plant_gen.hpp"
#include "compiled_tank/plant_gen.hpp"
#include "support/catch.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/tables/formula.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::test {
namespace {

/// Mostly numbers of a plant, some that are special.
double random_number(std::mt19937_64& random) {
  static constexpr double kSpecial[] = {0.0,
                                        -0.0,
                                        1.0,
                                        -1.0,
                                        1e308,
                                        5e-324,
                                        std::numeric_limits<double>::infinity(),
                                        std::numeric_limits<double>::quiet_NaN()};
  if (random() % 16 == 0) return kSpecial[random() % std::size(kSpecial)];
  return std::uniform_real_distribution<double>(-20, 20)(random);
}

bool same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST_CASE("Compiled formulas give the bits of those that are worked out") {
  const tables::ValueTables& values = formulas::tables().values;
  const auto texts = tables::split_names(values.formula_texts);
  REQUIRE(values.formulas.size() == 15);
  REQUIRE(values.compiled.size() == values.formulas.size());
  std::mt19937_64 random(42);
  std::size_t without_function = 0;
  for (std::size_t f = 0; f < values.formulas.size(); ++f) {
    INFO(texts[f]);
    if (values.compiled[f].call == nullptr) {  // that of the position
      ++without_function;
      continue;
    }
    CHECK(!values.compiled[f].replaced);
    const tables::FormulaRow& row = values.formulas[f];
    std::vector<std::uint32_t> slots(row.inputs.count);
    std::iota(slots.begin(), slots.end(), 0);
    std::size_t different = 0;
    for (int i = 0; i < 20'000; ++i) {
      std::vector<double> inputs(row.inputs.count);
      for (double& input : inputs) input = random_number(random);
      const double wanted =
          tables::evaluate(values.steps.subspan(row.steps.first, row.steps.count), values.numbers, inputs.data());
      if (!same(values.compiled[f].call(inputs.data(), slots.data()), wanted)) ++different;
    }
    CHECK(different == 0);
  }
  CHECK(without_function == 1);
}

TEST_CASE("The formula of docs/behaviours.md replaces that of the tank, which is then another model") {
  tank::Plant plant;
  plant.advance_to(0);
  CHECK(plant.set_level(4));
  plant.set(tank::Symbol::PLANT_T1_VALVE_O_OPEN, true);
  plant.advance_to(tables::kMillisecond);
  plant.advance_to(tables::kSecond);
  CHECK(plant.level() < 4);
  CHECK(same(plant.outflow(), 0.3 * std::sqrt(plant.level()) / 2));
  CHECK(plant.set_level(64));
  plant.advance_to(1010 * tables::kMillisecond);
  CHECK(same(plant.outflow(), 0.3 * std::sqrt(plant.level())));

  tables::PlantTables model = tank::tables();
  CHECK(model.values.compiled.size() > 1);
  model.values.compiled = {};
  CHECK(tables::model_hash(model) != plant.model_hash());
}

}  // namespace
}  // namespace symplant::test
