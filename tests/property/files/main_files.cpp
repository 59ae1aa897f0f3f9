// Random plants as files: what `symplant run` makes of them must be what the reference says.
#include "property/files/program_files.hpp"

int main(int argc, char** argv) {
  const auto options = symplant::property::read_options({argv + 1, argv + argc});
  return options ? symplant::property::files::run_files(*options) : 2;
}
