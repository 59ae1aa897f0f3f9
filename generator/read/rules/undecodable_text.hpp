// SP102: the bytes of a file are no text that can be read.
#pragma once

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr diag::RuleInfo kUndecodableText{
    .id = "SP102",
    .slug = "undecodable-text",
    .severity = diag::Severity::error,
    .summary = "a file is no text in a known encoding",
    .page =
        R"page(The file is neither UTF-8 nor UTF-16, or not in the encoding that was asked for, or it holds characters that no text has
(NUL, or many control characters). Either the list is in the code page of the machine that exported it (Western, Korean,
Japanese ...), or the file is no text at all: a workbook, a project file, an archive. The place is that of the first bytes
that do not fit; the message shows them in hexadecimal.

**What the model loses.** It cannot be built, and nothing is written. A code page is not guessed at: a wrong guess would
spoil names and nobody would notice. The message only proposes: what a likely code page would read at this place.

**How to mend it.** If the proposal reads as your language, give it: `--encoding cp949`, or in plant.json
`{ "file": "symbols.csv", "encoding": "cp949" }`. If not, give the code page of the machine that exported the list: cp932 in
Japan, cp949 in Korea, gb18030 in China, cp950 in Taiwan, cp1252 in Western, cp1250 in Central Europe, cp1251 where Cyrillic
is written. Or export the list as Unicode text, or open it in an editor and save it as UTF-8. Text in UTF-16 without a
byte order mark may need `--encoding utf-16le` or `--encoding utf-16be`; where `--encoding` is given, try without it.
)page"};

}  // namespace symplant::read
