// The property test as a program.
#include "property/program.hpp"

int main(int argc, char** argv) { return symplant::property::run_program({argv + 1, argv + argc}); }
