// Patterns for devices that belong together.
#include "learn/patterns.hpp"

#include <map>
#include <string>
#include <vector>

#include "learn_support.hpp"

namespace symplant::test {
namespace {

/// A plant of devices with one operation and one event each.
class Devices {
 public:
  explicit Devices(const std::vector<std::string>& paths) : plant_(bits(symbols(paths)), R"("devices": {})") {}

  /// The names of groups, each by the paths of its devices: `A, B | C`.
  std::string names(const std::vector<std::vector<std::string>>& groups, const std::vector<std::size_t>& keys = {}) {
    std::vector<learn::NamedGroup> named;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      learn::NamedGroup group{{}, g < keys.size() ? keys[g] : 0, {}};
      for (const std::string& path : groups[g]) group.units.push_back(plant_.unit(path));
      named.push_back(group);
    }
    learn::name_groups(plant_.compiled().plant, named);
    std::string text;
    for (const learn::NamedGroup& group : named) {
      text += text.empty() ? "" : " | ";
      for (const learn::DevicesName& name : group.names)
        text += (&name == &group.names.front() ? "" : ", ") + name.name;
    }
    return text;
  }

 private:
  static std::vector<std::string> symbols(const std::vector<std::string>& paths) {
    std::vector<std::string> names;
    for (const std::string& path : paths) names.insert(names.end(), {path + "_O_ADV", path + "_I_ADV"});
    return names;
  }

  DescribedPlant plant_;
};

const std::vector<std::string> kLine = {"BB_S10_CLAMP1", "BB_S10_CLAMP2", "BB_S20_CLAMP1",
                                        "BB_S20_CLAMP2", "BB_S20_GATE",   "BB_S20_GATE1"};

TEST_CASE("A device alone has its name") {
  Devices devices(kLine);
  CHECK(devices.names({{"BB_S10_CLAMP1"}, {"BB_S20_GATE"}}) == "BB_S10_CLAMP1 | BB_S20_GATE");
}

TEST_CASE("Devices that share a level in all but its end have a pattern") {
  Devices devices(kLine);
  CHECK(devices.names({{"BB_S10_CLAMP1", "BB_S10_CLAMP2"}}) == "BB_S10_CLAMP?");
  CHECK(devices.names({{"BB_S20_GATE", "BB_S20_GATE1"}}) == "BB_S20_GATE*");
  CHECK(devices.names({{"BB_S10_CLAMP1", "BB_S10_CLAMP2", "BB_S20_CLAMP1", "BB_S20_CLAMP2"}}) == "BB_S*_CLAMP?");
}

TEST_CASE("A pattern matches no device of which nothing was learned") {
  Devices devices(kLine);
  CHECK(devices.names({{"BB_S10_CLAMP1", "BB_S10_CLAMP2", "BB_S20_CLAMP1"}}) == "BB_S10_CLAMP?, BB_S20_CLAMP1");
}

TEST_CASE("A few devices with other times have exact names, which beat the pattern of the others") {
  Devices devices(kLine);
  CHECK(devices.names({{"BB_S20_CLAMP2"}, {"BB_S10_CLAMP1", "BB_S10_CLAMP2", "BB_S20_CLAMP1"}}) ==
        "BB_S20_CLAMP2 | BB_S*_CLAMP?");
}

TEST_CASE("A pattern matches no device whose entry has other keys") {
  Devices devices(kLine);
  CHECK(devices.names({{"BB_S20_CLAMP2"}, {"BB_S10_CLAMP1", "BB_S10_CLAMP2", "BB_S20_CLAMP1"}}, {1, 2}) ==
        "BB_S20_CLAMP2 | BB_S10_CLAMP?, BB_S20_CLAMP1");
}

TEST_CASE("Patterns of two groups match no device of each other") {
  Devices devices(kLine);
  CHECK(devices.names({{"BB_S10_CLAMP1", "BB_S20_CLAMP1"}, {"BB_S10_CLAMP2", "BB_S20_CLAMP2"}}) ==
        "BB_S*_CLAMP1 | BB_S*_CLAMP2");
  CHECK(devices.names({{"BB_S10_CLAMP1", "BB_S20_CLAMP2"}, {"BB_S10_CLAMP2", "BB_S20_CLAMP1"}}) ==
        "BB_S10_CLAMP1, BB_S20_CLAMP2 | BB_S10_CLAMP2, BB_S20_CLAMP1");
}

}  // namespace
}  // namespace symplant::test
