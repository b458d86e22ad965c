// A robot from dimensions and an arena from a floor plan with mouse and keyboard alone: from the Welcome page to a driven square.

#include <QAbstractButton>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "editor/document/structure_edits.h"
#include "editor/running/panels/trust.h"
#include "editor/running/session.h"
#include "editor/shell/window_fixture.h"
#include "editor/shell/window_hand.h"
#include "eventually.h"
#include "lang/formatter.h"
#include "square_path.h"

using namespace trundle;

namespace {

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Counts the presses of mouse buttons in the whole program.
class ClickCounter final : public QObject {
public:
    ClickCounter() { qApp->installEventFilter(this); }
    int clicks = 0;

private:
    bool eventFilter(QObject* watched, QEvent* event) override {
        // A press reaches the window before the widget; only widgets count, and each press one of them.
        if (event->type() == QEvent::MouseButtonPress && watched->isWidgetType()) ++clicks;
        return false;
    }
};

} // namespace

class NewRobotTest final : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        applyTheme(*qApp, qEnvironmentVariable("TRUNDLE_THEME") == QStringLiteral("dark") ? ThemeKind::Dark : ThemeKind::Light);
        m_application = makeApplication(findLocations(), Isolation::Module); // as the program does
    }
    void init() {
        QSettings().clear();
        m_folder = std::make_unique<QTemporaryDir>();
        m_window = std::make_unique<MainWindow>(*m_application, nullptr, findLocations());
        m_window->resize(1400, 900);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), kTimeoutMs));
    }
    void cleanup() { m_window.reset(); }

    void fromWelcomeToASquare_data() {
        QTest::addColumn<int>("base");
        QTest::addColumn<double>("side");
        QTest::addColumn<double>("radius"); // of its corners
        QTest::newRow("differential") << 0 << 1. << 0.;
        QTest::newRow("skid-steer") << 1 << 1. << 0.;
        QTest::newRow("omni") << 2 << 1. << 0.;
        QTest::newRow("mecanum") << 3 << 1. << 0.;
        QTest::newRow("ackermann") << 4 << 2. << 0.65;
    }
    /// In at most ten clicks.
    void fromWelcomeToASquare() {
        QFETCH(int, base);
        QFETCH(double, side);
        QFETCH(double, radius);
        const WindowHand hand(*m_window);
        const ClickCounter counter;
        QVERIFY(hand.press("welcome.file.newFromDimensions"));
        EVENTUALLY(dialog() && dialog()->isVisible());
        QVERIFY(hand.press(qPrintable(QStringLiteral("base%1").arg(base))));
        QTest::mouseClick(field("robotFolder"), Qt::LeftButton);
        typeOver(field("robotFolder"), m_folder->path());
        QVERIFY2(create()->isEnabled(), qPrintable(result()));
        WindowFixture::savePicture(*m_window, qPrintable(QStringLiteral("robot_dialog_%1").arg(base)), dialog());
        QVERIFY(hand.press("robotCreate"));
        Document& document = m_window->document();
        EVENTUALLY(document.isOpen());
        const Diagnostics& problems = document.loaded()->diagnostics;
        QVERIFY2(problems.all().empty(), problems.all().empty() ? "" : problems.all().front().message.c_str());
        QVERIFY(!document.texts().isModified());
        for (std::size_t f = 0; f < document.loaded()->trees.size(); ++f)
            if (QString::fromStdString(document.loaded()->paths[f]).startsWith(real("rover")))
                QCOMPARE(format(*document.loaded()->trees[f]), print(*document.loaded()->trees[f]));

        m_window->activateWindow(); // which needs a window manager when a dialog closes
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), kTimeoutMs));
        for (int i = 0; i < 12; ++i) hand.key(Qt::Key_BracketRight, Qt::ControlModifier);
        RunSession& session = m_window->session();
        QCOMPARE(session.speed(), 0.); // as fast as possible
        QVERIFY(hand.press("transportRun"));
        EVENTUALLY(session.state() == RunState::Ended);
        const SquarePath path(contentOf(session.logs().folder() + QStringLiteral("/rover_square.csv")), side, radius);
        QVERIFY(path.places.size() > 100);
        qInfo("%d clicks, at most %.1f mm beside a corner, %.4f m from edge to edge", counter.clicks, path.worst * 1e3,
              path.across);
        QVERIFY(path.worst < 0.02 * side && std::abs(path.across - side) < 0.02 * side);
        QVERIFY(counter.clicks <= 10);
        session.reset();
        QVERIFY(document.structure()
                    .apply(QStringLiteral("Insert"), {"RobotConfig.Rover"},
                           [](const LoadedProject& loaded, const StructureEdits::PathMapping& renamed) {
                               return planInsert(loaded, renamed("RobotConfig.Rover"),
                                                 "Body arm { Sphere s { Radius=0.1 Mass=1 } }");
                           })
                    .ok());
        QCOMPARE(document.texts().modifiedFiles(),
                 std::vector{real("rover/rover.sim").toStdString()}); // no question: it is used once
    }

    /// By the keys alone: a dimension in centimetres, the name, Enter.
    void withoutAMouse() {
        openByKeys();
        const auto key = [this](Qt::Key which) { QTest::keyClick(dialog()->focusWidget(), which); };
        QCOMPARE(focusName(), QStringLiteral("base0"));
        key(Qt::Key_Tab);
        QCOMPARE(focusName(), QStringLiteral("robotLength"));
        typeOver(dialog()->focusWidget(), QStringLiteral("36 cm"));
        QStringList order;
        for (int i = 0; i < 12; ++i) {
            key(Qt::Key_Tab);
            order.append(focusName());
        }
        QCOMPARE(order.mid(0, 8).join(u' '), QStringLiteral("robotWidth robotHeight robotWheelRadius robotWheelSeparation "
                                                            "robotMass robotTopSpeed robotName robotFolder"));
        QVERIFY(order.contains(QStringLiteral("robotCreate")));
        field("robotFolder")->setFocus(Qt::TabFocusReason);
        typeOver(field("robotFolder"), m_folder->path());
        field("robotName")->setFocus(Qt::TabFocusReason);
        typeOver(field("robotName"), QStringLiteral("Crawler"));
        key(Qt::Key_Return);
        EVENTUALLY(m_window->document().isOpen());
        const QByteArray robot = contentOf(m_folder->filePath(QStringLiteral("crawler/crawler.sim")));
        QVERIFY2(robot.contains("Size=0.36,0.2,0.1") && robot.contains("DifferentialDrive base"), robot.constData());
        QVERIFY(TrustedFolders::covers(real("crawler")));
    }

    /// The wheels follow the hull until their place is typed.
    void wheelsFollowTheHull() {
        openByKeys();
        const auto separation = [&] { return qobject_cast<QLineEdit*>(number("robotWheelSeparation"))->text(); };
        QCOMPARE(separation(), QStringLiteral("0.25"));
        typeOver(number("robotWidth"), QStringLiteral("1"));
        QCOMPARE(separation(), QStringLiteral("1.03"));
        QVERIFY2(create()->isEnabled(), qPrintable(result()));
        typeOver(number("robotWheelSeparation"), QStringLiteral("1.2"));
        typeOver(number("robotWidth"), QStringLiteral("0.5"));
        QCOMPARE(separation(), QStringLiteral("1.2"));
    }

    /// What is wrong is shown with each key, and nothing can be created until it is right.
    void saysWhatIsWrongWhileTyping() {
        openByKeys();
        QWidget* separation = number("robotWheelSeparation");
        typeOver(separation, QStringLiteral("0.2"));
        QVERIFY(!create()->isEnabled());
        QCOMPARE(result(),
                 QStringLiteral("The wheels touch the hull: the wheel separation must be at least 0.229 m with this hull and "
                                "these wheels."));
        QTest::keyClick(separation, Qt::Key_Return); // does nothing
        QVERIFY(dialog()->isVisible());
        QTest::keyClicks(separation, QStringLiteral("5"));
        QVERIFY2(create()->isEnabled(), qPrintable(result()));
        QVERIFY(motor().startsWith(QStringLiteral("2 × Pololu 70:1 37D 12 V: up to 0.65 m/s")));
        typeOver(separation, QStringLiteral("wide"));
        QVERIFY(!create()->isEnabled() && motor().isEmpty());
        QVERIFY2(result().contains(QStringLiteral("The wheel separation")), qPrintable(result()));
        QTest::keyClick(separation, Qt::Key_Escape); // the last valid value
        QVERIFY(create()->isEnabled() && dialog()->isVisible());
        typeOver(separation, QStringLiteral("0.2 + 5 cm"));
        QVERIFY2(create()->isEnabled(), qPrintable(result()));
        typeOver(number("robotTopSpeed"), QStringLiteral("12"));
        QVERIFY2(result().startsWith(QStringLiteral("No motor is fast enough")), qPrintable(result()));
        QTest::keyClick(number("robotTopSpeed"), Qt::Key_Down); // 11
        QVERIFY2(result().startsWith(QStringLiteral("No motor is fast enough")), qPrintable(result()));
        typeOver(number("robotTopSpeed"), QStringLiteral("2"));
        QVERIFY2(motor().startsWith(QStringLiteral("2 × Pololu 19:1 37D 12 V")), qPrintable(motor()));
        QTest::keyClick(dialog(), Qt::Key_Escape);
        EVENTUALLY(!dialog());
        QVERIFY(QDir(m_folder->path()).isEmpty());
    }

    /// Nothing that exists is written over.
    void refusesATakenName() {
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("rover")));
        openByKeys();
        typeOver(field("robotFolder"), m_folder->path());
        QVERIFY(!create()->isEnabled());
        QVERIFY2(result().endsWith(QStringLiteral("/rover exists already.")), qPrintable(result()));
        typeOver(field("robotName"), QStringLiteral("my robot"));
        QVERIFY(!create()->isEnabled());
        typeOver(field("robotName"), QStringLiteral("OpenFloor"));
        QVERIFY(!create()->isEnabled());
        QVERIFY2(result().contains(QStringLiteral("its experiment imports a config of that name")), qPrintable(result()));
        typeOver(field("robotName"), QStringLiteral("Rover2"));
        QVERIFY(create()->isEnabled());
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("rover2"))); // by another program, meanwhile
        QTest::keyClick(field("robotName"), Qt::Key_Return);
        QVERIFY(dialog()->isVisible());
        QVERIFY2(result().contains(QStringLiteral("it exists")), qPrintable(result()));
        QVERIFY(QDir(m_folder->filePath(QStringLiteral("rover2"))).isEmpty());
        QTest::keyClick(dialog(), Qt::Key_Escape);
    }

    /// A label is dragged as that of a property row.
    void aDragOfALabelChangesItsNumber() {
        openByKeys();
        QWidget* mass = number("robotMass");
        const QString before = mass->property("text").toString();
        QLabel* label = nullptr;
        for (QLabel* each : dialog()->findChildren<QLabel*>())
            if (each->buddy() == mass) label = each;
        QVERIFY(label);
        const QPoint from = label->rect().center();
        QTest::mousePress(label, Qt::LeftButton, {}, from);
        for (int x = 2; x <= 40; x += 2) QTest::mouseMove(label, from + QPoint(x, 0));
        QTest::mouseRelease(label, Qt::LeftButton, {}, from + QPoint(40, 0));
        QVERIFY2(mass->property("text").toDouble() > before.toDouble(), qPrintable(mass->property("text").toString()));
        QVERIFY(create()->isEnabled());
        QTest::keyClick(dialog(), Qt::Key_Escape);
    }

    /// The card of the Welcome page opens the same dialog.
    void theCardOpensIt() {
        const WindowHand hand(*m_window);
        QVERIFY(hand.press("welcome.newRobot"));
        EVENTUALLY(dialog() && dialog()->isVisible());
        QTest::keyClick(dialog(), Qt::Key_Escape);
    }

    /// The dark parts of a picture become boxes.
    void anArenaFromAFloorPlan() {
        QImage plan(80, 60, QImage::Format_RGB32);
        plan.fill(Qt::white);
        QPainter painter(&plan);
        painter.fillRect(0, 0, 80, 2, Qt::black);
        painter.fillRect(40, 2, 2, 40, Qt::black);
        painter.end();
        const QString picture = real("plan.png");
        QVERIFY(plan.save(picture));
        const WindowHand hand(*m_window);
        QVERIFY(hand.choose({QStringLiteral("File"), QStringLiteral("New"), QStringLiteral("Arena from Floor Plan")}));
        const auto asked = [this] { return m_window->findChild<QDialog*>(QStringLiteral("newArena")); };
        EVENTUALLY(asked() && asked()->isVisible());
        const auto* made = asked()->findChild<QPushButton*>(QStringLiteral("arenaCreate"));
        const auto* said = asked()->findChild<QLabel*>(QStringLiteral("arenaResult"));
        QVERIFY(!made->isEnabled());
        typeOver(asked()->findChild<QLineEdit*>(QStringLiteral("arenaPicture")), real("none.png"));
        QVERIFY2(said->text().startsWith(QStringLiteral("There is no file")), qPrintable(said->text()));
        typeOver(asked()->findChild<QLineEdit*>(QStringLiteral("arenaPicture")), picture);
        typeOver(asked()->findChild<QLineEdit*>(QStringLiteral("arenaFolder")), m_folder->path());
        typeOver(asked()->findChild<QWidget*>(QStringLiteral("arenaWidth"))->focusProxy(), QStringLiteral("800 cm"));
        QVERIFY2(said->text().startsWith(QStringLiteral("2 walls, 8 m × 6 m.")), qPrintable(said->text()));
        QVERIFY(hand.press("arenaLight"));
        QVERIFY2(!said->text().startsWith(QStringLiteral("2 walls")), qPrintable(said->text()));
        QVERIFY(hand.press("arenaLight"));
        QVERIFY(hand.press("arenaCreate"));
        Document& document = m_window->document();
        EVENTUALLY(document.isOpen());
        const Diagnostics& problems = document.loaded()->diagnostics;
        QVERIFY2(problems.all().empty(), problems.all().empty() ? "" : problems.all().front().message.c_str());
        const auto& geoms = *document.loaded()->experiment->statics.at(0).geoms;
        QCOMPARE(geoms.size(), std::size_t(3)); // and the floor
        QVERIFY(geoms[1].size.isApprox(Vec3(8, 0.2, 0.5), 1e-9) && geoms[1].pose.position.isApprox(Vec3(0, 2.9, 0.25), 1e-9));
        QVERIFY(geoms[2].size.isApprox(Vec3(0.2, 4, 0.5), 1e-9));
        QCOMPARE(document.loaded()->experiment->robots.size(), std::size_t(1));
    }

