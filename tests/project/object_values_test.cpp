// The values of an object as Properties shows them, the blocks around a selection, and how far copies are moved.
#include <QTest>

#include "model/provenance.h"
#include "plan_fixture.h"
#include "project/edits/duplicate_offset.h"
#include "project/edits/insert_positions.h"
#include "project/objects/object_values.h"
#include "project/objects/part_values.h"
#include "project/objects/unplaced_configs.h"

using namespace trundle;
using sample::PlanFixture;

namespace {

const char* const kScene = R"(#loadModule walker
Tick = 0.02
Param far = 4
Param pace = 1.5
Material red { ColorRGB=1,0,0 }
StaticConfig Yard { Box north { Size=2,3,1 } Sphere { Radius=0.5 } }
RobotConfig Cart {
  Param width = 0.5
  Param Deep = 0.25
  Body chassis { Pos=0,0,$width Box hull { Size=1,$width,$(2*Deep) Mass=200 g } }
  Body arm { Pos=1,0,1 Sphere s { Radius=0.1 Mass=1 } }
  Hinge axle { Parent=chassis Child=arm Anchor=0.5,0,1 }
}
Static arena { Config=Yard Pos=1,2,3 }
Robot robot0 { Config=Cart Pos = 1 , $far ,2 width=0.75 chassis.hull.Mass=0.3 Walker brain { Speed=$pace } }
Robot robot1 { Config=Cart Pos=0,-3,0 }
Grid swarm { Config=Cart Count=3 Spacing=4 Pos=9,9,9 }
)";

} // namespace

class ObjectValuesTest : public QObject {
    Q_OBJECT
    PlanFixture m_fixture;
    std::shared_ptr<const LoadedProject> m_loaded;

    FieldValue field(const char* path, const char* name) const {
        return ObjectValues(m_loaded, path).property(name).value_or(FieldValue{});
    }
    static QString joined(const std::vector<std::string>& texts) {
        QStringList all;
        for (const std::string& text : texts) all << QString::fromStdString(text);
        return all.join(' ');
    }

private Q_SLOTS:
    void init() {
        m_loaded = m_fixture.open({{"main.sim", kScene}});
        QVERIFY2(!m_loaded->diagnostics.hasErrors(), sample::messages(*m_loaded).c_str());
    }

    void originsOfValues_data() {
        QTest::addColumn<QString>("object");
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("origin");
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value"); // the first number, SI
        const auto row = [](const char* object, const char* name, ValueOrigin origin, const char* text, double value) {
            QTest::addRow("%s %s", object, name) << object << name << int(origin) << text << value;
        };
        row("", "Tick", ValueOrigin::Own, "0.02", 0.02);
        row("", "Duration", ValueOrigin::Default, "", -1);
        row("robot0", "Pos", ValueOrigin::Own, "1 , $far ,2", 1);
        row("robot0", "HPR", ValueOrigin::Default, "0,0,0", 0);
        row("robot0.chassis", "Pos", ValueOrigin::Config, "0,0,$width", 0);
        row("robot0.chassis.hull", "Mass", ValueOrigin::Override, "0.3", 0.3);
        row("robot1.chassis.hull", "Mass", ValueOrigin::Config, "200 g", 0.2);
        row("RobotConfig.Cart.chassis.hull", "Mass", ValueOrigin::Own, "200 g", 0.2);
        row("robot0.brain", "Speed", ValueOrigin::Own, "$pace", 1.5);
        row("swarm_2.arm.s", "Radius", ValueOrigin::Config, "0.1", 0.1);
        row("Material.red", "ColorRGB", ValueOrigin::Own, "1,0,0", 1);
    }
    void originsOfValues() {
        QFETCH(QString, object);
        QFETCH(QString, name);
        QFETCH(int, origin);
        QFETCH(QString, text);
        QFETCH(double, value);
        const FieldValue f = field(object.toLatin1(), name.toLatin1());
        QVERIFY(f.property);
        QCOMPARE(int(f.origin), origin);
        if (value < 0) return;
        QCOMPARE(QString::fromStdString(f.text), text);
        QCOMPARE(f.value->numbers.at(0), value);
        if (f.given()) QCOMPARE(m_loaded->outline->texts().slice(f.place), text.toStdString());
    }

