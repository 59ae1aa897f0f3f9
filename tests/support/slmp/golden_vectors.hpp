// Frames that other SLMP implementations agree on (section 1.14 of the SLMP reference), for both directions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace symplant::test::slmp {

/// A request to station FF of network 0 (module I/O 03FF, multidrop 0). 4E frames have the serial number 0.
///
/// `meaning` is the command, the subcommand, and then
///   0401, 1401   `D100*3`, in a write `D100*3=1995,1202,1130` or `M100*5=1,1,0,0,1`
///   0403, 1402   words ` | ` dwords: `D0=0550 D1=0575 | D1500=04391202`; bits: `M50=0 Y2F=1`
///   0406, 1406   word blocks ` | ` bit blocks: `D0*2=0008,0020 | M0*1=000C`
///   0619         the text
///   others       the payload as hex
/// Numbers of X, Y, B and W are hex, other numbers of devices and numbers of points are decimal, values are hex.
struct GoldenRequest {
  std::string_view name;
  bool is_iqr;  ///< subcommands 0002 and 0003, or a command that has only 0000
  bool is_ascii;
  bool is_4e;
  std::uint16_t timer;
  std::string_view meaning;
  std::string_view frame;  ///< in ASCII the characters themselves, in binary their hex digits
};

/// A reply from station FF of network 0.
struct GoldenReply {
  std::string_view name;
  bool is_ascii;
  bool is_4e;
  std::uint16_t serial;
  std::uint16_t end_code;
  std::uint16_t command;
  std::uint16_t subcommand;
  std::string_view values;  ///< `1995,1202,1130` or `1,1,0,0,1`; of a random read words ` | ` dwords; empty: no data
  std::string_view frame;
};

/// The bytes of `frame` on the wire.
inline std::vector<std::uint8_t> golden_bytes(std::string_view frame, bool is_ascii) {
  if (is_ascii) return {frame.begin(), frame.end()};
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i + 1 < frame.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(std::string(frame.substr(i, 2)), nullptr, 16)));
  }
  return bytes;
}

