// The rows of the list of problems: what is below a problem, the texts of the columns, and when the list is reset.
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "editor/problems/problem_icons.h"
#include "editor/problems/problems_panel.h"
#include "editor/problems/rows_fixture.h"

using namespace trundle;

class ProblemsModelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Below a problem: its notes, its fixes, and suggestions that no fix has. A row of a fix is that fix, the problem the first.
    void rowsOfAProblem() {
        RowsFixture fixture;
        QVERIFY(fixture.open("Tick = 0.01 // as text\n"));
        Diagnostic plain = problem("plain", {0, {1, 2}}), rich = problem("rich", {0, {3, 4}}, Severity::Warning);
        rich.notes = {{"a note", {0, {7, 8}}}, {"another", {0, {9, 10}}}};
        rich.fixes = {{"one", {TextEdit{{0, {3, 4}}, "x"}}}, {"two", {TextEdit{{0, {3, 4}}, "y"}}}};
        rich.suggestions = {"two", "three", "one", "four"};
        ProblemsModel model;
        model.setLoaded(fixture.document.loaded());
        model.setModelProblems({plain, rich}, fixture.document.loaded());
        const QModelIndex top = model.index(1, 0);
        QStringList texts;
        for (int i = 0; i < model.rowCount(top); ++i) texts << model.index(i, ProblemsModel::Message, top).data().toString();
        QCOMPARE(texts.join(u'|'), QStringLiteral("a note|another|Fix: one|Fix: two|Suggestion: three|Suggestion: four"));
        const auto fixOf = [&](const QModelIndex& index) {
            const Fix* fix = model.fixAt(index);
            return QString::fromStdString(fix ? fix->title : "-");
        };
        QStringList fixes{fixOf(top), fixOf(model.index(0, 0))};
        for (int i = 0; i < model.rowCount(top); ++i) fixes << fixOf(model.index(i, 0, top));
        QCOMPARE(fixes.join(u' '), QStringLiteral("one - - - one two - -"));
        QCOMPARE(model.index(1, ProblemsModel::Place, top).data().toString(), QStringLiteral("main.sim:1:10"));
        QCOMPARE(model.index(2, ProblemsModel::Place, top).data().toString(), QString());
        QCOMPARE(top.siblingAtColumn(ProblemsModel::Place).data().toString(), QStringLiteral("main.sim:1:4"));
        QCOMPARE(model.parent(model.index(3, 0, top)), top);
        QCOMPARE(model.rowCount(model.index(3, 0, top)), 0);
        QCOMPARE(model.rowCount(top.siblingAtColumn(ProblemsModel::Place)), 0);
        QVERIFY(fixture.document.edits().replaceText({}, fixture.document.loaded()->paths[0], "Tick = 0.02\n").ok());
        model.setRun({rich}, model.textsAt(top)); // of texts that have changed since
        model.setLoaded(fixture.document.loaded());
        QCOMPARE(fixOf(model.index(0, 0)), QStringLiteral("-"));
        QCOMPARE(fixOf(model.index(2, 0, model.index(0, 0))), QStringLiteral("-"));
    }

    void textsOfColumns() {
        RowsFixture fixture;
        QVERIFY(fixture.open("Tick = 0.01\n"));
        Diagnostic compiled = problem("of a compiler", {});
        compiled.fixes = {{"x", {TextEdit{{0, {3, 4}}, "x"}}}};
        ProblemsModel model;
        model.setLoaded(fixture.document.loaded());
        model.setRun({problem("of a run", {}, Severity::Hint)}, fixture.document.loaded());
        model.setBuild({compiled}, fixture.document.loaded());
        model.setModelProblems({problem("of all", {}, Severity::Warning)}, fixture.document.loaded());
        const auto rowOf = [&](const char* message) {
            for (int i = 0; i < model.rowCount(); ++i)
                if (model.index(i, 0).data() == QLatin1String(message)) return model.index(i, 0);
            return QModelIndex();
        };
        const auto text = [&](const char* message, int column, int role = Qt::DisplayRole) {
            return rowOf(message).siblingAtColumn(column).data(role).toString();
        };
        const QString code = QString::fromStdString(codeName(Code::OddInertia));
        QCOMPARE(text("of a run", ProblemsModel::CodeColumn), code);
        QCOMPARE(text("of a compiler", ProblemsModel::CodeColumn), QStringLiteral("build"));
        QCOMPARE(text("of a run", ProblemsModel::Place), QStringLiteral("run"));
        QCOMPARE(text("of all", ProblemsModel::Place), QString());
        QCOMPARE(text("of a compiler", ProblemsModel::Place), QString());
        QCOMPARE(text("of all", 0, Qt::ToolTipRole), code + QStringLiteral("  of all"));
        QCOMPARE(text("of a run", 0, Qt::AccessibleTextRole), QStringLiteral("Hint: of a run"));
        QCOMPARE(text("of all", 0, Qt::AccessibleTextRole), QStringLiteral("Warning: of all"));
        QCOMPARE(text("of a compiler", 0, Qt::AccessibleTextRole), QStringLiteral("Error: of a compiler"));
        QCOMPARE(model.rowCount(rowOf("of a compiler")), 0); // without fixes
        const auto colourOf = [](Severity severity) {
            return severityIcon(severity).pixmap(16, 16).toImage().pixelColor(4, 11).rgb();
        };
        QVERIFY(colourOf(Severity::Error) != colourOf(Severity::Warning) &&
                colourOf(Severity::Warning) != colourOf(Severity::Hint));
    }

    /// A run's problems and a compiler's are before those of the texts, wherever their places are.
    void problemsOfARunAreFirst() {
        RowsFixture fixture;
        QVERIFY(fixture.open("Tick = 0.01 // as text\n"));
        ProblemsModel model;
        model.setLoaded(fixture.document.loaded());
        model.setRun({problem("late of run", {0, {9, 10}}), problem("early of run", {0, {5, 6}})}, fixture.document.loaded());
        model.setBuild({problem("of build", {0, {8, 9}})}, fixture.document.loaded());
        model.setModelProblems({problem("of model", {0, {7, 8}}), problem("early", {0, {1, 2}})}, fixture.document.loaded());
        QCOMPARE(messagesOf(model), QByteArray("late of run, early of run, of build, early, of model"));
        model.setFilter(true, true, QStringLiteral("  of  "));
        QCOMPARE(messagesOf(model), QByteArray("late of run, early of run, of build, of model"));
        // What the check has found in the same texts is listed once, at its place.
        model.setFilter(true, true, {});
        model.setRun({problem("of model", {0, {7, 8}})}, fixture.document.loaded());
        QCOMPARE(messagesOf(model), QByteArray("of build, early, of model"));
        model.setRun({problem("of model", {0, {7, 8}})}, nullptr); // of other texts
        QCOMPARE(messagesOf(model), QByteArray("of model, of build, early, of model"));
    }

    void changesOfTheList_data() {
        QTest::addColumn<int>("change");
        QTest::addColumn<bool>("isReset");
        const char* names[] = {"nothing", "place", "message", "severity", "code", "notes"};
        for (int i = 0; i < 6; ++i) QTest::newRow(names[i]) << i << (i > 1);
    }
    /// Rows stay as they are, with what is open and selected, unless the list looks otherwise; then the list is the new one.
    void changesOfTheList() {
        QFETCH(int, change);
        QFETCH(bool, isReset);
        RowsFixture fixture;
        QVERIFY(fixture.open("Tick = 0.01 // as text\n"));
        ProblemsModel model;
        model.setLoaded(fixture.document.loaded());
        model.setModelProblems({problem("one", {0, {1, 2}}), problem("two", {0, {3, 4}})}, fixture.document.loaded());
        Diagnostic other = problem("two", {0, {3, 4}});
        if (change == 1) other.range.range = {5, 6};
        if (change == 2) other.message = "three";
        if (change == 3) other.severity = Severity::Warning;
        if (change == 4) other.code = Code::ControllerFailed;
        if (change == 5) other.notes = {{"a note", {0, {7, 8}}}};
        QSignalSpy reset(&model, &QAbstractItemModel::modelReset), changed(&model, &QAbstractItemModel::dataChanged);
        model.setModelProblems({problem("one", {0, {1, 2}}), other}, fixture.document.loaded());
        QCOMPARE(reset.size() > 0, isReset);
        QCOMPARE(changed.size() > 0, !isReset);
        const QModelIndex row = model.index(1, 0);
        QCOMPARE(row.data().toString(), QString::fromStdString(other.message));
        QCOMPARE(model.placeAt(row).range.begin, other.range.range.begin);
        QCOMPARE(model.rowCount(row), change == 5 ? 1 : 0);
        QCOMPARE(model.warnings(), change == 3 ? 1 : 0);
    }

    /// What the filter hides is said, also if that is warnings alone; another project has none of the run and of builds.
    void emptyLists() {
        RowsFixture fixture;
        ProblemsPanel panel(fixture.document, fixture.selection);
        const auto* none = panel.findChild<QLabel*>(QStringLiteral("noProblems"));
        QCOMPARE(none->text(), QStringLiteral("Nothing is open"));
        QVERIFY(fixture.open("Tick = 0.01\n"));
        QCOMPARE(none->text(), QStringLiteral("No problems"));
        panel.setRunProblems({problem("of a run", {}, Severity::Warning)}, fixture.document.loaded());
        panel.findChild<QToolButton*>(QStringLiteral("showWarnings"))->setChecked(false);
        QCOMPARE(none->text(), QStringLiteral("No problems match the filter"));
        panel.findChild<QToolButton*>(QStringLiteral("showWarnings"))->setChecked(true);
        panel.setBuildProblems({problem("of a build", {})}, fixture.document.loaded());
        QCOMPARE(panel.errors(), 1);
        QCOMPARE(panel.warnings(), 1);
        QVERIFY(fixture.open("Tick = 0.02\n"));
        QCOMPARE(panel.errors() + panel.warnings(), 0);
        QCOMPARE(none->text(), QStringLiteral("No problems"));
    }

    /// On a problem it opens the text, on a fix it applies it; the menu copies the row that it was opened on.
    void returnOnARow() {
        RowsFixture fixture;
        ProblemsPanel panel(fixture.document, fixture.selection);
        QVERIFY(fixture.open("Tikc = 0.01\nDuration = 5\n"));
        auto* view = panel.findChild<QTreeView*>(QStringLiteral("problems"));
        int opened = 0;
        connect(&panel, &ProblemsPanel::jumpTo, this, [&] { ++opened; });
        const auto text = [&] { return *fixture.document.texts().text(fixture.document.loaded()->paths[0]); };
        const std::string before = text();
        const QModelIndex row = view->model()->index(0, 0);
        QVERIFY(view->model()->rowCount(row) > 0);
        view->setCurrentIndex(row);
        QTest::keyClick(view, Qt::Key_Return);
        QCOMPARE(opened, 1);
        QCOMPARE(text(), before);
        for (int i = 0; i < view->model()->rowCount(row); ++i)
            if (const QModelIndex child = view->model()->index(i, 0, row);
                child.data().toString() == QStringLiteral("Fix: Tick")) {
                view->setCurrentIndex(child);
                QTest::keyClick(view, Qt::Key_Return);
                break;
            }
        QCOMPARE(text(), std::string("Tick = 0.01\nDuration = 5\n"));
        QCOMPARE(opened, 1);
    }
};

QTEST_MAIN(ProblemsModelTest)
#include "problems_model_test.moc"
