// The writers, one for each format; each is defined in its file in writers/.
#pragma once

#include "convert/writer.hpp"

namespace symplant::convert {

extern const WriterInfo kGxIecWriter;
extern const WriterInfo kCsvWriter;
extern const WriterInfo kStWriter;
extern const WriterInfo kPlcopenWriter;
extern const WriterInfo kTiaXlsxWriter;

}  // namespace symplant::convert