inline constexpr std::array kGoldenRequests = {
    GoldenRequest{"read words D100 *3", false, false, false, 0x0010, "0401/0000 D100*3",
                  "500000FFFF03000C00100001040000640000A80300"},
    GoldenRequest{"read bits X10 *5", false, false, false, 0x0010, "0401/0001 X10*5",
                  "500000FFFF03000C001000010401001000009C0500"},
    GoldenRequest{"read words X40 *2", false, false, false, 0x0010, "0401/0000 X40*2",
                  "500000FFFF03000C001000010400004000009C0200"},
    GoldenRequest{"write words D100 = 1995h,1202h,1130h", false, false, false, 0x0010,
                  "1401/0000 D100*3=1995,1202,1130", "500000FFFF03001200100001140000640000A80300951902123011"},
    GoldenRequest{"write bits M100 = 1,1,0,0,1", false, false, false, 0x0010, "1401/0001 M100*5=1,1,0,0,1",
                  "500000FFFF03000F00100001140100640000900500110010"},
    GoldenRequest{"write bit X1F = 1", false, false, false, 0x0010, "1401/0001 X1F*1=1",
                  "500000FFFF03000D001000011401001F00009C010010"},
    GoldenRequest{"random read D0, M100, X20 + dword D1500", false, false, false, 0x0010,
                  "0403/0000 D0 M100 X20 | D1500",
                  "500000FFFF030018001000030400000301000000A8640000902000009CDC0500A8"},
    GoldenRequest{"random write D0=0550h, D1=0575h, dword D1500=04391202h", false, false, false, 0x0010,
                  "1402/0000 D0=0550 D1=0575 | D1500=04391202",
                  "500000FFFF03001C001000021400000201000000A85005010000A87505DC0500A802123904"},
    GoldenRequest{"random bits M50=0, Y2F=1", false, false, false, 0x0010, "1402/0001 M50=0 Y2F=1",
                  "500000FFFF030011001000021401000232000090002F00009D01"},
    GoldenRequest{"block read D0*4 + M0*2 words", false, false, false, 0x0010, "0406/0000 D0*4 | M0*2",
                  "500000FFFF030014001000060400000101000000A80400000000900200"},
    GoldenRequest{"block write D0=8,20h + M0*1=000Ch", false, false, false, 0x0010,
                  "1406/0000 D0*2=0008,0020 | M0*1=000C",
                  "500000FFFF03001A001000061400000101000000A80200080020000000009001000C00"},
    GoldenRequest{"read type name", false, false, false, 0x0010, "0101/0000", "500000FFFF03000600100001010000"},
    GoldenRequest{"loopback ABCDE", false, false, false, 0x0010, "0619/0000 ABCDE",
                  "500000FFFF03000D0010001906000005004142434445"},
    GoldenRequest{"remote RUN force, no clear", false, false, false, 0x0010, "1001/0000 03000000",
                  "500000FFFF03000A0010000110000003000000"},
    GoldenRequest{"remote STOP", false, false, false, 0x0010, "1002/0000 0100", "500000FFFF030008001000021000000100"},
    GoldenRequest{"remote PAUSE force", false, false, false, 0x0010, "1003/0000 0300",
                  "500000FFFF030008001000031000000300"},
    GoldenRequest{"remote RESET", false, false, false, 0x0010, "1006/0000 0100", "500000FFFF030008001000061000000100"},
    GoldenRequest{"iQ-R read words D100 *3", true, false, false, 0x0010, "0401/0002 D100*3",
                  "500000FFFF03000E0010000104020064000000A8000300"},
    GoldenRequest{"iQ-R read bits X10 *5", true, false, false, 0x0010, "0401/0003 X10*5",
                  "500000FFFF03000E00100001040300100000009C000500"},
    GoldenRequest{"iQ-R write words D100 *3", true, false, false, 0x0010, "1401/0002 D100*3=1995,1202,1130",
                  "500000FFFF0300140010000114020064000000A8000300951902123011"},
    GoldenRequest{"iQ-R write bits M100 = 1,1,0,0,1", true, false, false, 0x0010, "1401/0003 M100*5=1,1,0,0,1",
                  "500000FFFF030011001000011403006400000090000500110010"},
    GoldenRequest{"iQ-R random read (as above)", true, false, false, 0x0010, "0403/0002 D0 M100 X20 | D1500",
                  "500000FFFF03002000100003040200030100000000A800640000009000200000009C00DC050000A800"},
    GoldenRequest{"iQ-R random write (as above)", true, false, false, 0x0010,
                  "1402/0002 D0=0550 D1=0575 | D1500=04391202",
                  "500000FFFF03002200100002140200020100000000A800500501000000A8007505DC050000A80002123904"},
    GoldenRequest{"iQ-R random bits M50=0, Y2F=1", true, false, false, 0x0010, "1402/0003 M50=0 Y2F=1",
                  "500000FFFF030017001000021403000232000000900000002F0000009D000100"},
    GoldenRequest{"iQ-R block read D0*4 + M0*2", true, false, false, 0x0010, "0406/0002 D0*4 | M0*2",
                  "500000FFFF03001800100006040200010100000000A80004000000000090000200"},
    GoldenRequest{"iQ-R block write D0*2 + M0*1", true, false, false, 0x0010, "1406/0002 D0*2=0008,0020 | M0*1=000C",
                  "500000FFFF03001E00100006140200010100000000A80002000800200000000000900001000C00"},
    GoldenRequest{"4E type name", true, false, true, 0x0010, "0101/0000", "54000000000000FFFF03000600100001010000"},
    GoldenRequest{"4E read D100*2", true, false, true, 0x0010, "0401/0002 D100*2",
                  "54000000000000FFFF03000E0010000104020064000000A8000200"},
    GoldenRequest{"4E write bit M101=1", true, false, true, 0x0010, "1401/0003 M101*1=1",
                  "54000000000000FFFF03000F00100001140300650000009000010010"},
    GoldenRequest{"4E random read D100, D101, dword D200", true, false, true, 0x0010, "0403/0002 D100 D101 | D200",
                  "54000000000000FFFF03001A00100003040200020164000000A80065000000A800C8000000A800"},
    GoldenRequest{"4E random bits M100=1, Y20=0", true, false, true, 0x0010, "1402/0003 M100=1 Y20=0",
                  "54000000000000FFFF03001700100002140300026400000090000100200000009D000000"},
    GoldenRequest{"4E block read D300*2 + M200*1", true, false, true, 0x0010, "0406/0002 D300*2 | M200*1",
                  "54000000000000FFFF0300180010000604020001012C010000A8000200C800000090000100"},
    GoldenRequest{"ASCII Q/L read D100*3", false, true, false, 0x0010, "0401/0000 D100*3",
                  "500000FF03FF000018001004010000D*0001000003"},
    GoldenRequest{"ASCII Q/L read bits X10*5", false, true, false, 0x0010, "0401/0001 X10*5",
                  "500000FF03FF000018001004010001X*0000100005"},
    GoldenRequest{"ASCII Q/L write M100 = 11001", false, true, false, 0x0010, "1401/0001 M100*5=1,1,0,0,1",
                  "500000FF03FF00001D001014010001M*000100000511001"},
    GoldenRequest{"ASCII Q/L write X1F=1", false, true, false, 0x0010, "1401/0001 X1F*1=1",
                  "500000FF03FF000019001014010001X*00001F00011"},
    GoldenRequest{"ASCII Q/L random bits", false, true, false, 0x0010, "1402/0001 M50=0 Y2F=1",
                  "500000FF03FF00002200101402000102M*00005000Y*00002F01"},
    GoldenRequest{"ASCII Q/L random read", false, true, false, 0x0010, "0403/0000 D0 M100 X20 | D1500",
                  "500000FF03FF0000300010040300000301D*000000M*000100X*000020D*001500"},
    GoldenRequest{"ASCII Q/L block write", false, true, false, 0x0010, "1406/0000 D0*2=0008,0020 | M0*1=000C",
                  "500000FF03FF0000340010140600000101D*000000000200080020M*0000000001000C"},
    GoldenRequest{"ASCII iQ-R read D100*3", true, true, false, 0x0010, "0401/0002 D100*3",
                  "500000FF03FF00001C001004010002D***000001000003"},
    GoldenRequest{"ASCII iQ-R write X1F=1", true, true, false, 0x0010, "1401/0003 X1F*1=1",
                  "500000FF03FF00001D001014010003X***0000001F00011"},
    GoldenRequest{"ASCII iQ-R random bits", true, true, false, 0x0010, "1402/0003 M50=0 Y2F=1",
                  "500000FF03FF00002E00101402000302M***000000500000Y***0000002F0001"},
    GoldenRequest{"manual: read D350*2", false, false, false, 0x0000, "0401/0000 D350*2",
                  "500000ffff03000c000000010400005e0100a80200"},
    GoldenRequest{"manual: random read", false, false, false, 0x0000, "0403/0000 D0 TN0 M100 X20 | D1500 Y160 M1111",
                  "500000ffff030024000000030400000403000000a8000000c2640000902000009cdc0500a86001009d57040090"},
    GoldenRequest{"manual: block read", false, false, false, 0x0000, "0406/0000 D0*4 W100*8 | M0*2 M128*2 B100*3",
                  "500000ffff030026000000060400000203000000a80400000100b40800000000900200800000900200000100a00300"},
    GoldenRequest{"manual: block write", false, false, false, 0x0000,
                  "1406/0000 D0*4=0008,0000,0000,2800 W100*8=0970,0000,0000,0000,0000,0000,0000,0131 | M0*2=2030,4849 "
                  "M128*2=C3DE,2800 B100*3=0970,0000,B9AF",
                  "500000ffff03004c000000061400000203000000A804000800000000000028000100B4080070090000000000000000000000"
                  "00310100000090020030204948800000900200DEC30028000100A0030070090000AFB9"},
};

