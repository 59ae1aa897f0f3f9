// SP102: the bytes of a file are not text in a known encoding.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kUndecodableText{
    .id = "SP102",
    .slug = "undecodable-text",
    .severity = diag::Severity::error,
    .summary = "a file is not text in a known encoding",
    .page =
        R"page(The file is neither UTF-8 nor UTF-16, or not in the requested encoding, or it holds characters that no text has
(NUL, or many control characters). Either the list is in the code page of the machine that exported it (Western, Korean,
Japanese ...), or the file is not a text: a workbook, a project file, an archive. The location is that of the first invalid
bytes; the message shows them in hexadecimal.

**What the model loses.** It cannot be built, and nothing is written. symplant does not guess a code page: a wrong guess
would spoil names without notice. The message proposes code pages that can decode the whole file, and shows how each would
read this location: one if the file has enough words to recognize it, else up to five.

**How to fix it.** Give the encoding that reads as your language: `--encoding cp949`, or in plant.json
`{ "file": "symbols.csv", "encoding": "cp949" }`. If none does, give the code page of the machine that exported the list:
cp932 in Japan, cp949 in Korea, gb18030 in China, cp950 in Taiwan, cp1252 in Western, cp1250 in Central Europe, cp1251 for
Cyrillic. Or export the list as Unicode text, or open it in an editor and save it as UTF-8. Text in UTF-16 without a
byte order mark may need `--encoding utf-16le` or `--encoding utf-16be`; if `--encoding` is given, try without it.
)page"};

}  // namespace symplant::read
