// The header of Properties: where an object comes from, and where a change of it goes.
#include "properties_fixture.h"

using namespace trundle;

class ObjectHeaderTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// What is inside a Part comes from its PartConfig, and the Part takes the override.
    void namesTheConfigOfAPart() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open("PartConfig Wheel { Body disc { Pos=0,0.1,0.05 Sphere ball { Radius=0.05 Mass=1 Material=grey Surface=rubber } }\n"
                             "  Fixed weld { Parent=$carrier Child=disc } }\n"
                             "RobotConfig Cart { Body hull { Pos=0,0,0.05 Box box { Size=0.1,0.1,0.05 Mass=1 Material=grey Surface=rubber } }\n"
                             "  Part left { Config=Wheel carrier=hull }\n  Part right { Config=Wheel carrier=hull Mirror=y } }\n"
                             "Robot cart { Config=Cart }\n"));
        const auto header = [&] { return fixture.panel.findChild<QLabel*>(QStringLiteral("objectConfig"))->text(); };
        fixture.selection.select("cart.hull.box");
        QVERIFY2(header().contains(u">Cart</a>"_qs) && header().contains(u"go into Cart in main.sim: only cart is created"_qs),
                 qPrintable(header()));
        fixture.selection.select("cart.right.disc.ball");
        QVERIFY2(header().contains(u"select:PartConfig.Wheel"_qs) && header().contains(u"main.sim:2<"_qs) &&
                     header().contains(u"Values of Wheel that are changed here become overrides of right in main.sim."_qs),
                 qPrintable(header()));
        fixture.type("Mass", QStringLiteral("2"));
        QVERIFY2(fixture.text().find("Mirror=y disc.ball.Mass=2 }") != std::string::npos, fixture.text().c_str());
    }
};

QTEST_MAIN(ObjectHeaderTest)
#include "object_header_test.moc"
