// The commands of Edit, Parts: what they write, how they are undone, and what is refused.

#include <set>

#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QtTest>

#include "editor/document/structure_edits.h"
#include "editor/shell/window_fixture.h"
#include "eventually.h"

using namespace trundle;

namespace {

const std::string kHead = R"(Tick = 0.01
Material red { ColorRGB=1,0,0 }
Surface rubber { Friction=1 }

)";
const std::string kConfig = R"(RobotConfig Kit {
  Body chassis { Box hull { Size=0.3,0.2,0.1 Mass=2 Material=red Surface=rubber } }
  Body leftWheel {
    Pos=0,0.12,0
    Cylinder tyre { Pos=0.01,0,0.01 Radius=0.05 Length=0.02 Mass=0.1 Material=red Surface=rubber }
  }
  Hinge leftAxle { Parent=chassis Child=leftWheel Axis=0,1,0 }
}

Robot robot0 { Config=Kit }
)";

} // namespace

class PartsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_fixture.start(); }
    void init() {
        QSettings().clear();
        open(kHead + kConfig);
    }
    void cleanup() { m_window.reset(); }

    void makesAPart() {
        m_window->selection().set({"robot0.leftWheel", "robot0.leftAxle"});
        trigger("parts.make");
        const std::string made = text();
        QVERIFY2(made.starts_with(kHead + "PartConfig Left {\n"), made.c_str());
        QVERIFY2(made.find("\n  Part left { Config=Left Pos=0,0.12,0 chassis=chassis }\n") != std::string::npos, made.c_str());
        QVERIFY(!document().loaded()->diagnostics.hasErrors());
        QCOMPARE(m_window->selection().current(), std::string("robot0.left"));
        checkUndo(QStringLiteral("Make Part of 2 objects"));
    }

    void mirrors_data() {
        QTest::addColumn<QByteArray>("action");
        QTest::addColumn<std::string>("part");
        QTest::newRow("left to right") << QByteArray("parts.mirrorY")
                                       << std::string("Part right { Config=Left Pos=0,-0.12,0 chassis=chassis Mirror=y }");
        QTest::newRow("front to back") << QByteArray("parts.mirrorX")
                                       << std::string("Part right { Config=Left Pos=0,0.12,0 chassis=chassis Mirror=x }");
        QTest::newRow("up and down") << QByteArray("parts.mirrorZ")
                                     << std::string("Part right { Config=Left Pos=0,0.12,0 chassis=chassis Mirror=z }");
    }
    void mirrors() {
        QFETCH(QByteArray, action);
        QFETCH(std::string, part);
        m_window->selection().set({"robot0.leftWheel", "robot0.leftAxle"});
        trigger(action);
        QVERIFY2(text().find("\n  " + part + "\n") != std::string::npos, text().c_str());
        QVERIFY(!document().loaded()->diagnostics.hasErrors());
        QCOMPARE(document().loaded()->experiment->robots.at(0).config->bodies.size(), 3u);
        checkUndo(QStringLiteral("Mirror 2 objects"));
    }

    void repeats() {
        m_window->selection().set({"robot0.leftWheel", "robot0.leftAxle"});
        trigger("parts.repeat");
        auto* dialog = m_window->findChild<QDialog*>(QStringLiteral("repeatDialog"));
        QVERIFY(dialog && dialog->isVisible());
        dialog->findChild<QSpinBox*>(QStringLiteral("repeatCount"))->setValue(3);
        for (const auto& [axis, step] : {std::pair{"X", -0.11}, std::pair{"Y", 0.0}, std::pair{"Z", 0.0}})
            typeInto(*dialog, "repeatStep" + QByteArray(axis), QString::number(step));
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        EVENTUALLY(text() != kHead + kConfig);
        QVERIFY2(text().find("Count=3") != std::string::npos, text().c_str());
        QVERIFY(!document().loaded()->diagnostics.hasErrors());
        const auto& bodies = document().loaded()->experiment->robots.at(0).config->bodies;
        QCOMPARE(bodies.size(), 4u);
        QVERIFY(std::abs(bodies[3].pose.position.x() - -0.22) < 1e-12);
        checkUndo(QStringLiteral("Repeat 2 objects"));
    }

    /// As in property rows. What is no length cannot be accepted. The count can be typed at once.
    void takesLengthsWithUnits() {
        m_window->selection().set({"robot0.leftWheel", "robot0.leftAxle"});
        trigger("parts.repeat");
        auto* dialog = m_window->findChild<QDialog*>(QStringLiteral("repeatDialog"));
        QVERIFY(dialog && dialog->focusWidget());
        QTest::keyClicks(dialog->focusWidget(), QStringLiteral("3"));
        QCOMPARE(dialog->findChild<QSpinBox*>(QStringLiteral("repeatCount"))->value(), 3);
        const QPushButton* repeat = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        typeInto(*dialog, "repeatStepX", QStringLiteral("7 kg"));
        QVERIFY(!repeat->isEnabled());
        typeInto(*dialog, "repeatStepY", QStringLiteral("0"));
        QLineEdit* field = typeInto(*dialog, "repeatStepX", QStringLiteral("-7 cm"));
        QVERIFY(repeat->isEnabled());
        QTest::keyClick(field, Qt::Key_Return);
        EVENTUALLY(text() != kHead + kConfig);
        const auto& bodies = document().loaded()->experiment->robots.at(0).config->bodies;
        QCOMPARE(bodies.size(), 4u);
        QVERIFY(std::abs(bodies[3].pose.position.x() - -0.14) < 1e-12);
    }

    /// Geoms of a body become members of a Repeat in the body.
    void repeatsGeoms() {
        m_window->selection().select("robot0.chassis.hull");
        trigger("parts.repeat");
        auto* dialog = m_window->findChild<QDialog*>(QStringLiteral("repeatDialog"));
        QVERIFY(dialog && dialog->isVisible());
        dialog->findChild<QSpinBox*>(QStringLiteral("repeatCount"))->setValue(3);
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        EVENTUALLY(text() != kHead + kConfig);
        QVERIFY(!document().loaded()->diagnostics.hasErrors());
        QVERIFY(document().loaded()->experiment->robots.at(0).config->bodies[0].geoms.size() >= 3u);
        checkUndo(QStringLiteral("Repeat hull"));
    }

    /// A Ring of RangeSensors around the chassis, as one entry of the history.
    void insertsARingOfSensors() {
        for (const char* selected : {"robot0.chassis.hull", "robot0"}) {
            m_window->selection().select(selected);
            trigger("sensors.ring");
            auto* dialog = m_window->findChild<QDialog*>(QStringLiteral("sensorRingDialog"));
            QVERIFY(dialog && dialog->isVisible());
            dialog->findChild<QSpinBox*>(QStringLiteral("ringCount"))->setValue(6);
            typeInto(*dialog, "ringRadius", QStringLiteral("25 cm"));
            QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
            EVENTUALLY(text() != kHead + kConfig);
            QVERIFY2(text().find("Count=6 Radius=0.25") != std::string::npos, text().c_str());
            QVERIFY(!document().loaded()->diagnostics.hasErrors());
            QCOMPARE(document().loaded()->experiment->robots.at(0).config->devices.size(), 6u);
            QCOMPARE(document().loaded()->experiment->robots.at(0).config->devices[1].text("Body"), std::string("chassis"));
            checkUndo(QStringLiteral("Add Ring of Sensors"));
            EVENTUALLY(!m_window->findChild<QDialog*>(QStringLiteral("sensorRingDialog")));
        }
        QSignalSpy refused(&document(), &Document::refused);
        m_window->selection().clear();
        trigger("sensors.ring");
        QCOMPARE(refused.size(), 1);
    }

    /// What comes with Trundle is copied, as for all other edits.
    void copiesShippedRobots() {
        open("Tick = 0.01\n#import robots/simple_robot.sim\nRobot robot0 { Config=SimpleRobot }\n");
        m_window->selection().set({"robot0.leftWheel", "robot0.leftAxle"});
        const std::string before = text();
        trigger("parts.make");
        QVERIFY2(text().find("PartConfig Left") != std::string::npos, text().c_str());
        QVERIFY(!document().loaded()->diagnostics.hasErrors());
        document().edits().undo();
        QCOMPARE(text(), before);
    }

    void saysWhyNot_data() {
        QTest::addColumn<QString>("selected");
        QTest::newRow("nothing") << QString();
        QTest::newRow("a geom of a body") << QStringLiteral("robot0.chassis.hull");
    }
    void saysWhyNot() {
        QFETCH(QString, selected);
        if (selected.isEmpty()) m_window->selection().clear();
        else m_window->selection().select(selected.toStdString());
        QSignalSpy refused(&document(), &Document::refused);
        for (const char* id : {"parts.make", "parts.mirrorY", "parts.repeat"}) {
            if (selected.endsWith(QStringLiteral(".hull")) && id == std::string_view("parts.repeat")) continue; // geoms can be repeated
            refused.clear();
            trigger(id);
            QVERIFY2(refused.size() == 1, id);
            QVERIFY2(refused[0][0].toString().size() > 20, qPrintable(refused[0][0].toString()));
            QCOMPARE(text(), kHead + kConfig);
            QVERIFY(!m_window->findChild<QDialog*>(QStringLiteral("repeatDialog")));
        }
    }

    /// What is placed at the top level, or is only named, is no part of anything.
    void onlyPartsAreOffered() {
        const auto isOffered = [this](const std::string& path) {
            m_window->selection().set({path});
            const auto* menu = m_window->findChild<QMenu*>(QStringLiteral("menu.Edit/Parts"));
            std::set<bool> enabled;
            for (const QAction* action : menu->actions())
                if (action->objectName().startsWith(QStringLiteral("parts."))) enabled.insert(action->isEnabled());
            return enabled == std::set{true};
        };
        for (const char* path : {"robot0", "Material.red", "RobotConfig.Kit"}) QVERIFY2(!isOffered(path), path);
        for (const char* path : {"robot0.leftWheel", "RobotConfig.Kit.leftAxle", "robot0.chassis.hull"})
            QVERIFY2(isOffered(path), path);
        const auto isRepeatOffered = [&](const char* path) {
            (void)isOffered(path);
            for (const QAction* action : m_window->findChild<QMenu*>(QStringLiteral("menu.Edit/Parts"))->actions())
                if (action->objectName() == QStringLiteral("parts.repeat")) return action->isEnabled();
            return false;
        };
        for (const char* path : {"Material.red", "RobotConfig.Kit"}) QVERIFY2(!isRepeatOffered(path), path);
        for (const char* path : {"robot0", "robot0.leftWheel", "robot0.chassis.hull"}) QVERIFY2(isRepeatOffered(path), path);
        m_window->selection().set({"robot0", "robot0.leftWheel"});
        m_window->selection().clear();
        QSignalSpy refused(&document(), &Document::refused);
        trigger("parts.make"); // says what to select
        QCOMPARE(refused.size(), 1);
    }

    /// A PartConfig is shown in the first model that has a Part of it.
    void ctrlEOnAPartConfigShowsAPart() {
        open(kHead + "PartConfig Wheel { Body wheel { Box w { Size=0.1,0.1,0.1 Mass=1 } } }\n"
                     "PartConfig Spare { Body wheel { Box w { Size=0.1,0.1,0.1 Mass=1 } } }\n"
                     "RobotConfig Other { Body b { Box hull { Size=0.3,0.2,0.1 Mass=2 } } }\n"
                     "RobotConfig Kit { Body b { Box hull { Size=0.3,0.2,0.1 Mass=2 } } Part left { Config=Wheel Pos=0,1,0 } }\n"
                     "Robot one { Config=Kit }\n");
        QAction* edit = nullptr;
        for (QAction* action : m_window->findChild<QMenu*>(QStringLiteral("menu.Edit"))->actions())
            if (action->objectName() == QStringLiteral("model.edit")) edit = action;
        QVERIFY(edit);
        for (const char* selected : {"PartConfig.Wheel", "PartConfig.Wheel.wheel.w"}) {
            m_window->selection().select(selected);
            edit->trigger();
            QCOMPARE(document().editedModel().path(), std::string("RobotConfig.Kit"));
            QCOMPARE(m_window->selection().current(), std::string("RobotConfig.Kit.left"));
            edit->trigger();
            QVERIFY(!document().editedModel().isOpen());
        }
        m_window->selection().select("PartConfig.Spare");
        edit->trigger();
        QVERIFY(!document().editedModel().isOpen() && !edit->isChecked());
        QVERIFY(m_window->statusBar()->currentMessage().startsWith(QStringLiteral("No robot or scenery has a Part of Spare")));
    }

    /// What is selected in a Part, or in a Part of that, is selected in the model too.
    void ctrlEKeepsTheNestedPart_data() {
        QTest::addColumn<std::string>("selected");
        QTest::addColumn<std::string>("inModel");
        QTest::newRow("a Part") << std::string("one.right") << std::string("RobotConfig.Kit.right");
        QTest::newRow("a Part of a Part") << std::string("one.right.back") << std::string("RobotConfig.Kit.right.back");
        QTest::newRow("inside") << std::string("one.right.back.wheel.w") << std::string("RobotConfig.Kit.right.back.wheel.w");
        QTest::newRow("in the config") << std::string("RobotConfig.Kit.right.back") << std::string("RobotConfig.Kit.right.back");
        QTest::newRow("in a PartConfig") << std::string("PartConfig.Side.back") << std::string("RobotConfig.Kit.left.back");
        QTest::newRow("inside, in a PartConfig")
            << std::string("PartConfig.Side.back.wheel.w") << std::string("RobotConfig.Kit.left.back");
        QTest::newRow("a nested PartConfig") << std::string("PartConfig.Wheel") << std::string("RobotConfig.Kit.left.front");
        QTest::newRow("a body") << std::string("one.b") << std::string("RobotConfig.Kit.b");
        QTest::newRow("the robot") << std::string("one") << std::string("RobotConfig.Kit");
    }
    void ctrlEKeepsTheNestedPart() {
        QFETCH(std::string, selected);
        QFETCH(std::string, inModel);
        open(kHead + "PartConfig Wheel { Body wheel { Box w { Size=0.1,0.1,0.1 Mass=1 } } }\n"
                     "PartConfig Side { Part front { Config=Wheel Pos=0.2,0,0 } Part back { Config=Wheel Pos=-0.2,0,0 } }\n"
                     "RobotConfig Kit { Body b { Box hull { Size=0.3,0.2,0.1 Mass=2 } }\n"
                     "  Part left { Config=Side Pos=0,1,0 }\n  Part right { Config=Side Pos=0,-1,0 } }\n"
                     "Robot one { Config=Kit }\n");
        m_window->selection().select(selected);
        for (QAction* action : m_window->findChild<QMenu*>(QStringLiteral("menu.Edit"))->actions())
            if (action->objectName() == QStringLiteral("model.edit")) action->trigger();
        QCOMPARE(document().editedModel().path(), std::string("RobotConfig.Kit"));
        QCOMPARE(m_window->selection().current(), inModel);
    }

    /// Messages of the core are parts of sentences; names keep their letters.
    void refusalsAreSentences() {
        for (const auto& [reason, shown] :
             {std::pair{"there is no arm", "There is no arm"}, std::pair{"chassis is needed", "chassis is needed"},
              std::pair{"robot0.leftWheel is locked", "robot0.leftWheel is locked"}, std::pair{"x", "X"}}) {
            Q_EMIT document().refused(QLatin1String(reason));
            QCOMPARE(m_window->statusBar()->currentMessage(), QLatin1String(shown));
        }
    }

    /// The question says that it is a value. A copy is preselected, as for blocks: it leaves the other robot as it is.
    void pushingAValueAsks() {
        open(kHead + "RobotConfig Kit { Body b { Box hull { Size=0.3,0.2,0.1 Mass=2 } } }\n"
                     "Robot one { Config=Kit b.hull.Mass=3 }\nRobot two { Config=Kit Pos=1,0,0 }\n");
        QVERIFY(document().structure().pushOverride(QStringLiteral("Push"), "one.b.hull.Mass"));
        auto* question = m_window->findChild<QMessageBox*>(QStringLiteral("shareQuestion"));
        QVERIFY(question);
        QCOMPARE(question->text(), QStringLiteral("This changes the value of Mass in Kit, which is defined in mine.sim."));
        QCOMPARE(question->defaultButton()->objectName(), QStringLiteral("makeCopy"));
        question->findChild<QPushButton*>(QStringLiteral("changeForAll"))->click();
        EVENTUALLY(text().find("Mass=3 } } }") != std::string::npos);
        QVERIFY2(text().find("Kit2") == std::string::npos, text().c_str());
    }

