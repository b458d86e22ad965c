#pragma once
// Fixture: the application's parts and main windows, for tests of the whole window. If TRUNDLE_PICTURES=FOLDER is in the environment,
// images of the tools in use are saved there; with TRUNDLE_THEME=dark in the dark theme.

#include <QtTest>

#include "app/application.h"
#include "editor/shell/main_window.h"
#include "editor/viewport/view/viewport_panel.h"
#include "editor/widgets/apply_theme.h"
#include "eventually.h"
#include "render/service.h"

namespace trundle {

/// Created once per test program: initTestCase() calls start().
struct WindowFixture {
    void start() {
        applyTheme(*qApp, qEnvironmentVariable("TRUNDLE_THEME") == QStringLiteral("dark") ? ThemeKind::Dark : ThemeKind::Light);
        application = makeApplication();
        auto started = RenderService::start();
        QVERIFY2(started.ok(), started.ok() ? "" : started.error().message.c_str());
        render = std::move(started).value();
    }
    [[nodiscard]] std::unique_ptr<MainWindow> window() const {
        return std::make_unique<MainWindow>(*application, render.get(), findLocations());
    }

    /// Of a widget, or of the window when its view has drawn everything.
    static void savePicture(MainWindow& window, const char* name, QWidget* widget = nullptr) {
        const QString folder = qEnvironmentVariable("TRUNDLE_PICTURES");
        if (folder.isEmpty()) return;
        if (!widget) EVENTUALLY(window.viewport().isSettled());
        const QString file = folder + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".png");
        QVERIFY((widget ? widget : &window)->grab().save(file));
    }

    std::unique_ptr<Application> application;
    std::unique_ptr<RenderService> render;
};

} // namespace trundle
