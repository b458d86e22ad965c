// Radios with the same address, which a packet for it all reaches.
#include "check/check_fixture.h"

using namespace fixture;

class RadioAddressesTest : public QObject {
    Q_OBJECT
    CheckFixture m_fixture;

private Q_SLOTS:
    void addresses_data() {
        QTest::addColumn<QString>("second"); ///< of two robots, whose first one has the address 7 on channel 3
        QTest::addColumn<bool>("clashes");
        QTest::newRow("the same") << "Address=7 Channel=3" << true;
        QTest::newRow("another address") << "Address=8 Channel=3" << false;
        QTest::newRow("another channel") << "Address=7 Channel=4" << false;
        QTest::newRow("none given") << "Channel=3" << false;
    }
    void addresses() {
        QFETCH(QString, second);
        QFETCH(bool, clashes);
        const auto config = [](const std::string& name, const std::string& values) {
            return "RobotConfig " + name + " { Body b { Box x { Size=0.1,0.1,0.1 Mass=1 } } Transceiver t { Body=b " + values +
                   " } }\n";
        };
        const auto loaded = m_fixture.open(kThings + config("A", "Address=7 Channel=3") + config("B", second.toStdString()) +
                                           "Robot one { Config=A } Robot two { Config=B Pos=3,0,0 }\n");
        QVERIFY(loaded && !loaded->diagnostics.hasErrors());
        std::vector<std::string> found;
        for (const Diagnostic& d : loaded->diagnostics.all())
            if (d.code == Code::DuplicateName) found.push_back(d.message);
        QCOMPARE(found.size(), std::size_t(clashes));
        if (clashes)
            QCOMPARE(found[0], std::string("two and one both have a radio with the address 7: packets for it reach both"));
    }
};

QTEST_GUILESS_MAIN(RadioAddressesTest)
#include "radio_addresses_test.moc"
