// Facets by the rows of links.
#include <string>
#include <vector>

#include "unit/pairing/pairing_support.hpp"

namespace symplant::pairing {
namespace {

name::Naming linked(std::vector<name::NamedLink> links) {
  name::Naming naming = naming_of("{process}_{device}_{task}");
  naming.links = std::move(links);
  return naming;
}

TEST_CASE("A link says which state an operation leads to and which event reports it") {
  const Paired paired(linked({{"KA1", "S1_TBL_HOME", "HOME"}, {"", "b2", "AWAY"}}),
                      {"Q KA1", "I S1_TBL_HOME", "I B2", "I B3"});
  CHECK(paired.facets() == "S1_TBL: KA1>HOME S1_TBL_HOME<HOME B2<AWAY");
  CHECK(paired.facet(0).by == FacetBy::links);
  CHECK(paired.facet(0).base->rest == "AWAY");
  CHECK(paired.of(name::Account::no_rule) == "B3");
}

TEST_CASE("Without a device that a rule reads, the operation is the device") {
  CHECK(Paired(linked({{"KA1", "B1", "UP"}}), {"Q KA1", "I B1"}).facets() == "KA1: KA1>UP B1<UP");
}

TEST_CASE("Links have priority over tasks") {
  const Paired paired(linked({{"S1_TBL_ADV", "B1", "UP"}}), {"Q S1_TBL_ADV", "I S1_TBL_ADV", "I B1"});
  CHECK(paired.facets() == "S1_TBL: S1_TBL_ADV>UP B1<UP");
  CHECK(paired.of(name::Account::no_operation) == "S1_TBL_ADV");
}

TEST_CASE("An event may report several states of its device") {
  const Paired paired(linked({{"KA1", "B1", "UP"}, {"KA2", "B2", "DOWN"}, {"", "B1", "MIDDLE"}, {"KA1", "B1", "UP"}}),
                      {"Q KA1", "Q KA2", "I B1", "I B2"});
  CHECK(paired.facets() == "KA1: KA1>UP B1<UP | KA2: KA2>DOWN B2<DOWN");
  REQUIRE(paired.pairing.remarks.size() == 1);
  CHECK(paired.pairing.remarks[0].kind == Remark::Kind::link_repeated);
  const Paired one(linked({{"KA1", "B1", "UP"}, {"", "B1", "MIDDLE"}}), {"Q KA1", "I B1"});
  CHECK(one.facets() == "KA1: KA1>UP B1<UP");
  CHECK(one.facet(0).states == std::vector<std::string>{"UP", "MIDDLE"});
  CHECK(one.facet(0).base->states == std::vector<std::string>{"MIDDLE"});
  REQUIRE(one.facet(0).base->outputs.size() == 1);
  CHECK(one.facet(0).base->outputs[0].state == "MIDDLE");
}

TEST_CASE("A link with a symbol that is missing or on the other side is reported") {
  const Paired paired(linked({{"KA1", "B1", "UP"}, {"KA2", "KA1", "UP"}, {"B1", "B1", "UP"}}), {"Q KA1", "I B1"});
  REQUIRE(paired.pairing.remarks.size() == 3);
  CHECK(paired.pairing.remarks[0].kind == Remark::Kind::link_side);
  CHECK(paired.pairing.remarks[0].link == 1);
  CHECK(paired.pairing.remarks[1].kind == Remark::Kind::link_unknown);
  CHECK(paired.pairing.remarks[2].kind == Remark::Kind::link_side);
  CHECK(paired.pairing.remarks[2].link == 2);
}

}  // namespace
}  // namespace symplant::pairing
