// Open, run, close, again and again: threads, descriptors and memory stay as they were.

#include <malloc.h>

#include <QDir>
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "editor/outline/library_panel.h"
#include "editor/shell/main_window.h"
#include "editor/widgets/theme.h"
#include "parts/parts.h"
#include "render/service.h"

using namespace trundle;

namespace {

constexpr int kWarmUp = 4; // Qt, fonts, icons, the module's library and the render service have taken what they keep

int countIn(const char* folder) {
    return int(QDir(QLatin1String(folder)).entryList(QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot).size());
}

/// Bytes that the program holds from malloc, in all its arenas. 0 under a sanitizer, which tells of leaks itself.
double bytesInUse() {
    const struct mallinfo2 now = mallinfo2();
    return double(now.uordblks) + double(now.hblkhd);
}

} // namespace

class OpenRunCloseTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        QSettings().clear();
        applyTheme(*qApp, ThemeKind::Light);
        m_parts = makeParts();
        auto render = RenderService::start();
        QVERIFY2(render.ok(), render.ok() ? "" : render.error().message.c_str());
        m_render = std::move(render).value();
        QFile sample(QStringLiteral(TRUNDLE_SOURCE_DIR "/configs/experiments/obstacle_detection.sim"));
        QVERIFY(sample.open(QIODevice::ReadOnly));
        QFile file(path());
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(file.write(sample.readAll()) > 0);
    }

    void nothingIsLeftBehind() {
        const int rounds = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 200 : 12;
        int threads = 0, descriptors = 0;
        std::vector<double> bytes;
        for (int round = 0; round < rounds; ++round) {
            oneRound(round);
            if (QTest::currentTestFailed()) {
                qWarning("round %d", round);
                return;
            }
            if (round + 1 == kWarmUp) {
                threads = countIn("/proc/self/task");
                descriptors = countIn("/proc/self/fd");
            }
            if (round + 1 >= kWarmUp) bytes.push_back(bytesInUse());
        }
        QTRY_VERIFY2(countIn("/proc/self/task") <= threads, qPrintable(QString::number(countIn("/proc/self/task") - threads)));
        QVERIFY2(countIn("/proc/self/fd") <= descriptors, qPrintable(QString::number(countIn("/proc/self/fd") - descriptors)));
        const double perRound = (bytes.back() - bytes.front()) / double(bytes.size() - 1);
        qInfo("%.0f bytes in use, %.0f more in each round", bytes.back(), perRound);
        QVERIFY2(perRound < kMostPerRound, qPrintable(QString::number(perRound)));
    }

private:
    static constexpr double kMostPerRound = 16e3;

    [[nodiscard]] QString path() const { return m_folder.filePath(QStringLiteral("obstacles.sim")); }

    void oneRound(int round) {
        MainWindow window(*m_parts, m_render.get(), findLocations());
        window.resize(1200, 800);
        window.show();
        QVERIFY(window.open(path()));
        QTRY_VERIFY(window.document().isOpen());
        window.selection().select("robot0");
        window.session().setSpeed(0);
        window.actions().at("sim.run").trigger();
        QTRY_VERIFY(window.session().snapshot() && window.session().snapshot()->tick > 20);
        if (round % 3 == 1) window.actions().at("sim.reset").trigger();
        if (round % 3 == 2) window.actions().at("file.close").trigger();
        if (round % 2) QTRY_VERIFY(window.isSettled());
        QVERIFY(window.close());
        QCOMPARE(window.session().state(), RunState::Start);
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Parts> m_parts;
    std::unique_ptr<RenderService> m_render;
};

QTEST_MAIN(OpenRunCloseTest)
#include "open_run_close_test.moc"
