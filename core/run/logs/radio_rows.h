#pragma once
// Formats radio frames as CSV rows, for log files and for exports from the window.

#include <string>

#include "radio/radio_settings.h"
#include "radio/radio_trace.h"

namespace trundle {

void addRadioHeader(std::string& csv);
void addRadioRow(const FrameRecord& frame, const RadioDefinition& from, const RadioDefinition& to, std::string& csv);

} // namespace trundle
