#pragma once
#include <optional>

#include <QCoreApplication>
#include <QSize>
#include <QString>
#include <QStringList>

#include "editor/shell/layouts.h"
#include "editor/widgets/theme.h"

namespace trundle {

/// What the command line asks of the window.
struct WindowOptions {
    QString open;                 ///< a file
    std::optional<double> runFor; ///< s, simulated; then the run is held
    QString view;                 ///< perspective, top, front, side, follow, chase, text
    QStringList select;           ///< paths of objects
    std::optional<Layout> layout;
    std::optional<ThemeKind> theme;
    QString look; ///< automatic, fast, rich
    QSize size;
    QString screenshot; ///< where to; .png
    bool quit = false;
};

/// Says what is wrong and exits with 2 where the command line cannot be read; --help and --version exit with 0.
[[nodiscard]] WindowOptions readOptions(const QCoreApplication& application);

} // namespace trundle