private:
    [[nodiscard]] QDialog* dialog() const { return m_window->findChild<QDialog*>(QStringLiteral("newRobot")); }
    [[nodiscard]] QLineEdit* field(const char* name) const { return dialog()->findChild<QLineEdit*>(QLatin1String(name)); }
    /// The line edit of a number.
    [[nodiscard]] QWidget* number(const char* name) const {
        return dialog()->findChild<QWidget*>(QLatin1String(name))->focusProxy();
    }
    [[nodiscard]] QPushButton* create() const { return dialog()->findChild<QPushButton*>(QStringLiteral("robotCreate")); }
    [[nodiscard]] QString textOf(const char* label) const { return dialog()->findChild<QLabel*>(QLatin1String(label))->text(); }
    [[nodiscard]] QString result() const { return textOf("robotResult"); }
    [[nodiscard]] QString motor() const { return textOf("robotMotor"); }
    [[nodiscard]] QString real(const char* name) const {
        return QDir(m_folder->path()).canonicalPath() + u'/' + QLatin1String(name);
    }
    /// Of the widget with the keyboard, or of the number that it belongs to.
    [[nodiscard]] QString focusName() const {
        const QWidget* focus = dialog()->focusWidget();
        if (!focus) return {};
        return focus->objectName() == QStringLiteral("field") ? focus->parentWidget()->objectName() : focus->objectName();
    }
    static void typeOver(QWidget* line, const QString& text) {
        QTest::keyClick(line, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(line, text);
    }
    void openByKeys() {
        auto* link = m_window->findChild<QAbstractButton*>(QStringLiteral("welcome.file.newFromDimensions"));
        link->setFocus(Qt::TabFocusReason);
        QTest::keyClick(link, Qt::Key_Return);
        EVENTUALLY(dialog() && dialog()->isVisible());
        QVERIFY(QTest::qWaitForWindowActive(dialog(), kTimeoutMs));
    }

    std::unique_ptr<Application> m_application;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(NewRobotTest)
#include "new_robot_test.moc"
