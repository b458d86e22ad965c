#pragma once
// For tests that compare what the window shows with something kept: the same on every machine.

#include <QFile>
#include <QString>

namespace trundle {

/// Makes settings, state and fonts independent of the machine; call before Qt starts.
inline void leaveTheMachineOut(const QString& home) {
    for (const char* place : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"})
        qputenv(place, home.toUtf8());
    QFile fonts(home + QStringLiteral("/fonts.conf"));
    if (fonts.open(QIODevice::WriteOnly))
        fonts.write("<?xml version='1.0'?><!DOCTYPE fontconfig SYSTEM 'fonts.dtd'><fontconfig><match target='pattern'>"
                    "<edit name='antialias'><bool>true</bool></edit><edit name='hintstyle'><const>hintslight</const></edit>"
                    "<edit name='rgba'><const>none</const></edit></match></fontconfig>");
    fonts.close();
    qputenv("FONTCONFIG_FILE", fonts.fileName().toUtf8());
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qputenv("LIBGL_ALWAYS_SOFTWARE", "1");
    qputenv("LC_ALL", "C.UTF-8");
    for (const char* variable : {"QT_STYLE_OVERRIDE", "QT_QPA_PLATFORMTHEME", "QT_FONT_DPI", "QT_SCREEN_SCALE_FACTORS"})
        qunsetenv(variable);
}

} // namespace trundle
