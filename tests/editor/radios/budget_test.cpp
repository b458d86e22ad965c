// The link budget of the Radio dock agrees with received frames, with the links of the run, and with theory.

#include <QComboBox>
#include <QLabel>
#include <QSpinBox>
#include <QTabBar>
#include <QToolButton>

#include "editor/document/structure_edits.h"
#include "editor/radios/level_diagram.h"
#include "editor/radios/packet_text.h"
#include "editor/radios/radio_window.h"
#include "editor/widgets/painted_text.h"
#include "eventually.h"

using namespace trundle;

namespace {

double sumOf(const LinkReport& r) {
    return r.outputPower + r.link.sendGain + r.link.receiveGain - r.link.pathLoss - r.link.shadow - r.link.wallLoss;
}

/// A box between two of the radios.
const QByteArray kWall = R"(
StaticConfig Slab { Box slab { Size=0.1,1,1 Pos=0,0,0.5 } Box post { Size=0.1,0.1,1 Pos=0.3,0,0.5 Collide=false } }
Static slab { Config=Slab Pos=2,0,0 }
)";

} // namespace

class RadioBudgetTest : public QObject {
    Q_OBJECT

    std::unique_ptr<RadioWindow> m_window;
    BudgetPage& budget() { return m_window->panel.budget(); }
    const LinkReport& report() { return *budget().report(); }
    void choose(const std::vector<std::string>& paths) {
        m_window->selection.set(paths);
        QVERIFY(m_window->settled());
    }

private Q_SLOTS:
    void init() {
        m_window = std::make_unique<RadioWindow>();
        m_window->panel.showPage(RadiosPanel::Budget);
    }
    void cleanup() { m_window.reset(); }

    void choosingTwoMotesFillsIt() {
        QVERIFY(m_window->open(kMotes));
        QVERIFY(m_window->settled());
        QVERIFY(budget().report().has_value());
        choose({"motes_2", "target.board.batteries"});
        QCOMPARE(budget().from(), QStringLiteral("motes_2/radio"));
        QCOMPARE(budget().to(), QStringLiteral("target/radio"));
        choose({"floor"}); // not a radio: the choice stays
        QCOMPARE(budget().from(), QStringLiteral("motes_2/radio"));
        // A choice made by hand stays after edits, until two other radios are selected.
        auto* to = m_window->find<QComboBox>("budgetTo");
        to->setFocus();
        QTest::keyClicks(to, QStringLiteral("deaf"));
        QVERIFY(m_window->document.structure().setValues(QStringLiteral("Move"), {{"deaf.Pos", "0, 4, 0"}}).ok());
        QVERIFY(m_window->settled());
        QCOMPARE(budget().to(), QStringLiteral("deaf/radio"));
        m_window->document.edits().undo();
        QVERIFY(m_window->settled());
        choose({"motes_2", "target"});
        QVERIFY(std::abs(report().link.distance - (m_window->headless(0).runner->world().medium()->link(3, 0).distance)) < 1e-9);
    }

