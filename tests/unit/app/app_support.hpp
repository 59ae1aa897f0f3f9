// Shared parts of the tests of the tool: lists with each kind of fault, in memory.
#pragma once

#include <string>

#include "support/catch.hpp"
#include "support/compile.hpp"
#include "support/golden.hpp"
#include "support/strings.hpp"
#include "support/tool.hpp"

namespace symplant::test {

inline std::string excell() { return read_bytes(std::string(SYMPLANT_SOURCE_DIR) + "/examples/excell/excell.csv"); }

/// clean.csv, note.csv, warning.csv, error.csv: named by the most severe finding in each; and unreadable lists.
inline MemoryFileSystem lists() {
  MemoryFileSystem files;
  files.files["excell.csv"] = excell();
  files.files["clean.csv"] = excell();
  files.files["note.csv"] = list_text(bits({"L_P_D_O_RUN", "L_P_D_I_RUN", "L_P_B_I_ON"}));
  files.files["warning.csv"] = list_text(bits({"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B2", "L_P_D_I_B2", "START"}));
  files.files["error.csv"] = list_text({{"L_P_D_I_A", "X1"}, {"L_P_D_I_A", "X2"}});
  files.files["empty.csv"] = "";
  files.files["header.csv"] = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n";
  files.files["binary.csv"] = std::string(
      "\x7F"
      "ELF\x02\x01\x01\0\0\0\0\0\xFF\xFE\xFD",
      15);
  files.files["nul.csv"] = std::string("Class,Identifier,Type\nVAR_GLOBAL,A\0B_C_D_I_X,BOOL\n", 50);
  files.files["quote.csv"] = "Class,Identifier,Type\nVAR_GLOBAL,\"A_B_C_I_X,BOOL\n";
  files.faults["denied.csv"] = "permission denied";
  files.faults["folder"] = "it is a directory";
  return files;
}

inline const std::vector<std::string> kUnreadable{"missing.csv", "empty.csv", "header.csv", "binary.csv",
                                                  "nul.csv",     "quote.csv", "denied.csv", "folder"};

inline ToolRun run_lists(const std::vector<std::string>& arguments) {
  MemoryFileSystem files = lists();
  return run_tool(arguments, files);
}

}  // namespace symplant::test
