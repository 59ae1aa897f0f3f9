// The grammar of Rockwell's resolved tags, and of the files of PLC-5 and SLC.
#include <algorithm>

#include "address/grammars.hpp"
#include "address/make.hpp"
#include "address/terminals.hpp"

namespace symplant::address {
namespace {

const auto kFirst = x3::ascii::alpha | '_';
const auto kName = kFirst >> *(x3::ascii::alnum | '_');
const auto kIndexes = '[' >> kDecimal % ',' >> ']';

/// What decides of a tag: Local:1:I.Data[3].0
struct Tag {
  std::string_view part;  ///< behind the last colon: `I`
  bool has_part = false;
  bool ends_in_bit = false;  ///< `.0`
  bool has_point = false;    ///< a member Pt00, Pt00Data
};

using Match = boost::iterator_range<const char*>;

std::string_view text_of(const Match& match) { return {match.begin(), match.size()}; }

bool is_point(std::string_view member) {
  return member.size() > 2 && text::equal_ignoring_case(member.substr(0, 2), "PT") && text::is_digit(member[2]);
}

const auto kPart = [](auto& context) {
  x3::get<Tag>(context).part = text_of(x3::_attr(context));
  x3::get<Tag>(context).has_part = true;
};
const auto kMember = [](auto& context) {
  if (is_point(text_of(x3::_attr(context)))) x3::get<Tag>(context).has_point = true;
};
const auto kBitNumber = [](auto& context) { x3::get<Tag>(context).ends_in_bit = true; };
const auto kTag = -x3::lit('\\') >> kName >> *(':' >> x3::raw[kName | kDecimal][kPart]) >>
                  *('.' >> x3::raw[kName][kMember] | kIndexes) >> -('.' >> kDecimal[kBitNumber]);

/// The area of the part behind the last colon: I, O, SI, SO, or I1 of a module with several connections.
Area area_of(std::string_view part) {
  if (part.size() > 1 && text::upper(part.front()) == 'S') part.remove_prefix(1);
  if (part.empty() || !std::all_of(part.begin() + 1, part.end(), text::is_digit)) return Area::memory;
  const char letter = text::upper(part.front());
  return letter == 'I' ? Area::input : letter == 'O' ? Area::output : Area::memory;
}

/// I:1/0, I:1.0/3, I:001/00, O1:2/3 of SLC and PLC-5.
struct FileWord {
  Area area = Area::memory;
  std::uint64_t slot = 0;
  std::uint64_t word = 0;
  std::optional<std::uint64_t> bit;
};

template <Area kArea>
const auto kOfFile = [](auto& context) { x3::get<FileWord>(context).area = kArea; };
const auto kBitOfFile = [](auto& context) {
  x3::get<FileWord>(context).bit = x3::_attr(context);
  x3::_pass(context) = x3::_attr(context) <= 17;  // octal digits 00 to 17 of PLC-5
};
const auto kFileWord = (letter('I')[kOfFile<Area::input>] | letter('O')[kOfFile<Area::output>]) >> -kDecimal >> ':' >>
                       kDecimal[kSet<&FileWord::slot>] >> -('.' >> kDecimal[kSet<&FileWord::word>]) >>
                       -('/' >> kDecimal[kBitOfFile]);

/// N7:0, B3:0/1, B3/17, T4:0.DN and other files of data.
const auto kDataFile = !(letter('I') | letter('O')) >> kFirst >> -kFirst >>
                       (kDecimal >> -(':' >> kDecimal) | ':' >> kDecimal) >> -('.' >> (kName | kDecimal)) >>
                       -('/' >> (kName | kDecimal));

}  // namespace

std::optional<Address> parse_rockwell(std::string_view text) {
  text = trimmed(text);
  FileWord file;
  if (matches(text, kFileWord, file)) {
    Key key;
    key.add(file.slot).add(file.word).add(file.bit ? *file.bit + 1 : 0);
    return keyed(file.area, file.bit ? Size::bit : Size::word, key);
  }
  Tag tag;
  if (matches(text, kTag, tag)) {
    const bool is_bit = tag.ends_in_bit || tag.has_point;
    // Without its type a member has the size of a DINT, in which modules with bits keep their data.
    Address address =
        keyed(tag.has_part ? area_of(tag.part) : Area::memory, is_bit ? Size::bit : Size::dword, Key().add(text));
    address.sized = is_bit;
    return address;
  }
  if (!matches(text, kDataFile, tag)) return std::nullopt;
  return keyed(Area::memory, text.find('/') != text.npos ? Size::bit : Size::word, Key().add(text));
}

}  // namespace symplant::address
