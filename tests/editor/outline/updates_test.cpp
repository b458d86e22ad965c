// The Scene tree after edits, and its context menu: which rows are reported, kept open, renamed or found again.

#include <QMenu>

#include "editor/outline/outline_rows.h"
#include "outline_fixture.h"
#include "project/edits/plans.h"

using namespace trundle;

namespace {

const QByteArray kTwo = R"(Material paint { ColorRGB=1,0,0 }
RobotConfig Big { Body hub { Box hull { Size=1,1,1 Mass=1 } } Camera eye { Body=hub } }
RobotConfig Small { Body hub { Box hull { Size=1,1,1 Mass=1 } Box cap { Size=1,1,1 Pos=0,0,1 Mass=1 } } Camera eye { Body=hub } }
Robot ro { Config=Big Pos=0,0,0.5 }
Robot rover { Config=Small Pos=3,0,0.5 }
Grid herd { Config=Small Count=2 Spacing=3 Pos=9,0,0.5 }
)";

} // namespace

class OutlineUpdatesTest : public QObject {
    Q_OBJECT

    static bool put(OutlineFixture& w, const QByteArray& text) {
        return w.document.edits()
            .replaceText(QStringLiteral("Type"), w.document.texts().files().front(), text.toStdString())
            .ok();
    }

private Q_SLOTS:
    void changesOfOneRow_data() {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("after");
        QTest::addColumn<QByteArray>("path");
        QTest::newRow("its config") << QByteArray("rover { Config=Small") << QByteArray("rover { Config=Big")
                                    << QByteArray("rover");
        QTest::newRow("its colour") << QByteArray("ColorRGB=1,0,0") << QByteArray("ColorRGB=0,1,0")
                                    << QByteArray("Material.paint");
        QTest::newRow("a problem") << QByteArray("rover { Config=Small") << QByteArray("rover { Config=Small Odd=1")
                                   << QByteArray("rover");
        QTest::newRow("its count") << QByteArray("Count=2") << QByteArray("Count=3") << QByteArray("herd");
    }
    /// The row is reported and shows the new content; the others are not.
    void changesOfOneRow() {
        QFETCH(QByteArray, before);
        QFETCH(QByteArray, after);
        QFETCH(QByteArray, path);
        OutlineFixture w;
        QVERIFY(w.open(kTwo));
        for (const char* open : {"rover", "ro", "Material.paint", "herd"}) QVERIFY(w.at(open).isValid());
        const auto contentOf = [&](const char* at) {
            const QModelIndex row = w.at(at);
            return QStringList{row.data(OutlineModel::DetailRole).toString(),
                               row.data(OutlineModel::ColourRole).value<QColor>().name(),
                               QString::number(row.data(OutlineModel::ErrorsRole).toInt())};
        };
        const QStringList old = contentOf(path.constData()), other = contentOf("ro");
        QSignalSpy changed(&w.model(), &QAbstractItemModel::dataChanged);
        QVERIFY(put(w, QByteArray(kTwo).replace(before, after)));
        QVERIFY(contentOf(path.constData()) != old);
        QCOMPARE(contentOf("ro"), other);
        const auto isReported = [&](const QModelIndex& row) {
            return std::ranges::any_of(changed, [&](const QList<QVariant>& call) {
                const auto first = call[0].toModelIndex(), last = call[1].toModelIndex();
                return first.parent() == row.parent() && first.row() <= row.row() && row.row() <= last.row();
            });
        };
        QVERIFY(isReported(w.at(path.constData())) && !isReported(w.at("ro")));
    }

    /// What is removed and put back has rows again, also as the only child of its row.
    void rowsComeAndGo() {
        OutlineFixture w;
        QVERIFY(w.open(kTwo));
        w.tree().expand(w.at("ro"));
        w.tree().expand(w.at("ro.hub"));
        QVERIFY(w.at("ro.hub.hull").isValid());
        QVERIFY(put(w, QByteArray(kTwo).replace("{ Box hull { Size=1,1,1 Mass=1 } } Camera", "{ } Camera")));
        QCOMPARE(w.model().rowCount(w.at("ro.hub")), 0);
        QVERIFY(put(
            w, QByteArray(kTwo).replace("Box hull { Size=1,1,1 Mass=1 } } Camera", "Sphere ball { Radius=1 Mass=1 } } Camera")));
        QVERIFY(w.at("ro.hub.ball").isValid() && !w.at("ro.hub.hull").isValid());
        QVERIFY(put(w, QByteArray(kTwo).replace("Robot ro {", "Robot z { Config=Big Pos=0,9,1 }\nRobot ro {"))); // before it
        QCOMPARE(w.at("z").row() + 1, w.at("ro").row());
        QVERIFY(w.at("ro.hub.hull").isValid());
    }

