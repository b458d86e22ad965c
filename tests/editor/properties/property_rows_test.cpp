// Which rows an object has, what they offer, and how their texts fit into a narrow panel.
#include "properties_fixture.h"

#include <QColorDialog>
#include <QMouseEvent>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>
#include <QToolButton>

using namespace trundle;

namespace {

const std::string kNested = R"(
PartConfig DrivenWheel { Body wheel { Sphere tyre { Radius=0.05 Mass=0.1 } } Hinge axle { Parent=$carrier Child=wheel Axis=0,1,0 }
  RotaryMotor motor { Joint=axle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 MaxVoltage=12 } }
PartConfig Side { Body rail { Box bar { Size=0.2,0.02,0.02 Mass=0.2 } } Fixed bolt { Parent=$hull Child=rail }
  Repeat lamp { Count=2 Body bulb { Sphere glass { Radius=0.01 Mass=0.01 } } Body cap { Sphere top { Radius=0.01 Mass=0.01 } } }
  Part front { Config=DrivenWheel Pos=0.1,0,0 carrier=rail } }
RobotConfig Kit { Body hull { Box box { Size=0.1,0.1,0.1 Mass=1 } Ring bolts { Count=3 Radius=0.1 Sphere head { Radius=0.01 Mass=0.1 } } }
  Body mast { In=hull Box pole { Size=0.1,0.1,0.1 Mass=1 } }
  Part left { Config=Side Pos=0,0.3,0 hull=hull } Part right { Config=Side Pos=0,-0.3,0 hull=hull } }
RobotConfig Tall { Config=Kit Body flag { Box cloth { Size=0.1,0.1,0.1 Mass=1 } } }
Robot rover { Config=Kit left.front.motor.Resistance=3 }
Robot tall { Config=Tall Pos=0,2,0 }
Ring fence { Count=4 Radius=3 Robot post { Config=Rover } }
)";

} // namespace

class PropertyRowsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, ThemeKind::Light); }

    /// In names a body beside the object; where there can be none, there is no such row.
    void inOffersTheBodiesBesideAnObject_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("names"); // "none": no row
        QTest::newRow("geoms of a body") << "rover.hull.bolts"
                                         << "none";
        QTest::newRow("the same in the config") << "RobotConfig.Kit.hull.bolts"
                                                << "none";
        QTest::newRow("at the top level") << "fence"
                                          << "none";
        QTest::newRow("a body")
            << "RobotConfig.Kit.mast"
            << "hull left.rail left.lamp_0.bulb left.lamp_0.cap left.front.wheel right.rail right.lamp_0.bulb "
               "right.lamp_0.cap right.front.wheel";
        QTest::newRow("a Part, without what is in it")
            << "RobotConfig.Kit.left"
            << "hull mast right.rail right.lamp_0.bulb right.lamp_0.cap right.front.wheel";
        QTest::newRow("a body in a Part") << "rover.right.rail"
                                          << "lamp_0.bulb lamp_0.cap front.wheel";
        QTest::newRow("a Part in a Part") << "rover.right.front"
                                          << "rail lamp_0.bulb lamp_0.cap";
        QTest::newRow("a Repeat in a Part") << "rover.right.lamp"
                                            << "rail front.wheel";
        QTest::newRow("in a Repeat") << "rover.right.lamp.bulb"
                                     << "cap";
        QTest::newRow("of a variant's base") << "tall.mast"
                                             << "hull left.rail left.lamp_0.bulb left.lamp_0.cap left.front.wheel right.rail "
                                                "right.lamp_0.bulb right.lamp_0.cap right.front.wheel flag";
    }
    void inOffersTheBodiesBesideAnObject() {
        QFETCH(QString, path);
        QFETCH(QString, names);
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kNested));
        QCOMPARE(fixture.document.loaded()->diagnostics.errorCount(), 0u);
        fixture.selection.select(path.toStdString());
        QVERIFY(fixture.row("Pos"));
        QCOMPARE(!fixture.row("In"), names == QStringLiteral("none"));
        if (!fixture.row("In")) return;
        const auto* pick = fixture.field<QToolButton>("In", "pick");
        Q_EMIT pick->menu()->aboutToShow();
        const std::string before = fixture.text();
        QStringList offered;
        for (const QAction* action : pick->menu()->actions()) offered << action->text();
        QCOMPARE(offered.join(QLatin1Char(' ')), names);
        pick->menu()->actions().constLast()->trigger();
        QVERIFY(fixture.text() != before);
        QCOMPARE(fixture.document.loaded()->diagnostics.errorCount(), 0u);
    }

    /// Also where the Part passes the name on to another Part. The list offers nothing from inside of the Part itself.
    void aParamOffersWhatItNames_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("row");
        QTest::addColumn<QString>("names");
        const QString inRight = QStringLiteral("right.rail right.lamp_0.bulb right.lamp_0.cap right.front.wheel");
        QTest::newRow("of a Part in a Part") << "rover.right.front"
                                             << "carrier"
                                             << "rail lamp_0.bulb lamp_0.cap world";
        QTest::newRow("of a Part") << "RobotConfig.Kit.left"
                                   << "hull" << QStringLiteral("hull mast ") + inRight + QStringLiteral(" world");
        QTest::newRow("of a robot") << "tall"
                                    << "where"
                                    << QStringLiteral("hull mast left.rail left.lamp_0.bulb left.lamp_0.cap left.front.wheel ") +
                                           inRight + QStringLiteral(" flag world");
        QTest::newRow("a Material") << "tall"
                                    << "paint"
                                    << "default grey red gold silver";
    }
    void aParamOffersWhatItNames() {
        QFETCH(QString, path);
        QFETCH(QString, row);
        QFETCH(QString, names);
        PropertiesFixture fixture;
        std::string text = replaced(kNested, "Config=Kit Body flag { Box cloth {",
                                    "Config=Kit Param where = hull Param paint = gold\n"
                                    "  Fixed pin { Parent=$where Child=flag } Body flag { Box cloth { Material=$paint");
        text = "Material gold { }\nMaterial silver { }\n" + text;
        QVERIFY(fixture.open(text));
        QCOMPARE(fixture.document.loaded()->diagnostics.errorCount(), 0u);
        fixture.selection.select(path.toStdString());
        const std::string id = "param." + row.toStdString();
        QVERIFY(fixture.row(id.c_str()));
        const auto* pick = fixture.field<QToolButton>(id.c_str(), "pick");
        Q_EMIT pick->menu()->aboutToShow();
        QStringList offered;
        for (const QAction* action : pick->menu()->actions()) offered << action->text();
        QCOMPARE(offered.join(QLatin1Char(' ')), names);
        const std::string before = fixture.text();
        pick->menu()->actions().constLast()->trigger();
        QVERIFY(fixture.text() != before);
        QCOMPARE(fixture.shown(id.c_str()), offered.constLast());
        QCOMPARE(fixture.document.loaded()->diagnostics.errorCount(), 0u);
    }

    void aRowHasOneUnit_data() {
        QTest::addColumn<QString>("first");
        QTest::addColumn<QString>("second");
        QTest::addColumn<QString>("names"); // of rows that both have, in other units
        const auto row = [](const char* name, const char* first, const char* second, const char* names) {
            QTest::newRow(name) << QString::fromLatin1(first) << QString::fromLatin1(second) << QString::fromLatin1(names);
        };
        row("joints", "rail", "axle", "LowStop HighStop");
        row("motors", "lift", "arm", "MaxSpeed");
    }
    /// Metres and degrees are not set in one row, although the properties have one name.
    void aRowHasOneUnit() {
        QFETCH(QString, first);
        QFETCH(QString, second);
        QFETCH(QString, names);
        const std::string text =
            "RobotConfig Lift { Body base { Box b { Size=1,1,1 Mass=9 } } Body car { Pos=0,0,1 Box b { Size=1,1,1 Mass=1 } }\n"
            "  Body tip { Pos=0,0,2 Box b { Size=1,1,1 Mass=1 } } Body end { Pos=0,0,3 Box b { Size=1,1,1 Mass=1 } }\n"
            "  Slider rail { Parent=base Child=car Axis=0,0,1 LowStop=0 HighStop=1 }\n"
            "  Hinge axle { Parent=car Child=tip Axis=0,1,0 LowStop=0 HighStop=1 }\n"
            "  Hinge wrist { Parent=tip Child=end Axis=0,1,0 LowStop=0 HighStop=1 }\n"
            "  LinearMotor lift { Joint=rail MaxForce=50 MaxSpeed=1 } Servo arm { Joint=axle MaxTorque=50 MaxSpeed=1 } }\n";
        const std::string one = "RobotConfig.Lift." + first.toStdString(), two = "RobotConfig.Lift." + second.toStdString();
        const auto hasRows = [&](const std::vector<std::string>& paths) {
            PropertiesFixture fixture;
            if (!fixture.open(text) || fixture.document.loaded()->diagnostics.errorCount() > 0)
                return QStringLiteral("not opened");
            fixture.selection.set(paths);
            QStringList rows;
            for (const QString& name : names.split(u' '))
                if (fixture.row(name.toLatin1().constData())) rows << name;
            return rows.join(u' ');
        };
        QCOMPARE(hasRows({one}), names);
        QCOMPARE(hasRows({two}), names);
        QCOMPARE(hasRows({one, two}), QString());
        QCOMPARE(hasRows({"RobotConfig.Lift.axle", "RobotConfig.Lift.wrist"}),
                 first == QStringLiteral("rail") ? names : QString());
    }

    /// A faulty value is still shown, so that it can be taken out.
    void aRefusedInHasARow() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(replaced(kNested, "Ring fence { ", "Ring fence { In=rover.hull ")));
        fixture.selection.select("fence");
        QCOMPARE(fixture.shown("In"), QStringLiteral("rover.hull"));
    }

    /// Of a long path the object stays readable, above the key.
    void aLongPathHasTwoLines() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kNested));
        fixture.selection.select("rover");
        fixture.picture("long_path");
        QTextDocument shown;
        shown.setHtml(fixture.field<QLabel>("override.left.front.motor.Resistance", "label")->text());
        QCOMPARE(shown.toPlainText(), QStringLiteral("left.front.motor\nResistance"));
        const QString tip = fixture.field<QLabel>("override.left.front.motor.Resistance", "label")->toolTip();
        QVERIFY2(tip.startsWith(QStringLiteral("left.front.motor.Resistance")), qPrintable(tip));
    }

    /// Where the words below an overridden value wrap, the next line begins without a gap.
    void wrappedLinksBeginWithoutAGap() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kNested));
        fixture.selection.select("rover.left.front.motor");
        QTextDocument words;
        words.setHtml(fixture.field<QLabel>("Resistance", "override")->text());
        for (int width = 40; width < 400; width += 4) {
            words.setTextWidth(width);
            const QTextBlock block = words.begin();
            for (int i = 0; i < block.layout()->lineCount(); ++i) {
                const QString line = block.text().mid(block.layout()->lineAt(i).textStart());
                QVERIFY2(!line.startsWith(QChar(QChar::Nbsp)) && !line.startsWith(QLatin1Char(' ')), qPrintable(line));
            }
        }
    }

    /// The links stay beside each other.
    void linksOfAnOverrideShareALine() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kNested));
        fixture.selection.select("rover.left.front.motor");
        QTextDocument words;
        words.setHtml(fixture.field<QLabel>("Resistance", "override")->text());
        for (int width = 140; width < 400; width += 4) {
            words.setTextWidth(width);
            const QTextBlock block = words.begin();
            const QTextLayout& lines = *block.layout();
            const auto lineOf = [&](const char* text) {
                return lines.lineForTextPosition(int(block.text().indexOf(QLatin1String(text)))).lineNumber();
            };
            QVERIFY2(lineOf("Reset") == lineOf("Up"), qPrintable(QString::number(width)));
        }
    }

    /// A Param without a default has to be given.
    void aValueThatIsNeededCannotBeReset() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kNested));
        fixture.selection.select("RobotConfig.Kit.left");
        QVERIFY(fixture.row("param.hull") && !fixture.choose("param.hull", "rowReset"));
        const QString links = fixture.field<QLabel>("param.hull", "override")->text();
        QVERIFY(!links.contains(QStringLiteral("href='reset'")) && links.contains(QStringLiteral("href='push'")));
        QVERIFY(fixture.choose("Pos", "rowReset"));
    }

    /// The value is set once both are chosen. A Part or Repeat stands for its bodies.
    void namesOfPairsAreChosenInTurn() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kNested));
        fixture.selection.select("RobotConfig.Kit");
        const std::string before = fixture.text();
        const auto* pick = fixture.field<QToolButton>("NoContact", "pick");
        const auto choose = [&](const char* name) {
            Q_EMIT pick->menu()->aboutToShow();
            for (QAction* action : pick->menu()->actions())
                if (action->text() == QLatin1String(name) && action->isEnabled()) return action->trigger();
            QFAIL(name);
        };
        choose("mast");
        QCOMPARE(fixture.shown("NoContact"), QStringLiteral("mast, "));
        QCOMPARE(fixture.text(), before);
        QTRY_VERIFY(pick->menu()->isVisible()); // for the second one
        QCOMPARE(pick->menu()->actions().constFirst()->text(), QStringLiteral("mast and"));
        pick->menu()->close();
        choose("left");
        QVERIFY2(fixture.text().find("NoContact=mast, left") != std::string::npos, fixture.text().c_str());
        QCOMPARE(fixture.document.loaded()->diagnostics.errorCount(), 0u);
        choose("mast"); // a name may be in several pairs
        choose("right.lamp");
        QVERIFY2(fixture.text().find("NoContact=mast, left, mast, right.lamp") != std::string::npos, fixture.text().c_str());
        QCOMPARE(fixture.document.loaded()->diagnostics.errorCount(), 0u);
        choose("hull");
        QTest::keyClick(fixture.field<QLineEdit>("NoContact"), Qt::Key_Return);
        QVERIFY(fixture.field("NoContact")->refused());
        choose("right");
        QVERIFY(!fixture.field("NoContact")->refused());
        QVERIFY2(fixture.text().find("right.lamp, hull, right") != std::string::npos, fixture.text().c_str());
    }

    /// Numbers side by side would push the marks of all rows out of a narrow panel.
    void aNarrowPanelShowsTheMarks() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open("Material paint { ColorRGB = 0.1, 0.2, 0.3 }\n"));
        fixture.selection.select("Material.paint");
        const auto* mark = fixture.row("ColorRGB")->findChild<QWidget*>(QStringLiteral("mark"));
        for (const int width : {340, 240}) {
            fixture.panel.resize(width, 900);
            EVENTUALLY(mark->mapTo(&fixture.panel, QPoint(mark->width(), 0)).x() <= width);
        }
        const QWidget *red = fixture.field("ColorRGB", "field0"), *green = fixture.field("ColorRGB", "field1");
        EVENTUALLY(green->y() > red->y());
    }

    /// Of two materials one has a colour of its own: neither text changes.
    void cancellingAColourLeavesNothing() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open("Material green { ColorRGB = 0, 1, 0 }\nMaterial plain { }\n"));
        const std::string before = fixture.text();
        fixture.selection.set({"Material.green", "Material.plain"});
        QTest::mouseClick(fixture.field<QToolButton>("ColorRGB", "swatch"), Qt::LeftButton);
        auto* dialog = fixture.panel.findChild<QColorDialog*>();
        QVERIFY(dialog);
        dialog->setCurrentColor(Qt::blue);
        dialog->setCurrentColor(Qt::black);
        QVERIFY2(fixture.text().find("Material plain { ColorRGB") != std::string::npos, fixture.text().c_str());
        dialog->reject();
        QCOMPARE(fixture.text(), before);
        QVERIFY(fixture.document.edits().history().entries().empty());
    }

    void aCancelledDragLeavesTheStepBefore() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open("Robot robot0 { Config=Rover leftMotor.Resistance=3 }\n"));
        fixture.selection.select("robot0.leftMotor");
        QTest::keyClick(fixture.field("Resistance"), Qt::Key_Up);
        const std::string stepped = fixture.text();
        QVERIFY2(stepped.find("Resistance=3.1 ") != std::string::npos, stepped.c_str());
        auto* label = fixture.row("Resistance")->findChild<QWidget*>(QStringLiteral("label"));
        const QPoint from(4, 6);
        QTest::mousePress(label, Qt::LeftButton, {}, from);
        for (const int x : {15, 30}) {
            QMouseEvent move(QEvent::MouseMove, QPointF(from + QPoint(x, 0)), label->mapToGlobal(QPointF(from + QPoint(x, 0))),
                             Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(label, &move);
        }
        QVERIFY(fixture.text() != stepped);
        QTest::keyClick(label, Qt::Key_Escape);
        QTest::mouseRelease(label, Qt::LeftButton, {}, from + QPoint(30, 0));
        QCOMPARE(fixture.text(), stepped);
        QCOMPARE(fixture.document.edits().history().entries().size(), 1u);
    }

    /// Helps are shown as plain text.
    void helpsHaveNoMarkup() {
        const FixtureApplication application;
        for (const Kind* kind : application.builtIn()->all()) {
            QVERIFY2(kind->help.find('`') == std::string::npos, kind->help.c_str());
            for (const Property& p : kind->properties) QVERIFY2(p.help.find('`') == std::string::npos, p.help.c_str());
        }
    }

    /// The mark of a row shows an override if any of the selected objects has one.
    void theMarkIsOfAllSelectedObjects() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open("Robot plain { Config=Rover }\nRobot same { Config=Rover Pos=0,4,0 }\n"
                             "Robot weak { Config=Rover Pos=0,2,0 leftMotor.Resistance=3 }\n"));
        const auto mark = [&](const std::vector<std::string>& paths, const char* id = "Resistance") {
            fixture.selection.set(paths);
            QCoreApplication::processEvents();
            return fixture.row(id)->findChild<QWidget*>(QStringLiteral("mark"))->grab().toImage();
        };
        const QImage ofConfig = mark({"plain.leftMotor"}), ofOverride = mark({"weak.leftMotor"});
        QVERIFY(ofConfig != ofOverride);
        QCOMPARE(mark({"plain.leftMotor", "same.leftMotor"}), ofConfig);
        QCOMPARE(mark({"weak.leftMotor", "plain.leftMotor"}), ofOverride);
        QCOMPARE(mark({"plain.leftMotor", "weak.leftMotor"}), ofOverride);
        QCOMPARE(mark({"plain.leftMotor", "same.leftMotor", "weak.leftMotor"}), ofOverride);
        QCOMPARE(mark({"plain.leftMotor", "weak.leftMotor"}, "MaxVoltage"), ofConfig); // another value of the same object
    }
};

QTEST_MAIN(PropertyRowsTest)
#include "property_rows_test.moc"
