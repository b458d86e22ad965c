#pragma once
// What is said about a text, with its places, for tests of messages.

#include <QStringList>

#include "model_fixture.h"
#include "schema/value_reader.h"

namespace sample {

/// Each error with the text that it is about, its notes with theirs, and what its fix writes. One that several uses of a value cause is
/// reported once, as by the project.
inline QString reported(const Resolved& r) {
    QStringList all;
    for (const trundle::Diagnostic& d : r.diagnostics.all()) {
        if (d.severity == trundle::Severity::Hint) continue;
        std::string text = trundle::codeName(d.code) + " " + d.message + " | " + r.slice(d.range);
        for (const auto& [note, range] : d.notes) {
            text += " | " + note + ": " + r.slice(range);
            if (note == trundle::kUsedHere) break;
        }
        if (!d.fixes.empty()) text += " | fix " + d.fixes[0].title;
        const QString line = QString::fromStdString(text);
        const auto isSame = [&](const QString& said) { return said.section(" | ", 0, 1) == line.section(" | ", 0, 1); };
        const bool isUse = !d.notes.empty() && d.notes[0].first == trundle::kUsedHere;
        if (!isUse || std::ranges::none_of(all, isSame)) all += line;
    }
    return all.join(u'\n');
}

} // namespace sample
