// Boost.Spirit X3 terminals for the .cpp files of the address grammars: numbers, and words from a table.
#pragma once

#include <array>
#include <boost/spirit/home/x3.hpp>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "text/ascii.hpp"

namespace symplant::address {

namespace x3 = boost::spirit::x3;

inline constexpr x3::uint_parser<std::uint64_t, 8> kOctal{};
inline constexpr x3::uint_parser<std::uint64_t, 10> kDecimal{};
inline constexpr x3::uint_parser<std::uint64_t, 16> kHexadecimal{};

/// The longest word of a table that the text begins with, without regard to ASCII case; its attribute is a pointer to
/// the row. The rows have a member `name` in capital letters and are sorted by its first letter, longer names first.
template <const auto& kRows>
struct OneOf : x3::parser<OneOf<kRows>> {
  using attribute_type = decltype(kRows.data());
  static constexpr bool has_attribute = true;

  template <class Context, class RuleContext, class Attribute>
  bool parse(const char*& at, const char* const& end, const Context&, RuleContext&, Attribute& attribute) const {
    const char first = at == end ? '\0' : text::upper(*at);
    if (first < 'A' || first > 'Z') return false;
    const auto letter = static_cast<std::size_t>(first - 'A');
    for (std::size_t i = kBegins[letter]; i < kBegins[letter + 1]; ++i) {
      if (!begins_with(at, end, kRows[i].name)) continue;
      at += kRows[i].name.size();
      x3::traits::move_to(&kRows[i], attribute);
      return true;
    }
    return false;
  }

 private:
  static bool begins_with(const char* at, const char* end, std::string_view name) {
    if (static_cast<std::size_t>(end - at) < name.size()) return false;
    for (std::size_t i = 1; i < name.size(); ++i) {  // the first letter is known
      if (text::upper(at[i]) != name[i]) return false;
    }
    return true;
  }

  /// The index at which the rows of a letter begin; after the last letter the number of rows.
  static constexpr auto kBegins = [] {
    std::array<std::uint8_t, 27> begins{};
    for (std::size_t letter = 0; letter < begins.size(); ++letter) {
      std::size_t at = 0;
      while (at < kRows.size() && kRows[at].name[0] < static_cast<char>('A' + letter)) ++at;
      begins[letter] = static_cast<std::uint8_t>(at);
    }
    return begins;
  }();
};

/// Matches without consuming input if `Holds` returns true for the value that is being read, of type Value.
template <class Value, class Holds>
struct OnlyIf : x3::parser<OnlyIf<Value, Holds>> {
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;

  template <class Context, class RuleContext, class Attribute>
  bool parse(const char*&, const char* const&, const Context& context, RuleContext&, Attribute&) const {
    return Holds()(x3::get<Value>(context));
  }
};
template <class Value, class Holds>
constexpr auto only_if(Holds) {
  return OnlyIf<Value, Holds>();
}

template <class T>
struct OfMember;
template <class Class, class Type>
struct OfMember<Type Class::*> {
  using Value = Class;
};
/// An action that sets a member of the value that is being read.
template <auto kMember>
inline constexpr auto kSet =
    [](auto& context) { x3::get<typename OfMember<decltype(kMember)>::Value>(context).*kMember = x3::_attr(context); };

/// An ASCII letter, given as a capital, in either case.
constexpr auto letter(char capital) { return x3::lit(capital) | text::lower(capital); }

constexpr auto kBlanks = *(x3::lit(' ') | '\t');

/// Whether all of a text matches a grammar, whose actions fill `value`. Grammars are constants without state, so that a
/// parse constructs nothing.
template <class Value, class Grammar>
bool matches(std::string_view text, const Grammar& grammar, Value& value) {
  const char* at = text.data();
  const char* const end = at + text.size();
  return grammar.parse(at, end, x3::make_context<Value>(value), x3::unused, x3::unused) && at == end;
}

}  // namespace symplant::address
