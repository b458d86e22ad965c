#pragma once
// Fixture: the application's parts and main windows, for tests of the whole window.

#include <QtTest>

#include "app/application.h"
#include "editor/shell/main_window.h"
#include "editor/widgets/apply_theme.h"
#include "render/service.h"

namespace trundle {

/// Created once per test program: initTestCase() calls start().
struct WindowFixture {
    void start() {
        applyTheme(*qApp, ThemeKind::Light);
        application = makeApplication();
        auto started = RenderService::start();
        QVERIFY2(started.ok(), started.ok() ? "" : started.error().message.c_str());
        render = std::move(started).value();
    }
    [[nodiscard]] std::unique_ptr<MainWindow> window() const {
        return std::make_unique<MainWindow>(*application, render.get(), findLocations());
    }

    std::unique_ptr<Application> application;
    std::unique_ptr<RenderService> render;
};

} // namespace trundle