    /// A robot by another name keeps its marks and stays open, one whose name begins alike is left alone; another kind is a new one.
    void renamedRows() {
        OutlineFixture w;
        QVERIFY(w.open(kTwo));
        w.marks.setHidden({"ro"}, true);
        w.marks.setLocked({"rover"}, true);
        w.tree().expand(w.at("ro"));
        w.tree().expand(w.at("rover"));
        QVERIFY(put(w, QByteArray(kTwo).replace("Robot ro {", "Robot cart {")));
        QVERIFY(w.marks.isHidden("cart") && !w.marks.isHidden("ro"));
        QVERIFY(w.marks.isLocked("rover") && w.tree().isExpanded(w.at("cart")) && w.tree().isExpanded(w.at("rover")));
        w.document.edits().undo();
        QVERIFY(w.tree().isExpanded(w.at("ro")) && w.tree().isExpanded(w.at("rover")));
        QVERIFY(put(w, QByteArray(kTwo).replace("Robot ro { Config=Big", "Grid flock { Count=2 Spacing=1 Config=Big")));
        QVERIFY(!w.marks.isHidden("flock"));
        QVERIFY(w.open(kTwo)); // nothing is marked there
        QVERIFY(!w.marks.isHidden("ro") && !w.marks.isLocked("rover") && w.filter().text().isEmpty());
    }

    void anotherDocumentIsNotFiltered() {
        OutlineFixture w;
        QVERIFY(w.open(kTwo));
        w.filter().setText(QStringLiteral("cap"));
        QVERIFY(!w.at("ro").isValid());
        QVERIFY(w.open(kTwo));
        QVERIFY(w.filter().text().isEmpty() && w.at("ro").isValid());
    }

    void contextMenus_data() {
        QTest::addColumn<QStringList>("selected");
        QTest::addColumn<QStringList>("hidden");
        QTest::addColumn<QString>("entries"); // those that only some menus have, with what they say
        const auto row = [](const char* selected, const char* hidden, const char* entries) {
            QTest::addRow("%s, hidden: %s", selected, hidden)
                << QString::fromLatin1(selected).split(u' ') << QString::fromLatin1(hidden).split(u' ', Qt::SkipEmptyParts)
                << QString::fromLatin1(entries);
        };
        row("ro", "", "config hide=Hide lock=Lock rename");
        row("ro", "ro", "config hide=Show lock=Lock rename showAll");
        row("ro", "rover", "config hide=Hide lock=Lock rename showAll");
        row("ro rover", "rover", "config hide=Hide lock=Lock rename showAll");
        row("ro rover", "ro rover", "config hide=Show lock=Lock rename showAll");
        row("herd", "", "config hide=Hide lock=Lock rename singles");
        row("herd_1", "", "config hide=Hide lock=Lock singles");
        row("RobotConfig.Big.eye", "", "rename through");
        row("ro.hub", "", "config hide=Hide lock=Lock rename");
        row("Material.paint", "", "rename");
    }
    void contextMenus() {
        QFETCH(QStringList, selected);
        QFETCH(QStringList, hidden);
        OutlineFixture w;
        QVERIFY(w.open(kTwo));
        const auto paths = [](const QStringList& names) {
            std::vector<std::string> all;
            for (const QString& name : names) all.push_back(name.toStdString());
            return all;
        };
        w.marks.setHidden(paths(hidden), true);
        w.selection.set(paths(selected));
        const std::unique_ptr<QMenu> menu(w.panel->contextMenu());
        QStringList entries;
        for (const QAction* action : menu->actions()) {
            const QString name = action->objectName().section(u'.', 1), text = QString(action->text()).remove(u'&');
            if (name == QStringLiteral("hide") || name == QStringLiteral("lock")) entries << name + u'=' + text;
            for (const char* some : {"config", "singles", "through", "showAll", "rename"})
                if (name == QLatin1String(some) && action->isEnabled()) entries << name;
        }
        entries.sort();
        QTEST(entries.join(u' '), "entries");
    }
};

QTEST_MAIN(OutlineUpdatesTest)
#include "updates_test.moc"
