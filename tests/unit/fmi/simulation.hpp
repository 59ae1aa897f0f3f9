// An instance of a described plant, with its variables by name.
#pragma once

#include <string>
#include <vector>

#include "support/described_plant.hpp"
#include "symplant/fmi/instance.hpp"
#include "symplant/fmi/variables.hpp"

namespace symplant::test {

class Simulation {
 public:
  Simulation(const std::vector<Row>& list, const std::string& members)
      : described(list, members), variables(described.rows), instance({described.rows, {}, variables}) {}

  std::uint32_t index(const std::string& name) const {
    for (std::uint32_t v = 0; v < variables.all().size(); ++v) {
      if (variables.all()[v].name == name) return v;
    }
    FAIL("no variable " << name);
    return 0;
  }
  const fmi::Variable& variable(const std::string& name) const { return variables.all()[index(name)]; }
  bool has(const std::string& name) const {
    for (const fmi::Variable& variable : variables.all()) {
      if (variable.name == name) return true;
    }
    return false;
  }
  double get(const std::string& name) const {
    const std::uint32_t v = index(name);
    return variables.all()[v].type == fmi::BaseType::real ? instance.real(v) : instance.integer(v);
  }
  fmi::Fault try_set(const std::string& name, double number) {
    const std::uint32_t v = index(name);
    return variables.all()[v].type == fmi::BaseType::real ? instance.set_real(v, number)
                                                          : instance.set_integer(v, static_cast<int>(number));
  }
  Simulation& set(const std::string& name, double number) {
    CHECK(try_set(name, number).empty());
    return *this;
  }
  /// A step from where the last one ended, in ms.
  Simulation& step(double milliseconds) {
    CHECK(instance.step(instance.time(), milliseconds / 1000).empty());
    return *this;
  }

  DescribedPlant described;
  fmi::Variables variables;
  fmi::Instance instance;
};

}  // namespace symplant::test
