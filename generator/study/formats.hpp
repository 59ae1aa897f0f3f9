// The forms in which a study is shown: those of a comparison, with the accuracy of the movements.
#pragma once

#include "base/text_source.hpp"
#include "compare/difference.hpp"
#include "study/study.hpp"

namespace symplant::study {

/// The comparison of the recording with the run, then a table of the movements.
void write_text(const Study& study, const compare::Comparison& comparison, base::TextSink& sink);
/// The comparison with the member `accuracy`: every movement and the rows of the table.
void write_json(const Study& study, const compare::Comparison& comparison, base::TextSink& sink);
/// The page of the comparison with the table above the chart.
void write_html(const Study& study, const compare::Comparison& comparison, base::TextSink& sink);

}  // namespace symplant::study
