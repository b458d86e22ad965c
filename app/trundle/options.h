#pragma once
#include <optional>

#include <QCoreApplication>
#include <QSize>
#include <QString>
#include <QStringList>

#include "app/open_options.h"
#include "editor/shell/layouts.h"
#include "editor/widgets/theme.h"

namespace trundle {

/// The command-line options of the window.
struct WindowOptions {
    QString open;                 ///< the file to open
    OpenOptions given;            ///< search folders and trusted modules, for every file opened in this window
    std::optional<double> runFor; ///< s, simulated; then the run is paused
    QString view;                 ///< perspective, top, front, side, follow, chase, text
    QStringList select;           ///< paths of objects
    std::optional<Layout> layout;
    std::optional<ThemeKind> theme;
    QString look; ///< rendering style: automatic, fast, rich
    QSize size;
    QString screenshot; ///< path of the .png to write
    bool quit = false;
};

/// Exits with 2 and a message if the command line is invalid; --help and --version exit with 0.
[[nodiscard]] WindowOptions readOptions(const QCoreApplication& application);

} // namespace trundle
