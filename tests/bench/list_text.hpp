// Lists of any size for benchmarks: devices of a given number of types, four symbols each; and their plant.json files.
#pragma once

#include <cstdio>
#include <string>

namespace symplant::bench {

/// `devices` double solenoids by name; their task words differ between types, so that their structures differ too.
inline std::string list_text(int devices, int types) {
  std::string text = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n";
  char line[200];
  for (int d = 0; d < devices; ++d) {
    const int type = d % types;
    const char* sides[4][3] = {{"O", "ADV1", "Y"}, {"O", "RET2", "Y"}, {"I", "ADV1", "X"}, {"I", "RET2", "X"}};
    for (const auto& side : sides) {
      const int number = 2 * d + (side[1][0] == 'R' ? 1 : 0);
      const int length = std::snprintf(
          line, sizeof line, "VAR_GLOBAL,LINE%d_ST%d_DEV%d_%s_T%d%s,%s%X,%%%sX%d,BOOL,FALSE,cylinder %d of the line\n",
          1 + d / 5000, 1 + d / 20, d, side[0], type, side[1], side[2], static_cast<unsigned>(number),
          side[2][0] == 'Y' ? "Q" : "I", number, d);
      text.append(line, static_cast<std::size_t>(length));
    }
  }
  return text;
}

/// The plant.json of such a list with 10 types: an entry for each device, by exact name, with a condition on its
/// neighbor.
inline std::string description_text(int devices, const std::string& list) {
  std::string text = "{\n  \"symplant\": 1,\n  \"symbols\": [\"" + list + "\"],\n  \"devices\": {\n";
  char line[400];
  const auto name = [](char(&buffer)[64], int d) {
    std::snprintf(buffer, sizeof buffer, "LINE%d_ST%d_DEV%d", 1 + d / 5000, 1 + d / 20, d);
  };
  char own[64];
  char other[64];
  for (int d = 0; d < devices; ++d) {
    const int neighbour = (d + 1) % devices;
    name(own, d);
    name(other, neighbour);
    const int length = std::snprintf(line, sizeof line,
                                     "    \"%s\": {\n      \"transitions\": [ { \"from\": \"T%dRET2\", \"to\": "
                                     "\"T%dADV1\", \"when\": \"%s.T%dRET2 and "
                                     "not %s.moving\", \"takes\": \"800ms\" } ]\n    }%s\n",
                                     own, d % 10, d % 10, other, neighbour % 10, other, d + 1 < devices ? "," : "");
    text.append(line, static_cast<std::size_t>(length));
  }
  return text + "  }\n}\n";
}

}  // namespace symplant::bench
