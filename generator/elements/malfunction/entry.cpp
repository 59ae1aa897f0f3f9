// Reads `malfunctions` of a plant.json.
#include "elements/malfunction/entry.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace symplant::description {
namespace {

using Json = nlohmann::json;
using tables::MalfunctionKind;

struct KindKey {
  MalfunctionKind kind;
  std::string_view key;
};
constexpr std::array kKindKeys{KindKey{MalfunctionKind::slower, "slower"}, KindKey{MalfunctionKind::stuck, "stuck"},
                               KindKey{MalfunctionKind::force, "force"}, KindKey{MalfunctionKind::flicker, "flicker"},
                               KindKey{MalfunctionKind::lose, "lose"}};

class MalfunctionReader {
 public:
  MalfunctionReader(const Json& entry, const Pointer& here, ShapeFaults& faults)
      : entry_(entry), here_(here), faults_(faults) {}

  GivenMalfunction read() {
    given_.name = text_or_empty(entry_, "name");
    check_text(given_.name, here_ / "name", faults_);
    for (const KindKey& kind : kKindKeys) {
      if (member(entry_, kind.key) != nullptr) given_.kinds.push_back(kind.kind);
    }
    if (given_.kinds.size() != 1) {
      faults_.add(here_, "a malfunction needs exactly one of `slower`, `stuck`, `force`, `flicker` and `lose`");
    }
    read_of();
    read_slower();
    given_.state = text_or_empty(entry_, "stuck");
    read_force();
    read_flicker();
    given_.lose = text_or_empty(entry_, "lose");
    given_.when = text_or_empty(entry_, "when");
    given_.chance = time_above_zero(entry_, "chance", here_);
    given_.lasts = time_above_zero(entry_, "lasts", here_);
    read_becomes();
    return std::move(given_);
  }

 private:
  /// A duration; a fault if it is 0 or may be 0.
  std::optional<Duration> time_above_zero(const Json& object, std::string_view key, const Pointer& here) {
    const auto time = duration_member(object, key, here, faults_);
    if (time && time->kind != Duration::Kind::normal && time->a == 0) {
      faults_.add(here / key, "this time is 0; write at least `1ns`", FaultKind::contradiction);
    }
    return time;
  }

  void read_of() {
    const Json* of = member(entry_, "of");
    if (of == nullptr) return;
    given_.of_is_list = of->is_array();
    if (of->is_string()) given_.of.push_back(of->get<std::string>());
    if (!of->is_array()) return;
    for (const Json& one : *of) given_.of.push_back(one.is_string() ? one.get<std::string>() : std::string());
  }

  void read_slower() {
    const Json* slower = member(entry_, "slower");
    if (slower == nullptr || !slower->is_number()) return;
    const auto factor = slower->get<double>();
    const double thousandths = std::round(factor * 1000);
    const bool in_range = thousandths >= tables::kMinSlower && thousandths <= tables::kMaxSlower;
    if (in_range && thousandths / 1000 == factor) {
      given_.factor = static_cast<std::uint32_t>(thousandths);
    } else {
      faults_.add(here_ / "slower", ticked(slower->dump()) +
                                        " is not a number from 0.001 to 1000 with at most three "
                                        "decimals");
    }
  }

  void read_force() {
    const Json* force = member(entry_, "force");
    if (force == nullptr || !force->is_object()) return;
    for (const auto& [symbol, value] : force->items()) {
      GivenForcedValue given;
      if (value.is_boolean()) given.bit = value.get<bool>();
      given.shown = ticked(value.dump());
      given.number = value.is_string() ? value.get<std::string>() : value.dump();
      given_.force.emplace_back(symbol, std::move(given));
    }
  }

  void read_flicker() {
    const Json* flicker = member(entry_, "flicker");
    if (flicker == nullptr) return;
    const Pointer here = here_ / "flicker";
    given_.flicker.symbol = text_or_empty(*flicker, "symbol");
    given_.flicker.every = time_above_zero(*flicker, "every", here);
    given_.flicker.shows = fixed_time(*flicker, "for", here);
  }

  void read_becomes() {
    const Json* becomes = member(entry_, "becomes");
    if (becomes == nullptr) return;
    const Pointer here = here_ / "becomes";
    given_.becomes = GivenBecomes{fixed_time(*becomes, "after", here), text_or_empty(*becomes, "unless"),
                                  text_or_empty(*becomes, "start")};
  }

  tables::Time fixed_time(const Json& object, std::string_view key, const Pointer& here) {
    const auto time = time_above_zero(object, key, here);
    return time ? time->a : 0;
  }

  const Json& entry_;
  const Pointer& here_;
  ShapeFaults& faults_;
  GivenMalfunction given_;
};

}  // namespace

std::vector<GivenMalfunction> malfunction_entries(const Json& array, ShapeFaults& faults) {
  std::vector<GivenMalfunction> all;
  if (!array.is_array()) return all;
  for (std::size_t i = 0; i < array.size(); ++i) {
    const Pointer here = Pointer("/malfunctions") / i;
    all.push_back(MalfunctionReader(array[i], here, faults).read());
  }
  return all;
}

}  // namespace symplant::description
