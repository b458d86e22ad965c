// What Save writes: all files or none, nothing of another program lost, nothing outside the project.
#include <csignal>
#include <fstream>

#include <QTemporaryDir>
#include <QTest>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/platform/read_file.h"
#include "project/saving/file_transaction.h"
#include "project/saving/project_save.h"

using namespace trundle;
namespace fs = std::filesystem;

namespace {

std::string bytesOf(const std::string& path) {
    const Result<std::string> bytes = readRegularFile(path);
    return bytes ? bytes.value() : "(" + bytes.error().message + ")";
}

std::string why(const Status& status) { return status ? "" : status.error().message; }

/// Limits the size of files that this process writes, as a full disk does.
class FileLimit {
public:
    explicit FileLimit(rlim_t bytes) {
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit limit{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
        std::signal(SIGXFSZ, SIG_IGN);
    }
    ~FileLimit() { setrlimit(RLIMIT_FSIZE, &m_before); }

private:
    rlimit m_before{};
};

} // namespace

class SavingTest : public QObject {
    Q_OBJECT

    std::string path(const std::string& name) const { return m_root + "/" + name; }
    std::string write(const std::string& name, const std::string& bytes) const {
        fs::create_directories(fs::path(path(name)).parent_path());
        std::ofstream(path(name), std::ios::binary) << bytes;
        return path(name);
    }
    /// A file of the project with a new text.
    void edit(const std::string& name, const std::string& disk, const std::string& text) {
        m_files.take(write(name, disk), std::make_shared<const std::string>(disk));
        m_files.find(path(name))->text = std::make_shared<const std::string>(text);
    }
    SaveEnvironment environment() {
        SaveEnvironment environment;
        environment.folders = {m_root + "/project"};
        environment.isSample = [this](const std::string& file) { return file == path("project/sample.sim"); };
        environment.shown = [](const std::string& file) { return fs::path(file).filename().string(); };
        environment.loadExternalChange = [this](const std::string& file, SharedText bytes) {
            m_loadedChanges.push_back(fs::path(file).filename().string() + ": " + *bytes);
        };
        environment.writeJournal = [this] { m_diskAtJournal = bytesOf(path("project/a.sim")); };
        return environment;
    }
    Status save() { return ProjectSave(m_files, environment()).save(); }

private Q_SLOTS:
    void init() {
        m_dir = std::make_unique<QTemporaryDir>();
        m_root = fs::canonical(m_dir->path().toStdString()).string();
        m_files.clear();
        m_loadedChanges.clear();
        m_diskAtJournal.clear();
        edit("project/a.sim", "a", "new a");
        edit("project/b.sim", "b", "new b");
    }

    void writesEveryModifiedFile() {
        edit("project/c.sim", "c", "c");
        write("project/c.sim", "not read: it is not modified");
        QCOMPARE(why(save()), "");
        QCOMPARE(bytesOf(path("project/a.sim")) + bytesOf(path("project/b.sim")), std::string("new anew b"));
        QCOMPARE(bytesOf(path("project/c.sim")), std::string("not read: it is not modified"));
        QVERIFY(m_files.modified().empty());
    }

    void writesTheJournalBeforeTheFirstByte() {
        QCOMPARE(why(save()), "");
        QCOMPARE(m_diskAtJournal, std::string("a"));
    }

