// The formats of `symplant map`.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/text_source.hpp"
#include "map/link_view.hpp"

namespace symplant::map {

/// Why a format cannot describe these links; nothing if it was written.
using FormatFault = std::optional<link::LinkError>;

struct MapFormat {
  std::string_view name;
  std::string_view what;  ///< for the help
  bool of_one_plc;        ///< a file of one PLC, which is the client of a Modbus server of the plant
  FormatFault (*write)(std::span<const LinkView> views, base::TextSink& sink);
};

/// Each is in its file.
FormatFault write_table(std::span<const LinkView> views, base::TextSink& sink);
FormatFault write_csv(std::span<const LinkView> views, base::TextSink& sink);
FormatFault write_json(std::span<const LinkView> views, base::TextSink& sink);
FormatFault write_st(std::span<const LinkView> views, base::TextSink& sink);
FormatFault write_codesys(std::span<const LinkView> views, base::TextSink& sink);
FormatFault write_openplc(std::span<const LinkView> views, base::TextSink& sink);

std::span<const MapFormat> map_formats();

/// Writes the maps in a format. Errors are of kind usage: a format of one PLC for several, or for a link that goes to
/// the PLC. O(symbols log symbols).
FormatFault write_maps(const MapFormat& format, std::span<const LinkView> views, base::TextSink& sink);

}  // namespace symplant::map
