// The node ids of the server, and the folders of its nodes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace symplant::link::opc_ua {

/// The index of the namespace `urn:symplant:PLANT`: the first after those that each server has.
inline constexpr std::uint16_t kPlantNamespace = 2;

/// The plant's object. Ids of nodes other than symbols begin with `/`, which no symbol has.
inline constexpr std::string_view kPlantNode = "/plant";
inline constexpr std::string_view kValuesNode = "/values";
inline constexpr std::string_view kMalfunctionsNode = "/malfunctions";
inline constexpr std::string_view kOtherNode = "/other";  ///< folder of symbols that no station has

/// The node id of a symbol's variable, as text: `ns=2;s=NAME`.
inline std::string symbol_node_text(std::string_view name) {
  return "ns=" + std::to_string(kPlantNamespace) + ";s=" + std::string(name);
}

/// The namespace of the nodes, or the application's URI, of a plant: what a URI must not have is replaced by `-`.
std::string plant_uri(std::string_view prefix, std::string_view plant);

/// What the path of a device or the name of a symbol begins with: line and process, as far as there is more behind
/// them.
struct Station {
  std::string_view line;     ///< empty: the name has one level
  std::string_view process;  ///< empty: the name has two levels
  std::string_view rest;     ///< what follows them
};
Station station_of(std::string_view name) noexcept;

inline std::string line_node(const Station& station) { return "/line/" + std::string(station.line); }
inline std::string process_node(const Station& station) {
  return "/process/" + std::string(station.line) + "_" + std::string(station.process);
}
inline std::string device_node(std::string_view path) { return "/device/" + std::string(path); }
inline std::string value_node(std::string_view output) { return "/value/" + std::string(output); }
inline std::string malfunction_node(std::string_view name) { return "/malfunction/" + std::string(name); }

}  // namespace symplant::link::opc_ua
