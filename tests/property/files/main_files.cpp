// Random plants as files: the output of `symplant run` must match the reference.
#include "property/files/program_files.hpp"

int main(int argc, char** argv) {
  const auto options = symplant::property::read_options({argv + 1, argv + argc});
  return options ? symplant::property::files::run_files(*options) : 2;
}
