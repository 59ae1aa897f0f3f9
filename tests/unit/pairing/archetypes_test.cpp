// Facets by archetypes.
#include <string>
#include <vector>

#include "unit/pairing/pairing_support.hpp"

namespace symplant::pairing {
namespace {

using name::ArchetypeModel;
using name::ArchetypeRole;

name::Naming with(std::vector<name::Archetype> archetypes) {
  name::Naming naming = naming_of("{device}_{task...}");
  naming.archetypes = std::move(archetypes);
  return naming;
}

name::Archetype echo() {
  return {"echo", ArchetypeModel::mirror, {{ArchetypeRole::operation, "{x}"}, {ArchetypeRole::event, "{x} ECHO"}}};
}

TEST_CASE("An archetype makes a facet for each {x}") {
  const Paired paired(with({echo()}),
                      {"Q RB1_GO", "I RB1_GO ECHO", "Q RB1_STYLE A", "I RB1_STYLE A ECHO", "I RB2_GO ECHO"});
  CHECK(paired.facets() ==
        "RB1.echo_GO: RB1_GO>ON RB1_GO ECHO<ON | RB1.echo_STYLE_A: RB1_STYLE A>ON RB1_STYLE A ECHO<ON");
  CHECK(paired.of(name::Account::no_operation) == "RB2_GO ECHO");
}

TEST_CASE("Archetypes take symbols in their order, before tasks") {
  name::Archetype work{
      "work", ArchetypeModel::handshake, {{ArchetypeRole::start, "GO"}, {ArchetypeRole::done, "READY"}}};
  CHECK(Paired(with({work, echo()}), {"Q RB1_GO", "I RB1_GO ECHO", "I RB1_READY", "I RB1_GO"}).facets() ==
        "RB1.work: RB1_GO>RUN RB1_READY<DONE");
  CHECK(Paired(with({echo(), work}), {"Q RB1_GO", "I RB1_GO ECHO", "I RB1_READY", "I RB1_GO"}).facets() ==
        "RB1.echo_GO: RB1_GO>ON RB1_GO ECHO<ON");
}

TEST_CASE("Of several symbols for a role the first counts, and the others are reported") {
  name::Archetype work{
      "work", ArchetypeModel::handshake, {{ArchetypeRole::start, "GO"}, {ArchetypeRole::done, "READY|DONE"}}};
  const Paired paired(with({work}), {"Q RB1_GO", "I RB1_READY", "I RB1_DONE"});
  CHECK(paired.facets() == "RB1.work: RB1_GO>RUN RB1_READY<DONE");
  REQUIRE(paired.pairing.remarks.size() == 1);
  CHECK(paired.pairing.remarks[0].kind == Remark::Kind::role_taken);
  CHECK(paired.pairing.remarks[0].input == 2);
  CHECK(paired.pairing.remarks[0].other == 1);
}

TEST_CASE("An event may have several roles") {
  name::Archetype work{
      "work",
      ArchetypeModel::handshake,
      {{ArchetypeRole::start, "GO"}, {ArchetypeRole::busy, "ON JOB"}, {ArchetypeRole::done, "ON JOB"}}};
  const Paired paired(with({work}), {"Q RB1_GO", "I RB1_ON JOB"});
  CHECK(paired.facets() == "RB1.work: RB1_GO>RUN RB1_ON JOB<RUN");
  REQUIRE(paired.facet(0).base->outputs.size() == 1);
  CHECK(paired.facet(0).base->outputs[0].state == "DONE");
}

TEST_CASE("A constant keeps its value and needs no operation") {
  name::Archetype healthy{"healthy", ArchetypeModel::constant, {{ArchetypeRole::event, "*AIR OK*|*E STOP*"}}};
  const Paired paired(with({healthy}), {"I RB1_AIR OK", "I RB1_E STOP", "Q RB1_AIR OK"});
  CHECK(paired.facets().empty());
  CHECK(paired.of(name::Account::constant) == "RB1_AIR OK RB1_E STOP");
  CHECK(paired.pairing.constant_on[0]);
}

TEST_CASE("With one command a device of two positions returns by a spring") {
  name::Archetype lift{"lift",
                       ArchetypeModel::two_position,
                       {{ArchetypeRole::b, "RAISE"}, {ArchetypeRole::at_a, "LOW"}, {ArchetypeRole::at_b, "HIGH"}}};
  const Paired paired(with({lift}), {"Q T_RAISE", "I T_LOW", "I T_HIGH"});
  CHECK(paired.facets() == "T.lift: T_RAISE>B T_LOW<A T_HIGH<B");
  CHECK(paired.facet(0).base->actuation == tables::Actuation::spring);
  CHECK(paired.facet(0).base->rest == "A");
}

}  // namespace
}  // namespace symplant::pairing
