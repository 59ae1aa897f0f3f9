// How many bytes of each format are read in a second: lists of one row over and over, with another name in each.
#include "read/readers.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>

namespace symplant::bench {
namespace {

constexpr std::size_t kBytes = 20'000'000;

/// `row` has `{0}` for a number, and `{1}` for its byte and bit.
struct Format {
  std::string_view name;
  std::string_view head;
  std::string_view row;
  std::string_view tail;
};

constexpr std::array kFormats{
    Format{"gx-iec", "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n",
           "VAR_GLOBAL,LINE_P{0}_DEV_I_ADV,X{0:X},%IX{0},BOOL,FALSE,a comment\n", ""},
    Format{"table", "Tag;Operand;Note\n", "LINE_P{0}_DEV_I_ADV;%IX{1};a note of the row\n", ""},
    Format{"gx-works-labels", "Class\tLabel Name\tData Type\tAssign (Device/Label)\tComment\n",
           "\"VAR_GLOBAL\"\t\"LINE_P{0}_DEV_I_ADV\"\t\"Bit\"\t\"X{0:X}\"\t\"a comment\"\n", ""},
    Format{"tia-sdf", "",
           "\"LINE_P{0}_DEV_I_ADV\",\"%I{1}\",\"Bool\",\"True\",\"True\",\"False\",\"a comment\",\"\",\"True\"\n", ""},
    Format{"step7-asc", "", "126,{0:<24}I {1:>9} BOOL      a comment of the row                                     \n",
           ""},
    Format{"rockwell-csv",
           "remark,\"CSV-Import-Export\"\n0.3\nTYPE,SCOPE,NAME,DESCRIPTION,DATATYPE,SPECIFIER,ATTRIBUTES\n",
           "ALIAS,,I{0},\"a$Ncomment\",\"\",\"Local:1:I.Data[{0}].3\",\"(RADIX := Decimal)\"\n", ""},
    Format{"ls-tags", "Type,Scope,Variable,Address,DataType,Property,Comment\n",
           "Tag,GlobalVariable,\"LINE_P{0}_DEV_I_ADV\",%IW{0}.1,\"BOOL\",,\"\"\n", ""},
    Format{"omron-cxt", "CXProgVer:=\"1.8\";\nGlobalVariables:=\nBEGIN\nVariableList:=\nBEGIN_LIST_$#[5]\n",
           "LINE_P{0}_DEV_I_ADV,{1},BOOL,,,a comment;\n", "END_LIST_$#[5];\nEND\n"},
    Format{"st", "VAR_GLOBAL\n", "  LINE_P{0}_DEV_I_ADV AT %IX{1} : BOOL := FALSE; // a comment\n", "END_VAR\n"},
    Format{"tia-tag-table", "<?xml version='1.0'?>\n<Tagtable name='a'>\n",
           "  <Tag type='Bool' hmiVisible='True' remark='a comment' addr='%I{1}'>LINE_P{0}_DEV_I_ADV</Tag>\n",
           "</Tagtable>\n"},
    Format{"plcopen",
           "<?xml version='1.0'?>\n<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"><instances><configurations>"
           "<configuration name=\"c\"><globalVars name=\"io\">\n",
           "<variable name=\"LINE_P{0}_DEV_I_ADV\" address=\"%IX{1}\"><type><BOOL/></type></variable>\n",
           "</globalVars></configuration></configurations></instances></project>\n"},
};

std::string text_of(const Format& format) {
  std::string text(format.head);
  for (std::size_t i = 0; text.size() < kBytes; ++i) {
    const std::string bit = fmt::format("{}.{}", i / 8, i % 8);
    text += fmt::format(fmt::runtime(format.row), i, bit);
  }
  return text.append(format.tail);
}

void read_format(benchmark::State& state, const Format& format) {
  const std::string text = text_of(format);
  for (auto _ : state) {
    diag::Diagnostics diagnostics;
    const auto table = read::read_symbol_list("list", text, {}, diagnostics);
    if (!table || table->rows.size() < kBytes / 1000) state.SkipWithError("not read");
    benchmark::DoNotOptimize(table);
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

const bool kRegistered = [] {
  for (const Format& format : kFormats) {
    benchmark::RegisterBenchmark(std::string(format.name).c_str(), [&format](benchmark::State& state) {
      read_format(state, format);
    })->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace symplant::bench
