// IEEE 802.15.4 frames and reception rates.
#include <QtTest>

#include "radio/ieee802154.h"
#include "radio/pcap.h"

using namespace trundle;

class Ieee802154Test : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void bitErrors_data() {
        QTest::addColumn<double>("sinr");
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("bytes26");
        QTest::addColumn<double>("bytes47");
        const double rows[][4] = {{-3, 1.641864e-2, .0320, .0020}, {-2, 5.197000e-3, .3383, .1410},
                                  {-1, 1.148944e-3, .7873, .6490}, {0, 1.615267e-4, .9670, .9411},
                                  {1, 1.291187e-5, .9973, .9952},  {2, 5.131392e-7, .9999, .9998}};
        for (const auto& r : rows) QTest::addRow("%g dB", r[0]) << r[0] << r[1] << r[2] << r[3];
    }
    void bitErrors() {
        QFETCH(double, sinr);
        QFETCH(double, rate);
        QFETCH(double, bytes26);
        QFETCH(double, bytes47);
        QVERIFY(std::abs(bitErrorRate(sinr) / rate - 1) < 1e-6);
        QVERIFY(std::abs(receptionRate(sinr, 8 * 26) - bytes26) < 1e-4);
        QVERIFY(std::abs(receptionRate(sinr, 8 * 47) - bytes47) < 1e-4);
    }
    void losesOnePercentAtSensitivity() {
        QVERIFY(std::abs(receptionRate(.509, 8 * 26) - .99) < 1e-4);
        QVERIFY(std::abs(receptionRate(.737, 8 * 47) - .99) < 1e-4);
        QVERIFY(std::abs(receptionRate(-94 + 98 - 3.5, 8 * 26) - .99) < 5e-4); // at the mote's sensitivity
    }
    void errorsEndSomewhere() {
        QCOMPARE(receptionRate(30, 1000), 1.);
        QVERIFY(receptionRate(-40, 1000) < 1e-100);
        QVERIFY(bitErrorRate(-100) <= 0.5);
    }
    void airtimes_data() {
        QTest::addColumn<int>("mpdu");
        QTest::addColumn<int>("us");
        for (const auto& [mpdu, us] : {std::pair{5, 352}, {11, 544}, {20, 832}, {41, 1504}, {127, 4256}})
            QTest::addRow("%d", mpdu) << mpdu << us;
    }
    void airtimes() {
        QFETCH(int, mpdu);
        QFETCH(int, us);
        QCOMPARE(airtimeUs(static_cast<std::uint32_t>(mpdu), 250000), static_cast<std::int64_t>(us));
    }
    void linkQualityHasItsRange() {
        QCOMPARE(linkQuality(100), 110);
        QCOMPARE(linkQuality(0), 50);
        QVERIFY(linkQuality(5) > linkQuality(4));
    }
    void framesCheckThemselves() {
        const std::vector<std::uint8_t> ack = ackFrame(7);
        QCOMPARE(ack.size(), std::size_t{kAckBytes});
        const std::uint8_t payload[] = {1, 2, 3};
        const std::vector<std::uint8_t> data = dataFrame(0x1234, 0xffff, 9, false, payload);
        QCOMPARE(data.size(), 3 + std::size_t{kFrameOverhead});
        const std::vector<std::uint8_t> head{0x41, 0x88, 9, 0x22, 0, 0xff, 0xff, 0x34, 0x12, 1, 2, 3};
        QVERIFY(std::equal(head.begin(), head.end(), data.begin()));
        for (const auto& frame : {ack, data}) { // the CRC over a frame and its own check sequence is 0
            std::uint16_t crc = 0;
            for (const std::uint8_t byte : frame) {
                crc = static_cast<std::uint16_t>(crc ^ byte);
                for (int i = 0; i < 8; ++i) crc = static_cast<std::uint16_t>(crc & 1 ? (crc >> 1) ^ 0x8408 : crc >> 1);
            }
            QCOMPARE(crc, std::uint16_t{0});
        }
    }
    void capturesHaveTheirHead() {
        std::string bytes;
        beginPcap(bytes);
        QCOMPARE(bytes.size(), std::size_t{24});
        QCOMPARE(bytes.substr(0, 4), std::string("\xd4\xc3\xb2\xa1"));
        QCOMPARE(static_cast<unsigned char>(bytes[20]), static_cast<unsigned char>(195));
        addToPcap({1.000250, 0, ackFrame(1)}, bytes);
        QCOMPARE(bytes.size(), std::size_t{24 + 16 + 5});
        QCOMPARE(static_cast<int>(bytes[24]), 1);
        QCOMPARE(static_cast<unsigned char>(bytes[28]), static_cast<unsigned char>(250));
        QCOMPARE(static_cast<int>(bytes[32]), 5);
    }
};

QTEST_APPLESS_MAIN(Ieee802154Test)
#include "ieee802154_test.moc"
