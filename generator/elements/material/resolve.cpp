// Resolves the material flow.
#include "elements/material/resolve.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "elements/material/moves.hpp"
#include "elements/material/names.hpp"
#include "elements/material/tracks.hpp"

namespace symplant::model {
namespace {

/// Whether each made entry is in the plant: those with `for` are left out if they name what the plant lacks.
struct Included {
  explicit Included(const MadeMaterial& made)
      : tracks(made.tracks.size(), true),
        places(made.places.size(), true),
        transfers(made.transfers.size(), true),
        work(made.work.size(), true),
        sources(made.sources.size(), true) {}

  std::vector<bool> tracks;
  std::vector<bool> places;
  std::vector<bool> transfers;
  std::vector<bool> work;
  std::vector<bool> sources;
};

class MaterialBuilder {
 public:
  MaterialBuilder(Derived& derived, MadeNames& names, description::Faults& faults)
      : plant_(derived.plant), made_(derived.material), names_(names), faults_(faults), in_(made_) {}

  void build() {
    plant_.material.kinds = checked_kinds(made_.entries.kinds, faults_);
    rejected_ = names_of_devices(plant_, made_, faults_);
    count_takers();
    // An entry that is left out may be what another one names.
    if (for_devices(plant_.description->material)) {
      std::vector<description::DescriptionFault> ignored;
      description::Faults scratch(ignored, ignored);
      while (resolve(scratch)) {
      }
    }
    resolve(faults_);
    finish_sensors();
    check_tasks_of_sensors(plant_, faults_);
  }

 private:
  /// Resolves what is included. Excludes what names something that the plant lacks; true if there was any.
  bool resolve(description::Faults& faults) {
    Material& material = plant_.material;
    material = {std::move(material.kinds), {}, {}, {}, {}, {}};
    const std::vector<std::size_t> tracks = declare(made_.entries.tracks, in_.tracks, material.tracks);
    const std::vector<std::size_t> places = declare(made_.entries.places, in_.places, material.places);
    for (std::size_t t = 0; t < tracks.size(); ++t) material.tracks[t].length = made_.entries.tracks[tracks[t]].length;
    MaterialLookup lookup(plant_, rejected_, faults);
    bool excluded = false;
    const auto close = [&](std::string_view list, const MadeBy& by, std::vector<bool>& included, std::size_t i) {
      if (lookup.lacking().empty()) return;
      included[i] = false;
      excluded = true;
      names_.lacks(material_pointer(list, by), by.device, lookup.lacking());
    };
    for (std::size_t t = 0; t < tracks.size(); ++t) {
      const std::size_t i = tracks[t];
      resolve_track(made_.entries.tracks[i], made_.tracks[i], lookup, material.tracks[t]);
      close("tracks", made_.tracks[i], in_.tracks, i);
    }
    for (std::size_t p = 0; p < places.size(); ++p) {
      const std::size_t i = places[p];
      resolve_place(made_.entries.places[i], made_.places[i], lookup, material.places[p]);
      close("places", made_.places[i], in_.places, i);
    }
    const auto each = [&](std::string_view list, const auto& entries, const std::vector<MadeBy>& origins,
                          std::vector<bool>& included, auto& to, auto resolve_one) {
      TakenNames taken;
      for (std::size_t i = 0; i < entries.size(); ++i) {
        if (!included[i]) continue;
        to.push_back(resolve_one(entries[i], origins[i], lookup, taken));
        close(list, origins[i], included, i);
      }
    };
    each("transfers", made_.entries.transfers, made_.transfers, in_.transfers, material.transfers, resolve_transfer);
    each("work", made_.entries.work, made_.work, in_.work, material.work, resolve_work);
    each("sources", made_.entries.sources, made_.sources, in_.sources, material.sources, resolve_source);
    return excluded;
  }

  /// Adds the included tracks or places, with their names only. Returns their indexes among the made ones.
  template <class Given, class Element>
  std::vector<std::size_t> declare(const std::vector<Given>& given, const std::vector<bool>& included,
                                   std::vector<Element>& elements) const {
    std::vector<std::size_t> indexes;
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (!included[i] || rejected_.contains(given[i].name)) continue;
      indexes.push_back(i);
      elements.emplace_back().name = given[i].name;
    }
    return indexes;
  }

  void count_takers() {
    const auto takes = [&](std::string_view list, const std::vector<MadeBy>& origins) {
      for (const MadeBy& by : origins) {
        if (!by.pattern.empty()) names_.takes(material_pointer(list, by));
      }
    };
    takes("tracks", made_.tracks);
    takes("places", made_.places);
    takes("transfers", made_.transfers);
    takes("work", made_.work);
    takes("sources", made_.sources);
  }

  /// Inverts symbols of sensors, and releases those whose entry is left out.
  void finish_sensors() {
    std::vector<bool> used(plant_.symbols.size());
    const auto use = [&](const auto& elements) {
      for (const auto& element : elements) {
        for (const PartSensor& sensor : element.sensors) used[sensor.symbol] = true;
      }
    };
    use(plant_.material.tracks);
    use(plant_.material.places);
    for (std::size_t i = 0; i < used.size(); ++i) {
      Symbol& symbol = plant_.symbols[i];
      if (symbol.account == Account::senses_parts && !used[i]) symbol.account = name::unpaired(symbol.direction);
    }
    for (const std::uint32_t symbol : made_.inverted) {
      if (used[symbol]) plant_.symbols[symbol].inverted = true;
    }
  }

  PlantModel& plant_;
  const MadeMaterial& made_;
  MadeNames& names_;
  description::Faults& faults_;
  Included in_;
  text::ByName<bool> rejected_;
};

}  // namespace

void resolve_material(Derived& derived, MadeNames& made, description::Faults& faults) {
  if (derived.plant.description->material.empty()) return;
  MaterialBuilder(derived, made, faults).build();
}

}  // namespace symplant::model