inline constexpr std::array kGoldenReplies = {
    GoldenReply{"words", 0, 0, 0x0000, 0x0000, 0x0401, 0x0000, "1995,1202,1130", "D00000FFFF030008000000951902123011"},
    GoldenReply{"bits", 0, 0, 0x0000, 0x0000, 0x0401, 0x0001, "1,1,0,0,1", "D00000FFFF030005000000110010"},
    GoldenReply{"write", 0, 0, 0x0000, 0x0000, 0x1401, 0x0000, "", "D00000FFFF030002000000"},
    GoldenReply{"error C056", 0, 0, 0x0000, 0xC056, 0x0401, 0x0000, "", "D00000FFFF03000B0056C000FFFF030001040000"},
    GoldenReply{"4E words", 0, 1, 0x1234, 0x0000, 0x0401, 0x0000, "1995,1202,1130",
                "D4003412000000FFFF030008000000951902123011"},
    GoldenReply{"4E error C05B, live", 0, 1, 0x000C, 0xC05B, 0x1406, 0x0002, "",
                "D4000C00000000FFFF03000B005BC000FFFF030006140200"},
    GoldenReply{"ASCII words", 1, 0, 0x0000, 0x0000, 0x0401, 0x0000, "1995,1202,1130",
                "D00000FF03FF0000100000199512021130"},
    GoldenReply{"ASCII bits", 1, 0, 0x0000, 0x0000, 0x0401, 0x0001, "1,1,0,0,1", "D00000FF03FF000009000011001"},
    GoldenReply{"ASCII error C056", 1, 0, 0x0000, 0xC056, 0x0401, 0x0000, "",
                "D00000FF03FF000016C05600FF03FF0004010000"},
    GoldenReply{"manual: D350*2", 0, 0, 0x0000, 0x0000, 0x0401, 0x0000, "56AB,170F", "d00000ffff030006000000ab560f17"},
    GoldenReply{"manual: random read", 0, 0, 0x0000, 0x0000, 0x0403, 0x0000,
                "1995,1202,2030,4849 | 4C544F4E,C3DEB9AF,BADDBCB7",
                "d00000ffff03001600000095190212302049484e4f544cafb9dec3b7bcddba"},
};

}  // namespace symplant::test::slmp
