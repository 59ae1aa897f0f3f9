// The rules that the project sets for its source files.
#include "arch/arch_rules.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <span>
#include <string_view>

namespace symplant::arch {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLines = 500;
constexpr std::size_t kLeastHead = 15;  // characters, slashes included

// Lowest first; a layer may use the layers before it.
constexpr std::array<std::string_view, 32> kGenerator = {
    "base",     "text",  "diag",  "address", "read",    "name",      "description", "naming",
    "pairing",  "infer", "model", "score",   "convert", "fmu",       "lower",       "check",
    "findings", "emit",  "view",  "diff",    "map",     "recording", "record",      "compare",
    "observe",  "study", "learn", "watch",   "batch",   "suite",     "campaign",    "app"};
constexpr std::array<std::string_view, 15> kRuntime = {"tables", "engine",   "plant",   "condition", "fmi",
                                                       "json",   "share",    "exec",    "link",      "trace",
                                                       "why",    "scenario", "program", "panel",     "host"};

/// What an element of plant.json needs lies in one folder, generator/elements/NAME: the files of these names belong to
/// these layers, all others to `model`.
struct ElementFile {
  std::string_view stem;
  std::string_view layer;
};
constexpr std::array kElementFiles = {
    ElementFile{"given", "description"}, ElementFile{"modules", "description"}, ElementFile{"entry", "description"},
    ElementFile{"file", "description"},  ElementFile{"key", "description"},     ElementFile{"lower", "lower"},
    ElementFile{"rows", "emit"},         ElementFile{"skeleton", "emit"},       ElementFile{"functions", "emit"},
    ElementFile{"json", "view"},         ElementFile{"words", "view"},          ElementFile{"html", "view"},
    ElementFile{"drawing", "view"},
};

/// In the root of the runtime, as C programs include it; of the layer `program`.
constexpr std::string_view kProgramInterface = "program.h";

/// The runtime layers that a layer of the generator may use.
struct RuntimeUse {
  std::string_view floor;
  std::string_view uses;  ///< separated and enclosed by blanks
};
constexpr std::array kRuntimeUse = {
    RuntimeUse{"text", " tables "},
    RuntimeUse{"read", " tables "},
    RuntimeUse{"name", " tables "},
    RuntimeUse{"description", " tables json link "},
    RuntimeUse{"naming", " tables json "},
    RuntimeUse{"pairing", " tables "},
    RuntimeUse{"model", " tables condition link "},
    RuntimeUse{"score", " tables condition "},
    RuntimeUse{"fmu", " tables condition fmi "},
    RuntimeUse{"lower", " tables condition "},
    RuntimeUse{"check", " tables condition "},
    RuntimeUse{"findings", " json "},
    RuntimeUse{"emit", " tables plant "},
    RuntimeUse{"view", " tables "},
    RuntimeUse{"diff", " tables "},
    RuntimeUse{"map", " tables link trace why "},
    RuntimeUse{"recording", " tables trace "},
    RuntimeUse{"record", " tables condition exec link trace scenario "},
    RuntimeUse{"compare", " tables trace "},
    RuntimeUse{"observe", " tables condition "},
    RuntimeUse{"study", " tables condition plant trace "},
    RuntimeUse{"learn", " tables engine trace "},
    RuntimeUse{"watch", " tables condition json trace "},
    RuntimeUse{"batch", " program "},
    RuntimeUse{"suite", " tables json trace why host "},
    RuntimeUse{"campaign", " tables trace plant program host "},
    RuntimeUse{"app", " tables json link trace why scenario program panel host "},
};

/// The layers that may include the headers of a third party.
struct ThirdParty {
  std::string_view include;  ///< prefix of its include paths
  std::array<std::string_view, 4> folders;
};
constexpr std::array kThirdParties = {
    ThirdParty{"<boost/spirit", {"generator/address/", "generator/name/", "generator/read/", "runtime/condition/"}},
    ThirdParty{"<boost/asio", {"generator/description/", "runtime/panel/web/"}},
    ThirdParty{"<boost/beast", {"runtime/panel/web/"}},
    ThirdParty{"<boost/lockfree", {"runtime/panel/operate/"}},
    ThirdParty{"<CLI/", {"generator/app/", "runtime/host/"}},
    ThirdParty{"<kainjow/", {"generator/emit/"}},
    ThirdParty{"<open62541/", {"runtime/link/opc_ua/"}},
    ThirdParty{"<uchardet", {"generator/text/"}},
    ThirdParty{"<zlib.h>", {"runtime/panel/web/"}},
    ThirdParty{"<zip.h>", {"generator/read/archive.cpp", "generator/convert/"}},
    ThirdParty{"<pugixml", {"generator/read/xml/", "generator/read/cells/"}},
};

struct Include {
  std::size_t line;
  std::string_view what;  ///< quotes or brackets included
};

std::vector<std::string_view> lines(std::string_view text) {
  std::vector<std::string_view> all;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    all.push_back(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
  }
  return all;
}

std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  return begin == text.npos ? std::string_view() : text.substr(begin);
}

