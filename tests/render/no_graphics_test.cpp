// The render service without OpenGL reports an error.
#include <QtTest>

#include <cstdlib>

#include "render/service.h"

using namespace trundle;

/// A separate program, because EGL searches for drivers only once per process.
class NoGraphicsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aMachineWithoutDriversIsAnErrorToRead() {
        ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere/none.json", 1);
        ::unsetenv("DISPLAY");
        const auto service = RenderService::start();
        QVERIFY(!service.ok());
        QCOMPARE(codeName(service.error().code), std::string("E510"));
        QVERIFY2(service.error().message.starts_with("no OpenGL to draw with (surfaceless: "), service.error().message.c_str());
        QVERIFY(!RenderService::start().ok()); // and a second time
    }
};

QTEST_APPLESS_MAIN(NoGraphicsTest)
#include "no_graphics_test.moc"
