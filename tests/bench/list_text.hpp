// Lists of any size for benchmarks: devices of a given number of types, four symbols each.
#pragma once

#include <cstdio>
#include <string>

namespace symplant::bench {

/// `devices` double solenoids by name; their task words differ from type to type, so that structures do, too.
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

}  // namespace symplant::bench
