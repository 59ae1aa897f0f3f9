// Reads an entry of `archetypes`.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "naming/entries.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::naming {
namespace {

using description::FaultKind;
using description::member;
using description::Pointer;
using description::text_member;
using description::text_or_empty;
using description::ticked;
using name::ArchetypeModel;
using Role = name::ArchetypeRole;

/// The roles and settings of a model. Of `commands` and `reports` at least one each is needed, of a mirror and a
/// contactor there is only one.
struct ModelKeys {
  std::string_view word;
  ArchetypeModel model;
  std::array<Role, 3> commands;
  std::size_t command_count;
  std::array<Role, 2> reports;
  std::size_t report_count;
  std::array<std::string_view, 2> settings;

  std::span<const Role> needed_commands() const { return std::span(commands).first(command_count); }
  std::span<const Role> needed_reports() const { return std::span(reports).first(report_count); }
};

constexpr std::array<ModelKeys, name::kArchetypeModels> kModels{{
    {"mirror", ArchetypeModel::mirror, {Role::operation}, 1, {Role::event}, 1, {"delay", "inverted"}},
    {"handshake",
     ArchetypeModel::handshake,
     {Role::start, Role::ack, Role::reset},
     3,
     {Role::busy, Role::done},
     2,
     {"takes"}},
    {"constant", ArchetypeModel::constant, {}, 0, {Role::event}, 1, {"value"}},
    {"two-position", ArchetypeModel::two_position, {Role::a, Role::b}, 2, {Role::at_a, Role::at_b}, 2, {"takes"}},
    {"contactor", ArchetypeModel::contactor, {Role::on}, 1, {Role::is_on}, 1, {"delay"}},
}};

constexpr std::array<std::string_view, 4> kSettings{"delay", "takes", "inverted", "value"};

constexpr std::array<Role, name::kArchetypeRoles> kRoles{
    Role::operation, Role::event, Role::start, Role::busy, Role::done, Role::ack,  Role::reset,
    Role::a,         Role::b,     Role::at_a,  Role::at_b, Role::on,   Role::is_on};

bool contains(std::span<const Role> roles, Role role) {
  return std::find(roles.begin(), roles.end(), role) != roles.end();
}

/// "`start`, `ack` or `reset`"
std::string one_of(std::span<const Role> roles) {
  std::string text;
  for (std::size_t i = 0; i < roles.size(); ++i) {
    if (i > 0) text += i + 1 == roles.size() ? " or " : ", ";
    text += ticked(name::archetype_role_name(roles[i]));
  }
  return text;
}

class ArchetypeEntry {
 public:
  ArchetypeEntry(const Json& entry, const Pointer& here, description::ShapeFaults& faults)
      : entry_(entry), here_(here), faults_(faults) {}

  name::Archetype read() {
    archetype_.name = text_or_empty(entry_, "name");
    description::check_text(archetype_.name, here_ / "name", faults_);
    for (const Role role : kRoles) {
      if (const std::string* text = text_member(entry_, name::archetype_role_name(role)))
        archetype_.texts.emplace_back(role, *text);
    }
    archetype_.delay = description::time_member(entry_, "delay", here_, faults_).value_or(archetype_.delay);
    archetype_.takes = description::time_member(entry_, "takes", here_, faults_).value_or(archetype_.takes);
    archetype_.inverted = description::flag_member(entry_, "inverted");
    archetype_.value = optional_flag(entry_, "value").value_or(archetype_.value);
    const std::string model = text_or_empty(entry_, "model");
    const auto* keys =
        std::find_if(kModels.begin(), kModels.end(), [&](const ModelKeys& one) { return one.word == model; });
    if (keys != kModels.end()) {  // others are already reported
      archetype_.model = keys->model;
      check_roles(*keys);
      check_settings(*keys);
    }
    return std::move(archetype_);
  }

 private:
  void check_roles(const ModelKeys& keys) {
    for (const auto& [role, text] : archetype_.texts) {
      if (contains(keys.needed_commands(), role) || contains(keys.needed_reports(), role)) continue;
      tables::NearestName nearest(name::archetype_role_name(role));
      std::string known;
      for (const auto& roles : {keys.needed_commands(), keys.needed_reports()}) {
        for (const Role one : roles) {
          known.append(known.empty() ? "" : ", ").append(ticked(name::archetype_role_name(one)));
          nearest.offer(name::archetype_role_name(one));
        }
      }
      faults_.add(here_ / name::archetype_role_name(role),
                  "the model " + ticked(keys.word) + " has no role " + ticked(name::archetype_role_name(role)) +
                      "; its roles are " + known +
                      (nearest.name().empty() ? "" : "; did you mean " + ticked(nearest.name()) + "?"),
                  FaultKind::unknown_name);
    }
    for (const auto& roles : {keys.needed_commands(), keys.needed_reports()}) need_one(keys, roles);
  }

  void need_one(const ModelKeys& keys, std::span<const Role> roles) {
    const bool given = std::any_of(archetype_.texts.begin(), archetype_.texts.end(),
                                   [&](const auto& one) { return contains(roles, one.first); });
    if (given || roles.empty()) return;
    faults_.add(here_ / "model", "the model " + ticked(keys.word) + " needs the role " + one_of(roles) + "; add it",
                FaultKind::contradiction);
  }

  void check_settings(const ModelKeys& keys) {
    for (const std::string_view setting : kSettings) {
      if (member(entry_, setting) == nullptr) continue;
      if (std::find(keys.settings.begin(), keys.settings.end(), setting) != keys.settings.end()) continue;
      faults_.add(here_ / setting, ticked(setting) + " has no effect on the model " + ticked(keys.word) + "; remove it",
                  FaultKind::contradiction);
    }
  }

  const Json& entry_;
  const Pointer& here_;
  description::ShapeFaults& faults_;
  name::Archetype archetype_;
};

}  // namespace

name::Archetype archetype_entry(const Json& entry, const Pointer& here, description::ShapeFaults& faults) {
  return ArchetypeEntry(entry, here, faults).read();
}

}  // namespace symplant::naming
