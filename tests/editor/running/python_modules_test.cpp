// Modules in Python, edited here and by other programs, and what a run makes of that.
#include <QSettings>
#include <QSignalSpy>
#include <QtTest>

#include "editor/running/session_fixture.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QByteArray kMind = "import trundle\n"
                         "class Mind(trundle.Controller):\n"
                         "    speed = trundle.field(\"Speed\", 0.5, trundle.number(), \"How fast.\")\n"
                         "    def update(self, since_last):\n"
                         "        self.print(self.speed)\n";
const QByteArray kText = "#import robots/simple_robot.sim\n#loadModule mind.py\nTick = 0.01\n"
                         "Robot rover { Config=SimpleRobot Mind brain { } }\n";

struct Trial : SessionFixture {
    Trial() {
        OpenOptions options;
        options.trust = true;
        document.setOptions(options);
    }
    void write(const QByteArray& text, const char* name = "mind.py") const {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text), text.size());
    }
    [[nodiscard]] const Property* field(const char* name) const {
        const Kind* kind = document.loaded()->registry->find("Mind");
        return kind ? kind->find(name) : nullptr;
    }
    [[nodiscard]] std::string mind() const { return QDir(folder.path()).canonicalPath().toStdString() + "/mind.py"; }
    /// Types a new text of the module, without saving it.
    void edit(const QByteArray& text) {
        QVERIFY(document.edits()
                    .replaceTexts(QStringLiteral("Typing"), {{mind(), std::make_shared<const std::string>(text.toStdString())}})
                    .ok());
    }
    [[nodiscard]] QByteArray onDisk() const {
        QFile file(path("mind.py"));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    [[nodiscard]] bool hasErrors() const { return document.loaded()->diagnostics.hasErrors(); }
};

QByteArray with(QByteArray text, const char* before, const char* after) { return text.replace(before, after); }
const QByteArray kBroken = with(kMind, "self, since_last", "(self, since_last");

} // namespace

class PythonModulesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() { QSettings().clear(); }

    /// No tab has the file, and nothing runs.
    void aChangeOnDiskIsReadAtOnce() {
        Trial p;
        p.write(kMind);
        QVERIFY(p.open(kText) && p.field("Speed") && !p.hasErrors());
        p.write(with(kMind, "\"Speed\"", "\"Pace\""));
        EVENTUALLY(p.field("Pace") && !p.field("Speed"));
        p.write(kBroken);
        EVENTUALLY(p.hasErrors());
        QVERIFY(p.session.source().refusal().contains(QStringLiteral("SyntaxError")));
        p.write(kMind);
        EVENTUALLY(!p.hasErrors() && p.field("Speed"));
    }

    void aFileBesideItThatItImportsIsReadToo() {
        Trial p;
        p.write("DEFAULT = 0.5\n", "helper.py");
        p.write("import helper\n" + with(kMind, "0.5", "helper.DEFAULT"));
        QVERIFY(p.open(kText) && !p.hasErrors());
        p.write("DEFAULT = = 0.5\n", "helper.py");
        EVENTUALLY(p.hasErrors());
        p.write("DEFAULT = 0.25\n", "helper.py");
        EVENTUALLY(!p.hasErrors() && p.field("Speed"));
    }

    /// The folder's name is like the end of a message.
    void theErrorIsAtTheLineOfTheSource_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QByteArray>("line"); // its text
        QTest::newRow("syntax") << kBroken << QByteArray("odd at x.py:1 (y)/mind.py")
                                << QByteArray("def update((self, since_last):");
        QTest::newRow("exception") << with(kMind, "0.5", "1 / 0") << QByteArray("mind.py")
                                   << QByteArray("speed = trundle.field(\"Speed\", 1 / 0, trundle.number(), \"How fast.\")");
        QTest::newRow("method") << with(kMind, ", since_last", "") << QByteArray("mind.py") << QByteArray("def update(self):");
        QTest::newRow("class") << with(kMind, "update", "updated") << QByteArray("mind.py")
                               << QByteArray("class Mind(trundle.Controller):");
    }
    void theErrorIsAtTheLineOfTheSource() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, file);
        QFETCH(QByteArray, line);
        Trial p;
        QVERIFY(QDir(p.folder.path()).mkpath(QFileInfo(p.path(file.constData())).path()));
        p.write(text, file.constData());
        QVERIFY(p.open(with(kText, "mind.py", '"' + file + '"')));
        const ProblemsInCode shown = shownInCode(p.document.loaded()->diagnostics.all(), p.document.loaded());
        QCOMPARE(shown.problems.size(), std::size_t(1));
        const Diagnostic& d = shown.problems[0];
        QVERIFY(d.code == Code::PythonModule && d.notes.size() == 1);
        QCOMPARE(QByteArray::fromStdString(std::string(shown.texts->sources[d.range.file].text->slice(d.range.range))), line);
    }

    void theErrorOfASetupIsAtItsLine() {
        Trial p;
        p.write(kMind + "    def setup(self, robot):\n        robot.motor(\"leftMoter\")\n");
        QVERIFY(p.open(kText));
        ProblemsInCode shown; // as soon as there are some: the run is left then
        const auto take = [&] { shown = p.session.messages().problemsInCode(p.session.results().built); };
        QObject::connect(&p.session.messages(), &RunMessages::problemsChanged, &p.session, take);
        p.session.run();
        EVENTUALLY(!shown.problems.empty());
        QCOMPARE(shown.problems.size(), std::size_t(1));
        const Diagnostic& d = shown.problems[0];
        QVERIFY(d.code == Code::UnknownPort && d.place.line == 7);
        QCOMPARE(std::string(shown.texts->sources[d.range.file].text->bytes().substr(d.range.range.begin, 11)), "robot.motor");
    }

    /// Before the window has seen that the file changed.
    void runReadsAModuleThatDidNotLoad() {
        Trial p;
        p.write(kBroken);
        QVERIFY(p.open(kText) && p.hasErrors());
        QSignalSpy refused(&p.session.messages(), &RunMessages::refused);
        p.session.run();
        QVERIFY(refused.size() == 1 && p.session.state() == RunState::Start);
        p.write(kMind);
        p.session.run();
        QCOMPARE(refused.size(), 1);
        QCOMPARE(p.session.state(), RunState::Building);
        EVENTUALLY(p.tick() > 10);
    }

    void runSavesEditedModulesOnly() {
        Trial p;
        p.write(kMind);
        QVERIFY(p.open(kText));
        const QByteArray edited = with(kMind, "\"Speed\"", "\"Pace\"");
        p.edit(edited);
        const std::string main = p.document.path();
        QVERIFY(
            p.document.edits()
                .replaceTexts(QStringLiteral("Typing"), {{main, std::make_shared<const std::string>(kText.toStdString() + "\n")}})
                .ok());
        QCOMPARE(p.onDisk(), kMind);
        p.session.run();
        QCOMPARE(p.onDisk(), edited);
        QCOMPARE(p.document.texts().modifiedFiles(), std::vector{main});
        QVERIFY(p.session.state() == RunState::Building && p.field("Pace")); // it was read before the run was built
        EVENTUALLY(p.tick() > 10);
    }

    /// Another program has written over the edited line: which text to keep is to be chosen first.
    void whatCannotBeSavedIsSaid() {
        Trial p;
        p.write(kMind);
        QVERIFY(p.open(kText));
        p.edit(with(kMind, "0.5", "0.7"));
        const QByteArray theirs = with(kMind, "0.5", "0.9");
        p.write(theirs);
        QSignalSpy notice(&p.document, &Document::notice);
        p.session.run();
        QCOMPARE(p.onDisk(), theirs);
        QVERIFY(!notice.isEmpty());
        const QString said = notice.last().first().toString();
        QVERIFY2(said.startsWith(QStringLiteral("Runs without the unsaved edits of mind.py: ")), qPrintable(said));
        QVERIFY(p.document.texts().isModified(p.mind()));
        EVENTUALLY(p.tick() > 10);
    }
};

QTEST_MAIN(PythonModulesTest)
#include "python_modules_test.moc"
