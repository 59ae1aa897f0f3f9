// Addresses in the notations of the targets.
#pragma once

#include <string>

#include "convert/symbols.hpp"

namespace symplant::convert {

/// How a target writes addresses of inputs, outputs and memory.
struct AddressForm {
  bool bits_in_bytes;   ///< %IX3.7, not %IX31
  bool counts_bytes;    ///< the word after %IW0 is %IW2, not %IW1
  bool has_long_words;  ///< %IL0
  bool names_bits;      ///< %IX0.0, not %I0.0
  bool overlays;        ///< %IW0 are the bits %IX0.0 to %IX1.7
};

inline constexpr AddressForm kGxIecForm{false, false, true, true, false};
inline constexpr AddressForm kCodesysForm{true, false, false, true, true};
inline constexpr AddressForm kOpenPlcForm{true, false, true, true, false};
inline constexpr AddressForm kTwinCatForm{true, true, false, true, true};
inline constexpr AddressForm kSiemensForm{true, true, false, false, true};

/// The address of a symbol in this form. A bit of a word (%IW5.3) becomes the bit of that number (%IX10.3). Empty if
/// the symbol has no address, or none that the form can express: a word that begins within another, a tag of a module,
/// memory of another vendor than Siemens or of a list in another notation than IEC.
std::string address_in(const Symbol& symbol, const AddressForm& form);

/// Whether address_in() makes a bit of a word a bit of a byte.
bool is_bit_of_word(const Symbol& symbol);

/// The address as the source has it: the cell that decides; empty without an address.
std::string_view source_address(const Symbol& symbol);

/// The MELSEC device of an input or output bit, X and Y counted in `radix`; empty for other addresses.
std::string melsec_device(const address::Address& address, address::Radix radix);

}  // namespace symplant::convert
