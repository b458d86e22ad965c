// Unsaved changes in the window: modified files by name, where they are saved, and the question about a shared config.

#include <QMessageBox>
#include <QSettings>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QtTest>

#include "editor/document/structure_edits.h"
#include "editor/properties/editors/value_field.h"
#include "editor/shell/unsaved_files.h"
#include "editor/shell/window_fixture.h"
#include "editor/widgets/name_list.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QByteArray kMain =
    "#import rover.sim\n#import looks.sim\nRobot robot0 { Config=Rover }\nRobot robot1 { Config=Rover Pos=1,0,0 }\n";
const QByteArray kRover = "RobotConfig Rover { Body b { Box hull { Size=0.1,0.1,0.1 Mass=1 } } }\n";
const QByteArray kLooks = "Material red { ColorRGB=1,0,0 }\n";

} // namespace

class UnsavedTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_fixture.start(); }
    void init() {
        QSettings().clear();
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("configs")));
        write("main.sim", kMain);
        write("rover.sim", kRover);
        write("looks.sim", kLooks);
        m_window = m_fixture.window();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kTimeoutMs));
        QVERIFY(m_window->open(path("main.sim")));
        EVENTUALLY(document().isOpen());
        QVERIFY(!document().loaded()->diagnostics.hasErrors());
    }
    void cleanup() {
        while (document().edits().history().canUndo()) document().edits().undo();
        m_window.reset();
    }

    void everyUnsavedFileIsNamed() {
        QCOMPARE(m_window->windowTitle(), QStringLiteral("main.sim[*] – Trundle"));
        QVERIFY(!m_window->isWindowModified());
        QVERIFY(saved().contains(QStringLiteral("saved")) && !saved().contains(QStringLiteral("unsaved")));

        edit("rover.sim"); // the opened file is not modified
        QCOMPARE(m_window->windowTitle(), QStringLiteral("main.sim, rover.sim[*] – Trundle"));
        QVERIFY(m_window->isWindowModified());
        QVERIFY2(saved().contains(QStringLiteral("unsaved: rover.sim<")), qPrintable(saved()));
        QCOMPARE(tabs(), (QStringList{QStringLiteral("main.sim"), QStringLiteral("rover.sim*")}));

        edit("main.sim");
        edit("looks.sim");
        QCOMPARE(m_window->windowTitle(), QStringLiteral("main.sim[*], looks.sim*, rover.sim* – Trundle"));
        QVERIFY2(saved().contains(QStringLiteral("unsaved: main.sim, looks.sim, rover.sim")), qPrintable(saved()));
        QCOMPARE(tabs(), (QStringList{QStringLiteral("main.sim*"), QStringLiteral("rover.sim*"), QStringLiteral("looks.sim*")}));

        const QString asked = question();
        for (const char* name : {"main.sim", "rover.sim", "looks.sim"}) QVERIFY2(asked.contains(QLatin1String(name)), name);
        document().edits().undo(); // undoes the edit of looks.sim
        QVERIFY(!question().contains(QStringLiteral("looks.sim")));
        QVERIFY(document().saving().save().ok());
        QCOMPARE(m_window->windowTitle(), QStringLiteral("main.sim[*] – Trundle"));
        QCOMPARE(tabs(), (QStringList{QStringLiteral("main.sim"), QStringLiteral("rover.sim"), QStringLiteral("looks.sim")}));
    }

    /// Typed without Enter: saved with Ctrl+S, and never lost without a question.
    void whatIsTypedInARowIsSaved() {
        ValueField* field = typeTick("0.02");
        QVERIFY(!document().texts().isModified());
        QTest::keyClick(field, Qt::Key_S, Qt::ControlModifier);
        QVERIFY2(onDisk("main.sim").contains("Tick=0.02") || onDisk("main.sim").contains("Tick = 0.02"),
                 onDisk("main.sim").constData());
        QVERIFY(!document().texts().isModified());
    }

    void closingAsksAboutWhatIsTypedInARow() {
        typeTick("0.02");
        const QString asked = question();
        QVERIFY2(asked.contains(QStringLiteral("main.sim")), qPrintable(asked));
        QVERIFY(document().isOpen());
    }

    /// As on losing the focus: it stays, in red, and the rest is saved.
    void aRefusedValueDoesNotStopSaving() {
        edit("looks.sim");
        ValueField* field = typeTick("1 kg");
        QTest::keyClick(field, Qt::Key_S, Qt::ControlModifier);
        QVERIFY(field->refused());
        QCOMPARE(field->text(), QStringLiteral("1 kg"));
        QVERIFY(onDisk("looks.sim").contains("// more"));
        QVERIFY(!onDisk("main.sim").contains("Tick"));
        field->restore();
    }

    void longListsAreCut() {
        const QStringList names{QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c"), QStringLiteral("d")};
        QCOMPARE(listed(names, 4), QStringLiteral("a, b, c, d"));
        QCOMPARE(listed(names, 2), QStringLiteral("a, b and 2 more"));
    }

    void asksAboutSharedConfig() {
        insert();
        auto* box = m_window->findChild<QMessageBox*>(QStringLiteral("shareQuestion"));
        QVERIFY(box && box->isVisible());
        QVERIFY2(box->text().contains(QStringLiteral("Rover")) && box->text().contains(QStringLiteral("rover.sim")),
                 qPrintable(box->text()));
        QVERIFY2(box->informativeText().contains(QStringLiteral("main.sim")), qPrintable(box->informativeText()));
        QVERIFY(!document().texts().isModified()); // nothing changes before the answer
        box->findChild<QAbstractButton*>(QStringLiteral("makeCopy"))->click();
        QCOMPARE(unsavedFiles(document()), QStringList{QStringLiteral("main.sim")});
        document().edits().undo();
        EVENTUALLY(!m_window->findChild<QMessageBox*>(QStringLiteral("shareQuestion")));
        insert(); // asked only once
        QVERIFY(!m_window->findChild<QMessageBox*>(QStringLiteral("shareQuestion")));
        QCOMPARE(unsavedFiles(document()), QStringList{QStringLiteral("main.sim")});
    }

    void escapeCancelsQuestion() {
        insert();
        auto* box = m_window->findChild<QMessageBox*>(QStringLiteral("shareQuestion"));
        QVERIFY(box);
        QTest::keyClick(box, Qt::Key_Escape);
        QVERIFY(!document().texts().isModified());
        EVENTUALLY(!m_window->findChild<QMessageBox*>(QStringLiteral("shareQuestion")));
        insert();
        box = m_window->findChild<QMessageBox*>(QStringLiteral("shareQuestion"));
        QVERIFY(box);
        box->findChild<QAbstractButton*>(QStringLiteral("changeForAll"))->click();
        QCOMPARE(unsavedFiles(document()), QStringList{QStringLiteral("rover.sim")});
    }

    /// No other file and no other robot uses Single, though it is in a file of its own.
    void aConfigUsedOnceIsNotShared() {
        write("once.sim", "#import single.sim\nRobot robot0 { Config=Single }\n");
        write("single.sim", QByteArray(kRover).replace("Rover", "Single"));
        QVERIFY(m_window->open(path("once.sim")));
        EVENTUALLY(document().path() == path("once.sim").toStdString());
        insert();
        QVERIFY(!m_window->findChild<QMessageBox*>(QStringLiteral("shareQuestion")));
        QCOMPARE(unsavedFiles(document()), QStringList{QStringLiteral("single.sim")});
        document().edits().undo();
        write("twice.sim", "#import single.sim\nRobot other { Config=Single }\n");
        insert();
        QVERIFY(m_window->findChild<QMessageBox*>(QStringLiteral("shareQuestion")));
        QVERIFY(!document().texts().isModified());
    }

    /// The selection stays, except for what an edit inserts, renames or removes.
    void anEditKeepsTheSelection() {
        const auto apply = [this](const StructureEdits::Plan& plan) {
            return document().structure().apply(QStringLiteral("Edit"), {}, plan).ok();
        };
        QVERIFY(document().structure().setValues(QStringLiteral("Set"), {{"robot0.b.hull.Mass", "2"}}, {}).ok());
        m_window->selection().set({"robot1", "robot0"});
        const std::vector<std::string> both = m_window->selection().paths();
        QVERIFY(apply([](const auto& loaded, const auto&) { return planPushOverride(loaded, "robot0.b.hull.Mass"); }));
        QCOMPARE(m_window->selection().paths(), both);
        QVERIFY(apply([](const auto& loaded, const auto&) { return planRemove(loaded, {"robot0"}); }));
        QCOMPARE(m_window->selection().paths(), std::vector<std::string>{"robot1"});
    }

private:
    [[nodiscard]] Document& document() { return m_window->document(); }
    [[nodiscard]] QString path(const char* name) const {
        return QDir(m_folder->path()).canonicalPath() + QStringLiteral("/configs/") + QLatin1String(name);
    }
    void write(const char* name, const QByteArray& bytes) const {
        QFile file(QDir(m_folder->path()).canonicalPath() + QStringLiteral("/configs/") + QLatin1String(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    void edit(const char* name) {
        const std::string file = path(name).toStdString();
        QVERIFY(
            document().edits().replaceText(QStringLiteral("Typing"), file, *document().texts().text(file) + "// more\n").ok());
    }
    /// Without Enter.
    ValueField* typeTick(const char* value) {
        m_window->selection().clear();
        const auto find = [this] {
            const auto* row = m_window->findChild<QWidget*>(QStringLiteral("row.Tick"));
            return row ? row->findChild<ValueField*>() : nullptr;
        };
        if (!QTest::qWaitFor(find, kTimeoutMs)) qFatal("there is no row for Tick");
        ValueField* field = find();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QLatin1String(value));
        return field;
    }
    [[nodiscard]] QByteArray onDisk(const char* name) const {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void insert() {
        QVERIFY(document()
                    .structure()
                    .apply(QStringLiteral("Insert"), {"robot0"},
                           [](const LoadedProject& loaded, const StructureEdits::PathMapping& renamed) {
                               return planInsert(loaded, renamed("robot0"), "Body arm { Sphere ball { Radius=0.1 Mass=1 } }");
                           })
                    .ok());
    }
    [[nodiscard]] QString saved() const { return m_window->findChild<QLabel*>(QStringLiteral("status.saved"))->text(); }
    [[nodiscard]] QStringList tabs() const {
        const auto* tabs = m_window->findChild<QTabWidget*>(QStringLiteral("textTabs"));
        QStringList texts;
        for (int i = 0; i < tabs->count(); ++i) texts += tabs->tabText(i);
        return texts;
    }
    /// The question before the file is closed; it is answered with Cancel.
    [[nodiscard]] QString question() {
        QString asked;
        QTimer::singleShot(0, this, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (!box) return;
            asked = box->text() + QLatin1Char('\n') + box->informativeText();
            box->reject();
        });
        m_window->actions().at("file.close").trigger();
        return asked;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    WindowFixture m_fixture;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(UnsavedTest)
#include "unsaved_test.moc"