    /// The Params of a config are those of the instance whose value is read.
    void formulasInTheirScope() {
        const FieldValue own = field("robot0.chassis", "Pos"), other = field("robot1.chassis", "Pos"),
                         config = field("RobotConfig.Cart.chassis", "Pos");
        QCOMPARE(own.value->numbers, (std::vector<double>{0, 0, 0.75}));
        QCOMPARE(other.value->numbers, (std::vector<double>{0, 0, 0.5}));
        QCOMPARE(config.value->numbers, (std::vector<double>{0, 0, 0.5}));
        QVERIFY(own.formula && own.shown == "0, 0, 0.75" && own.parts == (std::vector<std::string>{"0", "0", "0.75"}));
        QVERIFY(!field("robot1.arm", "Pos").formula && field("robot1.arm", "Pos").shown.empty());
        QVERIFY(field("swarm_1.chassis.hull", "Size").shown == "1, 0.5, 0.5");
    }

    void elementsOfAValue() {
        const FieldValue pos = field("robot0", "Pos");
        QVERIFY(pos.element(0) == "1" && pos.element(1) == "$far" && pos.element(2) == "2");
        QVERIFY(pos.before(1) == "1" && pos.before(2) == "1 , $far" && pos.before(0).empty() &&
                pos.with(1, "7.5") == "1 , 7.5 ,2" && pos.with(2, "x") == "1 , $far ,x");
        const FieldValue none = field("robot1", "HPR");
        QVERIFY(!none.given() && none.element(2) == "0" && none.with(1, "45") == "0,45,0");
    }

    void whatAnOverrideReplaces() {
        const FieldValue mass = field("robot0.chassis.hull", "Mass");
        QVERIFY(mass.config == "Cart" && mass.inherited == "200 g"); // with its own unit
        QCOMPARE(mass.path, std::string("robot0.chassis.hull.Mass"));
        QVERIFY(field("robot1.chassis.hull", "Mass").inherited.empty());
        QCOMPARE(joined(ObjectValues(m_loaded, "robot0").overrides()), QStringLiteral("chassis.hull.Mass"));
        QVERIFY(ObjectValues(m_loaded, "robot0.chassis").overrides().empty());
        // Without a value in the config it replaces the default, in the unit of the property.
        const auto edited =
            m_fixture.open({{"main.sim", std::string(kScene) + "Robot r2 { Config=Cart axle.Anchor=1,2,3 arm.s.HPR=1,2,3 }\n"}});
        m_loaded = edited;
        QVERIFY(field("r2.axle", "Anchor").inherited == "0.5,0,1 m");
        QVERIFY(field("r2.arm.s", "HPR").inherited == "0,0,0 deg");
    }

    /// Of many overrides of one value, in Repeats in Repeats and from several blocks, the rows and provenance have the resolver's.
    void valuesOfMembersAreThoseOfTheResolver() {
        const std::vector<std::string> inner = {"a.b", "a_1.b", "a.b_1", "a_1.b_1"};
        std::uint32_t random = 1;
        for (int round = 0; round < 40; ++round) {
            int value = 0;
            const auto some = [&](const std::string& before) { // about half of the possible overrides
                std::string text;
                for (const std::string& path : inner) {
                    random = random * 1664525 + 1013904223;
                    if (random >> 31) text += " " + before + path + ".w.s.Radius=0.0" + std::to_string(++value + 10);
                }
                return text;
            };
            const std::string leg = some(""), use = some(""),
                              variant = some("row.leg.") + some("row_1.leg.") + some("row_0.leg."),
                              robot = some("row.leg.") + some("row_1.leg.");
            const auto loaded = m_fixture.open(
                "PartConfig Leg { Repeat a { Count=2 Repeat b { Count=2 Body w { Sphere s { Radius=0.01 Mass=1 } } } } }\n"
                "PartConfig Long { Config=Leg" +
                leg + " }\nRobotConfig Base { Repeat row { Count=2 Part leg { Config=Long" + use +
                " } } }\nRobotConfig V { Config=Base" + variant + " }\nRobot r { Config=V" + robot + " }\n");
            QVERIFY2(!loaded->diagnostics.hasErrors(), sample::messages(*loaded).c_str());
            const std::vector<BodySpec>& bodies = loaded->experiment->robots.at(0).config->bodies;
            QCOMPARE(bodies.size(), std::size_t(8));
            for (const BodySpec& body : bodies) {
                const std::string path = "r." + body.name + ".s";
                const std::string where = path + " of\n" + std::string(loaded->trees[0]->source().bytes());
                const double radius = body.geoms.at(0).radius;
                QVERIFY2(valueAt(*loaded, *placeOf(*loaded, path), "Radius")->numbers.at(0) == radius, where.c_str());
                QVERIFY2(ObjectValues(loaded, path).property("Radius")->value->numbers.at(0) == radius, where.c_str());
                const auto from = provenanceOf(*loaded->outline, path + ".Radius");
                QVERIFY2(from && std::stod(std::string(loaded->sources.slice(from->value))) == radius, where.c_str());
            }
        }
    }

