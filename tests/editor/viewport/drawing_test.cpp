// The 3D views: when they draw, navigation, overlays, render styles and measuring.
#include <QtTest>

#include "editor/document/structure_edits.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/overlays/mass_overlay.h"
#include "editor/viewport/tools/measure_tool.h"
#include "editor/viewport/view_window.h"
#include "eventually.h"

using namespace trundle;

class DrawingTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }
    void init() {
        m_window = std::make_unique<ViewWindow>(m_render.get());
        QVERIFY(m_window->open(kRoom));
        EVENTUALLY(m_window->panel->views().isUpToDate());
    }
    void cleanup() { m_window.reset(); }

    void oneEditIsOnePictureInEachView() {
        m_window->trigger("view.two");
        EVENTUALLY(m_window->panel->views().isUpToDate());
        const int first = m_window->panel->views().view(0).image().redraws(),
                  second = m_window->panel->views().view(1).image().redraws();
        const int hidden = m_window->panel->views().view(2).image().redraws();
        QVERIFY(m_window->document.structure().setValues(QStringLiteral("move"), {{"robot0.Pos", "0,0,0"}}).ok());
        EVENTUALLY(m_window->panel->views().isUpToDate());
        QCOMPARE(m_window->panel->views().view(0).image().redraws(), first + 1);
        QCOMPARE(m_window->panel->views().view(1).image().redraws(), second + 1);
        QCOMPARE(m_window->panel->views().view(2).image().redraws(), hidden);
    }

    void manyChangesOfOneMomentAreOnePicture() {
        const int before = m_window->view().image().redraws();
        for (int i = 0; i < 5; ++i) m_window->selection.select(i % 2 ? "robot0" : "robot1");
        for (int i = 0; i < 20; ++i) m_window->view().redraw();
        EVENTUALLY(m_window->panel->views().isUpToDate());
        QCOMPARE(m_window->view().image().redraws(), before + 1);
    }

    void refinesPictureWhenIdle() {
        EVENTUALLY_EQUAL(m_window->view().image().refinements(), 1);
        EVENTUALLY(m_window->panel->views().isUpToDate());
        const int redraws = m_window->view().image().redraws();
        // Iterations of the event loop without an event of the view.
        for (int i = 0; i < 200; ++i) QCoreApplication::processEvents();
        QCOMPARE(m_window->view().image().redraws(), redraws);
        QCOMPARE(m_window->view().image().refinements(), 1);
    }

    void refinementDoesNotDelayNewImages() {
        m_window->panel->resize(1800, 1400); // so that drawing takes long
        EVENTUALLY(m_window->panel->views().isUpToDate());
        const int finer = m_window->view().image().refinements();
        while (m_window->view().image().refinements() == finer) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        const int before = m_window->view().image().redraws();
        QSignalSpy shown(&m_window->view().image(), &ViewImage::shown);
        m_window->selection.select("robot0");
        EVENTUALLY(m_window->panel->views().isUpToDate());
        QCOMPARE(m_window->view().image().redraws(), before + 1);
        QVERIFY(shown.size() >= 1);
        QVERIFY(orange(m_window->view().image().picture()) > 100);
        EVENTUALLY_EQUAL(m_window->view().image().refinements(), finer + 2); // the refined image follows
        EVENTUALLY(m_window->panel->isSettled());
        QCOMPARE(shown.size(), 2); // the image that was superseded was not shown
    }

    void hiddenPanelRequestsNothing() {
        m_window->panel->hide();
        const int before = m_window->view().image().redraws();
        QVERIFY(m_window->document.structure().setValues(QStringLiteral("move"), {{"robot0.Pos", "0,0,0"}}).ok());
        for (int i = 0; i < 100; ++i) QCoreApplication::processEvents();
        QCOMPARE(m_window->view().image().redraws(), before);
        m_window->panel->show();
        EVENTUALLY(m_window->panel->views().isUpToDate());
        QCOMPARE(m_window->view().image().redraws(), before + 1);
    }

    void aSelectedRobotHasAnOutline() {
        const QImage plain = m_window->view().image().picture();
        m_window->selection.select("robot0");
        EVENTUALLY(m_window->panel->views().isUpToDate() && orange(m_window->view().image().picture()) > 100);
        QCOMPARE(orange(plain), 0);
        m_window->selection.select("robot0.chassis.bumper");
        EVENTUALLY(m_window->panel->views().isUpToDate() && orange(m_window->view().image().picture()) > 20);
        m_window->selection.select("RobotConfig.SimpleRobot.chassis"); // outlined in both robots
        EVENTUALLY(m_window->panel->views().isUpToDate() && orange(m_window->view().image().picture()) > 100);
        m_window->selection.select("arena.floor"); // infinite, so it has no outline
        EVENTUALLY(m_window->panel->views().isUpToDate() && orange(m_window->view().image().picture()) == 0);
    }

    void omitsHiddenObjects() {
        m_window->selection.select("robot0");
        EVENTUALLY(m_window->panel->views().isUpToDate() && orange(m_window->view().image().picture()) > 100);
        m_window->panel->world().setHidden({"robot0"});
        EVENTUALLY(m_window->panel->views().isUpToDate() && orange(m_window->view().image().picture()) == 0);
        m_window->panel->world().setHidden({"robot0.chassis.hull", "arena"});
        EVENTUALLY(m_window->panel->views().isUpToDate() && orange(m_window->view().image().picture()) > 20);
    }

    void theWheelZoomsToTheCursor() {
        const QPointF cursor(600, 400);
        const Vec3 under = m_window->view().camera().pointUnder(cursor);
        const double before = m_window->view().camera().free().metresPerPixel(900, under);
        QWheelEvent event(cursor, m_window->view().mapToGlobal(cursor), {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&m_window->view(), &event);
        const QPointF after = *m_window->view().camera().pixelOf(under);
        QVERIFY(QLineF(after, cursor).length() < 0.01);
        QVERIFY(m_window->view().camera().free().metresPerPixel(900, under) < 0.8 * before);
    }

    void theMiddleButtonOrbitsAboutWhatIsUnderTheCursor() {
        const QPointF cursor(500, 420);
        const Vec3 under = m_window->view().camera().pointUnder(cursor);
        m_window->drag(cursor, cursor + QPointF(90, -30), Qt::MiddleButton);
        QVERIFY(QLineF(*m_window->view().camera().pixelOf(under), cursor).length() < 0.01);
    }

    void withShiftItPansAndThePointStaysUnderTheCursor() {
        const QPointF cursor(500, 420), to(620, 380);
        const Vec3 under = m_window->view().camera().pointUnder(cursor);
        m_window->drag(cursor, to, Qt::MiddleButton, Qt::ShiftModifier);
        QVERIFY(QLineF(*m_window->view().camera().pixelOf(under), to).length() < 0.01);
    }

    void inTheCadStyleTheMiddleButtonPansAndCtrlZooms() {
        ViewSettings& settings = m_window->view().context().settings;
        settings.setNavigation(NavigationStyle::Cad);
        const QPointF cursor(500, 420), to(620, 380);
        Vec3 under = m_window->view().camera().pointUnder(cursor);
        m_window->drag(cursor, to, Qt::MiddleButton);
        QVERIFY(QLineF(*m_window->view().camera().pixelOf(under), to).length() < 0.01);
        under = m_window->view().camera().pointUnder(cursor);
        const double before = m_window->view().camera().free().metresPerPixel(900, under);
        m_window->drag(cursor, cursor - QPointF(0, 60), Qt::MiddleButton, Qt::ControlModifier); // up zooms in, like the wheel
        QVERIFY(m_window->view().camera().free().metresPerPixel(900, under) < 0.8 * before);
        QVERIFY(QLineF(*m_window->view().camera().pixelOf(under), cursor).length() < 0.01);
        settings.setNavigation(NavigationStyle::Trundle);
    }

    void hintsAtFlyingWhileOrbiting() {
        m_window->press({500, 420}, Qt::RightButton);
        m_window->move({520, 420}, {}, Qt::RightButton);
        QVERIFY2(m_window->view().hints().hint().contains(QStringLiteral("W A S D")),
                 qPrintable(m_window->view().hints().hint()));
        m_window->release({520, 420}, Qt::RightButton);
        QCOMPARE(m_window->view().hints().hint(), QString());
    }

    void axisViewsAndLayoutsFollowTheirActions() {
        for (const auto& [id, kind] :
             std::vector<std::pair<const char*, ViewKind>>{{"view.top", ViewKind::Top},
                                                           {"view.front", ViewKind::Front},
                                                           {"view.side", ViewKind::Side},
                                                           {"view.parallel", ViewKind::Orthographic},
                                                           {"view.follow", ViewKind::Follow},
                                                           {"view.chase", ViewKind::Chase},
                                                           {"view.perspective", ViewKind::Perspective}}) {
            m_window->trigger(id);
            QCOMPARE(m_window->view().camera().free().kind(), kind);
            EVENTUALLY(m_window->panel->views().isUpToDate());
        }
        m_window->trigger("view.four");
        for (int i = 0; i < 4; ++i) QVERIFY(m_window->panel->views().view(i).isVisible());
        EVENTUALLY(m_window->panel->views().isUpToDate());
        m_window->trigger("view.three");
        QVERIFY(!m_window->panel->views().view(2).isVisible());
        QVERIFY(m_window->panel->views().view(0).height() > 1.8 * m_window->panel->views().view(3).height());
        EVENTUALLY(m_window->panel->views().isUpToDate());
        m_window->trigger("view.one");
        QVERIFY(!m_window->panel->views().view(1).isVisible() && !m_window->panel->views().view(3).isVisible());
    }

    /// Views that get cameras as they are first shown are not framed; one that the user adds is.
    void savedCamerasOfAllViewsAreRestored() {
        ViewGrid& views = m_window->panel->views();
        std::vector<ViewState> saved(4);
        for (std::size_t i = 0; i < 4; ++i) {
            saved[i].camera.eye = {2.0 + double(i), -20, 3};
            saved[i].camera.target = {0, double(i), 0};
        }
        const auto isSaved = [&](std::size_t i) {
            return (views.viewStates()[i].camera.eye - saved[i].camera.eye).norm() < 1e-6;
        };
        const auto handleEvents = [&] {
            bool handled = false; // after what was queued before
            QTimer::singleShot(0, &views, [&] { handled = true; });
            EVENTUALLY(handled);
        };
        views.setViewStates(saved, 4);
        handleEvents();
        for (std::size_t i = 0; i < 4; ++i) QVERIFY2(isSaved(i), qPrintable(QString::number(i)));
        views.setViewCount(1);
        views.setViewCount(2);
        handleEvents();
        QVERIFY(isSaved(0) && !isSaved(1));
    }

    void framingShowsTheSelection() {
        m_window->selection.select("robot1");
        m_window->trigger("view.frame");
        EVENTUALLY(m_window->view().rect().contains(m_window->at({0.5, 0.3, 0.05})));
        EVENTUALLY(m_window->view().camera().free().distance() < 1.5);
        m_window->trigger("view.frameAll");
        EVENTUALLY(m_window->view().camera().free().distance() > 3);
    }

    void showsBrokenObjectAsGhost() {
        const QPointF hull = m_window->at({0.5, 0.3, 0.1});
        EVENTUALLY_EQUAL(m_window->view().image().refinements(), 1);
        EVENTUALLY(m_window->panel->views().isUpToDate());
        const QColor before = m_window->view().image().picture().pixelColor(hull.toPoint());
        // The config of the second robot is missing now.
        const std::string file = m_window->document.texts().files().front();
        const std::string broken =
            QByteArray(kRoom).replace("robot1 { Config=SimpleRobot", "robot1 { Config=Nothing").toStdString();
        QVERIFY(m_window->document.edits().replaceText(QStringLiteral("typing"), file, broken).ok());
        QCOMPARE(m_window->panel->world().objects()->experiment().robots.size(), std::size_t(1));
        EVENTUALLY_EQUAL(m_window->view().image().refinements(), 2);
        EVENTUALLY(m_window->panel->views().isUpToDate());
        const QColor ghost = m_window->view().image().picture().pixelColor(hull.toPoint());
        const std::string gone =
            QByteArray(kRoom).split('\n').mid(0, 5).join('\n').toStdString() + "\nRobot x { Config=Nothing }\n";
        QVERIFY(m_window->document.edits().replaceText(QStringLiteral("typing"), file, gone).ok());
        EVENTUALLY_EQUAL(m_window->view().image().refinements(), 3);
        EVENTUALLY(m_window->panel->views().isUpToDate());
        const QColor floor = m_window->view().image().picture().pixelColor(hull.toPoint());
        QVERIFY(ghost != before);
        QVERIFY(ghost != floor);
    }

    void everyOverlayCanBeSwitched() {
        for (const char* id :
             {"view.overlayShadows", "view.overlayGrid", "view.overlayNames", "view.overlayTrails", "view.overlayJoints",
              "view.overlayMass", "view.overlayContacts", "view.overlayCollision", "view.overlayWireframe"}) {
            EVENTUALLY(m_window->panel->isSettled());
            const QImage before = m_window->view().grab().toImage();
            const bool on = m_window->actions.at(id).isChecked();
            m_window->trigger(id);
            QCOMPARE(m_window->actions.at(id).isChecked(), !on);
            EVENTUALLY(m_window->panel->isSettled());
            const bool needsRun = std::string(id) == "view.overlayTrails" || std::string(id) == "view.overlayContacts";
            if (!needsRun) QVERIFY2(m_window->view().grab().toImage() != before, id);
        }
    }

    void appliesRenderStyleAtOnce() {
        const auto chosen = [this](const char* id) { return m_window->actions.at(id).isChecked(); };
        EVENTUALLY(m_window->panel->isSettled());
        const QImage fast = m_window->view().image().picture();
        QVERIFY(chosen("view.lookAutomatic") && !chosen("view.lookRich"));
        m_window->trigger("view.lookRich");
        QVERIFY(!chosen("view.lookAutomatic") && chosen("view.lookRich"));
        EVENTUALLY(m_window->panel->isSettled());
        const QImage rich = m_window->view().image().picture();
        m_window->trigger("view.lookFast");
        QVERIFY(!chosen("view.lookRich") && chosen("view.lookFast"));
        EVENTUALLY(m_window->panel->isSettled());
        QVERIFY(rich != m_window->view().image().picture());
        if (m_render->isSoftware()) QVERIFY(fast == m_window->view().image().picture());
        m_window->trigger("view.lookAutomatic");
        EVENTUALLY(m_window->panel->isSettled());
        QVERIFY(fast == m_window->view().image().picture());
    }

    void whereThereIsNoFloorItsLinesAreThere() {
        QVERIFY(m_window->open("#import robots/simple_robot.sim\nRobot robot0 { Config=SimpleRobot Pos=0,0,0 }\n"));
        m_window->look({0, -2.5, 2.5}, {0, 0, 0});
        EVENTUALLY(m_window->panel->isSettled());
        const QImage with = m_window->view().image().picture();
        m_window->trigger("view.overlayGrid");
        EVENTUALLY(m_window->panel->isSettled());
        const QImage without = m_window->view().image().picture();
        // Along a metre of open floor there are ten grid lines; the robot looks the same.
        int lines = 0;
        const QPoint from = m_window->at({-0.55, -0.85, 0}), to = m_window->at({0.55, -0.85, 0});
        for (int x = from.x(); x < to.x(); ++x) {
            const auto dark = [&](int at) { return qGray(with.pixel(at, from.y())) < qGray(without.pixel(at, from.y())) - 3; };
            lines += dark(x) && !dark(x - 1);
        }
        QCOMPARE(lines, 11);
        const QPoint hull = m_window->at({0, 0, 0.16});
        QCOMPARE(with.pixel(hull), without.pixel(hull));
    }

    void withoutTheGridTheFloorIsPlainAndStillThere() {
        m_window->look({0, -2.5, 2.5}, {0, 0, 0});
        const auto look = [this](std::vector<int>& shades) { // along 40 cm of open floor, across four grid lines
            EVENTUALLY(m_window->panel->isSettled());
            const QImage& picture = m_window->view().image().picture();
            const QPoint from = m_window->at({-0.2, -0.85, 0}), to = m_window->at({0.2, -0.85, 0});
            for (int x = from.x(); x < to.x(); ++x) shades.push_back(qGray(picture.pixel(x, from.y())));
            std::ranges::sort(shades);
        };
        std::vector<int> lined, plain;
        m_window->trigger("view.overlayShadows");
        look(lined);
        m_window->trigger("view.overlayGrid");
        look(plain);
        QVERIFY(!lined.empty() && !plain.empty());
        QVERIFY2(lined.back() - lined.front() > 8, qPrintable(QString::number(lined.back() - lined.front())));
        QVERIFY2(plain.back() - plain.front() <= 2, qPrintable(QString::number(plain.back() - plain.front()))); // except for fog
        QVERIFY(std::abs(plain.back() - lined.back()) < 24); // drawn with the colour of the floor, not of what is below it
    }

    void withoutOpenGlAllButThePictureWorks() {
        ViewWindow window(nullptr);
        QVERIFY(window.open(kRoom));
        window.look({0, -2.5, 2.5}, {0, 0, 0});
        window.click(window.at({-0.5, 0, 0.14}));
        QCOMPARE(window.selection.current(), std::string("robot0"));
        QVERIFY(!window.view().grab().isNull());
    }

    void measuringShowsTheDistance() {
        m_window->look({0, -2.5, 2.5}, {0, 0, 0});
        m_window->trigger("tool.measure");
        EVENTUALLY(m_window->panel->views().isUpToDate());
        const QImage before = m_window->view().grab().toImage();
        m_window->click(m_window->at({-0.3, -0.8, 0}));
        m_window->click(m_window->at({0.7, -0.8, 0}));
        QVERIFY(m_window->view().grab().toImage() != before);
        QVERIFY(m_window->selection.empty());
        m_window->key(Qt::Key_Escape);
        QCOMPARE(m_window->text(), kRoom);
    }

    void hintsLeaveTheScaleBarToBeRead() {
        m_window->panel->views().setViewCount(4);
        EVENTUALLY(m_window->panel->isSettled());
        View& view = m_window->view();
        const int bar = view.height() - 76; // beside it: the axes
        const auto scaleBar = [&] { return view.grab().toImage().copy(0, bar, view.width(), view.height() - bar); };
        const QImage before = scaleBar();
        const QImage whole = view.grab().toImage();
        view.hints().setHint(QStringLiteral("Distance 1.234 m · x 1.000 m   y 0.500 m   z 0.250 m"));
        QVERIFY(view.grab().toImage() != whole);
        QCOMPARE(scaleBar(), before);
    }

    /// Its nearest edge is ahead; from afar there is no room for all of its labels.
    void theNearestEdgeHasALabelOfItsOwn_data() {
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("height");
        QTest::addColumn<int>("least"); // labels
        QTest::newRow("near") << 0.6 << 0.5 << 5;
        QTest::newRow("far") << 4.0 << 2.0 << 2;
        QTest::newRow("very far") << 30.0 << 10.0 << 2;
        QTest::newRow("from ahead, flat") << 1.0 << 0.02 << 2;
    }
    void theNearestEdgeHasALabelOfItsOwn() {
        QFETCH(double, distance);
        QFETCH(double, height);
        QFETCH(int, least);
        QVERIFY(m_window->open("RobotConfig Heavy {\n  Body frame {\n    Box base { Size=0.3,0.3,0.1 Pos=0,0,0.05 Mass=1 }\n"
                               "    Box load { Size=0.1,0.1,0.1 Pos=0.12,0,0.15 Mass=2 }\n  }\n}\nRobot one { Config=Heavy }\n"));
        m_window->trigger("view.overlaySupport");
        m_window->look({distance, -0.001, height}, {0, 0, 0});
        EVENTUALLY(m_window->panel->views().isUpToDate());
        const std::vector<PlacedLabel> labels = supportLabels(m_window->view());
        QVERIFY2(int(labels.size()) >= least, QByteArray::number(int(labels.size())));
        QCOMPARE(labels[0].text, QStringLiteral("31°")); // 70 mm from below its centre of mass to the edge ahead, 117 mm high
        QCOMPARE(labels[1].text, QStringLiteral("Stable: 70 mm to the edge"));
        for (std::size_t i = 0; i < labels.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) QVERIFY(!labels[i].rect.intersects(labels[k].rect));
        QVERIFY(!m_window->view().grab().isNull());
    }

    void aLabelThatIsWiderThanTheViewHasLines() {
        const QFontMetricsF metrics(m_window->view().font());
        const QRectF area(0, 0, 0.7 * metrics.horizontalAdvance(QStringLiteral("Stable: 100 mm to the edge")), 300);
        const LabelRequest wide{QStringLiteral("Stable: 100 mm to the edge"), {{10, 150}}, true};
        const LabelRequest narrow{QStringLiteral("31°"), {{10, 150}, {10, 250}}, true};
        const std::vector<PlacedLabel> labels = placeLabels(std::vector{wide, narrow}, metrics, area);
        QVERIFY(area.contains(labels[0].rect) && labels[0].rect.height() > 2 * metrics.height());
        QVERIFY(labels[1].rect.height() < 2 * metrics.height() && !labels[1].rect.intersects(labels[0].rect));
    }

    void aThirdPointBeginsAnotherMeasurement() {
        Measurement measured;
        const Vec3 points[] = {{1, 2, 3}, {4, 0, 1}, {-1, 5, 0}, {2, 2, 8}, {7, 0, 0}};
        for (std::size_t i = 0; i < std::size(points); ++i) {
            measured.setNext(Vec3(9, 9, 9));
            measured.add(points[i]);
            QVERIFY(!measured.next()); // until the cursor moves
            QCOMPARE(measured.points(), i % 2 ? (std::vector<Vec3>{points[i - 1], points[i]}) : std::vector<Vec3>{points[i]});
        }
        measured.clear();
        QVERIFY(measured.points().empty());
    }

    void oneMeasuresFromOneViewToAnother() {
        m_window->trigger("tool.measure");
        m_window->panel->views().setViewCount(2);
        EVENTUALLY(m_window->panel->isSettled());
        View &first = m_window->panel->views().view(0), &second = m_window->panel->views().view(1);
        const auto click = [](View& view, const Vec3& point) {
            QTest::mouseClick(&view, Qt::LeftButton, {}, view.camera().pixelOf(point).value().toPoint());
        };
        const auto drawn = [](View& view) {
            const QImage image = view.grab().toImage().convertToFormat(QImage::Format_RGB32);
            int count = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x) count += image.pixel(x, y) == qRgb(255, 208, 60);
            return count;
        };
        QCOMPARE(drawn(first) + drawn(second), 0);
        click(first, {0, 0, 0});
        const int point = drawn(second);
        QVERIFY(point > 0); // it is shown in this view too
        click(second, {0.2, 0.2, 0});
        QVERIFY(drawn(second) > point);
        QVERIFY(drawn(first) > point);
        m_window->trigger("tool.select"); // nothing of the measurement stays
        QCOMPARE(drawn(first) + drawn(second), 0);
    }

private:
    /// Counts pixels in the colour of the outline.
    static int orange(const QImage& image) {
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const QColor c = image.pixelColor(x, y);
                const QColor wanted = View::outlineColour();
                count +=
                    std::abs(c.red() - wanted.red()) + std::abs(c.green() - wanted.green()) + std::abs(c.blue() - wanted.blue()) <
                    60;
            }
        return count;
    }

    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;
};

QTEST_MAIN(DrawingTest)
#include "drawing_test.moc"
