#include "editor/shell/guide_index.h"

#include <QDir>
#include <QRegularExpression>

namespace trundle {

QString headingAnchor(const QString& heading) {
    QString anchor;
    for (const QChar c : heading.trimmed().toLower()) {
        if (c.isLetterOrNumber()) anchor += c;
        else if (c.isSpace() || c == QLatin1Char('-')) anchor += QLatin1Char('-');
    }
    return anchor;
}

GuideIndex::GuideIndex(const QString& folder) {
    static const QRegularExpression heading(QStringLiteral("^#+ (.*)$")),
        kinds(QStringLiteral("^<!-- (?:kinds|words): (.*) -->$"));
    const QDir guide(folder);
    for (const QString& page : guide.entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name)) {
        QFile file(guide.filePath(page));
        if (!file.open(QIODevice::ReadOnly)) continue;
        QString place = page;
        bool code = false;
        for (const QString& line : QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'))) {
            if (line.startsWith(QStringLiteral("```"))) code = !code;
            if (code) continue; // `#import` in a code block is not a heading
            if (const auto found = heading.match(line); found.hasMatch())
                place = page + QLatin1Char('#') + headingAnchor(found.captured(1));
            else if (const auto named = kinds.match(line); named.hasMatch())
                for (const QString& kind : named.captured(1).split(QLatin1Char(' '), Qt::SkipEmptyParts))
                    if (!m_places.contains(kind)) m_places.insert(kind, place);
        }
    }
}

QString GuideIndex::placeOf(const Kind& kind) const {
    const auto found = m_places.constFind(QString::fromStdString(kind.name));
    if (found != m_places.cend()) return *found;
    if (kind.role == Role::Controller) return m_places.value(QStringLiteral("controller"));
    if (kind.role == Role::Device) return m_places.value(QStringLiteral("device"));
    return {};
}

} // namespace trundle