std::vector<Include> includes(std::string_view text) {
  std::vector<Include> found;
  std::size_t number = 0;
  for (std::string_view line : lines(text)) {
    ++number;
    line = without_blanks(line);
    if (!line.starts_with('#')) continue;
    line = without_blanks(line.substr(1));
    if (!line.starts_with("include")) continue;
    line = without_blanks(line.substr(7));
    if (line.empty()) continue;
    const std::size_t end = line.find(line.front() == '<' ? '>' : '"', 1);
    if (end != line.npos) found.push_back({number, line.substr(0, end + 1)});
  }
  return found;
}

std::optional<std::size_t> index(std::span<const std::string_view> floors, std::string_view floor) {
  const auto at = std::find(floors.begin(), floors.end(), floor);
  if (at == floors.end()) return std::nullopt;
  return static_cast<std::size_t>(at - floors.begin());
}

std::string_view first_part(std::string_view path) { return path.substr(0, path.find('/')); }

std::string_view behind_first_part(std::string_view path) {
  const std::size_t slash = path.find('/');
  return slash == path.npos ? std::string_view() : path.substr(slash + 1);
}

/// The layer of a file of the generator, by its path in there.
std::string_view generator_layer(std::string_view path) {
  if (first_part(path) != "elements") return first_part(path);
  std::string_view stem = path.substr(path.rfind('/') + 1);
  stem = stem.substr(0, stem.find('.'));
  for (const ElementFile& file : kElementFiles) {
    if (file.stem == stem) return file.layer;
  }
  return "model";
}

bool may_use_of_runtime(std::string_view generator_floor, std::string_view used) {
  const std::string word = " " + std::string(used) + " ";
  return std::any_of(kRuntimeUse.begin(), kRuntimeUse.end(), [&](const RuntimeUse& use) {
    return use.floor == generator_floor && use.uses.find(word) != use.uses.npos;
  });
}

/// What is wrong with an include in a file of the given layer; empty if the include is allowed.
std::string fault_of(std::string_view what, bool in_generator, std::string_view floor) {
  const std::string_view header = what.substr(1, what.size() - 2);
  const bool of_runtime = first_part(header) == "symplant";
  if (what.front() == '<') return of_runtime ? "is the project's own: write it in quotes" : "";

  std::string_view used = of_runtime ? first_part(behind_first_part(header)) : generator_layer(header);
  if (of_runtime && used == kProgramInterface) used.remove_suffix(2);
  const auto at = of_runtime ? index(kRuntime, used) : index(kGenerator, used);
  if (!at) return "is on no floor";
  if (!of_runtime && !in_generator) return "is the generator's: the runtime stands alone";
  const bool allowed = !of_runtime    ? *at <= *index(kGenerator, floor)
                       : in_generator ? may_use_of_runtime(floor, used)
                                      : *at <= *index(kRuntime, floor);
  return allowed ? "" : "climbs: `" + std::string(floor) + "` may not use it";
}

