// The cycle's side of a link that keeps images: loss of the PLC, policies, status.
#pragma once

#include <cstdint>

#include "symplant/exec/exchange.hpp"
#include "symplant/link/health.hpp"
#include "symplant/link/image/images.hpp"
#include "symplant/link/image/map.hpp"
#include "symplant/link/image/status.hpp"
#include "symplant/link/link_settings.hpp"
#include "symplant/plant/plant.hpp"

namespace symplant::link::image {

/// Exchanges the images of a link with the plant. Used by the cycle's thread. The link's thread uses images(), of which
/// it may use only the members for the link's thread.
class CycleSide {
 public:
  /// If `plant` is given, the images have its events at once. `watch` as for Images.
  CycleSide(const tables::PlantTables& tables, const Map& map, const LinkSettings& settings, const plant::Plant* plant,
            RequestWatch* watch = nullptr);

  /// Takes the operations of the other thread and applies them as the link's health allows. `signs` counts the signs of
  /// life of the PLC; it must be read before the call. Returns true if the link is lost from this cycle on.
  bool read_operations(plant::Plant& plant, tables::Time now, std::uint64_t signs) noexcept;
  void write_events(const plant::Plant& plant, const exec::CycleStatus& status) noexcept;
  /// Publishes the stopping state.
  void leave() noexcept;

  exec::LinkState state() const noexcept { return health_.state(); }
  bool freezes_plant() const noexcept { return freezes_ && health_.state() != exec::LinkState::live; }
  std::uint32_t losses() const noexcept { return health_.losses(); }
  Images& images() noexcept { return images_; }

 private:
  bool freezes_;
  LinkHealth health_;
  std::uint64_t signs_ = 0;  ///< at the last call of read_operations()
  tables::Time now_ = 0;     ///< of that call
  Status status_;
  Images images_;
};

}  // namespace symplant::link::image
