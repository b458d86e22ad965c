// Compares the window with the golden images in tests/data/golden: four states, in both themes, at scale factors 1 and 2.
//
// After an intended visual change, run build/release/tests/test_editor_shell_golden --write and review each image.
// At most 0.5 % of the pixels may differ by more than 2 of 255 in any channel. On a mismatch, the drawn image and
// an image of the differences are saved in golden/ in the build folder.
//
// The images do not depend on the machine: the program's own fonts are the only ones, the 3D view is drawn in software, the files
// are in a folder of the test, so are the samples (a copy of tests/data/golden/configs), and the run is paused at an exact simulated time. The only measured number, the milliseconds
// per tick in the status line, is replaced by a constant.

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLocale>
#include <QProcess>
#include <QSettings>
#include <QtTest>
#include <filesystem>

#include "app/application.h"
#include "editor/document/structure_edits.h"
#include "editor/shell/fixed_machine.h"
#include "editor/shell/main_window.h"
#include "editor/text/code/code_edit.h"
#include "editor/widgets/apply_theme.h"
#include "eventually.h"
#include "render/service.h"

using namespace trundle;

namespace {

/// Of this run of the test alone: two at once do not meet. Made by main().
const QString kHome = qEnvironmentVariable("TRUNDLE_GOLDEN_HOME");
const QString kKept = QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/data/golden/");
const QString kMissed = QStringLiteral(TRUNDLE_BINARY_DIR "/golden/");
constexpr QSize kWindow(1100, 700);
constexpr double kTolerated = 0.005; // share of the pixels
constexpr int kNear = 2;             // of 255

const QByteArray kRover = "// Drives until the bumper touches the wall, backs off and turns.\n"
                          "Tick = 0.01   Duration = 60\n"
                          "#import robots/simple_robot.sim\n"
                          "#import arenas/medium_arena.sim\n"
                          "#loadModule controllers/bump_and_turn\n"
                          "\n"
                          "Static arena { Config=MediumArena }\n"
                          "Robot rover {\n"
                          "  Config=SimpleRobot\n"
                          "  Pos=0,0,0  HPR=150,0,0   // faces the far wall\n"
                          "  BumpAndTurn brain { Speed=0.3 BackOff=0.2 }\n"
                          "}\n"
                          "PoseLog path { Robot=rover Interval=0.1 }\n";

bool g_write = false;

/// Counts the pixels that differ, and marks them in red in a pale copy of `actual`.
qsizetype difference(const QImage& kept, const QImage& actual, QImage& shown) {
    shown = actual.convertToFormat(QImage::Format_RGB32);
    qsizetype count = 0;
    for (int y = 0; y < actual.height(); ++y) {
        for (int x = 0; x < actual.width(); ++x) {
            const QRgb a = kept.pixel(x, y), b = actual.pixel(x, y);
            const int far =
                std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
            count += far > kNear;
            const int pale = 192 + qGray(b) / 4;
            shown.setPixel(x, y, far > kNear ? qRgb(220, 0, 0) : qRgb(pale, pale, pale));
        }
    }
    return count;
}

/// Why the image differs from the golden one; empty if it does not.
QString mismatch(const QImage& kept, const QImage& actual, const QString& name) {
    QString why;
    if (kept.isNull()) why = QStringLiteral("there is no %1%2").arg(kKept, name);
    else if (kept.size() != actual.size()) why = QStringLiteral("%1 has another size").arg(name);
    QImage shown;
    if (why.isEmpty()) {
        const qsizetype count = difference(kept, actual, shown), all = qsizetype(actual.width()) * actual.height();
        if (double(count) <= kTolerated * double(all)) return {};
        why = QStringLiteral("%1: %2 of %3 pixels differ").arg(name).arg(count).arg(all);
    }
    QDir().mkpath(kMissed);
    actual.save(kMissed + name);
    if (!shown.isNull()) shown.save(kMissed + QStringLiteral("differs-") + name);
    return why + QStringLiteral("; see ") + kMissed;
}

} // namespace

class GoldenTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        Locations places = findLocations();
        places.configs = copiedSamples();
        m_fixture = makeApplication(places);
        m_render = RenderService::startInBackground();
    }
    void init() {
        QSettings().clear();
        QDir(kHome + QStringLiteral("/project")).removeRecursively();
        write(QStringLiteral("rover.sim"), kRover);
        write(QStringLiteral("broken.sim"), QByteArray(kRover)
                                                .replace("SimpleRobot", "SimpelRobot")
                                                .replace("Speed=0.3", "Speed=fast")
                                                .replace("Interval=0.1", "Intervall=0.1"));
    }
    void cleanup() { m_window.reset(); }

    void detectsImageDifference() {
        QImage kept(100, 100, QImage::Format_RGB32), shown;
        kept.fill(qRgb(100, 100, 100));
        QImage actual = kept;
        actual.fill(qRgb(102, 100, 98));
        QCOMPARE(difference(kept, actual, shown), 0);
        for (int x = 0; x < 51; ++x) actual.setPixel(x, 7, qRgb(100, 103, 100));
        QCOMPARE(difference(kept, actual, shown), 51);
        QCOMPARE(shown.pixel(50, 7), qRgb(220, 0, 0));
    }

    void windowMatchesGoldenImages_data() {
        QTest::addColumn<QString>("moment");
        QTest::addColumn<bool>("dark");
        for (const char* moment : {"welcome", "edited", "running", "broken"})
            for (const bool dark : {false, true})
                QTest::addRow("%s %s", moment, dark ? "dark" : "light") << QString::fromLatin1(moment) << dark;
    }
    void windowMatchesGoldenImages() {
        QFETCH(QString, moment);
        QFETCH(bool, dark);
        applyTheme(*qApp, dark ? ThemeKind::Dark : ThemeKind::Light);
        if (moment == QLatin1String("welcome"))
            QSettings().setValue(QStringLiteral("recentFiles"),
                                 QStringList{path(QStringLiteral("rover.sim")), path(QStringLiteral("broken.sim"))});
        m_window = std::make_unique<MainWindow>(*m_fixture, m_render.get(), m_fixture->locations());
        m_window->setAnimated(false);
        m_window->resize(kWindow);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kTimeoutMs));
        if (moment == QLatin1String("edited")) edit();
        if (moment == QLatin1String("running")) run();
        if (moment == QLatin1String("broken")) breakDown();
        if (QTest::currentTestFailed()) return;

        const QImage actual = picture();
        const QString name = QStringLiteral("%1-%2-%3x.png")
                                 .arg(moment, dark ? QStringLiteral("dark") : QStringLiteral("light"))
                                 .arg(m_window->devicePixelRatioF());
        if (g_write) {
            QVERIFY(QDir().mkpath(kKept));
            QVERIFY(actual.save(kKept + name, "PNG", 0)); // quality 0: smallest file
        } else {
            const QString why = mismatch(QImage(kKept + name), actual, name);
            QVERIFY2(why.isEmpty(), qPrintable(why));
        }
    }

