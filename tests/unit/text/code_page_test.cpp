// Legacy code pages, and proposals of one.
#include <iconv.h>

#include <array>
#include <string>

#include "support/catch.hpp"
#include "support/strings.hpp"
#include "text/encoding.hpp"

using namespace symplant;
using namespace symplant::text;
using namespace std::string_literals;

namespace {

/// UTF-8 converted to another encoding, named as iconv names it.
std::string encoded(std::string text, const char* name) {
  const iconv_t converter = iconv_open(name, "UTF-8");
  REQUIRE(converter != reinterpret_cast<iconv_t>(-1));
  std::string bytes(text.size() * 4 + 16, '\0');
  char* in = text.data();
  std::size_t left = text.size();
  char* out = bytes.data();
  std::size_t room = bytes.size();
  INFO(text << " in " << name);
  REQUIRE(iconv(converter, &in, &left, &out, &room) == 0);
  iconv_close(converter);
  bytes.resize(bytes.size() - room);
  return bytes;
}

std::string decoded(const std::string& bytes, Encoding encoding) {
  const auto result = decode(std::string(bytes), &encoding);
  INFO(encoding_name(encoding) << ": " << (result ? "" : result.error().what));
  REQUIRE(result);
  CHECK(result->encoding == encoding);
  return result->text;
}

DecodeError fault(const std::string& bytes, Encoding encoding) {
  const auto result = decode(std::string(bytes), &encoding);
  REQUIRE_FALSE(result);
  return result.error();
}

/// "cp949 cp932": the encodings proposed for bytes that are not UTF-8.
std::string guesses(const std::string& bytes) {
  const auto result = decode(std::string(bytes));
  REQUIRE_FALSE(result);
  std::string names;
  for (const EncodingGuess& guess : result.error().guesses) {
    names.append(names.empty() ? "" : " ").append(encoding_name(guess.encoding));
  }
  return names;
}

}  // namespace

TEST_CASE("cp949 is windows-949: 8C 63 is U+B620, 5C is a backslash") {
  CHECK(decoded("\x8C\x63", Encoding::cp949) == "\xEB\x98\xA0");
  CHECK(decoded("A\\B~", Encoding::cp949) == "A\\B~");
  CHECK(decoded("\xC5\xAC\xB7\xA5\xC7\xC1_\xC0\xFC\xC1\xF8", Encoding::cp949) == "클램프_전진");
}

TEST_CASE("The last character of a text in cp1255 or cp1258 is kept, whether a tone could follow it or not") {
  CHECK(decoded("\xC3", Encoding::cp1258) == "\xC4\x82");
  CHECK(decoded("a\xF5 b|", Encoding::cp1258) == "a\xC6\xA1 b|");
  CHECK(decoded("\xE0", Encoding::cp1255) == "\xD7\x90");
}

TEST_CASE("Each code page decodes its characters, and ASCII unchanged") {
  std::string ascii;
  for (char c = ' '; c <= '~'; ++c) ascii += c;
  ascii += "\r\n\t";
  for (const std::string_view name : encoding_names()) {
    const auto encoding = encoding_of_name(name);
    REQUIRE(encoding);
    CHECK(encoding_name(*encoding) == name);
    if (name.starts_with("utf")) continue;
    CHECK(decoded(ascii, *encoding) == ascii);
  }
  CHECK(decoded("\x83\x4E\x83\x89\xBC\xD8\xDD\x5C", Encoding::cp932) == "クラｼﾘﾝ\\");
  CHECK(decoded("\xBC\xD0\xBD\xF4\xB8\xEA", Encoding::gb18030) == "夹紧戈");
}

TEST_CASE("Common names of encodings are accepted, in any case and with or without hyphens") {
  struct Name {
    const char* name;
    Encoding encoding;
  };
  for (const Name& each : {Name{"Shift_JIS", Encoding::cp932},
                           Name{"shift-jis", Encoding::cp932},
                           Name{"SJIS", Encoding::cp932},
                           Name{"windows-31j", Encoding::cp932},
                           Name{"CP949", Encoding::cp949},
                           Name{"windows-949", Encoding::cp949},
                           Name{"UHC", Encoding::cp949},
                           Name{"EUC-KR", Encoding::cp949},
                           Name{"ks_c_5601-1987", Encoding::cp949},
                           Name{"gbk", Encoding::gb18030},
                           Name{"cp936", Encoding::gb18030},
                           Name{"GB2312", Encoding::gb18030},
                           Name{"Big5", Encoding::cp950},
                           Name{"windows-1252", Encoding::cp1252},
                           Name{"latin1", Encoding::cp1252},
                           Name{"ISO-8859-1", Encoding::cp1252},
                           Name{"windows 1251", Encoding::cp1251},
                           Name{"UTF8", Encoding::utf8},
                           Name{"utf-16", Encoding::utf16le},
                           Name{"ibm850", Encoding::cp850}}) {
    INFO(each.name);
    CHECK(encoding_of_name(each.name) == each.encoding);
  }
  for (const char* name : {"", "cp", "cp94", "cp9490", "korean", "-"}) CHECK_FALSE(encoding_of_name(name));
}

