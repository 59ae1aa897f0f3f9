// The symbols of a pairing, and the facets found so far.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "name/compiled_naming.hpp"
#include "pairing/facet.hpp"

namespace symplant::pairing {

inline constexpr std::uint32_t kNone = UINT32_MAX;
using name::Account;

struct Draft {
  Facet facet;
  std::uint32_t device = kNone;  ///< index of its device
};

struct Work {
  Work(const name::CompiledNaming& of, std::span<const Input> symbols);

  const name::Reading& reading(std::uint32_t input) const { return *inputs[input].reading; }
  bool is_read(std::uint32_t input) const { return device[input] != kNone; }
  /// Whether no facet has the symbol yet, and one may take it.
  bool is_free(std::uint32_t input) const { return is_read(input) && is_unpaired(result.accounts[input]); }
  bool is_operation(std::uint32_t input) const { return inputs[input].side == name::Direction::operation; }
  /// Adds a facet of a device, and accounts for its members if they are linked.
  void add(Facet facet, std::uint32_t of_device);
  /// Adds a facet whose only name is that of a symbol that no rule reads.
  void add(Facet facet, std::string_view path);

  const name::CompiledNaming& compiled;
  const name::Naming& naming;
  std::span<const Input> inputs;
  std::vector<std::uint32_t>
      device;  ///< of each input, by controller and levels; kNone if no rule reads it, or without a device
  std::vector<std::uint32_t> devices;  ///< the first input of each device
  std::vector<Draft> drafts;
  Pairing result;
};

/// What a symbol of a role other than `io` is accounted for as.
Account account_of(const Input& input, name::Role role);
/// Joins symbols by the rows of Naming::links.
void pair_by_links(Work& work);
/// Accounts for symbols that have the same text.
void set_repeated_texts_aside(Work& work);
/// Accounts for numbers that are spread over bits, as far as nothing else joins them.
void set_weights_aside(Work& work);
/// Joins symbols by archetypes, and accounts for constants.
void pair_by_archetypes(Work& work);
/// Joins symbols by their tasks.
void pair_by_words(Work& work);
/// Gives each symbol that nothing links the role of a rule of Naming::rest.
void account_for_rest(Work& work);
/// Adds to each device what nothing links: operations, events and numbers.
void add_unlinked(Work& work);
/// Names the facets, sorts them, and reports paths that several devices have.
void finish(Work& work);

/// Blanks become `_`.
std::string joined_words(std::string_view text);

}  // namespace symplant::pairing
