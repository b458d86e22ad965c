// Antenna lobes, radio links and coverage in the 3D views.

#include <cmath>
#include <numbers>

#include <QSignalSpy>
#include <QThread>
#include <QtTest>

#include "editor/document/structure_edits.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/radio/antenna_lobes.h"
#include "editor/viewport/radio/radio_colours.h"
#include "editor/viewport/radio/radio_overlays.h"
#include "editor/viewport/view_window.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QByteArray kMote = R"(Tick = 0.01
#import arenas/open_floor.sim
Static floor { Config=OpenFloor }
AntennaPattern beam { Model=patch BeamWidth=70 }
RobotConfig Mote {
  Body board { Box b { Size=0.06,0.03,0.02 Pos=0,0,0.01 Mass=0.05 Material=green Surface=plastic } }
  Transceiver radio { Body=board Pos=0,0,0.1 Antenna=isotropic MinReceivePower=-50 }
}
)";

/// Received power in dBm of 1 mW at 2.45 GHz between isotropic antennas (Friis); `distance` in metres.
double friis(double distance) { return -20 * std::log10(4 * std::numbers::pi * distance * 2.45e9 / 299792458.0); }

/// The radio poses that the window shows, for functions that do not need a window.
RadioPoses placesOf(ViewWindow& window) {
    const auto& objects = window.panel->world().objects();
    return {objects, window.panel->world().poses(),
            std::make_shared<const std::vector<RadioNode>>(radioNodesOf(objects->experiment()))};
}

int distance(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
}

} // namespace

class RadiosTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }
    void init() { m_window = std::make_unique<ViewWindow>(m_render.get()); }
    void cleanup() { m_window.reset(); }

    // --- lobes ---

    void aLobeFollowsThePattern_data() {
        QTest::addColumn<int>("model");
        for (const auto& [name, model] : {std::pair("isotropic", AntennaModel::Isotropic),
                                          {"dipole", AntennaModel::Dipole},
                                          {"inverted F", AntennaModel::InvertedF},
                                          {"patch", AntennaModel::Patch},
                                          {"yagi", AntennaModel::Yagi},
                                          {"cosine", AntennaModel::Cosine}})
            QTest::newRow(name) << int(model);
    }
    void aLobeFollowsThePattern() {
        QFETCH(int, model);
        const AntennaPattern pattern = AntennaPattern::of(AntennaModel(model));
        const int spokes = 32, middle = 8 * spokes;
        const auto mesh = lobeMesh(pattern, 0.5, spokes);
        const std::pair<int, Vec3> axes[] = {{middle, Vec3::UnitX()},       {middle + 8, Vec3::UnitY()},
                                             {middle + 16, -Vec3::UnitX()}, {middle + 24, -Vec3::UnitY()},
                                             {16 * spokes, Vec3::UnitZ()},  {0, -Vec3::UnitZ()}};
        for (const auto& [corner, axis] : axes) {
            const Vec3 point = mesh->points[std::size_t(corner)].cast<double>();
            const double wanted = lobeRadius(pattern.gain(axis), 0.5);
            QVERIFY((point - wanted * axis).norm() < 1e-6);
            QCOMPARE(mesh->colours[std::size_t(corner)], gainColour(pattern.gain(axis)));
        }
        QCOMPARE(lobeRadius(0, 0.5), 0.5);
        QCOMPARE(lobeRadius(10, 0.5), 0.75);
        QCOMPARE(lobeRadius(-20, 0.5), 0.0);
        QCOMPARE(lobeRadius(-30, 0.5), 0.0);
        // Triangles are counter-clockwise, seen from outside.
        for (std::size_t i = 0; i < mesh->indices.size(); i += 3) {
            const auto at = [&](std::size_t k) { return Vec3(mesh->points[mesh->indices[i + k]].cast<double>()); };
            QVERIFY(at(0).cross(at(1)).dot(at(2)) > -1e-12);
        }
    }

    void roundsUnitLength() {
        QCOMPARE(lobeUnitBeside(0.04), 0.05);
        QCOMPARE(lobeUnitBeside(0.22), 0.2);
        QCOMPARE(lobeUnitBeside(0.45), 0.5);
        QCOMPARE(lobeUnitBeside(0.9), 1.0);
        QCOMPARE(lobeUnitBeside(30), 20.0);
    }

    void aLobeTurnsWithItsBody() {
        QVERIFY(m_window->open(kMote + "Robot a { Config=Mote radio.Antenna=beam }\n"));
        m_window->look({0, -0.6, 0.6}, {0, 0, 0.1});
        EVENTUALLY(m_window->panel->isSettled());
        const QImage bare = m_window->view().image().picture();
        m_window->trigger("view.overlayLobes");
        step();
        const double ahead = 0.7 * lobeRadius(AntennaPattern::of(AntennaModel::Patch, {}, 70 * std::numbers::pi / 180).peak(),
                                              m_window->panel->radios().lobeUnit());
        QCOMPARE(m_window->panel->radios().inScene().shapes->size(), std::size_t(1));
        for (const double heading : {0.0, 90.0, 180.0}) {
            const double angle = heading * std::numbers::pi / 180;
            QVERIFY(m_window->session.robots().place("a", {Vec3::Zero(), rotationFromHpr({angle, 0, 0})}));
            EVENTUALLY(m_window->panel->views().isUpToDate());
            EVENTUALLY(differs(bare, {ahead * std::cos(angle), ahead * std::sin(angle), 0.1}));
            QVERIFY(!differs(bare, {-ahead * std::cos(angle), -ahead * std::sin(angle), 0.1}));
        }
        m_window->trigger("view.overlayLobes");
        EVENTUALLY(m_window->panel->views().isUpToDate());
        QVERIFY(!m_window->panel->radios().inScene().shapes);
        QVERIFY(!differs(bare, {-ahead, 0, 0.1}));
    }

    void lobeFollowsHingedBody() {
        QVERIFY(m_window->open(kMote + R"(RobotConfig Turret {
  Body foot { Box b { Size=0.1,0.1,0.1 Pos=0,0,0.05 Mass=1 Material=green Surface=plastic } }
  Body head { Pos=0,0,0.15 HPR=90,0,0 Box b { Size=0.1,0.02,0.02 Mass=0.1 Material=green Surface=plastic } }
  Hinge neck { Parent=foot Child=head Axis=0,0,1 }
  Transceiver radio { Body=head Pos=0.05,0,0 HPR=180,0,0 Antenna=beam }
}
Robot before { Config=Mote Pos=1,0,0 }
Robot a { Config=Turret }
)"));
        m_window->trigger("view.overlayLobes");
        const auto& shapes = *m_window->panel->radios().inScene().shapes;
        QCOMPARE(shapes.size(), std::size_t(2));
        QCOMPARE(shapes[1].body, std::size_t(2));
        const Vec3 ahead = (*m_window->panel->world().poses())[2] * shapes[1].mounting * Vec3(0.1, 0, 0);
        QVERIFY((ahead - Vec3(0, 0.05 - 0.1, 0.15)).norm() < 1e-9);
    }

    void ofWhatIsSelectedOrOfAll() {
        QVERIFY(m_window->open(kMote + "Robot a { Config=Mote }\nGrid g { Config=Mote Count=2 Spacing=1 Pos=3,0,0 }\n"));
        m_window->trigger("view.overlayLobes");
        const auto count = [this] { return m_window->panel->radios().inScene().shapes->size(); };
        QCOMPARE(count(), std::size_t(3));
        m_window->selection.select("g");
        QCOMPARE(count(), std::size_t(2));
        m_window->selection.select("a.radio");
        QCOMPARE(count(), std::size_t(1));
        m_window->selection.select("floor"); // has no antenna
        QCOMPARE(count(), std::size_t(3));
        m_window->panel->world().setHidden({"a"});
        QCOMPARE(count(), std::size_t(2));
    }

    // --- links ---

    void linksAreThoseOfTheBudget() {
        // Chosen margins by Friis: 1, 6 and 14 dB from a; d is out of reach, e uses another channel, f has a low sensitivity.
        QByteArray text = kMote + "Robot a { Config=Mote }\n";
        const auto far = [](double margin) { return std::pow(10, (friis(1) + 50 - margin) / 20); };
        const auto add = [&](const char* name, double x, double y, const char* more = "") {
            text += QByteArray("Robot ") + name + " { Config=Mote Pos=" + QByteArray::number(x, 'f', 9) + "," +
                    QByteArray::number(y, 'f', 9) + ",0 " + more + " }\n";
        };
        add("b", far(1), 0);
        add("c", 0, far(6));
        add("e", 0.2, 0.2, "radio.Channel=11");
        add("f", -far(14), 0, "radio.MinReceivePower=-30");
        add("d", 50, 50);
        QVERIFY(m_window->open(text));
        const RadioPoses places = placesOf(*m_window);
        const RadioLinks all = linksOf(places, {});
        const auto of = [&](std::size_t from, std::size_t to) {
            const auto it = std::ranges::find_if(all.links, [&](const RadioLink& l) { return l.from == from && l.to == to; });
            return it == all.links.end() ? nullptr : &*it;
        };
        QVERIFY(of(0, 1) && std::abs(of(0, 1)->margin - 1) < 0.01 && !of(0, 1)->oneWay);
        QVERIFY(of(0, 2) && std::abs(of(0, 2)->margin - 6) < 0.01 && !of(0, 2)->oneWay);
        QVERIFY(of(4, 0) && std::abs(of(4, 0)->margin - 14) < 0.01 && of(4, 0)->oneWay); // f is received, but does not receive
        for (const RadioLink& link : all.links) {
            QVERIFY(link.from != 3 && link.to != 3 && link.from != 5 && link.to != 5);
            // The same as the link budget.
            const RadioNodes radios = radiosAt(places);
            const double there = radios.link(RadioId(link.from), RadioId(link.to), 0).margin,
                         back = radios.link(RadioId(link.to), RadioId(link.from), 0).margin;
            QCOMPARE(link.margin, link.oneWay ? there : std::min(there, back));
        }
        QVERIFY(std::ranges::is_sorted(all.links, std::greater(), &RadioLink::margin));
        QCOMPARE(linksOf(places, {false, true, false, false, false, false}).links.size(), std::size_t(1));
        QVERIFY(marginColour(1) != marginColour(6) && marginColour(6) != marginColour(14) &&
                marginColour(14) == marginColour(50));
    }

    void ofManyTheStrongestAreDrawn() {
        QVERIFY(m_window->open(kMote + "Grid g { Config=Mote Count=8,5 Spacing=0.1 }\n"));
        const RadioLinks links = linksOf(placesOf(*m_window), {});
        QCOMPARE(links.links.size(), kMaxLinks);
        QCOMPARE(links.reaching, std::size_t(40 * 39 / 2));
        QCOMPARE(links.nearest, std::size_t(0));
        QVERIFY(m_window->open(kMote + "Grid g { Config=Mote Count=20,20 Spacing=0.1 }\n"));
        const RadioLinks many = linksOf(placesOf(*m_window), {});
        QCOMPARE(many.nearest, std::size_t(100));
        QVERIFY(many.reaching >= 400 * 100 / 2 && many.reaching <= 2 * kMaxLinkPairs);
        QVERIFY(std::abs(many.links.front().margin - (friis(0.1) + 50)) < 0.01);
    }

    void linksAreDrawnAndFollow() {
        QVERIFY(m_window->open(kMote + "Robot a { Config=Mote Pos=-0.4,0,0 }\nRobot b { Config=Mote Pos=0.4,0,0 }\n"));
        m_window->look({0, -1.5, 1.5}, {0, 0, 0.1});
        EVENTUALLY(m_window->panel->isSettled());
        const QPoint middle = m_window->at({0, 0, 0.1});
        QVERIFY(!shows(middle, marginColour(kSafeMargin)));
        m_window->trigger("view.overlayLinks");
        EVENTUALLY(m_window->panel->isSettled());
        QVERIFY(shows(middle, marginColour(kSafeMargin)));
        // An edit moves it: 4 dB are left.
        const double far = std::pow(10, (friis(1) + 46) / 20) - 0.4;
        const std::string place = QByteArray::number(far, 'f', 6).toStdString() + ",0,0";
        QVERIFY(m_window->document.structure().setValues(QStringLiteral("move"), {{"b.Pos", place}}).ok());
        EVENTUALLY(m_window->panel->isSettled());
        QVERIFY(shows(middle, marginColour(kSlimMargin)));
        // A run moves it out of reach.
        step();
        QVERIFY(m_window->session.robots().place("b", {Vec3(9, 0, 0), Quat::Identity()}));
        EVENTUALLY(m_window->panel->radios().links() && m_window->panel->radios().links()->links.empty());
        EVENTUALLY(m_window->panel->views().isUpToDate());
        QVERIFY(!shows(middle, marginColour(kSlimMargin)));
        m_window->trigger("view.overlayLinks");
        QVERIFY(!m_window->panel->radios().links());
    }

    // --- coverage ---

    void coverageIsFriis() {
        QVERIFY(m_window->open(kMote + "Robot a { Config=Mote Pos=0.3,-0.2,0 }\nRobot b { Config=Mote Pos=2,2,0 }\n"));
        CoverageRequest request{placesOf(*m_window), 0, {}, {-2, -2, 5, 4}, 100};
        request.receiver = typicalReceiver(request.places, 0);
        QCOMPARE(request.receiver.height, 0.1);
        QCOMPARE(request.receiver.sensitivity, -50.0);
        const auto coverage = coverageOf(request, [] { return true; });
        QVERIFY(coverage);
        QCOMPARE(coverage->columns, 100u);
        QCOMPARE(coverage->rows, 80u);
        const PowerScale scale = scaleOf(*coverage);
        const auto picture = pictureOf(*coverage, scale);
        for (const auto& [column, row] : {std::pair(0u, 0u), {99u, 0u}, {50u, 40u}, {10u, 79u}}) {
            const double x = -2 + 0.05 * (column + 0.5), y = -2 + 0.05 * (row + 0.5),
                         wanted = friis(std::hypot(x - 0.3, y + 0.2));
            QVERIFY(std::abs(coverage->at(x, y) - wanted) < 0.01);
            const std::size_t pixel = 4 * (std::size_t(row) * 100 + column);
            const Rgb shown{picture->pixels[pixel], picture->pixels[pixel + 1], picture->pixels[pixel + 2]};
            const double stepped = 0.5 * std::round(wanted / 0.5);
            if (wanted < -50) QVERIFY(shown[0] == 52 && shown[1] == 54 && shown[2] == 60);
            else QCOMPARE(shown, heatColour((stepped - scale.low) / (scale.high - scale.low)));
        }
        QVERIFY(std::isnan(coverage->at(-2.1, 0)) && std::isnan(coverage->at(0, 2.1)));
        QVERIFY(!coverageOf(request, [rows = 0]() mutable { return rows++ < 3; })); // cancelled after three rows
    }

    void coverageIsThatOfTheMedium_data() {
        QTest::addColumn<QByteArray>("medium");
        QTest::newRow("two rays") << QByteArray("Model=two_ray");
        QTest::newRow("log-distance") << QByteArray("Model=log_distance Exponent=3");
        QTest::newRow("walls") << QByteArray("WallLoss=7");
    }
    /// The map has the power that an isotropic mote receives by the link budget at the same position.
    void coverageIsThatOfTheMedium() {
        QFETCH(QByteArray, medium);
        QVERIFY(m_window->open(kMote + "RadioMedium air { " + medium + R"( }
StaticConfig Wall { Box b { Size=0.1,2,1 Pos=1,0,0.5 Material=concrete Surface=ground } }
Static wall { Config=Wall }
Robot a { Config=Mote HPR=20,10,0 radio.Antenna=beam }
Robot open { Config=Mote Pos=0.5,0.5,0 }
Robot behind { Config=Mote Pos=2,0.3,0 }
)"));
        CoverageRequest request{placesOf(*m_window), 0, {0.1, -94}, {}, 1};
        const RadioNodes radios = radiosAt(request.places);
        for (const RadioId to : {1u, 2u}) {
            const Vec3 at = radios.antenna(to).pose.position;
            request.ground = {at.x() - 0.01, at.y() - 0.01, 0.02, 0.02}; // one cell, with the mote at its centre
            const auto coverage = coverageOf(request, [] { return true; });
            QVERIFY(std::abs(coverage->power[0] - radios.link(0, to, 0).link.power) < 1e-4);
        }
        QCOMPARE(radios.link(0, 2, 0).link.wallLoss, medium.contains("Wall") ? 7.0 : 0.0);
    }

    void reusesGroundWhileObjectsMove() {
        Bounds bounds;
        bounds.add(Vec3(-3.2, -1, 0));
        bounds.add(Vec3(4.1, 2, 0.5));
        const Ground ground = groundAround(bounds);
        QVERIFY(ground.x < -3.7 && ground.x + ground.width > 4.6 && ground.y < -1.5 && ground.y + ground.depth > 2.5);
        bounds.add(Vec3(4.3, 0, 0));
        QCOMPARE(groundAround(bounds, ground), ground);
        bounds.add(Vec3(9, 0, 0));
        const Ground wider = groundAround(bounds, ground);
        QVERIFY(wider.x <= ground.x && wider.x + wider.width > 9);
        QVERIFY(groundAround(Bounds()).empty());
    }

    void coverageLiesOnTheFloor() {
        QVERIFY(m_window->open(kMote + "Robot a { Config=Mote }\nRobot b { Config=Mote Pos=2,0,0 }\n"));
        m_window->look({0.5, -2.5, 2.5}, {0.5, 0, 0});
        EVENTUALLY(m_window->panel->isSettled());
        const QImage bare = m_window->view().image().picture();
        m_window->trigger("view.overlayCoverage");
        EVENTUALLY(m_window->panel->isSettled());
        const RadioOverlays& radios = m_window->panel->radios();
        QCOMPARE(radios.coverage()->coverage.transmitter, std::string("a/radio"));
        QVERIFY(differs(bare, {0.6, 0.3, 0}));
        QVERIFY(differs(bare, {0.6, -0.3, 0}));
        QVERIFY(!differs(bare, {0, 0, 0.02})); // the mote itself is above the map
        const Ground& ground = radios.coverage()->coverage.ground;
        QVERIFY(!differs(bare, {0.5, ground.y + ground.depth + 0.2, 0}));
        // On the screen too, nearer is yellower.
        const auto red = [&](double x) { return qRed(m_window->view().image().picture().pixel(m_window->at({x, 0.15, 0}))); };
        QVERIFY(red(0.15) > red(0.7));
        m_window->selection.select("b");
        EVENTUALLY(radios.coverage()->coverage.transmitter == "b/radio" && m_window->panel->views().isUpToDate());
        m_window->selection.clear(); // the map of the radio that was selected last is kept
        EVENTUALLY(m_window->panel->isSettled());
        QCOMPARE(radios.coverage()->coverage.transmitter, std::string("b/radio"));
        m_window->trigger("view.overlayCoverage");
        QVERIFY(!radios.coverage() && !radios.inScene().floor);
        EVENTUALLY(m_window->panel->isSettled());
        QVERIFY(!differs(bare, {0.6, 0.3, 0}));
    }

    void skipsComputationWithoutMotion() {
        QVERIFY(m_window->open(kMote + "Robot a { Config=Mote }\nRobot b { Config=Mote Pos=2,0,0 }\n"));
        m_window->trigger("view.overlayCoverage");
        m_window->trigger("view.overlayLinks");
        step();
        EVENTUALLY(!m_window->panel->radios().isComputing());
        const int before = m_window->panel->radios().requests();
        m_window->session.runFor(0.3);
        EVENTUALLY(m_window->session.results().time() > 0.29 && m_window->session.state() == RunState::Paused);
        QCOMPARE(m_window->panel->radios().requests(), before);
        QVERIFY(m_window->session.robots().place("b", {Vec3(1, 0, 0), Quat::Identity()})); // b is not the sender
        EVENTUALLY_EQUAL(m_window->panel->radios().requests(), before + 1);
    }

    void workerSkipsObsoleteRequests() {
        QVERIFY(m_window->open(kMote + "RadioMedium air { WallLoss=4 }\nRobot a { Config=Mote }\n"));
        CoverageRequest request{placesOf(*m_window), 0, {}, {-2, -2, 4, 4}, 192};
        std::atomic<int> coarse = 0, fine = 0, givenUp = 0;
        RadioWorker* forgetful = nullptr;
        QThread* caller = nullptr;
        RadioWorker::Answers answers;
        answers.links = [](std::uint64_t, const RadioLinks&) {};
        answers.coverage = [&](std::uint64_t, const CoverageMap& map, bool last) {
            caller = QThread::currentThread();
            ++(last ? fine : coarse);
            if (!last && map.coverage.columns < 192) forgetful->forget();
        };
        answers.coverageGivenUp = [&](std::uint64_t) { ++givenUp; };
        RadioWorker worker(answers);
        forgetful = &worker;
        worker.requestCoverage(1, request);
        EVENTUALLY_EQUAL(givenUp.load(), 1);
        QCOMPARE(coarse.load(), 1);
        QCOMPARE(fine.load(), 0);
        QVERIFY(caller != QThread::currentThread());
    }

    void anotherTextEndsTheMapOfTheLast() {
        // Many obstacles, so that the fine map takes long to compute.
        QVERIFY(m_window->open(kMote + "RadioMedium air { WallLoss=0.001 }\nRobot a { Config=Mote }\n"
                                       "Grid others { Config=Mote Count=14,14 Spacing=0.4 Pos=0,0,-1 radio.Channel=11 }\n"));
        RadioOverlays& radios = m_window->panel->radios();
        bool edited = false;
        connect(&radios, &RadioOverlays::sceneChanged, m_window->panel.get(), [&] {
            // The coarse map is shown while the fine one is computed.
            if (edited || !radios.isComputing() || !radios.coverage()) return;
            edited = true;
            QVERIFY(m_window->document.structure().setValues(QStringLiteral("move"), {{"a.Pos", "1,0,0"}}).ok());
        });
        m_window->trigger("view.overlayCoverage");
        EVENTUALLY(edited);
        EVENTUALLY_EQUAL(radios.coveragesGivenUp(), 1);
        EVENTUALLY(!radios.isComputing());
        const Coverage& now = radios.coverage()->coverage;
        QVERIFY(std::max(now.columns, now.rows) == 192u);
        // The power is highest around its current position.
        QVERIFY(now.at(1.02, 0.02) > now.at(0.02, 0.02) + 6);
    }

    // --- all overlays ---

    void disabledOverlayComputesNothing() {
        QVERIFY(m_window->open(kMote + "Robot a { Config=Mote }\nRobot b { Config=Mote Pos=1,0,0 }\n"));
        m_window->look({0.5, -2, 2}, {0.5, 0, 0});
        EVENTUALLY(m_window->panel->isSettled());
        const RadioOverlays& radios = m_window->panel->radios();
        const QImage before = m_window->view().grab().toImage();
        QCOMPARE(radios.requests(), 0);
        QVERIFY(radios.nodes().empty() && !radios.inScene().shapes && !radios.inScene().floor);
        for (const char* id : {"view.overlayLobes", "view.overlayLinks", "view.overlayCoverage"}) {
            m_window->trigger(id);
            EVENTUALLY(m_window->panel->isSettled());
            QVERIFY2(m_window->view().grab().toImage() != before, id);
            m_window->trigger(id);
            EVENTUALLY(m_window->panel->isSettled());
            QCOMPARE(m_window->view().grab().toImage(), before);
        }
    }

    void runIsUnaffectedByViews() {
        const QByteArray text =
            kMote + "RadioMedium air { Model=log_distance Shadowing=4 }\nRobot a { Config=Mote Pos=0,0,0.3 HPR=0,20,0 "
                    "}\nRobot b { Config=Mote Pos=1,0,0 }\n";
        std::vector<std::uint64_t> hashes;
        for (const bool looked : {false, true}) {
            m_window = std::make_unique<ViewWindow>(m_render.get());
            QVERIFY(m_window->open(text));
            if (looked)
                for (const char* id : {"view.overlayLobes", "view.overlayLinks", "view.overlayCoverage"}) m_window->trigger(id);
            m_window->session.runFor(0.5);
            EVENTUALLY(m_window->session.state() == RunState::Paused && m_window->session.results().time() > 0.49);
            EVENTUALLY(m_window->session.results().snapshot->hash);
            hashes.push_back(*m_window->session.results().snapshot->hash);
        }
        QCOMPARE(hashes[0], hashes[1]);
    }

private:
    void step() {
        m_window->session.step();
        EVENTUALLY_EQUAL(m_window->session.state(), RunState::Paused);
    }
    /// True if a point in the world has another colour than before.
    bool differs(const QImage& before, const Vec3& place) {
        const QPoint at = m_window->at(place);
        return distance(before.pixelColor(at), m_window->view().image().picture().pixelColor(at)) > 24;
    }
    /// True if a colour is drawn on a pixel or next to it.
    bool shows(const QPoint& at, const Rgb& colour) {
        const QImage image = m_window->view().grab().toImage();
        for (int y = -2; y <= 2; ++y)
            for (int x = -2; x <= 2; ++x)
                if (distance(image.pixelColor(at + QPoint(x, y)), QColor(colour[0], colour[1], colour[2])) < 40) return true;
        return false;
    }
    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;
};

QTEST_MAIN(RadiosTest)
#include "radios_test.moc"
