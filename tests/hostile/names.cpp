// Hostile names, and lists of such names.
#include <array>

#include "inputs.hpp"

namespace symplant::hostile {
namespace {

/// Each name as a device with two states, and as a state of a device.
std::string levels_list(const std::vector<std::string>& levels) {
  std::string text = kHeader;
  std::size_t number = 0;
  for (const std::string& level : levels) {
    for (const std::string& name : {"L_P_" + level + "_O_", "L_P_" + level + "_I_"}) {
      for (const char* task : {"ONE1", "TWO2"}) text += row(name + task, number++);
    }
  }
  for (const std::string& level : levels) {
    text += row("L_P_STATES_O_" + level, number) + row("L_P_STATES_I_" + level, number + 1);
    number += 2;
  }
  return text;
}

std::string cell(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

std::string names_list(const std::vector<std::string>& names) {
  std::string text = kHeader;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += "VAR_GLOBAL," + cell(names[i]) + ",,%IX" + std::to_string(i) + ",BOOL,TRUE\n";
  }
  return text;
}

std::string levels() { return levels_list(hostile_levels()); }
std::string texts() { return names_list(hostile_names()); }

std::string one_case() {
  return kHeader + row("L_P_DOOR_O_OPEN", 0) + row("L_P_DOOR_I_OPEN", 1) + row("L_P_Door_O_CLOSE", 2) +
         row("L_P_Door_I_CLOSE", 3) + row("l_p_door_I_open", 4) + row("L_P_LAMP_O_ON", 5) + row("L_P_LAMP_O_On", 6);
}

std::string no_identifier() {
  std::string text = kHeader;
  std::size_t number = 0;
  for (const char* device : {"D\xC3\xA4", "D\xC3\xB6", "D\xEA\xB3\xB5", "D", "DU00E4"}) {
    for (const char* task : {"A\xC3\xA4", "A\xC3\xB6", "A"}) {
      text += row("L_P_" + std::string(device) + "_O_" + task, number);
      text += row("L_P_" + std::string(device) + "_I_" + task, number + 1);
      number += 2;
    }
  }
  for (const char* name : {"a-b", "a b", "a_b", "a.b", "a+b"}) text += row(name, number++);
  return text;
}

/// The same word composed and decomposed: different names that look the same.
std::string composed() {
  return kHeader + row("L_P_\xC3\x84_I_P1", 0) + row("L_P_A\xCC\x88_I_P1", 1) + row("L_P_\xD0\x90_I_P1", 2) +
         row("L_P_A_I_P1", 3);
}

std::string very_long_names() {
  const std::string level(20'000, 'A');
  return kHeader + row("L_P_" + level + "_O_P1", 0) + row("L_P_" + level + "_I_P1", 1) +
         row("L_P_D_O_" + level + "1", 2) + row("L_P_D_I_" + level + "1", 3) + row("L_P_D_O_" + level + "2", 4) +
         row("L_P_D_I_" + level + "2", 5) + row(std::string(20'000, '*'), 6);
}

std::string long_line() { return kHeader + row("L_P_D_I_" + std::string(50'000'000, 'A'), 0); }

std::string long_sequence() {
  const std::string digits(29, '9');
  std::string text = kHeader;
  for (int i = 0; i < 4; ++i) {
    const std::string number = digits + std::to_string(i);
    text += row("L_P_D_O_S" + number, static_cast<std::size_t>(2 * i)) +
            row("L_P_D_I_S" + number, static_cast<std::size_t>(2 * i + 1));
  }
  return text;
}

constexpr std::array kNameInputs{
    Input{Input::Kind::list,
          "devices and states called as C++ keywords, macros (`NULL`, `errno`, `linux`, `EOF`, `I`), "
          "digits first, in other scripts",
          levels},
    Input{Input::Kind::list,
          "names with quotes, `*/`, `{{`, `}}`, `%n`, backslashes, `?\?/`, CR, LF, bidi and zero-width "
          "characters, formulas",
          texts},
    Input{Input::Kind::list, "names that differ only by case", one_case},
    Input{Input::Kind::list, "names that differ only by a character that no identifier can hold", no_identifier},
    Input{Input::Kind::list, "names composed, decomposed, and of look-alike letters", composed},
    Input{Input::Kind::list, "names of 20,000 characters", very_long_names},
    Input{Input::Kind::list, "a name of 50 MB", long_line, true},
    Input{Input::Kind::list, "sequence numbers of 30 digits", long_sequence},
};

}  // namespace

std::span<const Input> name_inputs() { return kNameInputs; }

std::vector<std::string> hostile_levels() {
  return {"NULL",
          "errno",
          "linux",
          "unix",
          "EOF",
          "I",
          "O",
          "class",
          "int",
          "return",
          "namespace",
          "this",
          "concept",
          "coawait",
          "and",
          "not",
          "xor",
          "main",
          "std",
          "symplant",
          "State",
          "assert",
          "stdin",
          "EBUSY",
          "INFINITY",
          "true",
          "1ST",
          "42",
          "0x1F",
          "CON",
          "NUL",
          "\xEA\xB3\xB5\xEC\xA0\x95",
          "\xD8\xB9\xD8\xB1\xD8\xA8\xD9\x8A",
          "\xE4\xB8\xAD\xE6\x96\x87",
          "\xC3\x84\xC3\x9F",
          "\xD0\x9F\xD1\x80\xD0\xB5\xD1\x81\xD1\x81"};
}

std::vector<std::string> hostile_names() {
  std::vector<std::string> names{"quote\"inside",
                                 "'single'",
                                 "\"",
                                 "comment */ end",
                                 "/* comment",
                                 "// comment",
                                 "{{plant}}",
                                 "{{{unit_rows}}}",
                                 "}}",
                                 "{{#types}}",
                                 "%n%n%s",
                                 "%",
                                 "back\\slash",
                                 "ends with \\",
                                 "\\",
                                 "\\\\",
                                 "\\n",
                                 "\\u0041",
                                 "\\x41",
                                 "\\0",
                                 "trigraph ?\?/",
                                 "?\?/",
                                 "?\?)",
                                 "cr\rinside",
                                 "lf\ninside",
                                 "crlf\r\ninside",
                                 "tab\tinside",
                                 "vt\vff\f",
                                 "esc\x1B[31m",
                                 "bell\a",
                                 "bidi \xE2\x80\xAE end",
                                 "isolate \xE2\x81\xA6",
                                 "zero\xE2\x80\x8Bwidth",
                                 "joiner\xE2\x80\x8D",
                                 "bom\xEF\xBB\xBF"
                                 "inside",
                                 "line\xE2\x80\xA8separator",
                                 "next\xC2\x85line",
                                 "soft\xC2\xADhyphen",
                                 "no\xC2\xA0"
                                 "break",
                                 "\xF0\x9F\xA4\x96",
                                 "e\xCC\x81",
                                 "\xEF\xBF\xBD",
                                 "\xEF\xBF\xBF",
                                 "\xF4\x8F\xBF\xBF",
                                 "#define X",
                                 "#include <a>",
                                 "R\"(raw)\"",
                                 ")\"",
                                 "$(rm)",
                                 "`tick`",
                                 "<script>",
                                 "</script>",
                                 "&amp;",
                                 "]]>",
                                 "-->",
                                 "=1+1",
                                 "+1",
                                 "-1",
                                 "@sum",
                                 "a;b",
                                 "a,b",
                                 "a|b",
                                 "../../etc/passwd",
                                 "C:\\x",
                                 "a/b",
                                 "NULL",
                                 "errno",
                                 "class",
                                 "1",
                                 "_",
                                 "__",
                                 "___",
                                 "__x",
                                 "_X",
                                 "a b",
                                 "a  b",
                                 "<U+202E>",
                                 "\xEA\xB3\xB5\xEC\xA0\x95",
                                 "not",
                                 "and",
                                 "a.b",
                                 "don't'"};
  names.push_back(std::string(20'000, 'x'));
  names.push_back(repeated("\"\\", 5'000));
  return names;
}

}  // namespace symplant::hostile
