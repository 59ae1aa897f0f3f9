// The readers, one for each format; each is defined in its file in formats/.
#pragma once

#include "read/reader.hpp"

namespace symplant::read {

extern const ReaderInfo kAnyTable;
extern const ReaderInfo kAutomationMl;
extern const ReaderInfo kBrIoMapping;
extern const ReaderInfo kCodesysExp;
extern const ReaderInfo kCodesysIoMapping;
extern const ReaderInfo kGxIec;
extern const ReaderInfo kGxWorksComments;
extern const ReaderInfo kGxWorksLabels;
extern const ReaderInfo kKepware;
extern const ReaderInfo kLsGlobals;
extern const ReaderInfo kLsTags;
extern const ReaderInfo kOmronCxt;
extern const ReaderInfo kOwnTable;
extern const ReaderInfo kPlcopen;
extern const ReaderInfo kRockwellCsv;
extern const ReaderInfo kRockwellL5k;
extern const ReaderInfo kRockwellL5x;
extern const ReaderInfo kSchneiderXsy;
extern const ReaderInfo kStep7Asc;
extern const ReaderInfo kStep7Sdf;
extern const ReaderInfo kStructuredText;
extern const ReaderInfo kSysmac;
extern const ReaderInfo kTiaOpenness;
extern const ReaderInfo kTiaSdf;
extern const ReaderInfo kTiaTagTable;
extern const ReaderInfo kTiaTags;
extern const ReaderInfo kTwincatGvl;

}  // namespace symplant::read
