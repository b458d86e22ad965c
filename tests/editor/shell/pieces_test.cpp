// Parts of the window without the window: the arrangement of the docks, the recent files, the search of the command palette,
// the drawing of a robot in the making.

#include <cmath>
#include <optional>

#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "editor/shell/commands/command_palette.h"
#include "editor/shell/dialogs/robot_plan.h"
#include "editor/shell/layouts.h"
#include "editor/shell/recent_files.h"
#include "editor/widgets/apply_theme.h"
#include "eventually.h"

using namespace trundle;

namespace {

struct DocksFixture {
    QMainWindow window;
    Layouts layouts{window};

    DocksFixture() {
        window.setCentralWidget(new QLabel);
        window.resize(1400, 900);
        for (const char* name : {"scene", "properties", "history", "problems", "console"}) {
            auto* panel = new QLabel;
            panel->setObjectName(QLatin1String(name));
            layouts.add(panel, QLatin1String(name));
        }
        window.show();
    }
    QDockWidget& dock(const char* name) { return *layouts.dock(QLatin1String(name)); }
    Qt::DockWidgetArea area(const char* name) { return window.dockWidgetArea(&dock(name)); }
};

/// How much an image differs from itself one pixel further to the right and `down` pixels lower.
int changeAlong(const QImage& image, int down) {
    int change = 0;
    for (int y = 1; y + 1 < image.height(); ++y)
        for (int x = 0; x + 1 < image.width(); ++x)
            change += std::abs(qGray(image.pixel(x, y)) - qGray(image.pixel(x + 1, y + down)));
    return change;
}

} // namespace

class ShellPiecesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, ThemeKind::Light); }
    void init() { QSettings().clear(); }

    /// As the user left them, when a project is closed and another is opened.
    void docksStayAsTheyWereLeft() {
        DocksFixture o;
        QVERIFY(!o.dock("scene").isVisible());
        o.layouts.setShown(true);
        QVERIFY(!o.dock("history").isHidden() && !o.dock("scene").isHidden());
        QCOMPARE(o.area("problems"), Qt::BottomDockWidgetArea);
        o.dock("history").close();
        o.window.addDockWidget(Qt::RightDockWidgetArea, &o.dock("problems"));
        o.layouts.setShown(false);
        for (const char* name : {"scene", "properties", "problems"}) QVERIFY2(o.dock(name).isHidden(), name);
        QVERIFY(!o.layouts.menu()->isEnabled());
        o.layouts.setShown(true);
        QVERIFY(o.layouts.menu()->isEnabled());
        QVERIFY(o.dock("history").isHidden());
        QVERIFY(!o.dock("scene").isHidden());
        QCOMPARE(o.area("problems"), Qt::RightDockWidgetArea);
        QCOMPARE(o.area("scene"), Qt::LeftDockWidgetArea);
    }

    /// A small window narrows them; a large one gives them their widths back, also in the next start.
    void docksGetTheirWidthsBack() {
        const auto widths = [](DocksFixture& o) { return std::pair(o.dock("scene").width(), o.dock("properties").width()); };
        std::pair<int, int> chosen;
        {
            DocksFixture o;
            o.layouts.setShown(true);
            EVENTUALLY(o.dock("properties").width() >= 300);
            chosen = widths(o);
            o.window.centralWidget()->setMinimumWidth(400);
            o.window.resize(700, 700);
            EVENTUALLY(widths(o).second < chosen.second);
            o.window.resize(1400, 900);
            EVENTUALLY_EQUAL(widths(o), chosen);
            o.window.resize(700, 700);
            EVENTUALLY(widths(o).second < chosen.second);
            o.layouts.save();
        }
        DocksFixture o;
        o.layouts.setShown(true);
        EVENTUALLY_EQUAL(widths(o), chosen);
    }

    void eachLayoutHasItsOwnDocks() {
        DocksFixture o;
        o.layouts.setShown(true);
        o.dock("history").close();
        o.layouts.use(Layout::Run);
        o.dock("console").close();
        o.layouts.use(Layout::Edit);
        QVERIFY(o.dock("history").isHidden() && !o.dock("console").isHidden());
        o.layouts.use(Layout::Run);
        QVERIFY(o.dock("console").isHidden());
        o.layouts.resetCurrent(); // of this layout alone
        QVERIFY(!o.dock("console").isHidden());
        o.layouts.use(Layout::Edit);
        QVERIFY(o.dock("history").isHidden());
        // Settings that are not to be saved stay as they were.
        o.layouts.disableSettings();
        o.dock("scene").close();
        o.layouts.setShown(false);
        o.layouts.setShown(true);
        QVERIFY(!o.dock("scene").isHidden() && o.dock("history").isHidden());
    }

    void aFileOpenedAgainIsListedOnce() {
        QTemporaryDir folder;
        QStringList files;
        for (const char* name : {"a.sim", "b.sim", "c.sim"}) {
            files << folder.filePath(QLatin1String(name));
            QVERIFY(QFile(files.back()).open(QIODevice::WriteOnly));
            addRecentFile(files.back());
        }
        QCOMPARE(recentFiles(), (QStringList{files[2], files[1], files[0]}));
        addRecentFile(files[0]);
        QCOMPARE(recentFiles(), (QStringList{files[0], files[2], files[1]}));
        addRecentFile(files[0]);
        QCOMPARE(recentFiles(), (QStringList{files[0], files[2], files[1]}));
    }

    /// A name that begins with what is typed is before one with a word that begins so, that before one with it inside a word.
    void theBestNameIsFirst_data() {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("all"); // the best first
        QTest::newRow("a word") << "rob"
                                << "Robot Wizard, New Robot, Microbots";
        QTest::newRow("in capitals") << "ROB"
                                     << "robot wizard, New robot, Microbots";
        QTest::newRow("behind a sign") << "3d"
                                       << "3D View, Show (3D), Show X3D";
        QTest::newRow("two words") << "new rob"
                                   << "New Robot, New Microbots, Renew Microbots";
        QTest::newRow("in any order") << "rob new"
                                      << "New Robot, New Microbots, Renew Microbots";
    }
    void theBestNameIsFirst() {
        QFETCH(QString, typed);
        QFETCH(QString, all);
        const QStringList names = all.split(QStringLiteral(", "));
        for (qsizetype i = 0; i + 1 < names.size(); ++i)
            QVERIFY2(CommandPalette::match(names[i], typed) > CommandPalette::match(names[i + 1], typed), qPrintable(names[i]));
        QVERIFY(CommandPalette::match(names.back(), typed) > 0);
        QCOMPARE(CommandPalette::match(names.front(), typed + QStringLiteral(" quit")), 0); // every word has to be found
        QVERIFY(CommandPalette::match(names.back(), {}) > 0);
    }

    /// From above, the rollers of mecanum wheels lie along the diagonals of the robot: on two lines that cross in its middle.
    void rollersOfMecanumWheelsFormAnX() {
        const QImage image =
            baseIcon(BaseShape::Mecanum).pixmap(QSize(256, 256), 1).toImage().convertToFormat(QImage::Format_RGB32);
        const int w = image.width() / 2, h = image.height() / 2;
        QVERIFY(w > 50 && h > 50);
        const auto isRising = [&](bool right, bool bottom) { // as /
            const QImage quarter = image.copy(right ? image.width() - w : 0, bottom ? image.height() - h : 0, w, h);
            const int rising = changeAlong(quarter, -1), falling = changeAlong(quarter, 1);
            return std::abs(rising - falling) * 10 > rising + falling ? std::optional(rising < falling) : std::nullopt;
        };
        QCOMPARE(isRising(true, false), std::optional(true)); // left front: ahead is to the right
        QCOMPARE(isRising(true, true), std::optional(false));
        QCOMPARE(isRising(false, false), std::optional(false));
        QCOMPARE(isRising(false, true), std::optional(true));
    }

    void wheelsOfASkidSteerRobotHaveNoRollers() {
        const QImage image =
            baseIcon(BaseShape::SkidSteer).pixmap(QSize(256, 256), 1).toImage().convertToFormat(QImage::Format_RGB32);
        const int rising = changeAlong(image, -1), falling = changeAlong(image, 1);
        QVERIFY(std::abs(rising - falling) * 100 < rising + falling);
    }
};

QTEST_MAIN(ShellPiecesTest)
#include "pieces_test.moc"