    /// The second of two files fails while it is written: the first gets its old bytes back.
    void allOrNone() {
        edit("project/b.sim", "b", std::string(40'000, 'b'));
        m_files.find(path("project/b.sim"))->text = std::make_shared<const std::string>(std::string(40'000, 'b'));
        Status saved;
        {
            const FileLimit limit(20'000);
            saved = save();
        }
        QVERIFY2(why(saved).find("b.sim: File too large") != std::string::npos, why(saved).c_str());
        QCOMPARE(bytesOf(path("project/a.sim")) + bytesOf(path("project/b.sim")), std::string("ab"));
        QCOMPARE(m_files.modified().size(), std::size_t(2));
    }

    void aChangeOfAnotherProgramIsLoadedAndNotOverwritten() {
        write("project/b.sim", "theirs");
        QVERIFY2(why(save()).starts_with("b.sim was changed by another program; review"), why(save()).c_str());
        QCOMPARE(m_loadedChanges.front(), std::string("b.sim: theirs"));
        QCOMPARE(bytesOf(path("project/a.sim")) + bytesOf(path("project/b.sim")), std::string("atheirs"));
        QVERIFY(m_diskAtJournal.empty()); // refused before anything was written
    }

    void anUnresolvedConflictIsRefused() {
        m_files.find(path("project/b.sim"))->theirs = std::make_shared<const std::string>("theirs");
        QVERIFY2(why(save()).find("choose which text to keep") != std::string::npos, why(save()).c_str());
        QCOMPARE(bytesOf(path("project/a.sim")), std::string("a"));
    }

    void aDeletedFileIsWrittenAgain() {
        fs::remove(path("project/b.sim"));
        m_files.find(path("project/b.sim"))->gone = true;
        QCOMPARE(why(save()), "");
        QCOMPARE(bytesOf(path("project/b.sim")), std::string("new b"));
        QVERIFY(!m_files.find(path("project/b.sim"))->gone);
    }

    void refusesSamplesAndWhatIsOutside() {
        edit("project/sample.sim", "s", "new s");
        QVERIFY2(why(save()).starts_with("sample.sim is a sample and cannot be overwritten"), why(save()).c_str());
        m_files.remove(path("project/sample.sim"));
        // A link made since the file was opened leads outside of the project, to a file with the same bytes.
        const std::string outside = write("outside.sim", "b");
        fs::remove(path("project/b.sim"));
        fs::create_symlink(outside, path("project/b.sim"));
        QVERIFY2(why(save()).starts_with("b.sim is no longer in the project"), why(save()).c_str());
        QCOMPARE(bytesOf(path("project/a.sim")) + bytesOf(outside), std::string("ab"));
    }

    /// Files that edits created are written first, with their folders; a file whose creation was undone is removed last.
    void createsAndRemoves() {
        m_files.make(path("project/objects/made.sim"));
        m_files.find(path("project/objects/made.sim"))->text = std::make_shared<const std::string>("made");
        edit("project/Undone.sim", "undone", "");
        m_files.find(path("project/Undone.sim"))->made = true;
        QCOMPARE(m_files.inWritingOrder().front(), path("project/objects/made.sim"));
        QCOMPARE(m_files.inWritingOrder().back(), path("project/Undone.sim"));
        QCOMPARE(why(save()), "");
        QCOMPARE(bytesOf(path("project/objects/made.sim")), std::string("made"));
        QVERIFY(!fs::exists(path("project/Undone.sim")));
    }

    /// Root may write everywhere, so another user tries.
    void foldersAndFilesThatAreNotWritable_data() {
        QTest::addColumn<QString>("readOnly");
        QTest::addColumn<QString>("message");
        QTest::newRow("a file") << "project/b.sim"
                                << "b.sim is not writable";
        QTest::newRow("its folder") << "project"
                                    << "the folder of a.sim is not writable";
    }
    void foldersAndFilesThatAreNotWritable() {
        QFETCH(QString, readOnly);
        QFETCH(QString, message);
        for (const char* name : {"", "project", "project/a.sim", "project/b.sim"}) fs::permissions(path(name), fs::perms::all);
        const std::string refused = path(readOnly.toStdString()), answer = path("answer");
        fs::permissions(refused, fs::perms(0555));
        const pid_t child = fork();
        if (child == 0) {
            if (geteuid() == 0 && setresuid(65534, 65534, 65534) != 0) _exit(1);
            std::ofstream(answer) << why(save());
            _exit(0);
        }
        int status = 1;
        waitpid(child, &status, 0);
        fs::permissions(refused, fs::perms::all);
        QCOMPARE(status, 0);
        QVERIFY2(bytesOf(answer).starts_with(message.toStdString()), bytesOf(answer).c_str());
        QCOMPARE(bytesOf(path("project/a.sim")) + bytesOf(path("project/b.sim")), std::string("ab"));
    }

    // --- FileTransaction ---

    void aFailedCopyLeavesNoHalf() {
        const std::string from = write("big", std::string(40'000, 'x')), to = path("deep/copy");
        FileTransaction files;
        {
            const FileLimit limit(20'000);
            QVERIFY(!files.copy(from, to).ok());
        }
        QVERIFY(!fs::exists(to));
        write("deep/copy", "mine");
        QVERIFY(!files.copy(from, to).ok()); // a file that was there before is kept
        QCOMPARE(bytesOf(to), std::string("mine"));
        QCOMPARE(files.rollBack({Code::FileUnwritable, "full"}).message, std::string("full"));
        QCOMPARE(bytesOf(to), std::string("mine"));
    }

    void rollBackRestoresInReverseOrder() {
        const std::string a = write("a", "1"), copy = path("copy"), removed = write("removed", "r");
        FileTransaction files;
        QVERIFY(files.write(a, "2").ok());
        QVERIFY(files.write(a, "3").ok());
        QVERIFY(files.copy(a, copy).ok());
        QVERIFY(files.remove(removed).ok());
        QVERIFY(files.remove(path("never there")).ok());
        QCOMPARE(files.rollBack({Code::FileUnwritable, "why"}).message, std::string("why"));
        QCOMPARE(bytesOf(a), std::string("1"));
        QCOMPARE(bytesOf(removed), std::string("r"));
        QVERIFY(!fs::exists(copy));
    }

    void rollBackSaysWhatItCouldNotRestore() {
        const std::string a = write("folder/a", "1");
        FileTransaction files;
        QVERIFY(files.write(a, "2").ok());
        fs::remove_all(path("folder"));
        const std::string message = files.rollBack({Code::FileUnwritable, "why"}).message;
        QVERIFY2(message.starts_with("why; files already written cannot be restored: cannot write " + a), message.c_str());
    }

    void onlyNewFilesGetTheirFolder() {
        FileTransaction files;
        QVERIFY(!files.write(path("gone/a"), "1").ok());
        QVERIFY(!fs::exists(path("gone")));
        QVERIFY(files.write(path("gone/a"), "1", FileTransaction::MissingFolder::Create).ok());
        QCOMPARE(bytesOf(path("gone/a")), std::string("1"));
    }

private:
    std::unique_ptr<QTemporaryDir> m_dir;
    std::string m_root;
    OpenFiles m_files;
    std::vector<std::string> m_loadedChanges;
    std::string m_diskAtJournal;
};

QTEST_APPLESS_MAIN(SavingTest)
#include "saving_test.moc"