private:
    Document& document() { return m_window->document(); }
    std::string text() { return *document().texts().text(document().path()); }
    void open(const std::string& text) {
        m_folder = std::make_unique<QTemporaryDir>();
        const QString path = m_folder->filePath(QStringLiteral("mine.sim"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text.c_str());
        file.close();
        m_window = m_fixture.window();
        m_window->show();
        QVERIFY(m_window->open(path));
        EVENTUALLY(document().isOpen());
        QVERIFY(!document().loaded()->diagnostics.hasErrors());
    }
    void trigger(const QByteArray& id) {
        for (const auto* name : {"menu.Edit/Parts", "menu.Insert"}) {
            auto* menu = m_window->findChild<QMenu*>(QLatin1String(name));
            QVERIFY(menu);
            for (QAction* action : menu->actions())
                if (action->objectName() == QLatin1String(id)) return action->trigger();
        }
        QFAIL(id.constData());
    }
    static QLineEdit* typeInto(QDialog& dialog, const QByteArray& length, const QString& typed) {
        auto* field = dialog.findChild<QWidget*>(QLatin1String(length))->findChild<QLineEdit*>();
        field->selectAll();
        QTest::keyClicks(field, typed);
        return field;
    }
    void checkUndo(const QString& name) {
        const History& history = document().edits().history();
        QCOMPARE(history.position(), 1u);
        QCOMPARE(history.entries()[0].name, name);
        document().edits().undo();
        QCOMPARE(text(), kHead + kConfig);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    WindowFixture m_fixture;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(PartsTest)
#include "parts_test.moc"
