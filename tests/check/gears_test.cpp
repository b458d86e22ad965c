// Gears that contradict each other hold their joints still: they are reported, others are not.
#include "check/check_fixture.h"

using namespace fixture;

class GearsTest : public QObject {
    Q_OBJECT
    CheckFixture m_fixture;

private Q_SLOTS:
    void contradictions_data() {
        QTest::addColumn<QString>("gears");
        QTest::addColumn<QString>("said"); ///< empty: nothing
        QTest::newRow("a chain") << "Gear g { Joint=b Other=a Ratio=2 } Gear h { Joint=c Other=b Ratio=-3 }"
                                 << "";
        QTest::newRow("a tree") << "Gear g { Joint=b Other=a Ratio=2 } Gear h { Joint=c Other=a Ratio=-3 }"
                                << "";
        QTest::newRow("the same twice") << "Gear g { Joint=b Other=a Ratio=2 } Gear h { Joint=b Other=a Ratio=2 }"
                                        << "";
        QTest::newRow("there and back") << "Gear g { Joint=b Other=a Ratio=3 } Gear h { Joint=a Other=b Ratio=$(1/3) }"
                                        << "";
        QTest::newRow("there and not back")
            << "Gear g { Joint=b Other=a Ratio=2 } Gear h { Joint=a Other=b Ratio=2 }"
            << "the Gear h of Box holds a and b still: by its Ratio, a turns at 2 times the rate of b, "
               "by other Gears at 0.5 times";
        QTest::newRow("the other way") << "Gear g { Joint=b Other=a Ratio=1 } Gear h { Joint=b Other=a Ratio=-1 }"
                                       << "by its Ratio, b turns at -1 times the rate of a, by other Gears at 1 times";
        QTest::newRow("three meshing wheels")
            << "Gear g { Joint=b Other=a Ratio=-1 } Gear h { Joint=c Other=b Ratio=-1 } Gear i { Joint=a Other=c Ratio=-1 }"
            << "the Gear i of Box holds a and c still: by its Ratio, a turns at -1 times the rate of c, by other Gears at 1 "
               "times";
        QTest::newRow("four meshing wheels") << "Gear g { Joint=b Other=a Ratio=-1 } Gear h { Joint=d Other=c Ratio=-1 }"
                                                "Gear i { Joint=b Other=c Ratio=-1 } Gear j { Joint=a Other=d Ratio=-1 }"
                                             << "";
        QTest::newRow("two pairs joined wrongly")
            << "Gear g { Joint=b Other=a Ratio=2 } Gear h { Joint=d Other=c Ratio=5 } Gear i { Joint=b Other=c Ratio=4 }"
               "Gear j { Joint=d Other=a Ratio=2 }"
            << "the Gear j of Box holds d and a still: by its Ratio, d turns at 2 times the rate of a, by other Gears at 2.5 "
               "times";
    }
    void contradictions() {
        QFETCH(QString, gears);
        QFETCH(QString, said);
        std::string text = kThings + "RobotConfig Box { Body base { Box b { Size=1,1,0.1 Pos=0,0,0.05 Mass=5 } }\n";
        for (int i = 0; i < 4; ++i) {
            const std::string joint(1, static_cast<char>('a' + i));
            text += "  Body w" + joint + " { Pos=" + std::to_string(0.2 * i) +
                    ",0,0.3 Cylinder c { Radius=0.1 Length=0.05 Mass=0.5 } }\n" + "  Hinge " + joint + " { Parent=base Child=w" +
                    joint + " Axis=0,0,1 }\n";
        }
        const auto loaded =
            m_fixture.open(text + gears.toStdString() + " }\nRobot one { Config=Box }\nRobot two { Config=Box Pos=3,0,0 }\n");
        QVERIFY(loaded);
        const Diagnostics found = CheckFixture::check(*loaded);
        std::vector<QString> warnings;
        for (const Diagnostic& d : found.all())
            if (d.code == Code::ClosedLoop) warnings.push_back(QString::fromStdString(d.message));
        QVERIFY2(warnings.size() == std::size_t(!said.isEmpty()), CheckFixture::shown(*loaded, found).c_str());
        if (!said.isEmpty()) QVERIFY2(warnings[0].endsWith(said), qPrintable(warnings[0]));
    }
};

QTEST_GUILESS_MAIN(GearsTest)
#include "gears_test.moc"
