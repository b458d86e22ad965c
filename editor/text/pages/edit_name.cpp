#include "editor/text/pages/edit_name.h"

#include <algorithm>

#include <QCoreApplication>

namespace trundle {
namespace {

/// The changed text, shortened to one line; empty if it is blank.
QString inShort(const std::string& text) {
    constexpr int kLongest = 24;
    const QString words =
        QString::fromUtf8(text.data(), static_cast<qsizetype>(std::min<std::size_t>(text.size(), 4 * kLongest))).simplified();
    return words.size() > kLongest ? words.left(kLongest).trimmed() + QStringLiteral("…") : words;
}

QString tr(const char* text) { return QCoreApplication::translate("Typing", text); }

} // namespace

QString typedName(const TextSplice& change, std::string_view after, const std::string& file) {
    const auto until = after.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(change.at, after.size()));
    const auto line = 1 + std::count(after.begin(), until, '\n');
    const QString place = QStringLiteral("%1:%2").arg(QString::fromStdString(file), QString::number(line));
    const QString typed = inShort(change.inserted), gone = inShort(change.removed);
    if (change.removed.empty() && !typed.isEmpty()) return tr("Type “%1” at %2").arg(typed, place);
    if (change.inserted.empty() && !gone.isEmpty()) return tr("Delete “%1” at %2").arg(gone, place);
    if (!typed.isEmpty() && !gone.isEmpty()) return tr("Replace “%1” by “%2” at %3").arg(gone, typed, place);
    if (!typed.isEmpty() || !gone.isEmpty()) return tr("Change text at %1").arg(place);
    const bool lines = change.inserted.find_first_of("\r\n") != std::string::npos;
    return lines ? tr("New line at %1").arg(place) : tr("Change blanks at %1").arg(place);
}

} // namespace trundle
