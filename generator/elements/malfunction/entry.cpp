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
constexpr std::array kKindKeys{
    KindKey{MalfunctionKind::slower, "slower"},  KindKey{MalfunctionKind::stuck, "stuck"},
    KindKey{MalfunctionKind::force, "force"},    KindKey{MalfunctionKind::flicker, "flicker"},
    KindKey{MalfunctionKind::lose, "lose"},      KindKey{MalfunctionKind::set, "set"},
    KindKey{MalfunctionKind::distort, "distort"}};

/// A duration; a fault if it is 0 or may be 0.
std::optional<Duration> time_above_zero(const Json& object, std::string_view key, const Pointer& here,
                                        ShapeFaults& faults) {
  auto time = duration_member(object, key, here, faults);
  if (time && time->kind != Duration::Kind::normal && time->a == 0) {
    faults.add(here / key, "this time is 0; write at least `1ns`", FaultKind::contradiction);
  }
  return time;
}

tables::Time fixed_time(const Json& object, std::string_view key, const Pointer& here, ShapeFaults& faults) {
  const auto time = time_above_zero(object, key, here, faults);
  return time ? time->a : 0;
}

/// Reads what a malfunction, or one of its effects, does.
class EffectReader {
 public:
  EffectReader(const Json& entry, const Pointer& here, ShapeFaults& faults)
      : entry_(entry), here_(here), faults_(faults) {}

  GivenEffect read() {
    for (const KindKey& kind : kKindKeys) {
      if (member(entry_, kind.key) != nullptr) given_.kinds.push_back(kind.kind);
    }
    read_of();
    read_slower();
    given_.state = text_or_empty(entry_, "stuck");
    read_force();
    read_flicker();
    given_.lose = text_or_empty(entry_, "lose");
    read_set();
    read_distort();
    return std::move(given_);
  }

 private:
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
      given.holds = given.number == "hold";
      given_.force.emplace_back(symbol, std::move(given));
    }
  }

  void read_flicker() {
    const Json* flicker = member(entry_, "flicker");
    if (flicker == nullptr) return;
    const Pointer here = here_ / "flicker";
    given_.flicker.symbol = text_or_empty(*flicker, "symbol");
    given_.flicker.every = time_above_zero(*flicker, "every", here, faults_);
    given_.flicker.shows = fixed_time(*flicker, "for", here, faults_);
  }

  void read_set() {
    const Json* set = member(entry_, "set");
    if (set == nullptr || !set->is_object()) return;
    for (const auto& [value, number] : set->items()) {
      if (number.is_number()) given_.set.emplace_back(value, number.get<double>());
    }
  }

  void read_distort() {
    const Json* distort = member(entry_, "distort");
    if (distort == nullptr) return;
    given_.distort.symbol = text_or_empty(*distort, "symbol");
    const auto number = [&](std::string_view key, double& to) {
      const Json* given = member(*distort, key);
      if (given != nullptr && given->is_number()) to = given->get<double>();
    };
    number("gain", given_.distort.gain);
    number("offset", given_.distort.offset);
    number("drift", given_.distort.drift);
    const GivenDistort& given = given_.distort;
    if (!given.symbol.empty() && given.gain == 1 && given.offset == 0 && given.drift == 0) {
      faults_.add(here_ / "distort", "this malfunction distorts nothing; add `gain`, `offset` or `drift`",
                  FaultKind::contradiction);
    }
  }

  const Json& entry_;
  const Pointer& here_;
  ShapeFaults& faults_;
  GivenEffect given_;
};

class MalfunctionReader {
 public:
  MalfunctionReader(const Json& entry, const Pointer& here, ShapeFaults& faults)
      : entry_(entry), here_(here), faults_(faults) {}

  GivenMalfunction read() {
    given_.name = text_or_empty(entry_, "name");
    check_text(given_.name, here_ / "name", faults_);
    read_effects();
    given_.when = text_or_empty(entry_, "when");
    read_while();
    given_.chance = time_above_zero(entry_, "chance", here_, faults_);
    given_.lasts = time_above_zero(entry_, "lasts", here_, faults_);
    read_becomes();
    return std::move(given_);
  }

 private:
  void read_effects() {
    given_.one = EffectReader(entry_, here_, faults_).read();
    const Json* effects = member(entry_, "effects");
    if (given_.one.kinds.size() + (effects != nullptr ? 1 : 0) != 1) {
      faults_.add(here_,
                  "a malfunction needs exactly one of `slower`, `stuck`, `force`, `flicker`, `lose`, `set`, `distort` "
                  "and `effects`");
    }
    if (effects == nullptr || !effects->is_array()) return;
    for (std::size_t i = 0; i < effects->size(); ++i) {
      const Pointer here = here_ / "effects" / i;
      given_.effects.push_back(EffectReader((*effects)[i], here, faults_).read());
      if (given_.effects.back().kinds.size() == 1 || !(*effects)[i].is_object()) continue;
      faults_.add(here,
                  "an effect needs exactly one of `slower`, `stuck`, `force`, `flicker`, `lose`, `set` and `distort`");
    }
  }

  void read_while() {
    const std::string condition = text_or_empty(entry_, "while");
    if (member(entry_, "while") == nullptr) return;
    for (const std::string_view key : {"when", "chance", "lasts", "becomes"}) {
      if (member(entry_, key) == nullptr) continue;
      faults_.add(
          here_ / key,
          "a malfunction with `while` is active as long as the condition holds; remove " + ticked(key) + ", or `while`",
          FaultKind::contradiction);
    }
    given_.when = condition;
    given_.during = true;
  }

  void read_becomes() {
    const Json* becomes = member(entry_, "becomes");
    if (becomes == nullptr) return;
    const Pointer here = here_ / "becomes";
    given_.becomes = GivenBecomes{fixed_time(*becomes, "after", here, faults_), text_or_empty(*becomes, "unless"),
                                  text_or_empty(*becomes, "start")};
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
