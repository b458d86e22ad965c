// Comments above blocks: which ones go with a block that is removed, copied or moved, and which ones stay.
#include <QTest>

#include "plan_fixture.h"

using namespace trundle;

namespace {

// The comment above `a` is about both, the others are about one block each.
const char* const kText = R"(// the file
Material first { }

// red ones
// and darker ones
Material a { }
Material b { }

// blue
Material c { } // it is
/* green,
   of leaves */
Material d {
}
// the config
StaticConfig S { // of two boxes
  // low
  Box low { Size=1,1,1 }
  // high
  Box high { Size=1,1,2 }
}
// far below

Material e { }
// slips
Surface ice { }
Material f { }
Tick = 0.01
)";

} // namespace

class BlockCommentsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void goWithTheirBlock_data() {
        QTest::addColumn<QStringList>("paths");
        QTest::addColumn<QString>("whole");
        QTest::addRow("begins the file") << QStringList{"Material.first"} << "Material first { }\n";
        QTest::addRow("about more than one, the first") << QStringList{"Material.a"} << "Material a { }\n";
        QTest::addRow("about more than one, the last") << QStringList{"Material.b"} << "Material b { }\n";
        QTest::addRow("all it is about") << QStringList{"Material.b", "Material.a"}
                                         << "// red ones\n// and darker ones\nMaterial a { }\nMaterial b { }\n";
        QTest::addRow("above and behind") << QStringList{"Material.c"} << "// blue\nMaterial c { } // it is\n";
        QTest::addRow("of several lines") << QStringList{"Material.d"} << "/* green,\n   of leaves */\nMaterial d {\n}\n";
        QTest::addRow("within a block, then a comment")
            << QStringList{"StaticConfig.S.low"} << "  // low\n  Box low { Size=1,1,1 }\n";
        QTest::addRow("within a block, then its end")
            << QStringList{"StaticConfig.S.high"} << "  // high\n  Box high { Size=1,1,2 }\n";
        QTest::addRow("another kind follows") << QStringList{"Surface.ice"} << "// slips\nSurface ice { }\n";
        QTest::addRow("a blank line between") << QStringList{"Material.e"} << "Material e { }\n";
    }
    void goWithTheirBlock() {
        QFETCH(QStringList, paths);
        QFETCH(QString, whole);
        const auto loaded = m_fixture.open(kText);
        std::vector<std::string> all;
        for (const QString& path : paths) all.push_back(path.toStdString());
        QCOMPARE(QString(kText).count(whole), 1);
        QCOMPARE(QString::fromStdString(m_fixture.text(loaded, planRemove(*loaded, all))), QString(kText).remove(whole));
        QString copy = whole;
        if (copy.startsWith("  ")) copy = copy.mid(2).replace("\n  ", "\n");
        QCOMPARE(QString::fromStdString(textOf(*loaded, all)), copy);
    }

    void takeABlankLineAlong_data() {
        QTest::addColumn<QString>("before");
        QTest::addColumn<QString>("after");
        QTest::addRow("between two") << "Tick = 0.01\n\nMaterial a { }\n \t\nMaterial b { }\n"
                                     << "Tick = 0.01\n\nMaterial b { }\n";
        QTest::addRow("CRLF") << "Tick = 0.01\r\n\r\nMaterial a { }\r\n\r\nMaterial b { }\r\n"
                              << "Tick = 0.01\r\n\r\nMaterial b { }\r\n";
        QTest::addRow("one below only") << "Tick = 0.01\nMaterial a { }\n\nMaterial b { }\n"
                                        << "Tick = 0.01\n\nMaterial b { }\n";
        QTest::addRow("one above only") << "Tick = 0.01\n\nMaterial a { }\nMaterial b { }\n"
                                        << "Tick = 0.01\n\nMaterial b { }\n";
        QTest::addRow("at the end of the file") << "Tick = 0.01\n\nMaterial a { }\n"
                                                << "Tick = 0.01\n";
        QTest::addRow("without a last line end") << "Tick = 0.01\n\nMaterial a { }"
                                                 << "Tick = 0.01\n";
        QTest::addRow("at the begin of the file") << "Material a { }\n\nTick = 0.01\n"
                                                  << "Tick = 0.01\n";
        QTest::addRow("all of it") << "Material a { }\n"
                                   << "";
    }
    void takeABlankLineAlong() {
        QFETCH(QString, before);
        QFETCH(QString, after);
        const auto loaded = m_fixture.open(before.toStdString());
        QCOMPARE(QString::fromStdString(m_fixture.text(loaded, planRemove(*loaded, {"Material.a"}))), after);
    }
    void takeABlankLineAlongInABlock() {
        const auto loaded = m_fixture.open("StaticConfig S {\n\n  Box a { Size=1,1,1 }\n\n  Box b { Size=1,1,2 }\n\n}\n");
        QCOMPARE(m_fixture.text(loaded, planRemove(*loaded, {"StaticConfig.S.a"})),
                 "StaticConfig S {\n\n  Box b { Size=1,1,2 }\n\n}\n");
        QCOMPARE(m_fixture.text(loaded, planRemove(*loaded, {"StaticConfig.S.a", "StaticConfig.S.b"})),
                 "StaticConfig S {\n\n}\n");
        const auto tight = m_fixture.open("StaticConfig S {\n  Box a { Size=1,1,1 }\n\n  Box b { Size=1,1,2 }\n}\n");
        QCOMPARE(m_fixture.text(tight, planRemove(*tight, {"StaticConfig.S.a"})),
                 "StaticConfig S {\n  Box b { Size=1,1,2 }\n}\n");
        QCOMPARE(m_fixture.text(tight, planRemove(*tight, {"StaticConfig.S.a", "StaticConfig.S.b"})), "StaticConfig S {\n}\n");
        QCOMPARE(m_fixture.text(tight, planRemove(*tight, {"StaticConfig.S.b"})),
                 "StaticConfig S {\n  Box a { Size=1,1,1 }\n}\n");
    }

    void areTakenToAnotherPlace() {
        const auto loaded =
            m_fixture.open("// about a\nMaterial a { }\n\n// about b\nMaterial b { } // b\n\n// about c\nMaterial c { }\n");
        QCOMPARE(m_fixture.text(loaded, planMove(*loaded, {"Material.c"}, "", "Material.b")), // above the comment of b
                 "// about a\nMaterial a { }\n\n// about c\nMaterial c { }\n// about b\nMaterial b { } // b\n");
        QCOMPARE(m_fixture.text(loaded, planMove(*loaded, {"Material.b"}, "", "")),
                 "// about a\nMaterial a { }\n\n// about c\nMaterial c { }\n// about b\nMaterial b { } // b\n");
    }

    void areTakenToAnotherBlock() {
        const auto loaded = m_fixture.open(R"(RobotConfig Cart {
  Body hull {
    // the first
    Box first { Size=1,1,1 Mass=1 }

    // soft,
    //   as a ball
    Sphere ball { // round
      Radius=0.1 Mass=1
    } // light
  }
  Body other { Pos=0,0,1 Sphere own { Radius=0.1 Mass=1 } }
}
Robot r { Config=Cart }
)");
        QCOMPARE(m_fixture.text(loaded, planMove(*loaded, {"RobotConfig.Cart.hull.ball"}, "RobotConfig.Cart.other", "")),
                 R"(RobotConfig Cart {
  Body hull {
    // the first
    Box first { Size=1,1,1 Mass=1 }
  }
  Body other { Pos=0,0,1 Sphere own { Radius=0.1 Mass=1 }
    // soft,
    //   as a ball
    Sphere ball { // round
      Radius=0.1 Mass=1
      Pos=0,0,-1
    } // light
  }
}
Robot r { Config=Cart }
)");
    }

private:
    sample::PlanFixture m_fixture;
};

QTEST_APPLESS_MAIN(BlockCommentsTest)
#include "block_comments_test.moc"
