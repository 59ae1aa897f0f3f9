// The order of pairing: links, archetypes, words, data, then what nothing links.
#include "pairing/pairing.hpp"

#include <utility>

#include "pairing/work.hpp"

namespace symplant::pairing {

Pairing pair(const name::CompiledNaming& naming, std::span<const Input> inputs, Extent extent) {
  Work work(naming, inputs);
  pair_by_links(work);
  set_repeated_texts_aside(work);
  pair_by_archetypes(work);
  pair_by_words(work);
  set_weights_aside(work);
  account_for_rest(work);
  if (extent == Extent::devices) add_unlinked(work);
  finish(work);
  return std::move(work.result);
}

}  // namespace symplant::pairing
