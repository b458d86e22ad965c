#pragma once

namespace trundle {

enum class WrapLines { InNarrowPanes, Always, Never };

/// What a person chose for the whole program, as QSettings keeps it.
struct Preferences {
    WrapLines wrapLines = WrapLines::InNarrowPanes;

    bool operator==(const Preferences&) const = default;
};

/// What is missing or cannot be read has its default.
[[nodiscard]] Preferences loadPreferences();
void savePreferences(const Preferences& preferences);

} // namespace trundle
