#pragma once
// The real parts of the program and windows of them, for tests of the whole window.

#include <QtTest>

#include "editor/shell/main_window.h"
#include "editor/widgets/theme.h"
#include "parts/parts.h"
#include "render/service.h"

namespace trundle {

/// Made once for all tests of a program: initTestCase() calls start().
struct WindowParts {
    void start() {
        applyTheme(*qApp, ThemeKind::Light);
        parts = makeParts();
        auto started = RenderService::start();
        QVERIFY2(started.ok(), started.ok() ? "" : started.error().message.c_str());
        render = std::move(started).value();
    }
    [[nodiscard]] std::unique_ptr<MainWindow> window() const {
        return std::make_unique<MainWindow>(*parts, render.get(), findLocations());
    }

    std::unique_ptr<Parts> parts;
    std::unique_ptr<RenderService> render;
};

} // namespace trundle
