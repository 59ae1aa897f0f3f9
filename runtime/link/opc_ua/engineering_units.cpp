// Units of values in OPC UA.
#include "symplant/link/opc_ua/engineering_units.hpp"

#include <algorithm>
#include <array>

namespace symplant::link::opc_ua {

namespace {

struct KnownUnit {
  std::string_view text;
  std::string_view code;  ///< common code of UN/CEFACT, Recommendation 20
  std::string_view description;
};

constexpr std::array kKnownUnits = {
    KnownUnit{"%", "P1", "percent"},
    KnownUnit{"1/min", "RPM", "revolutions per minute"},
    KnownUnit{"rpm", "RPM", "revolutions per minute"},
    KnownUnit{"A", "AMP", "ampere"},
    KnownUnit{"mA", "4K", "milliampere"},
    KnownUnit{"V", "VLT", "volt"},
    KnownUnit{"mV", "2Z", "millivolt"},
    KnownUnit{"W", "WTT", "watt"},
    KnownUnit{"kW", "KWT", "kilowatt"},
    KnownUnit{"kWh", "KWH", "kilowatt hour"},
    KnownUnit{"J", "JOU", "joule"},
    KnownUnit{"Hz", "HTZ", "hertz"},
    KnownUnit{"N", "NEW", "newton"},
    KnownUnit{"kN", "B47", "kilonewton"},
    KnownUnit{"Nm", "NU", "newton metre"},
    KnownUnit{"Pa", "PAL", "pascal"},
    KnownUnit{"kPa", "KPA", "kilopascal"},
    KnownUnit{"bar", "BAR", "bar"},
    KnownUnit{"mbar", "MBR", "millibar"},
    KnownUnit{"K", "KEL", "kelvin"},
    KnownUnit{"°C", "CEL", "degree Celsius"},
    KnownUnit{"degC", "CEL", "degree Celsius"},
    KnownUnit{"°", "DD", "degree [unit of angle]"},
    KnownUnit{"deg", "DD", "degree [unit of angle]"},
    KnownUnit{"rad", "C81", "radian"},
    KnownUnit{"rad/s", "2A", "radian per second"},
    KnownUnit{"g", "GRM", "gram"},
    KnownUnit{"kg", "KGM", "kilogram"},
    KnownUnit{"t", "TNE", "tonne (metric ton)"},
    KnownUnit{"kg/s", "KGS", "kilogram per second"},
    KnownUnit{"kg/h", "E93", "kilogram per hour"},
    KnownUnit{"ml", "MLT", "millilitre"},
    KnownUnit{"l", "LTR", "litre"},
    KnownUnit{"l/s", "G51", "litre per second"},
    KnownUnit{"l/min", "L2", "litre per minute"},
    KnownUnit{"m3", "MTQ", "cubic metre"},
    KnownUnit{"m3/h", "MQH", "cubic metre per hour"},
    KnownUnit{"m2", "MTK", "square metre"},
    KnownUnit{"um", "4H", "micrometre"},
    KnownUnit{"mm", "MMT", "millimetre"},
    KnownUnit{"cm", "CMT", "centimetre"},
    KnownUnit{"m", "MTR", "metre"},
    KnownUnit{"km", "KMT", "kilometre"},
    KnownUnit{"mm/s", "C16", "millimetre per second"},
    KnownUnit{"m/s", "MTS", "metre per second"},
    KnownUnit{"m/min", "2X", "metre per minute"},
    KnownUnit{"m/s2", "MSK", "metre per second squared"},
    KnownUnit{"ms", "C26", "millisecond"},
    KnownUnit{"s", "SEC", "second [unit of time]"},
    KnownUnit{"min", "MIN", "minute [unit of time]"},
    KnownUnit{"h", "HUR", "hour"},
};

}  // namespace

EngineeringUnit engineering_unit(std::string_view text) noexcept {
  const auto* const known =
      std::find_if(kKnownUnits.begin(), kKnownUnits.end(), [&](const KnownUnit& unit) { return unit.text == text; });
  if (known == kKnownUnits.end()) return {};
  std::int32_t id = 0;  // OPC 10000-8, 5.6.3.4: the bytes of the code, the first one highest
  for (const char c : known->code) id = id << 8 | static_cast<unsigned char>(c);
  return {id, known->description};
}

}  // namespace symplant::link::opc_ua
