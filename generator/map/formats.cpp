// The formats of `symplant map`.
#include "map/formats.hpp"

#include <fmt/format.h>

#include <array>

#include "diag/visible_text.hpp"

namespace symplant::map {
namespace {

constexpr std::array kMapFormats{
    MapFormat{"table", "for people", false, &write_table},
    MapFormat{"csv", "a row for each symbol, status register and channel", false, &write_csv},
    MapFormat{"json", "for scripts", false, &write_json},
    MapFormat{"st", "declarations in IEC 61131-3", true, &write_st},
    MapFormat{"openplc", "mbconfig.cfg of OpenPLC", true, &write_openplc},
    MapFormat{"codesys", "a global variable list for CODESYS", true, &write_codesys},
};

link::LinkError usage(std::string message) { return {link::LinkError::Kind::usage, std::move(message)}; }

}  // namespace

std::span<const MapFormat> map_formats() { return kMapFormats; }

FormatFault write_maps(const MapFormat& format, std::span<const LinkView> views, base::TextSink& sink) {
  if (format.of_one_plc && views.size() > 1) {
    const std::string& controller = views.back().controller();
    return usage(
        fmt::format("the plant has {} controllers, and `{}` is a file for one controller: choose one, as in `--link "
                    "{}=modbus-tcp-server://127.0.0.1:1502`",
                    views.size(), format.name, diag::visible(controller)));
  }
  if (format.of_one_plc && !views.front().is_server()) {
    return usage(fmt::format(
        "`{}` is for a PLC that polls the plant, and this link goes to the PLC, whose program chooses its addresses: "
        "use `csv` or `json`, or give a link with `--link modbus-tcp-server://HOST:PORT`",
        format.name));
  }
  return format.write(views, sink);
}

}  // namespace symplant::map
