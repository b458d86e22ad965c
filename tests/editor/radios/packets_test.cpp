// The packet list of the Radio dock: rows, filters, search, details and export.

#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTabBar>
#include <QTableView>
#include <QToolButton>

#include "editor/radios/packet_text.h"
#include "editor/radios/radio_window.h"
#include "editor/widgets/theme.h"
#include "eventually.h"
#include "radio/ieee802154.h"

using namespace trundle;

class RadioPacketsTest : public QObject {
    Q_OBJECT

    std::unique_ptr<RadioWindow> m_window;

    QString cell(int row, PacketModel::Column column) { return m_window->model().index(row, column).data().toString(); }
    int rows() { return m_window->model().rowCount(); }
    /// Counts the matching packets of all that are stored.
    template <class Is> int count(const Is& is) {
        const PacketFilter before = m_window->model().filter();
        m_window->model().setFilter({});
        int n = 0;
        for (int row = 0; row < rows(); ++row) n += is(m_window->model().record(row));
        m_window->model().setFilter(before);
        return n;
    }
    void clickRow(int row, bool twice = false) {
        auto* view = m_window->find<QTableView>("radioFrames");
        view->scrollTo(m_window->model().index(row, 0));
        const QPoint at = view->visualRect(m_window->model().index(row, 1)).center();
        QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, at);
        if (twice) QTest::mouseDClick(view->viewport(), Qt::LeftButton, {}, at);
    }

