#pragma once
// Formats frames for display.

#include <span>

#include <QColor>
#include <QString>

#include "radio/radio_settings.h"
#include "radio/radio_trace.h"

namespace trundle {

/// "too weak"
[[nodiscard]] QString outcomeText(ReceptionOutcome outcome);
/// Explains the outcome of a frame at its receiver; empty if no explanation is needed. `addressee`: the radio it was sent to.
[[nodiscard]] QString reasonOf(const FrameRecord& frame, const RadioDefinition& receiver, const QString& addressee);

/// The payload of a frame as transmitted; empty for an acknowledgement.
[[nodiscard]] std::span<const std::uint8_t> payloadOf(const AirFrame& frame, bool ack);
/// "b1000742"
[[nodiscard]] QString hexOf(std::span<const std::uint8_t> bytes);
/// Printable characters; others as dots.
[[nodiscard]] QString asciiOf(std::span<const std::uint8_t> bytes);
/// Sixteen bytes per line: offset, hex and characters.
[[nodiscard]] QString dumpOf(std::span<const std::uint8_t> bytes);

/// The colour of a margin (dB), as for the links in the viewport: weak below 3, good from 10.
[[nodiscard]] QColor inkForMargin(double margin);
/// With one decimal: "-61.3".
[[nodiscard]] QString decibelText(double value);

} // namespace trundle
