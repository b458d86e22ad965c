// Springs and masses of joints at the top level: as of joints of one robot.
#include "check/check_fixture.h"

using namespace fixture;

class LinkedBodiesTest : public QObject {
    Q_OBJECT
    CheckFixture m_fixture;

private Q_SLOTS:
    void links_data() {
        QTest::addColumn<QString>("links");
        QTest::addColumn<QString>("said"); ///< empty: nothing
        QTest::newRow("a soft spring") << "Spring s { Parent=world Child=one.b Anchor=0,0,7 Length=2 Stiffness=400 }"
                                       << "";
        QTest::newRow("a stiff spring")
            << "Spring s { Parent=world Child=one.b Anchor=0,0,7 Length=2 Stiffness=40000 }"
            << "E330 the spring s swings at 31.8 Hz; a tick of 10 ms follows up to 28.6 Hz, and damps it "
               "strongly; make it softer, or the Tick at most 9 ms";
        QTest::newRow("between two robots") << "Slider s { Parent=one.b Child=two.b Axis=1,0,0 Stiffness=1e9 }"
                                            << "E330 the spring of s swings at ";
        QTest::newRow("in a Repeat")
            << "Repeat r { Count=3 Pos=$(5*index),0,0 Robot x { Config=B Pos=0,5,0.1 } Hinge s { Parent=world "
               "Child=x.b Axis=0,0,1 Stiffness=1e9 } }"
            << "E330 the spring of r_0.s swings at ";
        QTest::newRow("of a moving static")
            << "Spring s { Parent=door.leaf Child=one.b Anchor2=0,0,0.1 Length=2 Stiffness=40000 }"
            << "E330 the spring s swings at ";
        QTest::newRow("a light one")
            << "Hinge s { Parent=one.b Child=light.b Axis=0,1,0 }"
            << "E328 light.b weighs 1e-05 kg and one.b, which s joins to it, 1 kg: 1 to 100000 is more than the "
               "solver holds together (1 to 10000); give light.b more mass or one.b less";
        QTest::newRow("a light one on the world") << "Hinge s { Parent=world Child=light.b Axis=0,1,0 }"
                                                  << "";
    }
    void links() {
        QFETCH(QString, links);
        QFETCH(QString, said);
        const auto loaded = m_fixture.open(
            kThings +
            "RobotConfig B { Param m = 1 Body b { Sphere x { Radius=0.1 Mass=$m } } }\n"
            "StaticConfig Door { Body leaf { Box x { Size=0.1,1,1 Mass=50 } } Slider rail { Parent=world Child=leaf Axis=1,0,0 } "
            "}\n"
            "Static door { Config=Door Pos=9,0,3 }\nRobot one { Config=B Pos=0,0,0.1 } Robot two { Config=B Pos=1,0,0.1 }\n"
            "Robot light { Config=B Pos=0.21,0,0.1 m=1e-5 }\n" +
            links.toStdString() + "\n");
        QVERIFY(loaded);
        const Diagnostics found = CheckFixture::check(*loaded);
        std::vector<QString> warnings;
        for (const Diagnostic& d : found.all())
            if (d.code == Code::SpringTooFast || d.code == Code::MassRatio)
                warnings.push_back(QString::fromStdString(codeName(d.code) + " " + d.message));
        QVERIFY2(!loaded->diagnostics.hasErrors() && warnings.size() == std::size_t(!said.isEmpty()),
                 CheckFixture::shown(*loaded, found).c_str());
        if (!said.isEmpty()) QVERIFY2(warnings[0].startsWith(said), qPrintable(warnings[0]));
    }
};

QTEST_GUILESS_MAIN(LinkedBodiesTest)
#include "linked_bodies_test.moc"
