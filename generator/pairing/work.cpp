// The symbols of a pairing, and the facets found so far.
#include "pairing/work.hpp"

#include <algorithm>
#include <utility>

#include "base/large_memory.hpp"

namespace symplant::pairing {
namespace {

Account account_of(const Input& input, const name::Naming& naming, bool& on) {
  const name::Reading& reading = *input.reading;
  if (!reading.is_read()) return name::account_of(reading, input.boolean);
  if (reading.role == name::Role::io) return input.boolean ? name::unpaired(input.side) : Account::numeric;
  const Account account = account_of(input, reading.role);
  if (account == Account::constant) on = naming.rules[reading.rule].value.value_or(true);
  return account;
}

}  // namespace

Account account_of(const Input& input, name::Role role) {
  switch (role) {
    case name::Role::operator_panel:
      return Account::operator_panel;
    case name::Role::constant:
      if (!input.boolean) return Account::data;
      return input.side == name::Direction::event ? Account::constant : Account::role_none;
    case name::Role::none:
      return Account::role_none;
    case name::Role::interlock:
      return Account::interlock;
    case name::Role::io:
    case name::Role::data:
      break;
  }
  return Account::data;
}

Work::Work(const name::CompiledNaming& of, std::span<const Input> symbols)
    : compiled(of), naming(of.naming()), inputs(symbols) {
  base::reserve_large(device, inputs.size());
  result.accounts.reserve(inputs.size());
  result.constant_on.resize(inputs.size());
  std::vector<std::vector<std::uint32_t>> by_controller;
  for (std::uint32_t i = 0; i < inputs.size(); ++i) {
    const name::Reading& of_input = reading(i);
    bool on = false;
    result.accounts.push_back(account_of(inputs[i], naming, on));
    if (on) result.constant_on[i] = true;
    if (!of_input.is_read() || of_input.levels->path.empty()) {
      device.push_back(kNone);
      continue;
    }
    if (inputs[i].controller >= by_controller.size()) by_controller.resize(inputs[i].controller + 1);
    std::vector<std::uint32_t>& known = by_controller[inputs[i].controller];
    const std::uint32_t id = of_input.levels->device_id;
    if (id >= known.size()) known.resize(std::max<std::size_t>(id + std::size_t{1}, known.size() * 2), kNone);
    std::uint32_t& index = known[id];
    if (index == kNone) {
      index = static_cast<std::uint32_t>(devices.size());
      devices.push_back(i);
    }
    device.push_back(index);
  }
}

void Work::add(Facet facet, std::uint32_t of_device) {
  for (const Member& member : facet.members) {
    if (facet.linked) result.accounts[member.input] = Account::modelled;
  }
  if (of_device != kNone) {
    const name::DeviceLevels& levels = *reading(devices[of_device]).levels;
    facet.path = levels.path;
    facet.line = levels.line;
    facet.process = levels.process;
    facet.device = levels.device;
  }
  drafts.push_back({std::move(facet), of_device});
}

void Work::add(Facet facet, std::string_view path) {
  facet.path = facet.device = path;
  add(std::move(facet), kNone);
}

std::string joined_words(std::string_view text) {
  std::string joined(text);
  std::replace(joined.begin(), joined.end(), ' ', '_');
  return joined;
}

}  // namespace symplant::pairing
