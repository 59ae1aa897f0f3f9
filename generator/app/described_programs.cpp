// The PLC programs of a plant's description, as the host takes them.
#include "app/described_programs.hpp"

#include <filesystem>

namespace symplant::app {

DescribedPrograms::DescribedPrograms(const description::Description& description, const std::string& plant_file) {
  const std::filesystem::path folder = std::filesystem::path(plant_file).parent_path();
  for (const description::ProgramDescription& given : description.programs) {
    files_.push_back((folder / given.file).generic_string());
    ignored_.emplace_back(given.ignore.begin(), given.ignore.end());
    rows_.push_back({given.controller, files_.back(), given.period, given.delay, given.on_loss, ignored_.back()});
  }
}

}  // namespace symplant::app