private:
    void edit() {
        open(QStringLiteral("rover.sim"));
        m_window->selection().select("rover");
        act("tool.move");
        QVERIFY(m_window->document().structure().setValues(QStringLiteral("Move rover"), {{"rover.Pos", "-1.2,0.5,0"}}).ok());
    }
    void run() {
        open(QStringLiteral("rover.sim"));
        m_window->selection().select("rover");
        act("view.layoutRun");
        for (const char* overlay : {"view.overlayNames", "view.overlayTrails", "view.overlayJoints", "view.overlayMass",
                                    "view.overlayContacts", "view.overlayCollision"})
            act(overlay);
        RunSession& session = m_window->session();
        for (int tenth = 1; tenth <= 71; ++tenth) { // in steps, so that the points of the trail have the same times
            session.runFor(0.1);
            EVENTUALLY(session.state() == RunState::Paused && session.results().time() > 0.1 * tenth - 1e-9);
        }
        act("view.frame");
        auto* status = m_window->findChild<QLabel*>(QStringLiteral("status.run"));
        static const QRegularExpression step(QStringLiteral("step [0-9.]+ ms"));
        QVERIFY(status->text().contains(step));
        status->setText(status->text().replace(step, QStringLiteral("step 0.10 ms")));
    }
    void breakDown() {
        open(QStringLiteral("broken.sim"));
        m_window->selection().select("rover");
        act("view.viewport");
        act("problems.next");
    }

    void open(const QString& file) {
        QVERIFY(m_window->open(path(file)));
        EVENTUALLY(m_window->document().isOpen());
    }
    void act(const char* id) { m_window->actions().at(id).trigger(); }

    QImage picture() {
        if (QWidget* focus = m_window->focusWidget()) focus->clearFocus(); // no caret and the same focus on every machine
        int still = 0;                                                     // consecutive checks without a new image
        const bool settled = QTest::qWaitFor([&] { return (still = m_window->isSettled() ? still + 1 : 0) > 5; }, 60000);
        if (!settled) qWarning("the window did not come to rest");
        // The scroll position depends on how many lines were wrapped at the time.
        for (auto* text : m_window->findChildren<CodeEdit*>()) text->setFirstVisibleLine(0);
        return m_window->grab().toImage().convertToFormat(QImage::Format_RGB888);
    }

    /// The samples that the images show. A change of those in configs/ changes no image.
    static std::string copiedSamples() {
        const std::string to = (kHome + QStringLiteral("/configs")).toStdString();
        std::filesystem::remove_all(to);
        std::filesystem::copy((kKept + QStringLiteral("configs")).toStdString(), to, std::filesystem::copy_options::recursive);
        return to;
    }
    static QString path(const QString& file) { return kHome + QStringLiteral("/project/") + file; }
    static void write(const QString& file, const QByteArray& text) {
        QVERIFY(QDir().mkpath(kHome + QStringLiteral("/project")));
        QFile written(path(file));
        QVERIFY(written.open(QIODevice::WriteOnly) && written.write(text) == text.size());
    }

    std::unique_ptr<Application> m_fixture;
    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<MainWindow> m_window;
};

int main(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet(
            "TRUNDLE_GOLDEN_HOME")) { // Qt reads the scale factor once at start, so each needs its own process
        const QTemporaryDir home;
        if (!home.isValid()) return 1;
        qputenv("TRUNDLE_GOLDEN_HOME", home.path().toUtf8());
        leaveTheMachineOut(home.path());
        QStringList arguments;
        for (int i = 1; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
        int failed = 0;
        for (const char* scale : {"1", "2"}) {
            qputenv("QT_SCALE_FACTOR", scale);
            QDir(home.filePath(QStringLiteral("project"))).removeRecursively();
            failed |= QProcess::execute(QString::fromLocal8Bit(argv[0]), arguments);
        }
        return failed;
    }
    const auto rest = std::remove_if(argv + 1, argv + argc, [](const char* word) {
        const bool write = qstrcmp(word, "--write") == 0;
        g_write = g_write || write;
        return write;
    });
    argc = int(rest - argv);
    QApplication application(argc, argv);
    GoldenTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "golden_test.moc"
