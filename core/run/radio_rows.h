#pragma once
// Frames as rows of CSV: the same in a log's file and in what a window exports.

#include <string>

#include "radio/radio_settings.h"
#include "radio/radio_trace.h"

namespace trundle {

void addRadioHeader(std::string& csv);
void addRadioRow(const FrameRecord& frame, const RadioDefinition& from, const RadioDefinition& to, std::string& csv);

} // namespace trundle
