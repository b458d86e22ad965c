// In = body: the pose of a body, Part or Repeat counts from another body.
#include <QTest>

#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;
using sample::resolved;

namespace {

const std::string kGeom = "Box g { Size=0.1,0.1,0.1 Mass=1 Material=m Surface=s }";
Resolved kit(const std::string& blocks, const std::string& before = {}) {
    std::string all = "Material m { } Surface s { }\n" + before + "RobotConfig Kit {\n" + blocks + "}\nRobot r { Config=Kit }\n";
    for (std::size_t at = 0; (at = all.find("@", at)) != std::string::npos;) all.replace(at, 1, kGeom);
    return resolved(all);
}
QString messagesOf(const Resolved& r) { return QString::fromStdString(r.messages()); }

const BodySpec* body(const Resolved& r, const std::string& name) {
    for (const BodySpec& b : r.config().bodies)
        if (b.name == name) return &b;
    return nullptr;
}
bool isAt(const Resolved& r, const std::string& name, const Vec3& p) {
    const BodySpec* b = body(r, name);
    return b && (b->pose.position - p).norm() < 1e-12;
}

} // namespace

class RelativePosesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aBodyCountsFromAnotherBody() {
        const Resolved r = kit("Body upper { In=lower Pos=0.1,0,0 HPR=0,0,90 @ }\n" // before what it counts from
                               "Body base { Pos=0,0,1 @ }\nBody lower { In=base Pos=1,0,0 HPR=90,0,0 @ }\n");
        QCOMPARE(messagesOf(r), QString());
        QVERIFY(isAt(r, "lower", {1, 0, 1}));
        QVERIFY(isAt(r, "upper", {1, 0.1, 1}));
        QVERIFY((body(r, "upper")->pose.rotation * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-12);
        QCOMPARE(body(r, "base")->pose.position, Vec3(0, 0, 1)); // the same bits as without
    }

    void aPartCountsFromABody() {
        const Resolved r =
            kit("Body base { Pos=0,0,1 HPR=90,0,0 @ }\n"
                "Part left { Config=Wheel In=base Pos=0,0.5,0 }\nPart right { Config=Wheel In=base Pos=0,-0.5,0 Mirror=y }\n"
                "Body flag { In=right.rim Pos=0,0,0.2 @ }\n",
                "PartConfig Wheel { Body hub { Pos=0.1,0.2,0 @ } Body rim { In=hub Pos=0,0.3,0 @ } }\n");
        QCOMPARE(messagesOf(r), QString());
        QVERIFY(isAt(r, "left.hub", {-0.7, 0.1, 1}));
        QVERIFY(isAt(r, "left.rim", {-1, 0.1, 1}));
        QVERIFY(isAt(r, "right.rim", {1, 0.1, 1}));
        QVERIFY(isAt(r, "flag", {1, 0.1, 1.2}));
    }

    void aRepeatCountsFromABody() {
        const Resolved r = kit("Body base { Pos=0,0,1 @ }\nRepeat roller { In=base Count=2 Pos=$index,0,0\n"
                               "  Body drum { @ } Body cap { In=drum Pos=0,0.1,0 @ } }\n"
                               "Ring bolt { In=roller_1.drum Count=2 Radius=0.5 Body pin { @ } }\n");
        QCOMPARE(messagesOf(r), QString());
        QVERIFY(isAt(r, "roller_1.drum", {1, 0, 1}));
        QVERIFY(isAt(r, "roller_1.cap", {1, 0.1, 1}));
        QVERIFY(isAt(r, "bolt_0.pin", {1.5, 0, 1}));
        QVERIFY(isAt(r, "bolt_1.pin", {0.5, 0, 1}));
    }

    /// Of a Part, also to what a Part or Repeat further down has.
    void namesWhatIsFurtherDown() {
        const Resolved r =
            kit("Part first { Config=Wheel In=row_1.b Pos=0,0,1 } Repeat row { Count=2 Pos=$index,0,0 Body b { @ } }\n"
                "Repeat late { Count=2 In=last.hub Pos=0,$index,0 Body c { @ } } Part last { Config=Wheel Pos=5,0,0 }\n",
                "PartConfig Wheel { Body hub { @ } }\n");
        QCOMPARE(messagesOf(r), QString());
        QVERIFY(isAt(r, "first.hub", {1, 0, 1}));
        QVERIFY(isAt(r, "late_1.c", {5, 1, 0}));
    }

    void anInstanceSetsIt() {
        const Resolved r = resolved("Material m { } Surface s { }\nRobotConfig Kit { Body a { Pos=1,0,0 " + kGeom +
                                    " } Body b { " + kGeom + " } }\nRobot r { Config=Kit b.In=a b.Pos=0,1,0 }\n");
        QCOMPARE(messagesOf(r), QString());
        QVERIFY(isAt(r, "b", {1, 1, 0}));
    }

    void errors_data() {
        QTest::addColumn<QString>("blocks");
        QTest::addColumn<QString>("message");
        QTest::addColumn<QString>("place");
        const auto row = [](const char* name, const char* blocks, const char* message, const char* place) {
            QTest::newRow(name) << blocks << message << place;
        };
        row("circle", "Body a { In=b @ } Body b { In=c @ } Body c { In=b @ }\n",
            "E302 poses count from each other in a circle: b > c > b", "c");
        row("itself", "Body a { In=a @ }\n", "E302 poses count from each other in a circle: a > a", "a");
        row("unknown", "Body base { @ } Body b { In=bse @ }\n", "E208 In names bse, but there is no such Body", "bse");
        row("kind", "Body base { @ } Body b { In=base.g @ }\n", "E208 In names base.g, a Box; it takes a Body", "base.g");
        row("outside", "Body base { @ } Repeat x { Count=1 Body b { In=base @ } }\n",
            "E302 In names base, which is outside of Repeat x; give In to Repeat x instead", "base");
        row("own part", "Body base { @ } Part p { Config=P In=p.a }\n", "E302 poses count from each other in a circle: p > p",
            "p.a");
    }
    void errors() {
        QFETCH(QString, blocks);
        QFETCH(QString, message);
        QFETCH(QString, place);
        const Resolved r = kit(blocks.toStdString(), "PartConfig P { Body a { @ } }\n");
        QVERIFY2(!r.diagnostics.all().empty(), "no message");
        const Diagnostic& d = r.diagnostics.all().front();
        QCOMPARE(QString::fromStdString(codeName(d.code) + " " + d.message), message);
        QCOMPARE(QString::fromStdString(r.slice(d.range)), place);
        QCOMPARE(r.diagnostics.errorCount(), std::size_t(1));
    }
};

QTEST_APPLESS_MAIN(RelativePosesTest)
#include "relative_poses_test.moc"