std::string fault(const File& file, std::size_t line, std::string_view what) {
  return file.path + ":" + std::to_string(line) + ": " + std::string(what);
}

bool in_house(const File& file) { return file.path.starts_with("generator/") || file.path.starts_with("runtime/"); }

bool is_source(const fs::path& path) { return path.extension() == ".hpp" || path.extension() == ".cpp"; }

}  // namespace

std::string layer_of(const std::string& path) {
  const std::string_view rest = behind_first_part(path);
  const bool in_generator = path.starts_with("generator/");
  return std::string(first_part(path)) + "/" + std::string(in_generator ? generator_layer(rest) : first_part(rest));
}

Tree read_tree(const std::string& root, const std::vector<std::string>& folders) {
  Tree tree;
  for (const std::string& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(root) / folder)) {
      if (!entry.is_regular_file() || !is_source(entry.path())) continue;
      std::ifstream file(entry.path(), std::ios::binary);
      tree.push_back({fs::relative(entry.path(), root).generic_string(),
                      std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>())});
    }
  }
  std::sort(tree.begin(), tree.end(), [](const File& a, const File& b) { return a.path < b.path; });
  return tree;
}

Faults climbing_includes(const Tree& tree) {
  Faults faults;
  for (const File& file : tree) {
    if (!in_house(file)) continue;
    const bool in_generator = file.path.starts_with("generator/");
    const std::string_view path = behind_first_part(file.path);
    const std::string_view floor = in_generator ? generator_layer(path) : first_part(path);
    if (!(in_generator ? index(kGenerator, floor) : index(kRuntime, floor))) {
      faults.push_back(fault(file, 1, "stands on no floor"));
      continue;
    }
    for (const Include& include : includes(file.text)) {
      const std::string what = fault_of(include.what, in_generator, floor);
      if (!what.empty()) faults.push_back(fault(file, include.line, std::string(include.what) + " " + what));
    }
  }
  return faults;
}

Faults stray_third_parties(const Tree& tree) {
  Faults faults;
  for (const File& file : tree) {
    if (!in_house(file)) continue;
    for (const Include& include : includes(file.text)) {
      for (const ThirdParty& party : kThirdParties) {
        if (!include.what.starts_with(party.include)) continue;
        const bool allowed = std::any_of(party.folders.begin(), party.folders.end(), [&](std::string_view folder) {
          return !folder.empty() && file.path.starts_with(folder);
        });
        if (!allowed) faults.push_back(fault(file, include.line, std::string(include.what) + " is not for this floor"));
      }
      if (include.what == "<nlohmann/json.hpp>" && file.path.ends_with(".hpp")) {
        faults.push_back(fault(file, include.line, "a header takes <nlohmann/json_fwd.hpp>"));
      }
    }
  }
  return faults;
}

Faults missing_heads(const Tree& tree) {
  Faults faults;
  for (const File& file : tree) {
    const std::string_view head = std::string_view(file.text).substr(0, file.text.find('\n'));
    if (!head.starts_with("// ") || head.size() < kLeastHead) {
      faults.push_back(fault(file, 1, "the first line does not say what the file is for"));
    }
  }
  return faults;
}

Faults closed_pipes(const Tree& scripts) {
  static const std::regex early(R"(\|\s*(grep\s+-[a-zA-Z]*q|head\b))");
  Faults faults;
  for (const File& file : scripts) {
    std::size_t number = 0;
    for (const std::string_view line : lines(file.text)) {
      ++number;
      if (std::regex_search(line.begin(), line.end(), early)) {
        faults.push_back(
            fault(file, number, "the pipe may be closed early: read all of it (`grep >/dev/null`, `sed -n 1p`)"));
      }
    }
  }
  return faults;
}

Faults long_files(const Tree& tree) {
  Faults faults;
  for (const File& file : tree) {
    const std::size_t count = lines(file.text).size();
    if (count > kMostLines) faults.push_back(fault(file, kMostLines + 1, std::to_string(count) + " lines"));
  }
  return faults;
}

}  // namespace symplant::arch
