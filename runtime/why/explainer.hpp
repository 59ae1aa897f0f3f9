// Explains in words why a device, a symbol or a part of a plant is as it is.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <string_view>
#include <vector>

#include "symplant/condition/tree.hpp"
#include "symplant/engine/behaviour.hpp"
#include "symplant/why/explanation.hpp"
#include "symplant/why/state_view.hpp"

namespace symplant::why {

struct PlantIndex;

/// The things of a plant with a name: a device, a facet or all facets of a device, a symbol, a requirement, a track, a
/// place, a transfer, work, a source. Names compare without regard to the case of ASCII letters. O(plant).
std::vector<Reference> things_named(std::string_view name, const trace::PlantNames& names);
/// The nearest such name; empty if none is near. O(plant).
std::string nearest_thing(std::string_view name, const trace::PlantNames& names);

/// An explanation is at most six levels deep. A level has at most twelve sentences and then how many more there are. A
/// cause that is mentioned twice is explained once, and a circle of causes is named. The cost depends on the size of
/// the explanation; the first one builds look-ups, O(plant). Several threads may use it at the same time.
class Explainer {
 public:
  /// `behaviours` are those of the plant. All arguments must outlive it.
  explicit Explainer(const trace::PlantNames& names, std::span<const engine::Behaviour> behaviours = {});
  ~Explainer();
  Explainer(const Explainer&) = delete;
  Explainer& operator=(const Explainer&) = delete;

  /// Why a thing is as it is, and what it waits for.
  Explanation why(const Reference& thing, const StateView& view) const;
  /// Why a condition does not hold: a cause for each part of it that must change; none if it holds.
  std::vector<Explanation> why_not(const condition::Tree& condition, const StateView& view) const;
  /// What led to the violation of a requirement, at its time.
  Explanation violation(std::uint32_t requirement, const StateView& view) const;

  const trace::PlantNames& names() const { return names_; }

 private:
  const PlantIndex& index() const;

  const trace::PlantNames& names_;
  std::span<const engine::Behaviour> behaviours_;
  mutable std::once_flag made_;
  mutable std::unique_ptr<const PlantIndex> index_;
};

}  // namespace symplant::why
