// Resolves transfers, work and sources.
#include "elements/material/moves.hpp"

#include <utility>

#include "text/ascii.hpp"

namespace symplant::model {
namespace {

using description::Pointer;
using description::ticked;

/// An entry that is left out takes no name.
void take_name(const std::string& name, const Pointer& here, MaterialLookup& lookup, TakenNames& taken) {
  if (!lookup.lacking().empty() || name.empty() || taken.insert(text::to_upper(name)).second) return;
  lookup.faults().add(here / "name",
                      ticked(name) + " already names another entry of this list; " +
                          (lookup.made_for_device() ? "use `{self}` in the name" : "choose another name"));
}

}  // namespace

Transfer resolve_transfer(const description::GivenTransfer& given, const MadeBy& by, MaterialLookup& lookup,
                          TakenNames& taken) {
  const Pointer here = lookup.begin("transfers", by);
  Transfer transfer;
  transfer.name = given.name;
  transfer.from = lookup.location(given.from, here / "from");
  transfer.to = lookup.target(given.to, here / "to");
  transfer.condition = lookup.condition(given.when, here / "when");
  transfer.once = given.once;
  transfer.given = by.given;
  if (transfer.from.location != tables::kOut && transfer.from == transfer.to) {
    lookup.faults().add(here / "to",
                        "this transfer moves parts from " + ticked(given.from) + " to itself; write another location");
  }
  take_name(given.name, here, lookup, taken);
  return transfer;
}

Work resolve_work(const description::GivenWork& given, const MadeBy& by, MaterialLookup& lookup, TakenNames& taken) {
  const Pointer here = lookup.begin("work", by);
  Work work;
  work.name = given.name;
  work.at = lookup.location(given.at, here / "at");
  lookup.condition(given.when, here / "when", work.condition);
  work.from = lookup.kind(given.from, here / "from");
  work.to = lookup.kind(given.to, here / "to");
  work.given = by.given;
  const std::vector<PartKind>& kinds = lookup.plant().material.kinds;
  if (work.from != kNone && work.to != kNone && kinds[work.from].length != kinds[work.to].length) {
    lookup.faults().add(here / "to", ticked(given.to) + " and " + ticked(given.from) +
                                         " have different lengths; work cannot change the length of a part");
  }
  take_name(given.name, here, lookup, taken);
  return work;
}

Source resolve_source(const description::GivenSource& given, const MadeBy& by, MaterialLookup& lookup,
                      TakenNames& taken) {
  const Pointer here = lookup.begin("sources", by);
  Source source;
  source.name = given.name;
  source.to = lookup.location(given.at, here / "at");
  for (std::size_t i = 0; i < given.kinds.size(); ++i) {
    source.kinds.push_back(lookup.kind(given.kinds[i], here / "kind" / i));
  }
  source.every = given.every;
  source.first = given.first;
  source.count = given.count;
  source.condition = lookup.condition(given.when, here / "when");
  source.given = by.given;
  take_name(given.name, here, lookup, taken);
  return source;
}

}  // namespace symplant::model
