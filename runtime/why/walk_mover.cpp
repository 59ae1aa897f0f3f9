// Why transfers, work and sources of parts do nothing.
#include <fmt/format.h>

#include "symplant/trace/finding_words.hpp"
#include "symplant/why/walk.hpp"

namespace symplant::why {

Explanation Walk::transfer(std::uint32_t transfer) {
  const tables::TransferRow& row = tables_.material.transfers[transfer];
  const Reference self{Reference::Kind::transfer, transfer};
  Explanation result{fmt::format("transfer `{}` moves no part from {} to {}", names_.transfer(transfer),
                                 place_words(row.from), place_words(row.to)),
                     {self},
                     {}};
  if (is_mentioned(self, result)) return result;
  const Level level(*this, self);
  const auto known = view_.transfer(transfer);
  if (known && known->frozen) {
    result.sentence += ": it is in an instantaneous loop, and stays frozen until the run ends";
    return result;
  }
  if (row.condition != tables::kNone && add_need(result, ": `when`", index_.conditions.network(row.condition))) {
    return result;
  }
  const bool is_empty = known ? known->part == 0 : view_.parts(row.from.location).empty();
  const auto explain = [this](std::uint32_t of) { return location(of); };
  if (known && known->spent) {
    result.sentence += ": it has moved one, and moves another one after `when` has begun to hold again";
  } else if (is_empty) {
    result.sentence += ": no part is there";
    append(result.because, causes(std::vector{row.from.location}, explain));
  } else if (known && known->obstacle != 0) {
    result.sentence += fmt::format(": part {} leaves no room", known->obstacle);
    append(result.because, causes(std::vector{row.to.location}, explain));
  }
  return result;
}

Explanation Walk::work(std::uint32_t work) {
  const tables::WorkRow& row = tables_.material.work[work];
  const Reference self{Reference::Kind::work, work};
  Explanation result{fmt::format("work `{}` makes {} of {} at {} when its `when` begins to hold", names_.work(work),
                                 names_.part_kind(row.to), names_.part_kind(row.from), place_words(row.at)),
                     {self},
                     {}};
  const Level level(*this, self);
  if (add_need(result, ": that", index_.conditions.network(row.condition))) return result;
  result.sentence += ": it holds already";
  append(result.because, causes(std::vector{row.at.location}, [this](std::uint32_t of) { return location(of); }));
  return result;
}

Explanation Walk::source(std::uint32_t source) {
  const tables::SourceRow& row = tables_.material.sources[source];
  const Reference self{Reference::Kind::source, source};
  Explanation result{
      fmt::format("source `{}` makes no part at {}", names_.source(source), place_words(row.to)), {self}, {}};
  if (is_mentioned(self, result)) return result;
  const Level level(*this, self);
  const auto known = view_.source(source);
  if (known && known->due == tables::kNever) {
    result.sentence += fmt::format(": it has made all of its parts, {}", known->made);
  } else if (row.condition != tables::kNone && add_need(result, ": `when`", index_.conditions.network(row.condition))) {
    return result;
  } else if (known && known->due > view_.now()) {
    result.sentence += fmt::format(": the next one is due at {}", trace::seconds(known->due));
  } else if (known) {
    result.sentence += ": there is no room";
    append(result.because, causes(std::vector{row.to.location}, [this](std::uint32_t of) { return location(of); }));
  }
  return result;
}

}  // namespace symplant::why
