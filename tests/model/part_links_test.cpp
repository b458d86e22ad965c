// Where Parts and variants lead to, and their shapes with other Params.
#include <QTest>

#include "model/name_walk.h"
#include "model/resolve/instance_variants.h"
#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;
using sample::resolved;

namespace {

const std::string kHead = "Material g { } Surface s { }\n"
                          "Surface rollers { Friction=0.1 Friction2=0.9 FrictionHeading=45 }\n";

QString messagesOf(const Resolved& r) { return QString::fromStdString(r.messages()); }

} // namespace

class PartLinksTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// What a PartConfig is joined to has no other meaning by the names of what uses it, whichever of them is first in the text.
    void impliedParamsOfNestedParts_data() {
        QTest::addColumn<QString>("arm");
        QTest::addColumn<bool>("isFirst");
        for (const bool isFirst : {true, false}) {
            const QByteArray order = isFirst ? ", first" : ", last";
            QTest::newRow(("the same Param" + order).constData())
                << "Body q { BOX } Fixed f { Parent=$on Child=q } Part sub { Config=Hand on=q }" << isFirst;
            QTest::newRow(("passed on" + order).constData())
                << "Body q { BOX } Fixed f { Parent=$on Child=q } Part sub { Config=Hand on=$on }" << isFirst;
            QTest::newRow(("a body" + order).constData())
                << "Body on { BOX } Fixed f { Parent=hull Child=on } Body hull { BOX } Part sub { Config=Hand on=on }" << isFirst;
            QTest::newRow(("in a Repeat" + order).constData())
                << "Body q { BOX } Fixed f { Parent=$on Child=q } Repeat on2 { Count=1 Part on { Config=Hand on=q } }" << isFirst;
        }
    }
    void impliedParamsOfNestedParts() {
        QFETCH(QString, arm);
        QFETCH(bool, isFirst);
        const std::string box = "Box x { Size=1,1,1 Mass=1 Material=g Surface=s }";
        const std::string outer = "PartConfig Arm { " + arm.replace("BOX", QString::fromStdString(box)).toStdString() + " }\n";
        const std::string inner = "PartConfig Hand { Body z { " + box + " } Fixed g { Parent=$on Child=z } }\n";
        const std::string given = arm.contains("$on") ? " on=b" : "";
        const Resolved r = resolved(kHead + (isFirst ? outer + inner : inner + outer) + "RobotConfig K { Body b { " + box +
                                    " } Part p { Config=Arm" + given + " } }\nRobot a { Config=K }\n");
        QVERIFY2(!r.diagnostics.hasErrors(), r.messages().c_str());
        const std::vector<JointSpec>& joints = r.config().joints;
        QCOMPARE(joints.size(), std::size_t(2));
        QCOMPARE(joints.back().parent, arm.contains("on=$on") ? 0 : 1);
    }

    /// A config within a config, as a comment that hides a `}` makes one, does not lead back to the one around it: what lists its content
    /// ends.
    void misplacedConfigsLeadNowhere() {
        const std::string body = "Body b { Sphere s { Radius=1 Material=g Surface=s } Mass=1 }";
        const Resolved r =
            resolved(kHead + "PartConfig A { " + body + " PartConfig B { Part a { Config=A } } }\nRobotConfig K { " + body +
                     " RobotConfig V { Config=K } Part p { Config=A } Repeat r { Count=2 RobotConfig W { Config=K } } }\n"
                     "Robot x { Config=K }\n");
        QVERIFY(r.diagnostics.hasErrors());
        std::size_t blocks = 0;
        for (const Part* config : r.outline->configs.all())
            NameWalk(10'000).inside(*config, {}, [&](const Part&, const std::string&) { return ++blocks < 1000; });
        QVERIFY2(blocks < 50, std::to_string(blocks).c_str());
        const Part* kit = r.outline->configs.find("K");
        QVERIFY(kit && kit->find("V") && !kit->find("V")->config && kit->find("p")->config);
    }

    /// The shapes of one instance with other Params, as the scale handles ask for them, without the materials and surfaces of the text.
    void mirrorsShapesWithOtherParams() {
        const Resolved r = resolved(kHead + R"(
Surface roller { Friction=1 Friction2=0 FrictionHeading=45 }
PartConfig Wheel { Param r = 1  Body wheel { Pos=0,2,0 Sphere tyre { Radius=$r Material=g Surface=roller } Mass=1 } }
RobotConfig Kit { Param w = 1  Body hull { Box h { Size=$w,1,1 Material=g Surface=s } Mass=1 }  Part right { Config=Wheel Mirror=y } }
StaticConfig Yard { Param w = 1  Repeat b { Count=2 Box b { Size=$w,1,1 Material=g Surface=roller } } }
Robot a { Config=Kit }
Static y { Config=Yard }
)");
        QCOMPARE(messagesOf(r), QString());
        for (const char* name : {"a", "y"}) {
            const InstanceVariants variants(r.outline, sample::assets(), *r.outline->world.find(name));
            InstanceVariants::Params params = variants.params();
            QCOMPARE(params.size(), std::size_t{1});
            params[0].second.elements.at(0).number = 3;
            const auto geoms = variants.geoms(params);
            QVERIFY(geoms && geoms->size() == 2);
            QCOMPARE(geoms->at(0).geom.size.x(), 3.0);
        }
    }
};

QTEST_APPLESS_MAIN(PartLinksTest)
#include "part_links_test.moc"