TEST_CASE("Bytes that are invalid in a code page are reported with line, column and value") {
  const DecodeError korean = fault("abc\r\n\xC5\xAC\xB7\xA5,\xFF\xFFx\n", Encoding::cp949);
  CHECK(korean.line == 2);
  CHECK(korean.column == 4);  // in characters: two of Korean, and a comma
  CHECK(test::contains(korean.what, "FF FF are not a character of cp949 here"));
  CHECK(korean.shown.substr(0, korean.shown_offset) == "abc\r\n클램,");
  const DecodeError western = fault("a\xE4\x81z", Encoding::cp1252);
  CHECK(western.column == 3);
  CHECK(western.what == "the byte 81 is not a character of cp1252 here");
  CHECK(fault("ab\xC5", Encoding::cp949).column == 3);  // half a character at the end
}

TEST_CASE("Control characters outside ASCII are not text in a code page") {
  for (std::size_t before : {0U, 1U, 5000U, 70000U}) {
    INFO(before);
    std::string text;
    for (std::size_t i = 0; i < before; ++i) text += "\xB0\xA1";
    const DecodeError found = fault(text + "\x81\x30\x81\x31z", Encoding::gb18030);  // U+0081
    CHECK(found.column == before + 1);
    CHECK(test::contains(found.what, "81 30"));
  }
}

TEST_CASE("A text longer than the blocks of the decoder is complete") {
  std::string text;
  std::string bytes;
  for (int i = 0; i < 50000; ++i) {
    text += i % 5 == 0 ? "a" : "클";
    bytes += i % 5 == 0 ? "a" : "\xC5\xAC";
  }
  CHECK(decoded(bytes, Encoding::cp949) == text);
}

TEST_CASE("A code page rejects binary files, NUL and zip archives, and accepts one end mark") {
  CHECK(decoded("\xB0\xA1\n\0"s, Encoding::cp949) == "가\n");
  const DecodeError nul = fault("\xB0\xA1\xB0\xA1\0\xB0\xA1"s, Encoding::cp949);
  CHECK(nul.column == 3);
  CHECK(test::contains(nul.what, "U+0000"));
  CHECK(test::contains(fault("PK\x03\x04zzzz", Encoding::cp932).what, "zip archive"));
}

TEST_CASE("A byte order mark conflicts with a requested code page") {
  const DecodeError found = fault("\xEF\xBB\xBF클", Encoding::cp932);
  CHECK(found.what == "the file begins with the byte order mark of utf-8");
  CHECK(found.remedy ==
        "remove `--encoding cp932`, or the list's `encoding` in plant.json; if other lists need it, write "
        "`\"encoding\": \"cp932\"` for each of them in the `symbols` of a plant.json");
  CHECK(fault("\xFF\xFE"
              "a\0"s,
              Encoding::cp949)
            .what == "the file begins with the byte order mark of utf-16le");
}

TEST_CASE("If the requested code page cannot decode the file, UTF-8 or another one is proposed") {
  const DecodeError utf8 = fault("A,클램프,B\n", Encoding::cp1252);
  REQUIRE(utf8.guesses.size() == 1);
  CHECK(utf8.guesses[0].encoding == Encoding::utf8);
  CHECK(utf8.guesses[0].sample == "클램프");
  std::string long_cell;
  for (int i = 0; i < 1000; ++i) long_cell += "클";
  CHECK(fault(long_cell, Encoding::cp1252).guesses.at(0).sample.size() == 41 * 3);  // 40 characters and `…`
  const DecodeError korean = fault(encoded("A,클램프_전진,B\n", "CP949"), Encoding::cp932);
  REQUIRE_FALSE(korean.guesses.empty());
  CHECK(korean.guesses[0].encoding == Encoding::cp949);
  for (const EncodingGuess& guess : korean.guesses) CHECK(guess.encoding != Encoding::cp932);
}

