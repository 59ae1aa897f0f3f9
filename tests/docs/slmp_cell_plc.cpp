// A PLC on a port of this machine that runs the program of the paper's cell, for the commands of docs/mitsubishi.md.
//
//   slmp_cell_plc PORT COMMAND...   serves until the command has ended; its exit code
#include <cstdlib>
#include <iostream>
#include <string>

#include "support/slmp/slmp_plc.hpp"
#include "unit/slmp/cell_bench.hpp"

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  try {
    symplant::test::slmp::PlcOptions options;
    options.port = static_cast<std::uint16_t>(std::stoi(argv[1]));
    options.program = [](symplant::test::slmp::PlcMemory& memory) { symplant::test::scan_cell(memory); };
    const symplant::test::slmp::SlmpPlc plc(options);
    std::string command;
    for (int i = 2; i < argc; ++i) command += std::string(i == 2 ? "" : " ") + argv[i];
    return std::system(command.c_str()) == 0 ? 0 : 1;  // NOLINT(cert-env33-c): the command is the test's own
  } catch (const std::exception& error) {
    std::cerr << "slmp_cell_plc: " << error.what() << "\n";
    return 3;
  }
}
