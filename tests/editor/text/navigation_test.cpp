// Where Go to Definition and Find References lead in a text.
#include <QTest>

#include "editor/text/symbols/text_navigation.h"
#include "editor/text/text_fixture.h"

using namespace trundle;
using namespace trundle::test;

namespace {

const std::string kKit = "PartConfig Wheel {\n"
                         "  Body wheel { Sphere tyre { Radius=0.1 Mass=1 } }\n"
                         "  Hinge axle { Parent=$carrier Child=wheel }\n"
                         "  Camera eye { Body=$carrier }\n"
                         "}\n"
                         "PartConfig Pair {\n"
                         "  Part front { Config=Wheel carrier=$frame }\n"
                         "  Part back { Config=Wheel carrier=$frame }\n"
                         "}\n"
                         "RobotConfig Kit {\n"
                         "  Body chassis { Box hull { Size=1,1,1 Mass=2 } }\n"
                         "  Part left { Config=Wheel carrier=chassis }\n"
                         "  Part pair { Config=Pair frame=chassis }\n"
                         "}\n"
                         "PartConfig Caster { Config=Wheel carrier=fork Body fork { Box b { Size=1,1,1 Mass=1 } } }\n"
                         "Robot robot { Config=Kit left.carrier=chassis }\n";

QString shown(const LoadedProject& loaded, SourceRange place) {
    const std::uint32_t begin = place.range.begin;
    const auto at = loaded.trees[place.file]->source().position(begin);
    return QStringLiteral("%1 %2").arg(at.line).arg(QString::fromStdString(std::string(loaded.sources.slice(place))));
}

} // namespace

class NavigationTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void leads_data() {
        QTest::addColumn<QString>("before"); // the caret is behind it
        QTest::addColumn<QString>("definition");
        QTest::addColumn<QString>("uses");
        QTest::addColumn<QString>("symbol");
        const auto row = [](const char* before, const char* definition, const char* uses, const char* symbol) {
            QTest::newRow(before) << QString::fromLatin1(before) << QString::fromLatin1(definition) << QString::fromLatin1(uses)
                                  << QString::fromLatin1(symbol);
        };
        const char* const carrier = "3 carrier, 4 carrier, 7 carrier, 8 carrier, 12 carrier, 15 carrier, 16 carrier";
        for (const char* at : {"Parent=$car", "Body=$car", "front { Config=Wheel car", "left { Config=Wheel car",
                               "Caster { Config=Wheel car", "left.car"})
            row(at, "3 carrier", carrier, "PartConfig.Wheel.carrier");
        for (const char* at : {"front { Config=Wheel carrier=$fr", "back { Config=Wheel carrier=$fr", "Config=Pair fr"})
            row(at, "7 frame", "7 frame, 8 frame, 13 frame", "PartConfig.Pair.frame");
        for (const char* at : {"left { Config=Wheel carrier=ch", "frame=ch", "left.carrier=ch", "Body ch"})
            row(at, "11 chassis", "11 chassis, 12 chassis, 13 chassis, 16 chassis", "RobotConfig.Kit.chassis");
        row("carrier=fo", "15 fork", "15 fork, 15 fork", "PartConfig.Caster.fork");
        row("Param", "", "", "");
    }
    void leads() {
        QFETCH(QString, before);
        TextFixture w;
        w.open(w.write("a.sim", QByteArray::fromStdString(kKit)));
        const LoadedProject& loaded = *w.document.loaded();
        const std::size_t at = kKit.find(before.toStdString());
        const auto offset = static_cast<std::uint32_t>(at == std::string::npos ? 0 : at + std::size_t(before.size()));
        const auto definition = definitionAt(loaded, 0, offset);
        QTEST(definition ? shown(loaded, definition->place) : QString(), "definition");
        QStringList uses;
        for (const SourceRange& use : usesAt(loaded, 0, offset)) uses += shown(loaded, use);
        QTEST(uses.join(QStringLiteral(", ")), "uses");
        const auto symbol = symbolAt(loaded, 0, offset);
        QTEST(symbol ? QString::fromStdString(symbol->path) : QString(), "symbol");
    }
};

QTEST_MAIN(NavigationTest)
#include "navigation_test.moc"