TEST_CASE("With few words, the code pages that read the word differently are proposed in a fixed order, at most five") {
  const DecodeError one = fault("A,P\xC5,B\n", Encoding::utf8);
  std::string proposed;
  for (const EncodingGuess& guess : one.guesses) {
    proposed += std::string(encoding_name(guess.encoding)) + " " + guess.sample + "\n";
  }
  CHECK(proposed == "cp1252 PÅ\ncp932 Pﾅ\ncp1250 PĹ\ncp1251 PЕ\ncp1253 PΕ\n");
  CHECK(guesses("A,T\xFCr\n,\x81\x20") == "cp1251 cp850 cp866 cp852 cp437");  // cp1252 has no 81
  CHECK(guesses("ab,\xFF\xFE,c\n").starts_with("cp1252 "));                   // not a byte order mark of UTF-16
}

TEST_CASE("The proposal shows the wrong word as the code page reads it") {
  const auto result = decode(std::string() + "VAR_GLOBAL,S331_X_" + encoded("클램프_전진", "CP949") + ",X0\n");
  REQUIRE_FALSE(result);
  CHECK(result.error().what == "the bytes B7 A5 C7 C1 are not valid UTF-8 here, so the file is in another encoding");
  REQUIRE_FALSE(result.error().guesses.empty());
  CHECK(result.error().guesses[0].encoding == Encoding::cp949);
  CHECK(result.error().guesses[0].sample == "S331_X_클램프_전진");
}

TEST_CASE("The code page of a text with at least five words is recognized, and is the only proposal") {
  struct Text {
    const char* text;
    const char* name;
    const char* guess;
  };
  for (const Text& each : {
           Text{"로봇1호 상호 인터록3\n클램프_잠김단\n운전준비\n", "CP949", "cp949"},
           Text{"ロボット原点\n治具クランプ\n起動ボタン\n非常停止\n前進端\n", "CP932", "cp932"},
           Text{"夹具夹紧到位\n机器人在原点\n急停按钮\n启动\n复位按钮\n", "GB18030", "gb18030"},
           Text{"夾具夾緊到位\n機器人在原點\n緊急停止按鈕\n啟動\n馬達過載\n", "CP950", "cp950"},
           Text{"Förderer läuft\nTür geöffnet\nKühlung\nStörung\n", "CP1252", "cp1252"},
           Text{"Moteur démarré\nporte fermée\narrêt d'urgence\npièce\nsécurité\n", "CP1252", "cp1252"},
           Text{"Siłownik wysunięty\nZawór otwarty\nczujnik położenia\nŁożysko\n", "CP1250", "cp1250"},
           Text{"Dveře otevřeny\nválec vysunut\nčidlo\ntlačítko\n", "CP1250", "cp1250"},
           Text{"Датчик открытия\nНасос включен\nКлапан\n", "CP1251", "cp1251"},
           Text{"Датчик открытия\nНасос включен\nКлапан\n", "CP866", "cp866"},
           Text{"Kapı açık\nMotor çalışıyor\nBasınç düşük\nışık\n", "CP1254", "cp1254"},
           Text{"Κινητήρας σε λειτουργία\nθύρα ανοιχτή\nαντλία\n", "CP1253", "cp1253"},
       }) {
    INFO(each.text << " in " << each.name);
    CHECK(guesses("Class,Identifier\n" + encoded(each.text, each.name)) == each.guess);
  }
}

TEST_CASE("The code page of a single word is among the proposals") {
  struct Word {
    const char* text;
    const char* name;
    const char* guess;
  };
  for (const Word& each :
       {Word{"전진", "CP949", "cp949"}, Word{"클램프", "CP949", "cp949"}, Word{"급정지", "CP949", "cp949"},
        Word{"ボタン", "CP932", "cp932"}, Word{"前進", "CP932", "cp932"}, Word{"ｸﾗﾝﾌﾟ", "CP932", "cp932"},
        Word{"夹紧", "GB18030", "gb18030"}, Word{"启动", "GB18030", "gb18030"}, Word{"Tür", "CP1252", "cp1252"},
        Word{"Hauptförderer", "CP1252", "cp1252"}, Word{"Насос", "CP1251", "cp1251"}}) {
    INFO(each.text << " in " << each.name);
    const std::string proposed = " " + guesses("A," + encoded(each.text, each.name) + ",B\n") + " ";
    CHECK(test::contains(proposed, " " + std::string(each.guess) + " "));
  }
}

TEST_CASE("A code page that cannot decode the whole file is not proposed") {
  std::string korean;
  for (int i = 0; i < 20; ++i) korean += encoded("클램프\n전진\n", "CP949");
  CHECK(guesses(korean) == "cp949");
  const std::string proposed = guesses(korean + "\xFF\xFF\n");
  CHECK_FALSE(proposed.empty());
  CHECK_FALSE(test::contains(proposed, "cp949"));
}
