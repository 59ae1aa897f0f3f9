// The rules of reading.
#include "read/rules.hpp"

#include <array>

#include "read/rules/alias_not_resolved.hpp"
#include "read/rules/ambiguous_columns.hpp"
#include "read/rules/array_too_large.hpp"
#include "read/rules/cannot_read_file.hpp"
#include "read/rules/cell_too_long.hpp"
#include "read/rules/document_type.hpp"
#include "read/rules/empty_file.hpp"
#include "read/rules/encoding_assumed.hpp"
#include "read/rules/header_alone.hpp"
#include "read/rules/invalid_xml.hpp"
#include "read/rules/missing_column.hpp"
#include "read/rules/no_such_part.hpp"
#include "read/rules/recognized_format.hpp"
#include "read/rules/row_not_understood.hpp"
#include "read/rules/row_without_identifier.hpp"
#include "read/rules/text_after_quote.hpp"
#include "read/rules/unclosed_comment.hpp"
#include "read/rules/unclosed_quote.hpp"
#include "read/rules/undecodable_text.hpp"
#include "read/rules/unknown_format.hpp"
#include "read/rules/unknown_input_format.hpp"
#include "read/rules/unreadable_workbook.hpp"

namespace symplant::read {

namespace {

constexpr std::array kRules{
    &kCannotReadFile,        //
    &kUndecodableText,       //
    &kEmptyFile,             //
    &kHeaderAlone,           //
    &kUnknownFormat,         //
    &kUnknownInputFormat,    //
    &kMissingColumn,         //
    &kUnclosedQuote,         //
    &kRowWithoutIdentifier,  //
    &kTextAfterQuote,        //
    &kCellTooLong,           //
    &kInvalidXml,            //
    &kDocumentType,          //
    &kUnclosedComment,       //
    &kAliasNotResolved,      //
    &kRowNotUnderstood,      //
    &kArrayTooLarge,         //
    &kAmbiguousColumns,      //
    &kEncodingAssumed,       //
    &kNoSuchPart,            //
    &kUnreadableWorkbook,    //
    &kRecognizedFormat,      //
};

}  // namespace

std::span<const diag::RuleInfo* const> rules() { return kRules; }

}  // namespace symplant::read