private Q_SLOTS:
    void bytesAndReasonsInWords() {
        const std::vector<std::uint8_t> bytes{0x00, 0x1f, 0x20, 0x41, 0x7e, 0x7f, 0xff};
        QCOMPARE(hexOf(bytes), QStringLiteral("001f20417e7fff"));
        QCOMPARE(asciiOf(bytes), QStringLiteral(".. A~.."));
        QCOMPARE(dumpOf(bytes), QStringLiteral("0000  00 1f 20 41 7e 7f ff  .. A~.."));
        std::vector<std::uint8_t> many(18);
        for (std::size_t i = 0; i < many.size(); ++i) many[i] = static_cast<std::uint8_t>(0x61 + i);
        QCOMPARE(dumpOf(many), QStringLiteral("0000  61 62 63 64 65 66 67 68 69 6a 6b 6c 6d 6e 6f 70  abcdefghijklmnop\n"
                                              "0010  71 72                                            qr"));
        QVERIFY(dumpOf({}).isEmpty());
        QCOMPARE(decibelText(-70.26), QStringLiteral("-70.3"));
        for (const auto& [margin, expected] :
             {std::pair{-1., Ink::Error}, {2.99, Ink::Error}, {3., Ink::Warning}, {9.99, Ink::Warning}, {10., Ink::Good}})
            QCOMPARE(inkForMargin(margin), ink(expected));
        const AirFrame air{0, 1, std::vector<std::uint8_t>(kFrameOverhead + 2, 7)};
        QCOMPARE(payloadOf(air, false).size(), std::size_t(2));
        QVERIFY(payloadOf(air, true).empty() && payloadOf({0, 1, {1, 2, 3}}, false).empty());

        FrameRecord frame;
        frame.link.power = -97.04;
        frame.sinr = 1.26;
        RadioDefinition receiver;
        receiver.minReceivePower = -94;
        receiver.bufferLimit = 3;
        const std::pair<ReceptionOutcome, const char*> reasons[] = {
            {ReceptionOutcome::Delivered, ""},
            {ReceptionOutcome::NotAddressed, "it is for mote7"},
            {ReceptionOutcome::TooWeak, "-97.0 dBm is 3.0 dB below its MinReceivePower"},
            {ReceptionOutcome::Sending, "it was sending itself, or about to"},
            {ReceptionOutcome::Busy, "it was receiving another frame"},
            {ReceptionOutcome::Collision, "another frame was too strong: SINR 1.3 dB"},
            {ReceptionOutcome::BitErrors, "noise: SINR 1.3 dB"},
            {ReceptionOutcome::BufferFull, "3 packets waited unread, its BufferLimit"},
            {ReceptionOutcome::Duplicate, "a duplicate: its acknowledgement was lost"}};
        QCOMPARE(std::size(reasons), kReceptionOutcomes);
        for (const auto& [outcome, words] : reasons) {
            frame.outcome = outcome;
            QCOMPARE(reasonOf(frame, receiver, QStringLiteral("mote7")), QLatin1String(words));
        }
    }

    void init() { m_window = std::make_unique<RadioWindow>(); }
    void cleanup() { m_window.reset(); }

    void showsHintWithoutRadio() {
        QVERIFY(m_window->open(kStandingRobot));
        QVERIFY(m_window->settled());
        auto* words = m_window->find<QLabel>("radiosEmpty");
        QVERIFY(words->isVisible());
        QVERIFY(words->text().contains(QStringLiteral("▸ Transceiver")));
        QVERIFY(m_window->open(kMotes));
        QVERIFY(m_window->settled());
        QVERIFY(!words->isVisible());
        auto* hint = m_window->find<QLabel>("radioHint");
        QVERIFY(hint->isVisible() && hint->text().contains(QStringLiteral("F5")));
        QVERIFY(!m_window->find<QToolButton>("radioExport")->isEnabled());
    }

    void everySampleWithRadiosHasPackets_data() {
        QTest::addColumn<int>("ticks");
        QTest::newRow("sensor_network_amr.sim") << 300;
        QTest::newRow("directional_antenna.sim") << 300;
        QTest::newRow("network_navigation.sim") << 300;
        QTest::newRow("turn_angle.sim") << 300;
    }
    void everySampleWithRadiosHasPackets() {
        QFETCH(int, ticks);
        const QString sample =
            QStringLiteral(TRUNDLE_SOURCE_DIR "/configs/experiments/") + QLatin1String(QTest::currentDataTag());
        QVERIFY(m_window->document.opening().open(sample.toStdString()).ok());
        QVERIFY(m_window->runTo(std::uint64_t(ticks)));
        QVERIFY(rows() > 10);
        QVERIFY(m_window->panel.budget().report().has_value());
    }

    void rowShowsPacketDetails() {
        QVERIFY(m_window->open(kMotes));
        QVERIFY(m_window->runTo(100));
        const auto expected = m_window->headless(100).trace->records;
        QCOMPARE(std::size_t(rows()), expected.size());
        QSet<QString> reasons;
        for (int row = 0; row < rows(); ++row) {
            const FrameRecord& r = expected[std::size_t(row)];
            QCOMPARE(cell(row, PacketModel::Time), QString::number(r.time, 'f', 6));
            QCOMPARE(cell(row, PacketModel::From) + u'/' + QStringLiteral("radio"),
                     QString::fromStdString(m_window->model().radios()[r.from].path));
            QCOMPARE(cell(row, PacketModel::For), QStringLiteral("all"));
            QCOMPARE(cell(row, PacketModel::Channel), QStringLiteral("26"));
            QCOMPARE(cell(row, PacketModel::Rssi), QString::number(r.rssi));
            QCOMPARE(cell(row, PacketModel::Lqi), QString::number(r.lqi));
            QCOMPARE(cell(row, PacketModel::Margin), QString::number(r.link.power + 94, 'f', 1));
            QCOMPARE(cell(row, PacketModel::Outcome), QString::fromUtf8(outcomeName(r.outcome).data()));
            QCOMPARE(cell(row, PacketModel::Reason).isEmpty(), r.outcome == ReceptionOutcome::Delivered);
            reasons << cell(row, PacketModel::Outcome);
        }
        QVERIFY(reasons.contains(QStringLiteral("too weak")) && reasons.contains(QStringLiteral("buffer full")));
        QCOMPARE(m_window->find<QLabel>("radioCounts")->text(), QStringLiteral("%L1 packets").arg(rows()));
    }

    void outcomesAddUpAndFilter() {
        QVERIFY(m_window->open(kMotes));
        QVERIFY(m_window->runTo(100));
        const auto numberIn = [](const QString& text) {
            QString digits;
            for (const QChar c : text)
                if (c.isDigit()) digits += c;
            return digits.toInt();
        };
        int sum = numberIn(m_window->find<QLabel>("radioInTheAir")->isVisible() ? m_window->find<QLabel>("radioInTheAir")->text()
                                                                                : QString());
        for (std::size_t i = 0; i < kReceptionOutcomes; ++i) {
            auto* button = m_window->panel.findChild<QToolButton*>(QStringLiteral("radioOutcome%1").arg(i));
            if (button->isVisible()) sum += numberIn(button->text());
        }
        QVERIFY(sum > 0);
        QCOMPARE(sum, numberIn(m_window->find<QLabel>("radioSum")->text()));

        const int all = rows(), weak = count([](const FrameRecord&r) { return r.outcome == ReceptionOutcome::TooWeak; }),
                  full = count([](const FrameRecord&r) { return r.outcome == ReceptionOutcome::BufferFull; });
        QVERIFY(weak > 0 && full > 0);
        auto* tooWeak =
            m_window->panel.findChild<QToolButton*>(QStringLiteral("radioOutcome%1").arg(int(ReceptionOutcome::TooWeak)));
        auto* bufferFull =
            m_window->panel.findChild<QToolButton*>(QStringLiteral("radioOutcome%1").arg(int(ReceptionOutcome::BufferFull)));
        QTest::mouseClick(tooWeak, Qt::LeftButton);
        QCOMPARE(rows(), weak);
        QTest::mouseClick(bufferFull, Qt::LeftButton);
        QCOMPARE(rows(), weak + full);
        QVERIFY(m_window->find<QLabel>("radioCounts")->text().contains(QStringLiteral(" of ")));
        QVERIFY(m_window->runTo(150)); // new packets are filtered too
        QCOMPARE(rows(), count([](const FrameRecord& r) {
                     return r.outcome == ReceptionOutcome::TooWeak || r.outcome == ReceptionOutcome::BufferFull;
                 }));
        QTest::mouseClick(tooWeak, Qt::LeftButton);
        QTest::mouseClick(bufferFull, Qt::LeftButton);
        QVERIFY(rows() > all);
    }

    void itFiltersByRadioAndText() {
        QVERIFY(m_window->open(kMotes));
        QVERIFY(m_window->runTo(100));
        const int all = rows();
        auto *from = m_window->find<QComboBox>("radioFrom"), *to = m_window->find<QComboBox>("radioTo");
        QCOMPARE(from->count(), 10);
        from->setFocus();
        QTest::keyClicks(from, QStringLiteral("target"));
        QCOMPARE(from->currentText(), QStringLiteral("target"));
        const auto pathOf = [&](RadioId id) { return m_window->model().radios()[id].path; };
        QCOMPARE(rows(), count([&](const FrameRecord& r) { return pathOf(r.from) == "target/radio"; }));
        QVERIFY(rows() > 0 && rows() < all);
        QTest::keyClicks(to, QStringLiteral("deaf"));
        QCOMPARE(rows(),
                 count([&](const FrameRecord& r) { return pathOf(r.from) == "target/radio" && pathOf(r.to) == "deaf/radio"; }));
        QVERIFY(rows() > 0);
        QTest::keyClick(from, Qt::Key_Home);
        QTest::keyClick(to, Qt::Key_Home);
        QCOMPARE(rows(), all);

        auto* search = m_window->find<QLineEdit>("radioSearch");
        QTest::mouseClick(search, Qt::LeftButton);
        QTest::keyClicks(search, QStringLiteral("motes_4"));
        QCOMPARE(rows(), count([&](const FrameRecord& r) {
                     return pathOf(r.from) == "motes_4/radio" || pathOf(r.to) == "motes_4/radio";
                 }));
        QVERIFY(rows() > 0 && rows() < all);
        search->clear();
        const auto payload = [&](const FrameRecord& r) {
            const AirFrame* frame = m_window->model().capturedFrame(r);
            return frame ? QByteArray(reinterpret_cast<const char*>(frame->bytes.data()) + 9, qsizetype(r.bytes)) : QByteArray();
        };
        const QByteArray reported = payload(m_window->model().record(all - 1));
        QVERIFY(reported.startsWith('\xb1')); // beacon of a mote
        QTest::keyClicks(search, QString::fromLatin1(reported.toHex(' ')));
        QCOMPARE(rows(), count([&](const FrameRecord& r) { return payload(r).contains(reported); }));
        QVERIFY(rows() > 0 && rows() < all);
        search->clear();
        QTest::keyClicks(search, QStringLiteral("nobody"));
        QCOMPARE(rows(), 0);
        QVERIFY(m_window->find<QLabel>("radioHint")->isVisible());
        search->clear();
        QCOMPARE(rows(), all);
    }

    /// Hex digits match from the beginning of a byte, also where they match half a byte before that.
    void hexDigitsMatchWholeBytes() {
        const auto isFound = [](const char* payload, const char* text) {
            const QByteArray bytes = QByteArray::fromHex(payload);
            LiveRadio fresh;
            auto radios = std::make_shared<std::vector<RadioDefinition>>(2);
            radios->at(0).path = "one/radio";
            radios->at(1).path = "two/radio";
            fresh.radios = radios;
            std::vector<std::uint8_t> sent(kFrameOverhead); // 9 bytes of it are before the payload
            sent.insert(sent.begin() + 9, bytes.begin(), bytes.end());
            fresh.frames.push_back({0.5, 0, sent});
            FrameRecord record;
            record.time = 0.5;
            record.from = 0;
            record.to = 1;
            record.bytes = std::uint32_t(bytes.size());
            fresh.records.push_back(record);
            PacketModel model;
            model.add(fresh);
            PacketFilter filter;
            filter.text = QLatin1String(text);
            model.setFilter(filter);
            return model.rowCount() == 1;
        };
        for (const auto& [payload, text] : {std::pair{"0111", "11"},
                                            {"1100", "11"},
                                            {"100000", "0000"},
                                            {"10000000", "00 00"},
                                            {"bb1bb1b1", "b1b1"},
                                            {"aab1", "B1"}})
            QVERIFY2(isFound(payload, text), payload);
        for (const auto& [payload, text] : {std::pair{"0110", "11"}, {"100001", "0000"}, {"0b10", "b1"}, {"00", "0000"}})
            QVERIFY2(!isFound(payload, text), payload);
    }

    void aPacketShowsItsBytes() {
        QVERIFY(m_window->open(kMotes));
        QVERIFY(m_window->runTo(100));
        auto* bytes = m_window->find<QPlainTextEdit>("radioBytes");
        QVERIFY(!bytes->isVisible());
        const int row = rows() / 2;
        clickRow(row);
        const FrameRecord& r = m_window->model().record(row);
        const AirFrame* frame = m_window->model().capturedFrame(r);
        QVERIFY(frame);
        QVERIFY(bytes->isVisible());
        const QByteArray payload(reinterpret_cast<const char*>(frame->bytes.data()) + 9, qsizetype(r.bytes));
        QVERIFY2(bytes->toPlainText().contains(QString::fromLatin1(payload.toHex(' '))), qPrintable(bytes->toPlainText()));
        QVERIFY(m_window->find<QLabel>("radioFacts")->text().contains(QString::fromUtf8(outcomeName(r.outcome).data())));
        // Copied as text, a packet is its row of the log.
        auto* view = m_window->find<QTableView>("radioFrames");
        QTest::keySequence(view, QKeySequence::Copy);
        const QStringList lines = QGuiApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 2);
        QCOMPARE(QString::fromStdString(m_window->model().csv()).split(u'\n')[row + 1], lines[1]);
        QTest::keyClick(view, Qt::Key_Escape);
        QVERIFY(!bytes->isVisible());
    }

    void reportsUnwritableFile() {
        QVERIFY(m_window->open(kMotes));
        QVERIFY(m_window->runTo(20));
        m_window->panel.packets().exportTo(m_window->folder.filePath(QStringLiteral("nowhere/packets.csv")));
        QCOMPARE(m_window->reportOf.size(), std::size_t(1));
        QVERIFY(m_window->reportOf.front().contains(QStringLiteral("cannot write")));
    }

    void aDoubleClickOpensItsLink() {
        QVERIFY(m_window->open(kMotes));
        QVERIFY(m_window->runTo(100));
        auto* from = m_window->find<QComboBox>("radioFrom");
        from->setFocus();
        QTest::keyClicks(from, QStringLiteral("target"));
        clickRow(0, true);
        QCOMPARE(m_window->find<QTabBar>("radioPages")->currentIndex(), int(RadiosPanel::Budget));
        QCOMPARE(m_window->panel.budget().from(), QStringLiteral("target/radio"));
        QCOMPARE(m_window->panel.budget().power(), -3.);
    }

    void itFollowsTheEndUntilOneScrollsUp() {
        QVERIFY(m_window->open(kMotes));
        QVERIFY(m_window->runTo(100));
        QScrollBar* bar = m_window->find<QTableView>("radioFrames")->verticalScrollBar();
        EVENTUALLY(bar->maximum() > 50);
        QCOMPARE(bar->value(), bar->maximum());
        auto* view = m_window->find<QTableView>("radioFrames");
        QWheelEvent up(QPointF(50, 50), view->viewport()->mapToGlobal(QPointF(50, 50)), {}, {0, 1200}, Qt::NoButton, {},
                       Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(view->viewport(), &up);
        const int read = bar->value();
        QVERIFY(read < bar->maximum());
        const int maximum = bar->maximum();
        QVERIFY(m_window->runTo(150));
        EVENTUALLY(bar->maximum() > maximum);
        QCOMPARE(bar->value(), read);
        view->setFocus();
        QTest::keyClick(view, Qt::Key_End, Qt::ControlModifier);
        QCOMPARE(bar->value(), bar->maximum());
        const int further = bar->maximum();
        QVERIFY(m_window->runTo(190));
        EVENTUALLY(bar->maximum() > further);
        QCOMPARE(bar->value(), bar->maximum());
    }

    void dropsOldestAndShowsIt() {
        QVERIFY(m_window->open(kMotes));
        QVERIFY(m_window->runTo(100));
        PacketModel& model = m_window->model();
        const std::size_t before = model.frameCount();
        const FrameRecord one = model.record(0);
        LiveRadio many;
        many.records.assign(PacketModel::kMaxFrames - 10, one);
        for (std::size_t i = 0; i < many.records.size(); ++i) many.records[i].time = 10 + double(i);
        m_window->panel.packets().add(many);
        QCOMPARE(model.frameCount(), PacketModel::kMaxFrames);
        QCOMPARE(model.dropped(), std::uint64_t(before - 10));
        QCOMPARE(rows(), int(PacketModel::kMaxFrames));
        auto* counts = m_window->find<QLabel>("radioCounts");
        QCOMPARE(counts->text(), QStringLiteral("newest 20,000 packets"));
        QVERIFY(counts->toolTip().startsWith(QStringLiteral("%L1 others were dropped").arg(before - 10)));
        QStringList seen;
        for (int width = 1000; width >= 300; width -= 10) { // at any width, nothing is clipped
            m_window->panel.resize(width, 320);
            QTRY_VERIFY2(!counts->isVisible() || counts->width() >= counts->sizeHint().width(),
                         qPrintable(QString::number(width)));
            if (seen.isEmpty() || seen.back() != counts->text()) seen.push_back(counts->text());
        }
        QVERIFY2(seen.contains(QStringLiteral("newest 20,000")), qPrintable(seen.join(u'|')));
        m_window->panel.resize(1000, 320);
        many.droppedRecords = 7; // records lost because they were not fetched in time
        many.records.assign(2 * PacketModel::kMaxFrames, one);
        m_window->panel.packets().add(many);
        QCOMPARE(model.frameCount(), PacketModel::kMaxFrames);
        QCOMPARE(model.dropped(), std::uint64_t(before - 10 + 7 + 2 * PacketModel::kMaxFrames));
        QTest::mouseClick(m_window->find<QToolButton>("radioClear"), Qt::LeftButton);
        QCOMPARE(rows(), 0);
    }
};

QTEST_MAIN(RadioPacketsTest)
#include "packets_test.moc"
