// Hostile symbol lists.
#include <array>
#include <cstdint>

#include "inputs.hpp"
#include "text/utf8.hpp"

namespace symplant::hostile {
namespace {

/// Random bytes, the same each time; 0 is among them.
std::string noise(std::size_t size) {
  std::string bytes;
  std::uint32_t state = 12345;
  for (std::size_t i = 0; i < size; ++i) {
    state = state * 1664525U + 1013904223U;
    bytes += static_cast<char>(state >> 24U);
  }
  return bytes;
}

std::string utf16(const std::string& ascii, bool little) {
  std::string bytes = little ? "\xFF\xFE" : "\xFE\xFF";
  for (const char c : ascii) bytes += little ? std::string{c, '\0'} : std::string{'\0', c};
  return bytes;
}

std::string empty() { return ""; }
std::string blanks() { return " \t\r\n\n\r  \n"; }
std::string header_alone() { return kHeader; }
std::string binary() { return noise(100'000); }
std::string zipped() { return "PK\x03\x04" + noise(10'000); }
std::string zeros() { return std::string(1'000'000, '\0'); }
std::string nul_in_name() { return kHeader + row(std::string("L_P_D_I_P\0001", 11), 0) + row("L_P_D_I_P2", 1); }
std::string one_long_line() { return std::string(50'000'000, 'A'); }
std::string long_comment() { return kHeader + ("VAR_GLOBAL,L_P_D_I_P1,,%IX1,BOOL," + std::string(50'000'000, ' ')); }
std::string columns_of_header() {
  return "Class,Identifier" + std::string(1'000'000, ',') + "\nVAR_GLOBAL,L_P_D_I_P1\n";
}
std::string columns_of_row() {
  return kHeader + ("VAR_GLOBAL,L_P_D_I_P1,,%IX1,BOOL,FALSE" + std::string(1'000'000, ',')) + "\n";
}
std::string surrogate_utf8() { return kHeader + row("L_P_D_I_\xED\xA0\x80", 0); }
std::string surrogate_utf16() {
  std::string bytes = utf16(kHeader + row("L_P_D_I_P1", 0), true);
  bytes[bytes.size() - 4] = '\x00';
  bytes[bytes.size() - 3] = '\xD8';
  return bytes;
}
std::string odd_utf16() { return utf16(good_list(), true) + "A"; }
std::string big_endian() { return utf16(good_list(), false); }
std::string overlong() { return kHeader + row("L_P_D_I_\xC0\xAF", 0); }
std::string code_page() { return kHeader + row("L_P_\xB0\xF8\xC1\xA4_I_P1", 0); }
std::string unclosed() {
  return kHeader + row("L_P_D_I_P1", 0) + "VAR_GLOBAL,\"L_P_D_I_P2,,%IX2,BOOL,FALSE\n" + row("L_P_D_I_P3", 2);
}
std::string unclosed_far() { return kHeader + ("VAR_GLOBAL,\"" + repeated(row("L_P_D_I_P1", 0), 1'000'000)); }
std::string quotes() { return kHeader + ("VAR_GLOBAL,\"" + std::string(10'000'001, '"')) + "\n"; }
std::string header_twice() { return kHeader + row("L_P_D_I_P1", 0) + kHeader + row("L_P_D_I_P2", 1); }
std::string columns_twice() {
  return "Class,Identifier,Identifier,Class,Type,Type\nVAR_GLOBAL,L_P_D_I_P1,L_P_D_I_P2,VAR_GLOBAL,BOOL,INT\n";
}
std::string carriage_returns() {
  std::string text = good_list();
  for (char& c : text) c = c == '\n' ? '\r' : c;
  return text;
}
std::string two_delimiters() { return kHeader + row("L_P_D_I_P1", 0) + "VAR_GLOBAL;L_P_D_I_P2;;%IX1;BOOL;FALSE\n"; }

std::string far_addresses() {
  std::string text = kHeader;
  int number = 0;
  for (const std::string address : {"18446744073709551615", "18446744073709551616", "99999999999999999999999999", "-1",
                                    "0.99999999999999999999", "1.1.1.1.1.1", "0x10", "1e9"}) {
    text += "VAR_GLOBAL,L_P_D_I_P" + std::to_string(++number) + ",X" + address + ",%IX" + address + ",BOOL,FALSE\n";
    text += "VAR_GLOBAL,L_P_E_I_P" + std::to_string(number) + ",D" + address + ",%IW" + address + ",INT,0\n";
  }
  return text + "VAR_GLOBAL,L_P_F_I_P1,XFFFFFFFFFFFFFFFFFFFFFFFF,%IX" + std::string(60'000, '9') + ",BOOL,FALSE\n";
}

std::string far_initials() {
  std::string text = kHeader;
  std::size_t number = 0;
  for (const char* type :
       {"BOOL", "INT", "DINT", "LINT", "ULINT", "WORD", "REAL", "LREAL", "STRING[99999999999]", "FLOAT128"}) {
    for (const char* initial : {"99999999999999999999999", "-99999999999999999999999", "1e999", "NaN", "inf",
                                "16#FFFFFFFFFFFFFFFFF", "T#1s"}) {
      text += "VAR_GLOBAL,V" + std::to_string(number) + ",,%ML" + std::to_string(number * 4) + "," + type + "," +
              initial + "\n";
      ++number;
    }
  }
  return text;
}

std::string many_states() {
  std::string text = kHeader;
  for (std::size_t i = 0; i < 5'000; ++i) {
    text += row("L_P_D_O_S" + std::to_string(i), 2 * i) + row("L_P_D_I_S" + std::to_string(i), 2 * i + 1);
  }
  return text;
}

std::string most_states() {
  std::string text = kHeader;
  for (std::size_t i = 0; i < 200; ++i) {
    text += row("L_P_D_O_S" + std::to_string(i), 2 * i) + row("L_P_D_I_S" + std::to_string(i), 2 * i + 1);
  }
  return text;
}

std::string many_devices() {
  std::string text = kHeader;
  for (std::size_t i = 0; i < 20'000; ++i) text += row("L_P_D" + std::to_string(i) + "_I_ON", i);
  return text;
}

std::string many_tasks() {  // each in a separate device, all different
  std::string text = kHeader;
  for (std::size_t i = 0; i < 20'000; ++i) text += row("L_P_D" + std::to_string(i) + "_I_T" + std::to_string(i), i);
  return text;
}

std::string one_symbol_often() { return kHeader + repeated(row("L_P_D_I_P1", 1), 100'000); }
std::string one_address_often() {
  std::string text = kHeader;
  for (int i = 0; i < 20'000; ++i) text += row("L_P_D" + std::to_string(i) + "_I_ON", 1);
  return text;
}
std::string many_findings() {
  std::string text = kHeader;
  for (std::size_t i = 0; i < 100'000; ++i) text += row("a-b " + std::to_string(i), i);
  return text;
}
std::string many_levels() { return kHeader + row("L_P_D_I_P1" + repeated("_I", 1'000'000), 0); }

std::string cut_in_header() { return good_list().substr(0, 14); }
std::string cut_in_cell() { return good_list().substr(0, 130); }
std::string cut_in_character() { return kHeader + row("L_P_\xEA\xB3\xB5_I_P1", 0).substr(0, 17); }

constexpr auto kList = Input::Kind::list;
constexpr std::array kListInputs{
    Input{kList, "an empty file", empty},
    Input{kList, "blanks and line ends alone", blanks},
    Input{kList, "a header alone", header_alone},
    Input{kList, "100,000 bytes of noise", binary},
    Input{kList, "a zip archive", zipped},
    Input{kList, "1 MB of NUL bytes", zeros},
    Input{kList, "a NUL within a name", nul_in_name},
    Input{kList, "one line of 50 MB, without a header", one_long_line, true},
    Input{kList, "a cell of 50 MB of blanks", long_comment, true},
    Input{kList, "a header of a million columns", columns_of_header},
    Input{kList, "a row of a million columns", columns_of_row},
    Input{kList, "a lone surrogate in UTF-8", surrogate_utf8},
    Input{kList, "a lone surrogate in UTF-16", surrogate_utf16},
    Input{kList, "UTF-16 cut within a character", odd_utf16},
    Input{kList, "a good list in UTF-16, big-endian", big_endian},
    Input{kList, "overlong UTF-8", overlong},
    Input{kList, "a Korean code page", code_page},
    Input{kList, "a quote that is never closed", unclosed},
    Input{kList, "the same, a million rows before the end", unclosed_far, true},
    Input{kList, "ten million quotes", quotes, true},
    Input{kList, "a good list cut within its header", cut_in_header},
    Input{kList, "a good list cut within a cell", cut_in_cell},
    Input{kList, "a list cut within a character", cut_in_character},
    Input{kList, "the header twice", header_twice},
    Input{kList, "a header with repeated columns", columns_twice},
    Input{kList, "lines that end in CR", carriage_returns},
    Input{kList, "two delimiters in one file", two_delimiters},
    Input{kList, "addresses beyond 64 bits, negative, of six levels", far_addresses},
    Input{kList, "initial values beyond their types, unknown types", far_initials},
    Input{kList, "one device of 5,000 states", many_states, true},
    Input{kList, "one device of 200 states", most_states, true},
    Input{kList, "20,000 devices of one symbol, all alike", many_devices, true},
    Input{kList, "20,000 devices of one symbol, none alike", many_tasks, true},
    Input{kList, "one symbol in 100,000 rows", one_symbol_often, true},
    Input{kList, "one address in 20,000 rows", one_address_often, true},
    Input{kList, "100,000 rows with a finding each", many_findings, true},
    Input{kList, "a name of a million levels", many_levels, true},
};

}  // namespace

std::span<const Input> list_inputs() { return kListInputs; }

std::string repeated(const std::string& text, std::size_t times) {
  std::string result;
  result.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

std::string row(const std::string& name, std::size_t number, const std::string& type, const std::string& initial) {
  const bool operation = name.find("_O_") != std::string::npos;
  return "VAR_GLOBAL," + name + ",," + (operation ? "%QX" : "%IX") + std::to_string(number) + "," + type + "," +
         initial + "\n";
}

std::string good_list() {
  std::string text = kHeader;
  std::size_t number = 0;
  for (const char* name : {"L_P_AGV_O_P1", "L_P_AGV_I_P1", "L_P_AGV_O_P2", "L_P_AGV_I_P2", "L_P_CYL_O_ADV",
                           "L_P_CYL_I_ADV", "L_P_CYL_I_RET", "L_P_LAMP_O_ON", "L_P_BUTTON_I_PRESSED"}) {
    text += row(name, number++);
  }
  return text + "VAR_GLOBAL,LEVEL,,%IW10,INT,0\n";
}

}  // namespace symplant::hostile