    void overridesForAllMembers() {
        const auto loaded = m_fixture.open("RobotConfig C { Repeat a { Count=3 Body w { Sphere s { Radius=1 Mass=1 } } } }\n"
                                           "Robot r { Config=C a.w.s.Radius=2 a_1.w.s.Radius=3 }\n");
        const auto row = [&](const char* path) { return *ObjectValues(loaded, path).property("Radius"); };
        QCOMPARE(row("r.a_0.w.s").setForAll, std::string("a.w.s.Radius"));
        QVERIFY(row("r.a_1.w.s").setForAll.empty() && row("r.a_1.w.s").inherited == "1 m");
        QVERIFY(row("r.a.w.s").setForAll.empty() && row("r.a.w.s").origin == ValueOrigin::Override);
    }

    void paramsOfAnObject() {
        const auto texts = [&](const char* path, std::size_t most) {
            std::vector<std::string> all;
            for (const FieldValue& f : ObjectValues(m_loaded, path).params(most))
                all.push_back(f.path + "=" + f.text + (f.origin == ValueOrigin::Override ? "!" + f.inherited : ""));
            return joined(all);
        };
        QCOMPARE(texts("robot0", 9), QStringLiteral("robot0.width=0.75!0.5 robot0.Deep=0.25"));
        QCOMPARE(texts("robot0", 1), QStringLiteral("robot0.width=0.75!0.5"));
        QCOMPARE(texts("RobotConfig.Cart", 9), QStringLiteral("RobotConfig.Cart.width=0.5 RobotConfig.Cart.Deep=0.25"));
        QCOMPARE(texts("", 9), QStringLiteral("far=4 pace=1.5"));
        QVERIFY(texts("robot0.chassis", 9).isEmpty() && texts("arena", 9).isEmpty());
    }

    void whatAPathIs() {
        const ObjectValues robot(m_loaded, "robot0"), inside(m_loaded, "robot0.arm"), member(m_loaded, "swarm_1.arm"),
            config(m_loaded, "RobotConfig.Cart.arm"), all(m_loaded, "");
        QVERIFY(robot.isInstance() && !robot.inConfig() && robot.config()->name == "Cart" && !robot.member());
        QVERIFY(!inside.isInstance() && inside.inConfig() && inside.instance()->name == "robot0");
        QVERIFY(member.member() && member.path() == "swarm.arm" && member.shownPath() == "swarm_1.arm");
        QVERIFY(!config.instance() && !config.inConfig() && config.config()->name == "Cart");
        QVERIFY(all.exists() && !all.part() && all.kind());
        for (const char* none : {"robot2", "robot0.leg", "swarm_x", "RobotConfig.Cart.leg"})
            QVERIFY2(!ObjectValues(m_loaded, none).exists(), none);
        QVERIFY(!ObjectValues(m_loaded, "robot0").property("Nothing") && ObjectValues(m_loaded, "robot2").properties().empty());
    }

