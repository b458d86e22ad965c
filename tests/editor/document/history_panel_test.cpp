// The History panel: its entries, and going to one of them.
#include <QListWidget>
#include <QTest>

#include "editor/document/history_panel.h"
#include "editor/document/structure_edits.h"
#include "eventually.h"
#include "sample_document.h"

using namespace trundle;
using namespace sample;

class HistoryPanelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_application = makeApplication(); }

    void listsEditsAndMovesToThem() {
        const DocumentFixture fixture;
        Document d(*m_application);
        HistoryPanel panel(d);
        panel.resize(240, 320);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel, kTimeoutMs));
        auto* list = panel.findChild<QListWidget*>(u"historyList"_qs);
        QVERIFY(list);
        QCOMPARE(list->count(), 0);
        QVERIFY(d.opening().open(fixture.main).ok());
        QCOMPARE(names(*list), "Opened");
        QVERIFY(d.structure().setValues(u"Move robot0"_qs, {{"robot0.Pos", "1,0,0"}}).ok());
        QVERIFY(d.structure().setValues(u"Set Tick"_qs, {{"Tick", "5 ms"}}).ok());
        QVERIFY(d.structure().setValues(u"Set Seed"_qs, {{"Seed", "5"}}).ok());
        QCOMPARE(names(*list), "Opened, Move robot0, Set Tick, Set Seed");
        QCOMPARE(list->currentRow(), 3);

        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(1)).center());
        QCOMPARE(d.edits().history().position(), 1u);
        QCOMPARE(list->currentRow(), 1);
        QCOMPARE(d.loaded()->experiment->settings.tick, 0.01);
        QVERIFY(list->item(3)->foreground().color() != list->item(1)->foreground().color()); // undone entries have another colour
        QTest::keyClick(list, Qt::Key_Down);
        QCOMPARE(d.edits().history().position(), 2u);
        QTest::keyClick(list, Qt::Key_Home);
        QCOMPARE(*d.texts().text(fixture.main), kMain);

        QVERIFY(d.structure().setValues(u"Turn robot1"_qs, {{"robot1.HPR", "90,0,0"}}).ok());
        QCOMPARE(names(*list), "Opened, Turn robot1");
        d.opening().close();
        QCOMPARE(list->count(), 0);
    }

    void marksTheStateThatIsSaved() {
        const DocumentFixture fixture;
        Document d(*m_application);
        HistoryPanel panel(d);
        auto* list = panel.findChild<QListWidget*>(u"historyList"_qs);
        const auto saved = [list] {
            std::string rows;
            for (int row = 0; row < list->count(); ++row)
                if (list->item(row)->toolTip().contains(u"Saved"_qs)) rows += std::to_string(row);
            return rows;
        };
        QVERIFY(d.opening().open(fixture.main).ok());
        QCOMPARE(saved(), "0");
        QVERIFY(d.structure().setValues(u"Tick"_qs, {{"Tick", "5 ms"}}).ok());
        QCOMPARE(saved(), "0");
        QVERIFY(d.saving().save().ok());
        QCOMPARE(saved(), "1");
        QVERIFY(d.structure().setValues(u"Seed"_qs, {{"Seed", "5"}}).ok());
        d.edits().moveTo(0);
        QCOMPARE(saved(), "1");
        QVERIFY(
            d.structure().setValues(u"Seed"_qs, {{"Seed", "6"}}).ok()); // the new edit removes the saved state from the history
        QCOMPARE(saved(), "");
        QVERIFY(d.saving().save().ok());
        QCOMPARE(saved(), "1");
        QVERIFY(!list->item(1)->icon().isNull());
        QCOMPARE(list->sizeHintForRow(0), list->sizeHintForRow(1)); // with and without a mark
    }

    void staysWhereTheDocumentStays() {
        const DocumentFixture fixture;
        Document d(*m_application);
        HistoryPanel panel(d);
        auto* list = panel.findChild<QListWidget*>(u"historyList"_qs);
        QVERIFY(d.opening().open(fixture.main).ok());
        QVERIFY(d.structure().setValues(u"Set Tick"_qs, {{"Tick", "5 ms"}}).ok());
        d.opening().openLater(fixture.robot); // while a file is loading neither edits nor undo are possible
        list->setCurrentRow(0);
        QCOMPARE(list->currentRow(), 1);
        EVENTUALLY_EQUAL(d.path(), fixture.robot);
        QCOMPARE(names(*list), "Opened");
    }

private:
    static std::string names(const QListWidget& list) {
        std::string all;
        for (int row = 0; row < list.count(); ++row) all += (row ? ", " : "") + list.item(row)->text().toStdString();
        return all;
    }

    std::unique_ptr<Application> m_application;
};

QTEST_MAIN(HistoryPanelTest)
#include "history_panel_test.moc"
