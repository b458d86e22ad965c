#pragma once
// How frames are told to a person.

#include <span>

#include <QColor>
#include <QString>

#include "radio/radio_settings.h"
#include "radio/radio_trace.h"

namespace trundle {

/// "too weak"
[[nodiscard]] QString fateText(Fate fate);
/// Why a frame came to that at its receiver; empty where there is nothing to explain. `addressee` is whom it is for.
[[nodiscard]] QString reasonOf(const FrameRecord& frame, const RadioDefinition& receiver, const QString& addressee);

/// The payload within a frame as it goes over the air; empty for an acknowledgement.
[[nodiscard]] std::span<const std::uint8_t> payloadOf(const AirFrame& frame, bool ack);
/// "b1000742"
[[nodiscard]] QString hexOf(std::span<const std::uint8_t> bytes);
/// Characters where there are any, else dots.
[[nodiscard]] QString asciiOf(std::span<const std::uint8_t> bytes);
/// Sixteen bytes a line: place, hex and characters.
[[nodiscard]] QString dumpOf(std::span<const std::uint8_t> bytes);

/// Of a margin (dB), as the links in the 3D view have it: under 3 it is thin, from 10 on comfortable.
[[nodiscard]] QColor inkOfMargin(double margin);
/// With one digit: "-61.3".
[[nodiscard]] QString decibelText(double value);

} // namespace trundle