    void definitions() {
        const std::pair<const char*, const char*> all[] = {{"robot0.chassis", "RobotConfig.Cart.chassis"},
                                                           {"robot0", "robot0"},
                                                           {"robot0.brain", "robot0.brain"},
                                                           {"swarm_1", "swarm"},
                                                           {"swarm_1.arm.s", "RobotConfig.Cart.arm.s"},
                                                           {"arena.north", "StaticConfig.Yard.north"},
                                                           {"nothing.at.all", "nothing.at.all"}};
        for (const auto& [path, block] : all) QCOMPARE(definedAt(*m_loaded, path), std::string(block));
        QVERIFY(parentOf(*m_loaded, "a.b.c") == "a.b" && parentOf(*m_loaded, "robot0").empty());
        QVERIFY(parentOf(*m_loaded, "Material.red").empty() && parentOf(*m_loaded, "RobotConfig.Cart").empty());
        QCOMPARE(parentOf(*m_loaded, "RobotConfig.Cart.arm"), std::string("RobotConfig.Cart"));
        QVERIFY(kindAt(*m_loaded, "robot0.arm.s")->name == "Sphere" && !kindAt(*m_loaded, "") && !kindAt(*m_loaded, "robot9"));
    }

    void blocksAroundASelection() {
        const auto around = [&](const char* path) { return joined(placesAround(*m_loaded, path)); };
        QCOMPARE(around(""), QString());
        QCOMPARE(placesAround(*m_loaded, "").size(), std::size_t{1});
        QCOMPARE(around("robot0.arm.s"), QStringLiteral("RobotConfig.Cart.arm.s RobotConfig.Cart.arm RobotConfig.Cart robot0 "));
        QCOMPARE(around("robot0"), QStringLiteral("robot0 RobotConfig.Cart "));
        QCOMPARE(around("arena.north"), QStringLiteral("StaticConfig.Yard.north StaticConfig.Yard arena "));
        const auto place = [&](const char* selected, std::vector<const char*> names) {
            std::vector<const Kind*> kinds;
            for (const char* name : names) kinds.push_back(m_loaded->registry->find(name));
            const auto found = placeFor(*m_loaded, selected, kinds);
            return found ? QString::fromStdString(*found) : QStringLiteral("nowhere");
        };
        QCOMPARE(place("robot0.arm.s", {"Box"}), QStringLiteral("RobotConfig.Cart.arm"));
        QCOMPARE(place("robot0.arm.s", {"Body"}), QStringLiteral("RobotConfig.Cart"));
        QCOMPARE(place("robot0.arm.s", {"Walker"}), QStringLiteral("robot0"));
        QCOMPARE(place("robot0.arm.s", {"Robot"}), QString());
        QCOMPARE(place("robot0.arm.s", {"Box", "Robot"}), QStringLiteral("nowhere")); // all of them in one place
        QCOMPARE(place("robot0", {"Body", "Hinge"}), QStringLiteral("RobotConfig.Cart"));
        QCOMPARE(place("", {"Box"}), QStringLiteral("nowhere"));
    }

    void wordsForPlaces() {
        QCOMPARE(placesOf(*m_loaded->registry->find("Robot")), std::string("the top level"));
        QCOMPARE(placesOf(*m_loaded->registry->find("Walker")), std::string("a Robot, a Static, a Grid or a Scatter"));
        QCOMPARE(placesOf(*m_loaded->registry->find("Hinge")), std::string("a RobotConfig, a StaticConfig, a PartConfig or the top level"));
    }

