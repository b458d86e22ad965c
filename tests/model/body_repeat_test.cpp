// Repeat and Ring in a Body: geoms that differ by a number alone.
#include <QTest>

#include "model/body_geom.h"
#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;
using sample::resolved;

namespace {

const std::string kHead = "Material g { } Surface s { }\n";

std::string robot(const std::string& geoms, const std::string& values = {}, const std::string& more = {}) {
    return kHead + "RobotConfig Kit {\n  Body hull {\n    Box base { Size=1,1,0.1 Mass=2 Material=g Surface=s }\n" + geoms + "  }\n" +
           more + "}\nRobot r { Config=Kit " + values + " }\n";
}

std::string plate(const std::string& pose, const std::string& radius) {
    return "Cylinder plate { Radius=" + radius + " Length=0.1 " + pose + " Mass=0.5 Material=g Surface=s }";
}

QString messagesOf(const Resolved& r) { return QString::fromStdString(r.messages()); }

void compare(const BodySpec& a, const BodySpec& b) {
    QCOMPARE(a.geoms.size(), b.geoms.size());
    for (std::size_t i = 0; i < a.geoms.size(); ++i) {
        QCOMPARE(a.geoms[i].pose.position, b.geoms[i].pose.position);
        QVERIFY(a.geoms[i].pose.rotation.coeffs() == b.geoms[i].pose.rotation.coeffs());
        QCOMPARE(a.geoms[i].radius, b.geoms[i].radius);
    }
    QCOMPARE(a.mass.mass, b.mass.mass);
    QCOMPARE(a.mass.centre, b.mass.centre);
    QVERIFY(a.mass.inertia == b.mass.inertia);
}

} // namespace

class BodyRepeatTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Geoms and mass have the bits of copies by hand.
    void equalsCopiesByHand() {
        const Resolved one = resolved(robot("    Repeat disc { Count=3 Pos=$(0.25*index),0.5,0\n      " +
                                            plate("Pos=0,0,0.125 HPR=0,$(15*index),0", "$(0.125*(index+1))") + " }\n"));
        std::string copies;
        for (int i = 0; i < 3; ++i)
            copies += plate("Pos=" + std::to_string(0.25 * i) + ",0.5,0.125 HPR=0," + std::to_string(15 * i) + ",0",
                            std::to_string(0.125 * (i + 1)))
                          .replace(9, 5, "p" + std::to_string(i)) +
                      "\n";
        const Resolved many = resolved(robot(copies));
        QCOMPARE(messagesOf(one), QString());
        QCOMPARE(messagesOf(many), QString());
        QCOMPARE(one.config().bodies[0].geoms[2].name, std::string("disc_1.plate"));
        compare(one.config().bodies[0], many.config().bodies[0]);
    }

    void aRingTurnsThem() {
        const Resolved r = resolved(robot("    Ring disc { Count=4 Radius=2 Pos=0,0,1 " + plate("", "0.1") + " }\n"));
        QCOMPARE(messagesOf(r), QString());
        const GeomSpec& second = r.config().bodies[0].geoms.at(2);
        QVERIFY((second.pose.position - Vec3(0, 2, 1)).norm() < 1e-12);
        QVERIFY((second.pose.rotation * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-12);
    }

    /// `index` of a Repeat around the body is that of the body, also for the Count in it.
    void bodiesInRepeatsHaveTheirOwn() {
        const Resolved r = resolved(kHead + "RobotConfig Kit { Repeat post { Count=2 Param k=$(index+1) Body b { Pos=$index,0,0 Mass=1\n"
                                            "  Repeat ball { Count=$k Sphere s { Radius=$(0.1*k) Pos=0,$index,0 Material=g Surface=s } } } } }\n"
                                            "Robot r { Config=Kit }\n");
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.config().bodies.size(), std::size_t(2));
        QCOMPARE(r.config().bodies[0].geoms.size(), std::size_t(1));
        QCOMPARE(r.config().bodies[1].geoms.size(), std::size_t(2));
        QCOMPARE(r.config().bodies[1].geoms[1].pose.position, Vec3(0, 1, 0));
        QCOMPARE(r.config().bodies[1].geoms[1].radius, 0.2);
    }

    /// Mirror images of parts hold the mirror images of all of them.
    void isMirrored() {
        const std::string part = "PartConfig Side { Body b { Pos=0,1,0 Mass=1 Repeat ball { Count=2 Pos=0,$(index+1),0\n"
                                 "  Sphere s { Radius=0.1 Material=g Surface=s } } }\n  Fixed f { Parent=$carrier Child=b } }\n";
        const Resolved r = resolved(kHead + part + robot("", "", "  Part left { Config=Side carrier=hull }\n"
                                                                 "  Part right { Config=Side carrier=hull Mirror=y }\n").substr(kHead.size()));
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.config().bodies[2].name, std::string("right.b"));
        QCOMPARE(r.config().bodies[2].geoms[1].pose.position, Vec3(0, -2, 0));
    }

    void valuesAreSetForOneAndForAll() {
        const Resolved r = resolved(robot("    Repeat disc { Count=2 " + plate("", "0.1") + " }\n",
                                          "hull.disc.Count=4 hull.disc.plate.Radius=0.2 hull.disc_3.plate.Radius=0.3 hull.disc_1.Pos=0,0,7"));
        QCOMPARE(messagesOf(r), QString());
        const std::vector<GeomSpec>& geoms = r.config().bodies[0].geoms;
        QCOMPARE(geoms.size(), std::size_t(5));
        QCOMPARE(geoms[1].radius, 0.2);
        QCOMPARE(geoms[4].radius, 0.3);
        QCOMPARE(geoms[2].pose.position, Vec3(0, 0, 7));
        QCOMPARE(r.config().bodies[0].mass.mass, 4.0);
    }

    /// A path leads to a geom of a member, and of a member of a Part.
    void pathsLeadToThem() {
        const Resolved r = resolved(robot("    Repeat disc { Count=2 " + plate("", "0.1") + " }\n"));
        const std::vector<BodySpec>& bodies = r.config().bodies;
        QCOMPARE(geomAt(bodies, "hull.disc_1.plate").geom, 2);
        QCOMPARE(geomAt(bodies, "hull.base").geom, 0);
        QCOMPARE(geomAt(bodies, "hull.disc_2.plate").body, 0);
        QCOMPARE(geomAt(bodies, "hull.disc_2.plate").geom, -1);
        QCOMPARE(geomAt(bodies, "disc_1.plate").body, -1);
        const std::optional<Provenance> radius = provenanceOf(*r.outline, "r.hull.disc_1.plate.Radius");
        QVERIFY(radius);
        QCOMPARE(r.slice(radius->value), std::string("0.1"));
    }

    void reportsWhatIsWrong_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const std::string& text, const char* message) {
            QTest::newRow(name) << QString::fromStdString(text) << message;
        };
        row("a body", robot("    Repeat a { Count=2 Body b { Mass=1 } }\n"),
            "E302 Body is allowed in a RobotConfig, a StaticConfig or a PartConfig, not in a Repeat of a Body\n");
        row("a part", robot("    Repeat a { Count=2 Part b { } }\n"),
            "E302 Part is allowed in a RobotConfig, a StaticConfig or a PartConfig, not in a Repeat of a Body\n");
        row("a plane", robot("    Repeat a { Count=2 Plane b { } }\n"),
            "E302 Plane is allowed in a StaticConfig or a PartConfig, not in a Repeat of a Body\n");
        row("another body", robot("    Repeat a { Count=2 In=hull " + plate("", "1") + " }\n"),
            "E302 In has no meaning in a Body: its geoms are described in Body hull itself\n");
        row("once", robot("    Repeat a { Count=50 " + plate("", "$(0-index-1)") + " }\n"),
            "E203 Radius is -1, it must be above 0\n");
        row("no count", robot("    Repeat a { " + plate("", "1") + " }\n"), "E209 Repeat a needs Count (how many; or how many by how many)\n");
        row("a member", robot("    Repeat a { Count=2 " + plate("", "1") + " }\n", "hull.a_2.plate.Radius=2"),
            "E314 Repeat a has no member a_2; the last one is a_1\n");
        row("one Count", robot("    Repeat a { Count=2 " + plate("", "1") + " }\n", "hull.a_1.Count=2"),
            "E314 one member of Repeat a has no Count; set a.Count\n");
        row("a taken name", robot("    Repeat a { Count=2 " + plate("", "1") + " } Box a_1 { Size=1,1,1 Mass=1 }\n"),
            "E303 the name a_1 belongs to a member of Repeat a\n");
        row("two masses", kHead + "RobotConfig K { Body b { Mass=1 Repeat a { Count=2 " + plate("", "1") + " } } }\n",
            "E214 Body b has a Mass, which is spread over its geoms; Cylinder plate cannot have its own\n");
    }
    void reportsWhatIsWrong() {
        QFETCH(QString, text);
        QFETCH(QString, message);
        const Resolved r = resolved(text.toStdString());
        QString errors;
        for (const Diagnostic& d : r.diagnostics.all())
            if (d.severity == Severity::Error) errors += QString::fromStdString(codeName(d.code) + " " + d.message) + u'\n';
        QCOMPARE(errors, message);
    }
};

QTEST_APPLESS_MAIN(BodyRepeatTest)
#include "body_repeat_test.moc"
