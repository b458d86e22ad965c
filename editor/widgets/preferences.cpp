#include "editor/widgets/preferences.h"

#include <algorithm>

#include <QSettings>

namespace trundle {
namespace {

const QString kTheme = QStringLiteral("theme"), kDarkTheme = QStringLiteral("darkTheme"); // kDarkTheme: key of earlier versions
const QString kInterfaceFont = QStringLiteral("fonts/interface"), kTextFont = QStringLiteral("fonts/text");
const QString kWrap = QStringLiteral("text/wrap"), kNavigation = QStringLiteral("views/navigation");

// Saved names of the enumeration values, in order.
const QStringList kThemes{QStringLiteral("system"), QStringLiteral("light"), QStringLiteral("dark")};
const QStringList kWraps{QStringLiteral("narrow"), QStringLiteral("always"), QStringLiteral("never")};
const QStringList kNavigations{QStringLiteral("trundle"), QStringLiteral("blender"), QStringLiteral("cad")};

template <class E> void read(const QSettings& settings, const QString& key, const QStringList& words, E& value) {
    if (const qsizetype at = words.indexOf(settings.value(key).toString()); at >= 0) value = static_cast<E>(at);
}

void read(const QSettings& settings, const QString& key, int largest, int& value) {
    bool number = false;
    const int kept = settings.value(key).toInt(&number);
    if (number) value = std::clamp(kept, kSmallestFont, largest);
}

} // namespace

Preferences loadPreferences() {
    const QSettings settings;
    Preferences p;
    if (settings.contains(kDarkTheme)) p.theme = settings.value(kDarkTheme).toBool() ? ThemeChoice::Dark : ThemeChoice::Light;
    read(settings, kTheme, kThemes, p.theme);
    read(settings, kInterfaceFont, kLargestInterfaceFont, p.fonts.interface);
    read(settings, kTextFont, kLargestTextFont, p.fonts.text);
    read(settings, kWrap, kWraps, p.wrapLines);
    read(settings, kNavigation, kNavigations, p.navigation);
    return p;
}

void savePreferences(const Preferences& preferences) {
    QSettings settings;
    settings.setValue(kTheme, kThemes.at(static_cast<int>(preferences.theme)));
    settings.setValue(kInterfaceFont, preferences.fonts.interface);
    settings.setValue(kTextFont, preferences.fonts.text);
    settings.setValue(kWrap, kWraps.at(static_cast<int>(preferences.wrapLines)));
    settings.setValue(kNavigation, kNavigations.at(static_cast<int>(preferences.navigation)));
}

ThemeKind themeOf(ThemeChoice choice) {
    return choice == ThemeChoice::System ? systemTheme() : choice == ThemeChoice::Dark ? ThemeKind::Dark : ThemeKind::Light;
}

} // namespace trundle
