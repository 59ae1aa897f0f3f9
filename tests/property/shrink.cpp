// Delta debugging of actions and of plants.
#include "property/shrink.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "property/simpler.hpp"

namespace symplant::property {
namespace {

class Shrinker {
 public:
  Shrinker(Case the_case, const std::function<bool(const Case&)>& disagrees, int most_runs)
      : best_(std::move(the_case)), disagrees_(disagrees), left_(most_runs) {}

  Case run() {
    for (std::size_t size = 0; left_ > 0 && size != size_of(best_);) {
      size = size_of(best_);
      actions();
      units();
      descriptions();
      rows();
      actions();
    }
    return std::move(best_);
  }

 private:
  static std::size_t size_of(const Case& the_case) { return the_case.actions.size() + plant_size(the_case.plant); }

  bool keep(Case candidate) {
    if (left_ <= 0) return false;
    --left_;
    if (!disagrees_(candidate)) return false;
    best_ = std::move(candidate);
    return true;
  }

  template <class List>
  void pieces(const List& list_of) {
    remove_pieces(best_, list_of, [&](Case candidate) { return keep(std::move(candidate)); });
  }

  void actions() {
    pieces([](auto& the_case) -> auto& { return the_case.actions; });
  }

  void units() {
    for (const std::string& path : unit_paths(best_.plant)) {
      Case candidate = best_;
      remove_unit(candidate.plant, path);
      keep(std::move(candidate));
    }
  }

  void rows() {
    pieces([](auto& the_case) -> auto& { return the_case.plant.rows; });
    for (std::size_t i = 0; i < best_.plant.rows.size(); ++i) {
      Case plainer = best_;
      if (!std::exchange(plainer.plant.rows[i].initial, "").empty()) keep(std::move(plainer));
      Case apart = best_;
      if (give_own_address(apart.plant, i)) keep(std::move(apart));
    }
  }

  void descriptions() {
    pieces([](auto& the_case) -> auto& { return the_case.plant.description.devices; });
    pieces([](auto& the_case) -> auto& { return the_case.plant.description.requirements; });
    pieces([](auto& the_case) -> auto& { return the_case.plant.description.inverted; });
    pieces([](auto& the_case) -> auto& { return the_case.plant.description.follow; });
    material();
    malfunctions();
    pieces([](auto& the_case) -> auto& { return the_case.plant.description.values; });
    pieces([](auto& the_case) -> auto& { return the_case.plant.description.signals; });
    for (std::size_t i = 0; i < best_.plant.description.devices.size(); ++i) device(i);
    // One edit after the other; a kept edit makes the plant smaller, so that the next has the same index.
    for (std::size_t i = 0; i < count_simpler(best_.plant);) {
      Case candidate = best_;
      make_simpler(candidate.plant, i);
      if (!keep(std::move(candidate))) ++i;
      if (left_ <= 0) return;
    }
  }

  void material() {
    for (const std::string& name : part_locations(best_.plant)) {
      Case candidate = best_;
      remove_location(candidate.plant, name);
      keep(std::move(candidate));
    }
    const auto of = [](auto& the_case) -> auto& { return the_case.plant.description.material; };
    pieces([&](auto& the_case) -> auto& { return of(the_case).transfers; });
    pieces([&](auto& the_case) -> auto& { return of(the_case).work; });
    pieces([&](auto& the_case) -> auto& { return of(the_case).sources; });
    for (std::size_t i = 0; i < of(best_).tracks.size(); ++i) {
      pieces([&](auto& the_case) -> auto& { return of(the_case).tracks[i].stops; });
      pieces([&](auto& the_case) -> auto& { return of(the_case).tracks[i].sensors; });
      pieces([&](auto& the_case) -> auto& { return of(the_case).tracks[i].ends; });
      pieces([&](auto& the_case) -> auto& { return of(the_case).tracks[i].drives; });
    }
    for (std::size_t i = 0; i < of(best_).places.size(); ++i) {
      pieces([&](auto& the_case) -> auto& { return of(the_case).places[i].sensors; });
    }
    pieces([&](auto& the_case) -> auto& { return of(the_case).kinds; });
  }

  void malfunctions() {
    const auto all = best_.plant.description.malfunctions;
    for (const description::GivenMalfunction& given : all) {
      Case candidate = best_;
      remove_malfunction(candidate.plant, given.name);
      keep(std::move(candidate));
    }
  }

  void device(std::size_t i) {
    const auto described = [i](auto& the_case) -> auto& { return the_case.plant.description.devices[i]; };
    pieces([&](auto& the_case) -> auto& { return described(the_case).transitions; });
    pieces([&](auto& the_case) -> auto& { return described(the_case).outputs; });
    pieces([&](auto& the_case) -> auto& { return described(the_case).disables; });
    pieces([&](auto& the_case) -> auto& { return described(the_case).states; });
    const auto without = [&](auto&& edit) {
      Case candidate = best_;
      if (edit(described(candidate))) keep(std::move(candidate));
    };
    without([](description::DeviceDescription& it) { return std::exchange(it.initial, std::nullopt).has_value(); });
    without([](description::DeviceDescription& it) { return std::exchange(it.rest, std::nullopt).has_value(); });
    without([](description::DeviceDescription& it) { return std::exchange(it.sequence, std::nullopt).has_value(); });
    without([](description::DeviceDescription& it) { return std::exchange(it.overrun, std::nullopt).has_value(); });
    without([](description::DeviceDescription& it) { return std::exchange(it.actuation, std::nullopt).has_value(); });
    without([](description::DeviceDescription& it) { return std::exchange(it.only, false); });
    without([](description::DeviceDescription& it) { return !std::exchange(it.type, "").empty(); });
    without([](description::DeviceDescription& it) {
      it.inputs.clear();
      return !std::exchange(it.behaviour, "").empty();
    });
  }

  Case best_;
  const std::function<bool(const Case&)>& disagrees_;
  int left_;
};

}  // namespace

Case shrink(Case the_case, const std::function<bool(const Case&)>& disagrees, int most_runs) {
  return Shrinker(std::move(the_case), disagrees, most_runs).run();
}

}  // namespace symplant::property
