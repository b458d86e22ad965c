// What a reference may name: bodies that In counts from.
#include <algorithm>
#include <fstream>

#include <QTemporaryDir>
#include <QtTest>

#include "editor/document/document.h"
#include "editor/properties/fitting_names.h"

using namespace trundle;

namespace {

const char* const kText = R"(RobotConfig Crane {
  Body hull { Box box { Size=0.4,0.2,0.1 Mass=2 } }
  Body arm { Pos=0,0,0.2 Box bar { Size=0.1,0.1,0.1 Mass=1 } }
  Body arm2 { Pos=0,0,0.4 Box bar { Size=0.1,0.1,0.1 Mass=1 } }
  Body armrest { Pos=0,0,0.6 Box bar { Size=0.1,0.1,0.1 Mass=1 } }
  Part mast { Config=Pole Pos=1,0,0 }
  Part mast2 { Config=Pole Pos=2,0,0 }
  Fixed one { Parent=hull Child=arm }
  Fixed two { Parent=hull Child=arm2 }
  Fixed three { Parent=hull Child=armrest }
  Fixed four { Parent=hull Child=mast.pole }
  Fixed five { Parent=hull Child=mast2.pole }
}
PartConfig Pole { Body pole { Box box { Size=0.1,0.1,0.5 Mass=1 } } }
Robot crane { Config=Crane }
)";

} // namespace

class FittingNamesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void countsFromEveryBodyButItself_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("without");
        QTest::newRow("body") << "RobotConfig.Crane.hull"
                              << "hull";
        QTest::newRow("names that begin with its own") << "RobotConfig.Crane.arm"
                                                       << "arm";
        QTest::newRow("begins with another's name") << "RobotConfig.Crane.arm2"
                                                    << "arm2";
        QTest::newRow("part") << "RobotConfig.Crane.mast"
                              << "mast.pole";
        QTest::newRow("another part") << "RobotConfig.Crane.mast2"
                                      << "mast2.pole";
    }
    void countsFromEveryBodyButItself() {
        QFETCH(QString, path);
        QFETCH(QString, without);
        const QTemporaryDir folder;
        const std::string file = folder.filePath(QStringLiteral("main.sim")).toStdString();
        std::ofstream(file, std::ios::binary) << kText;
        const auto application = makeApplication();
        Document document(*application);
        QVERIFY(document.opening().open(file).ok());
        std::vector<std::string> expected{"hull", "arm", "arm2", "armrest", "mast.pole", "mast2.pole"};
        std::erase(expected, without.toStdString());
        QCOMPARE(expected.size(), std::size_t(5));
        const auto names = bodiesForIn(*document.loaded(), path.toStdString());
        QVERIFY(names);
        QCOMPARE(*names, expected);
    }

    void thereIsNoneOutsideOfConfigs() {
        const QTemporaryDir folder;
        const std::string file = folder.filePath(QStringLiteral("main.sim")).toStdString();
        std::ofstream(file, std::ios::binary) << kText;
        const auto application = makeApplication();
        Document document(*application);
        QVERIFY(document.opening().open(file).ok());
        for (const char* path : {"crane", "RobotConfig.Crane.arm.bar", "RobotConfig.Crane.none"})
            QVERIFY2(!bodiesForIn(*document.loaded(), path), path);
    }
};

QTEST_GUILESS_MAIN(FittingNamesTest)
#include "fitting_names_test.moc"
