#include "editor/properties/origin_words.h"

#include <QObject>

#include "project/search.h"

namespace trundle {

QString placeWords(const Loaded& loaded, const SourceRange& place) {
    if (!place.known() || place.file >= loaded.sources.size()) return {};
    const SourceText& source = *loaded.sources[place.file].text;
    const std::string& file = place.file < loaded.paths.size() ? loaded.paths[place.file] : source.path();
    const QString name = QString::fromStdString(shownInProject(file, loaded.projectFolder));
    return QStringLiteral("%1:%2").arg(name).arg(source.position(place.range.begin).line);
}

QString originWords(const FieldValue& value) {
    switch (value.standing) {
    case Standing::Default: return value.text.empty() ? QObject::tr("not set") : QObject::tr("the default");
    case Standing::Own: return QObject::tr("set here");
    case Standing::Override: return QObject::tr("set for this one alone");
    case Standing::Config: return QObject::tr("set in the config");
    case Standing::CommandLine: return QObject::tr("set on the command line");
    }
    return {};
}

} // namespace trundle
