#include "editor/widgets/preferences.h"

#include <QSettings>

namespace trundle {
namespace {

const QString kWrap = QStringLiteral("text/wrap");

/// The words that stand for the values of an enumeration, in its order.
const QStringList kWrapWords{QStringLiteral("narrow"), QStringLiteral("always"), QStringLiteral("never")};

template <class E> E read(const QSettings& settings, const QString& key, const QStringList& words, E usual) {
    const qsizetype at = words.indexOf(settings.value(key).toString());
    return at < 0 ? usual : static_cast<E>(at);
}

} // namespace

Preferences loadPreferences() {
    const QSettings settings;
    Preferences p;
    p.wrapLines = read(settings, kWrap, kWrapWords, p.wrapLines);
    return p;
}

void savePreferences(const Preferences& preferences) {
    QSettings settings;
    settings.setValue(kWrap, kWrapWords.at(static_cast<int>(preferences.wrapLines)));
}

} // namespace trundle
