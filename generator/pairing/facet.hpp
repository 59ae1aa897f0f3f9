// What pairing takes and makes: symbols that a naming rule has read, and facets.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "description/description.hpp"
#include "name/reading.hpp"

namespace symplant::pairing {

/// An I/O symbol.
struct Input {
  const name::Reading* reading = nullptr;
  std::string_view name;  ///< for links
  name::Direction side{};
  bool boolean = true;           ///< others are numbers
  std::uint32_t controller = 0;  ///< only symbols of one controller are joined
};

struct Member {
  std::uint32_t input = 0;
  std::string task;         ///< in the facet: the state that it leads to or reports, or a command or report of the base
  bool makes_state = true;  ///< false: an event that nothing links, whose task is a state only if plant.json says so
};

/// What made a facet.
enum class FacetBy : std::uint8_t { links, archetype, words };

/// The symbols of one unit. Views point into readings and names of the inputs.
struct Facet {
  std::string_view path;  ///< of its device
  std::string_view line;
  std::string_view process;
  std::string_view device;
  std::string name;       ///< empty: the facet has the device's name
  std::string full_path;  ///< `DEVICE.FACET`; empty if the facet has the device's name
  FacetBy by = FacetBy::words;
  bool linked = true;                  ///< false: its symbols name the device, and nothing links them
  bool is_default = false;             ///< it has the name of its device, whatever other facets the device has
  bool numbered = false;               ///< its states are in the order of their sequence numbers
  std::uint32_t archetype = 0;         ///< index in Naming::archetypes
  std::vector<Member> members;         ///< in list order
  std::vector<std::uint32_t> numbers;  ///< numeric symbols of the device, if this is its default facet, in list order
  std::vector<std::string> states;     ///< S in its order; empty if `numbered`
  bool first_is_rest = false;  ///< the vocabulary or the archetype says that the first state is the rest position
  /// What the naming rule gives of its model; null if nothing. The user's description has priority, key by key.
  std::shared_ptr<const description::DeviceDescription> base;

  std::string_view unit_path() const { return full_path.empty() ? path : std::string_view(full_path); }
  /// The input that comes first in the lists.
  std::uint32_t first_input() const {
    return std::min(members.empty() ? UINT32_MAX : members.front().input,
                    numbers.empty() ? UINT32_MAX : numbers.front());
  }
};

/// Something that the user should know; `input` is the symbol.
struct Remark {
  enum class Kind : std::uint8_t {
    role_taken,      ///< another symbol of its device has the same role of an archetype; it is left out
    link_unknown,    ///< a link names a symbol that does not exist, or is not BOOL I/O: `link` is its row, and
                     ///< `other` is 1 if it is the operation
    link_side,       ///< a link names an operation as an event, or the reverse
    link_repeated,   ///< a link names a symbol that an earlier link gives another state or device: `other` is its row
    path_ambiguous,  ///< another device has the same path with other levels
  } kind{};
  std::uint32_t input = 0;
  std::uint32_t other = 0;  ///< an input; of `link_repeated` a row of the links
  std::uint32_t link = 0;   ///< index in Naming::links
};

struct Pairing {
  std::vector<Facet> facets;            ///< in the order of their first symbol
  std::vector<name::Account> accounts;  ///< one for each input: `modelled` if it is linked
  std::vector<bool> constant_on;        ///< one for each input: the value of a constant
  std::vector<Remark> remarks;
};

}  // namespace symplant::pairing