    /// Copies stand beside the originals: the step above their common width.
    void offsetsOfCopies() {
        const auto offset = [&](std::vector<std::string> paths) { return duplicateOffset(*m_loaded, paths); };
        const Vec3 yard = offset({"arena"}); // 3 m wide; the sphere is inside
        QVERIFY(yard.x() == 0 && yard.z() == 0 && std::abs(yard.y() - 3.1) < 1e-12);
        const double cart = offset({"robot1"}).y();
        QVERIFY(cart >= 1.2 && cart <= 2.5);
        const double both = offset({"robot0", "robot1"}).y(); // y = 4 and y = -3
        QVERIFY2(std::abs(both - cart - 7) < 0.21, qPrintable(QString::number(both - cart)));
        QCOMPARE(offset({"robot0.chassis"}), Vec3(0, 0.1, 0));
        for (const int tenths : {1, 2, 3, 6, 7, 8}) { // never beside each other without a gap, nor with two
            const auto wide =
                m_fixture.open("StaticConfig W { Box b { Size=1,0." + std::to_string(tenths) + ",1 } }\nStatic w { Config=W }\n");
            const double step = duplicateOffset(*wide, {"w"}).y();
            QVERIFY2(std::abs(step - (tenths + 1) / 10.0) < 1e-9, qPrintable(QString::number(step)));
        }
        QCOMPARE(offset({}), Vec3(0, 0.1, 0));
    }

    /// Copies of a Repeat, Ring or Grid are beside all of its members.
    void offsetsOfCopiesWithMembers() {
        const auto loaded = m_fixture.open(
            "RobotConfig W { Body b { Sphere s { Radius=0.1 Mass=1 } } }\nStaticConfig P { Box b { Size=0.2,0.2,1 } }\n"
            "Repeat lane { Count=3 Pos=0,$(0.6*index),0 Robot cart { Config=W } }\n"
            "Grid herd { Config=W Count=1,3 Spacing=1 Pos=9,0,0 }\n"
            "Ring circle { Count=4 Radius=1 Axis=0,0,1 Pos=20,0,0 Robot cart { Config=W } }\n"
            "Repeat row { Count=2 Pos=30,$(2*index),0 Repeat pair { Count=2 Pos=$index,0,0 Static post { Config=P } } }\n");
        QVERIFY(loaded && !loaded->diagnostics.hasErrors());
        const std::map<std::string, double> steps{{"lane", 1.5}, {"herd", 2.3}, {"circle", 2.3}, {"row", 2.3}};
        for (const auto& [path, step] : steps) {
            const Vec3 offset = duplicateOffset(*loaded, {path});
            QVERIFY2(offset.x() == 0 && offset.z() == 0 && std::abs(offset.y() - step) < 1e-9,
                     (path + " " + std::to_string(offset.y())).c_str());
        }
    }

    /// What is round reaches as far on both sides of its middle, or of its axis.
    void offsetsOfRoundCopies() {
        const std::map<std::string, double> steps{{"Sphere s { Radius=0.45 }", 1},
                                                  {"Capsule c { Radius=0.2 Length=3 }", 0.5},
                                                  {"Capsule c { Radius=0.2 Length=1 HPR=0,0,90 }", 1.5},
                                                  {"Sphere s { Radius=0.2 Pos=0,-1,0 } Sphere t { Radius=0.3 Pos=0,1,0 }", 2.6},
                                                  {"Sphere s { Radius=0.45 Collide=false } Box b { Size=1,0.2,1 }", 0.3}};
        for (const auto& [geoms, step] : steps) {
            const auto loaded =
                m_fixture.open("StaticConfig W { " + geoms + " }\nStatic post { Config=W }\nStatic w { Config=W Pos=3,-7,0 }\n");
            QVERIFY(loaded && !loaded->diagnostics.hasErrors());
            const Vec3 offset = duplicateOffset(*loaded, {"w"});
            QVERIFY2(offset.x() == 0 && offset.z() == 0 && std::abs(offset.y() - step) < 1e-9,
                     (geoms + " " + std::to_string(offset.y())).c_str());
        }
    }

    void configsThatNothingPlaces() {
        QVERIFY(configsWithoutInstances(*m_loaded).empty());
        const auto parts =
            m_fixture.open({{"main.sim", "StaticConfig Yard { }\nRobotConfig Cart { Body b { Sphere { Radius=1 Mass=1 } } }\n"}});
        const auto configs = configsWithoutInstances(*parts);
        QVERIFY(configs.size() == 2 && configs[0]->name == "Yard" && configs[1]->name == "Cart");
    }
};

QTEST_APPLESS_MAIN(ObjectValuesTest)
#include "object_values_test.moc"