    /// Radios in Parts, also of robots in a Repeat; of another part of a robot its first radio.
    void choosesRadiosInParts() {
        QVERIFY(m_window->open(R"(Tick = 0.01
PartConfig Mast { Body pole { Box b { Size=0.1,0.1,0.4 Mass=1 } } Transceiver radio { Body=pole Antenna=isotropic } }
RobotConfig Twin {
  Body base { Box b { Size=0.4,0.4,0.1 Mass=2 } }
  Part left { Config=Mast Pos=0,0.1,0.25 }
  Part right { Config=Mast Pos=0,-0.1,0.25 }
  Fixed l { Parent=base Child=left.pole }
  Fixed r { Parent=base Child=right.pole }
}
Robot a { Config=Twin }
Robot b { Config=Twin Pos=3,0,0 }
Repeat row { Count=2 Robot cart { Config=Twin Pos=$(3*index),5,0 } }
)"));
        QVERIFY(m_window->settled());
        const auto chosen = [&](const std::vector<std::string>& paths) {
            choose(paths);
            return budget().from() + u' ' + budget().to();
        };
        QCOMPARE(chosen({"a.right.radio", "b.left.radio"}), QStringLiteral("a/right.radio b/left.radio"));
        QCOMPARE(chosen({"b.right", "a.base"}), QStringLiteral("b/right.radio a/left.radio"));
        QCOMPARE(chosen({"row_1.cart.right.radio", "row_0.cart.base.b"}),
                 QStringLiteral("row_1.cart/right.radio row_0.cart/left.radio"));
    }

    void budgetMatchesPacketsOfRun_data() {
        QTest::addColumn<QByteArray>("medium");
        QTest::newRow("ideal") << QByteArray("Model=ideal");
        QTest::newRow("two rays") << QByteArray("Model=two_ray");
        QTest::newRow("all of it") << QByteArray(
            "Model=log_distance Exponent=2.7 Shadowing=4 WallLoss=6 Offsets=1.5 NoiseFloor=-90");
    }
    void budgetMatchesPacketsOfRun() {
        QFETCH(QByteArray, medium);
        QVERIFY(m_window->open(QByteArray(kMotes).replace("Collisions=true", medium) + kWall));
        QVERIFY(m_window->runTo(100));
        const PacketModel& model = m_window->model();
        QVERIFY(model.rowCount() > 100);
        QSet<QString> pairs;
        bool walled = false;
        for (int row = 0; row < model.rowCount(); ++row) {
            const FrameRecord& r = model.record(row);
            const QString from = QString::fromStdString(model.radios()[r.from].path),
                          to = QString::fromStdString(model.radios()[r.to].path);
            if (pairs.contains(from + to)) continue;
            pairs << from + to;
            budget().choose(from, to, r.outputPower);
            const QByteArray who = (from + u' ' + to).toUtf8();
            QVERIFY2(std::abs(report().outputPower - r.outputPower) < 1e-9, who);
            QVERIFY2(std::abs(report().link.power - r.link.power) < 0.01, who); // the motes settled by some micrometres meanwhile
            QVERIFY2(std::abs(sumOf(report()) - report().link.power) < 1e-9, who);
            QVERIFY2(std::abs(report().rssi - r.rssi) <= 1 &&
                         (report().rssi == r.rssi || std::abs(std::remainder(report().link.power, 1)) > 0.48),
                     who);
            QVERIFY2(std::abs(report().link.wallLoss - r.link.wallLoss) < 1e-9, who);
            QVERIFY2((report().margin < 0) == (r.outcome == ReceptionOutcome::TooWeak), who);
            walled = walled || r.link.wallLoss > 0;
            // The label shows the same value.
            const QString shown = m_window->find<QLabel>("budgetTerm6")->text();
            QCOMPARE(shown, QStringLiteral("%1 dBm").arg(report().link.power, 0, 'f', 1));
            // So do those of the other terms, and a negative margin is put into words.
            const LinkReport& l = report();
            for (const auto& [term, value] : {std::pair(0, l.outputPower),
                                              {1, l.link.sendGain},
                                              {2, l.link.pathLoss},
                                              {3, l.link.shadow},
                                              {4, l.link.wallLoss},
                                              {5, l.link.receiveGain},
                                              {10, l.snr},
                                              {12, l.margin}}) {
                const QString text = m_window->find<QLabel>(qPrintable(QStringLiteral("budgetTerm%1").arg(term)))->text();
                QVERIFY2(std::abs(text.section(QLatin1Char(' '), 0, 0).toDouble() - value) < 0.051, qPrintable(text));
            }
            const auto labels = m_window->panel.findChildren<QLabel*>();
            QCOMPARE(std::ranges::any_of(labels, [](QLabel* l) { return l->text() == QStringLiteral("receives nothing"); }),
                     l.margin < 0);
        }
        QVERIFY(pairs.size() > 40);
        QCOMPARE(walled, medium.contains("WallLoss"));
    }

    void beforeARunItIsThatOfTheStart() {
        QVERIFY(m_window->open(QByteArray(kMotes).replace("Collisions=true", "WallLoss=5") + kWall));
        QVERIFY(m_window->settled());
        const auto run = m_window->headless(0);
        const Medium& medium = *run.runner->world().medium();
        for (RadioId from = 0; from < medium.radioCount(); ++from)
            for (RadioId to = 0; to < medium.radioCount(); ++to) {
                if (from == to) continue;
                budget().choose(QString::fromStdString(medium.radio(from).path), QString::fromStdString(medium.radio(to).path),
                                0.);
                const LinkBudget expected = medium.link(from, to);
                QVERIFY(std::abs(report().link.power - expected.power) < 1e-9);
                QCOMPARE(report().link.wallLoss, expected.wallLoss);
                QCOMPARE(report().margin, report().link.power + 94);
            }
        // An edit changes the budget without a run.
        budget().choose(QStringLiteral("target/radio"), QStringLiteral("deaf/radio"));
        const double before = report().link.distance;
        QVERIFY(m_window->document.structure().setValues(QStringLiteral("Move"), {{"deaf.Pos", "0, 30, 0"}}).ok());
        EVENTUALLY(std::abs(report().link.distance - before) > 20);
    }

    void budgetFollowsRun() {
        QVERIFY(m_window->open(R"(Tick = 0.01
#import robots/radio_robot.sim
#import robots/tmote_sky.sim
#import arenas/open_floor.sim
#loadModule controllers/network_navigator
Static floor { Config=OpenFloor }
Robot robot0 { Config=RadioRobot BearingSweep brain { TurnRate=0.5 } }
Robot mote { Config=TmoteSky Pos=3,0,0 }
)"));
        QVERIFY(m_window->settled());
        choose({"mote", "robot0"});
        const LinkReport start = report();
        QVERIFY(m_window->runTo(300)); // it turned by about 80 degrees
        QVERIFY(std::abs(report().link.receiveGain - start.link.receiveGain) > 3);
        QVERIFY(std::abs(report().link.sendGain - start.link.sendGain) < 3);
        const auto run = m_window->headless(300);
        const Medium& medium = *run.runner->world().medium();
        const LinkBudget expected = medium.link(*medium.find("mote/radio"), *medium.find("robot0/radio"));
        budget().setPower(0);
        QVERIFY(std::abs(report().link.power - expected.power) < 1e-6);
        m_window->session.reset();
        EVENTUALLY(std::abs(report().link.receiveGain - start.link.receiveGain) < 1e-9);
    }

    void swapPowerAndPayload() {
        QVERIFY(m_window->open(QByteArray(kMotes).replace("Collisions=true", "PacketErrors=true NoiseFloor=-80")));
        QVERIFY(m_window->settled());
        choose({"target", "motes_5"});
        const LinkReport there = report();
        QTest::mouseClick(m_window->find<QToolButton>("budgetSwap"), Qt::LeftButton);
        QCOMPARE(budget().from(), QStringLiteral("motes_5/radio"));
        QCOMPARE(report().link.power, there.link.power); // the Friis equation, exactly
        QCOMPARE(report().link.sendGain, there.link.receiveGain);

        auto* levels = m_window->find<QComboBox>("budgetLevel");
        QVERIFY(levels->isVisible());
        QCOMPARE(levels->count(), 8);
        levels->setFocus();
        QTest::keyClick(levels, Qt::Key_End);
        QCOMPARE(budget().power(), -25.);
        QVERIFY(std::abs(report().link.power - (there.link.power - 25)) < 1e-9);
        QCOMPARE(m_window->find<QLabel>("budgetTerm0")->text(), QStringLiteral("-25.0 dBm"));

        auto* payload = m_window->find<QSpinBox>("budgetPayload");
        payload->setValue(116);
        const double many = report().packetLoss;
        QVERIFY(many > 0 && many < 1);
        payload->setFocus();
        QTest::keyClick(payload, Qt::Key_Down);
        QVERIFY(report().packetLoss < many);
    }

    /// Which is not the one that the other radio would get.
    void swapKeepsThePower() {
        QVERIFY(m_window->open(kMotes));
        QVERIFY(m_window->settled());
        budget().choose(QStringLiteral("target/radio"), QStringLiteral("motes_5/radio"), -15.);
        QCOMPARE(budget().power(), -15.);
        for (const QString& from : {QStringLiteral("motes_5/radio"), QStringLiteral("target/radio")}) {
            QTest::mouseClick(m_window->find<QToolButton>("budgetSwap"), Qt::LeftButton);
            QCOMPARE(budget().from(), from);
            QVERIFY(budget().to() != from);
            QCOMPARE(budget().power(), -15.);
            QCOMPARE(report().outputPower, -15.);
        }
    }

    /// From the power sent, by one step for each term that there is, to the power received.
    void theLevelDiagramEndsAtTheReceivedPower_data() {
        QTest::addColumn<double>("shadow");
        QTest::addColumn<double>("walls");
        QTest::addColumn<QString>("names");
        QTest::newRow("in the open") << 0. << 0. << "send path receive";
        QTest::newRow("shadow") << 7. << 0. << "send path shadow receive";
        QTest::newRow("a bright place") << -7.5 << 0. << "send path shadow receive";
        QTest::newRow("walls") << 0. << 12. << "send path walls receive";
        QTest::newRow("both") << 7. << 12. << "send path shadow walls receive";
    }
    void theLevelDiagramEndsAtTheReceivedPower() {
        QFETCH(double, shadow);
        QFETCH(double, walls);
        QFETCH(QString, names);
        LinkReport r;
        r.outputPower = 3;
        r.link.sendGain = 2;
        r.link.pathLoss = 61;
        r.link.shadow = shadow;
        r.link.wallLoss = walls;
        r.link.receiveGain = -1.5;
        LevelDiagram diagram;
        diagram.resize(900, 300);
        diagram.setLevels(LevelDiagram::Levels{r, -94, -98});
        QStringList texts = paintedTexts(diagram);
        QCOMPARE(texts.takeLast(), decibelText(3 + 2 - 61 - shadow - walls - 1.5));
        QVERIFY(texts.contains(decibelText(3)));
        texts.removeIf([&](const QString& text) { return !names.contains(text); });
        QCOMPARE(texts.join(u' '), names);
    }

    void reportsOtherChannels() {
        QVERIFY(m_window->open(
            QByteArray(kMotes).replace("Robot deaf { Config=TmoteSky", "Robot deaf { Config=TmoteSky radio.Channel=11")));
        QVERIFY(m_window->settled());
        auto* words = m_window->find<QLabel>("budgetWords");
        choose({"target", "motes_0"});
        QVERIFY(!words->isVisible());
        choose({"target", "deaf"});
        QVERIFY(words->isVisible() && words->text().contains(QStringLiteral("channel 26")));
        QVERIFY(m_window->open("Tick = 0.01\n#import robots/tmote_sky.sim\nRobot alone { Config=TmoteSky }\n"));
        QVERIFY(m_window->settled());
        QVERIFY(words->text().contains(QStringLiteral("only one radio")) && !budget().report());
    }
};

QTEST_MAIN(RadioBudgetTest)
#include "budget_test.moc"
