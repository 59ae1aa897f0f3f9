// SP320 word-and-bits: a number and its bits are symbols.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kWordAndBitsPage =
    R"(A number and some of its bits are symbols: `%IW64` of SIMATIC and `%I64.3`, `%IW5` and its bit `%IW5.3`, `K4X0` of MELSEC and `X3`.
Usually both are wanted: the word to copy it, its bits by name. There is one finding for each number, with all of its bits.

**What the model loses.** The symbols are separate: if a device sets the bit, the word does not change, and the PLC may read a
word that its bits contradict.

**How to fix it.** Let the PLC program read either the word or its bits, or correct the address.
)";

}  // namespace

/// Fired by the search for overlaps (addresses_overlap.cpp).
const Rule kWordAndBits{
    {"SP320", "word-and-bits", diag::Severity::note, "a number and its bits are symbols", kWordAndBitsPage}};

}  // namespace symplant::check
