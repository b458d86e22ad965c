// Recovery journals of unsaved texts, and the lock of a project.

#include <QTest>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include <sys/wait.h>
#include <unistd.h>

#include <QTemporaryDir>

#include "base/platform/read_file.h"
#include "project/journal/journal.h"
#include "project/journal/journal_record.h"
#include "project/journal/project_lock.h"
#include "project/journal/state_folder.h"

using namespace trundle;
namespace fs = std::filesystem;

namespace {

SharedText shared(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

std::string bytesOf(const std::string& path) {
    const auto bytes = readRegularFile(path);
    return bytes ? bytes.value() : std::string();
}

void write(const std::string& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

std::size_t entriesIn(const fs::path& folder) {
    std::error_code none;
    std::size_t count = 0;
    for (fs::recursive_directory_iterator at(folder, none), end; !none && at != end; at.increment(none)) ++count;
    return count;
}

} // namespace

class JournalTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_dir = std::make_unique<QTemporaryDir>();
        m_folder = fs::canonical(m_dir->path().toStdString()).string();
        qputenv("XDG_STATE_HOME", QByteArray::fromStdString(m_folder + "/state"));
        m_project = m_folder + "/project";
        fs::create_directories(m_project + "/.trundle");
    }

    void findsJournalAfterCrash() {
        leave("base\n", {"base 1\n", "base 12\n", "\xff\0 any bytes"});
        const auto found = findRecoveries(m_project);
        QCOMPARE(found.size(), 1u);
        QCOMPARE(found[0].head.opened, m_project + "/main.sim");
        QCOMPARE(found[0].files.size(), 1u);
        QCOMPARE(found[0].files.at("a.sim").base, "base\n");
        QCOMPARE(found[0].files.at("a.sim").text, std::string("\xff"));
        QVERIFY(found[0].time > 1700000000);
        discardRecovery(found[0]);
        QVERIFY(findRecoveries(m_project).empty());
        QCOMPARE(entriesIn(journals()), 0u);
        QCOMPARE(entriesIn(m_project + "/.trundle"), 0u);
    }

    /// However often a large text is changed, its journal stays small, and gives the last text.
    void manyChangesLeaveASmallFile() {
        const std::string base(100'000, 'b');
        std::string text = base;
        std::uint64_t largest = 0;
        int shrunk = 0;
        {
            Journal journal(m_project, {m_project + "/main.sim", {}});
            std::uint64_t before = 0;
            for (int i = 0; i < 120; ++i) {
                text.assign(100'000, char('a' + i % 7));
                QVERIFY(journal.note("a.sim", shared(base), shared(text)).ok());
                const std::uint64_t size = fs::file_size(journal.file()->path());
                shrunk += size < before;
                before = size;
                largest = std::max(largest, size);
            }
        }
        QVERIFY2(largest < 3'000'000, std::to_string(largest).c_str()); // 2 * (1 MiB + twice both texts), and one change
        QVERIFY2(shrunk >= 3, std::to_string(shrunk).c_str());
        const auto found = findRecoveries(m_project);
        QCOMPARE(found.size(), std::size_t{1});
        QVERIFY(found[0].files.at("a.sim").base == base && found[0].files.at("a.sim").text == text);
    }

    void newestFirst() {
        leave("base\n", {"text"}); // now
        for (const std::int64_t time : {1'500'000'000, 1'100'000'000, 1'300'000'000, 1'400'000'000, 1'200'000'000}) {
            const std::string at = std::to_string(time);
            write(journals() + "/" + at + ".journal",
                  std::string(kJournalMark) +
                      journalBytes({JournalRecord::Head, {m_project + "/main.sim", "", "1", "1", thisProcess().host}}) +
                      journalBytes({JournalRecord::Begin, {"a.sim", "base", at}}) +
                      journalBytes({JournalRecord::Change, {"a.sim", "0", "4", "text", at}}));
        }
        std::vector<std::int64_t> times;
        for (const Recovery& recovery : findRecoveries(m_project)) times.push_back(recovery.time / 100'000'000);
        QCOMPARE(times.size(), std::size_t(6));
        QVERIFY(std::ranges::is_sorted(times, std::greater()));
        QCOMPARE(times.back(), 11);
    }

    void ignoresJournalOfLiveWindow() {
        Journal journal(m_project, {m_project + "/main.sim", {}});
        QVERIFY(journal.note("a.sim", shared("base"), shared("text")).ok());
        QVERIFY(findRecoveries(m_project).empty());
    }

    void savingClearsJournal() {
        {
            Journal journal(m_project, {m_project + "/main.sim", {}});
            QVERIFY(journal.note("a.sim", shared("a"), shared("a1")).ok());
            QVERIFY(journal.note("b.sim", shared("b"), shared("b1")).ok());
            QVERIFY(journal.forget("a.sim").ok());
            QVERIFY(!journal.holds("a.sim"));
        }
        const auto found = findRecoveries(m_project);
        QCOMPARE(found.size(), 1u);
        QCOMPARE(found[0].files.size(), 1u);
        QCOMPARE(found[0].files.at("b.sim").text, "b1");
    }

    void lastSaveRemovesJournal() {
        Journal journal(m_project, {m_project + "/main.sim", {}});
        QVERIFY(journal.note("a.sim", shared("a"), shared("a1")).ok());
        QVERIFY(entriesIn(journals()) > 0);
        QVERIFY(journal.forget("a.sim").ok());
        QCOMPARE(entriesIn(journals()), 0u);
        QVERIFY(journal.note("a.sim", shared("a1"), shared("a2")).ok());
        QVERIFY(entriesIn(journals()) > 0);
        QCOMPARE(entriesIn(m_project + "/.trundle"), 0u);
    }

    void aSaveInBetweenIsANewBase() {
        {
            Journal journal(m_project, {m_project + "/main.sim", {}});
            QVERIFY(journal.note("a.sim", shared("one"), shared("two")).ok());
            QVERIFY(journal.note("a.sim", shared("two"), shared("three")).ok());
        }
        const auto found = findRecoveries(m_project);
        QCOMPARE(found.at(0).files.at("a.sim").base, "two");
        QCOMPARE(found.at(0).files.at("a.sim").text, "three");
    }

    // A crash may truncate the file anywhere: everything before the cut is restored, and nothing else.
    void brokenTailsAreCut() {
        const std::vector<std::string> texts{"base 1\n", "base 12\n", "base 123\n", "bose 123\n"};
        const std::string bytes = leave("base\n", texts);
        std::size_t most = 0;
        for (std::size_t length = 0; length <= bytes.size(); ++length) {
            const auto read = readJournal(std::string_view(bytes).substr(0, length));
            if (!read) continue;
            const std::string& text = read->files.at("a.sim").text;
            const auto which = static_cast<std::size_t>(std::find(texts.begin(), texts.end(), text) - texts.begin());
            QVERIFY(which < texts.size());
            QVERIFY(which >= most);
            most = which;
        }
        QCOMPARE(most, texts.size() - 1);
    }

    void damagedBytesAreNoText() {
        const std::vector<std::string> texts{"base 1\n", "base 12\n", "base 123\n"};
        const std::string bytes = leave("base\n", texts);
        for (std::size_t at = 0; at < bytes.size(); ++at) {
            std::string damaged = bytes;
            damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
            if (const auto read = readJournal(damaged))
                QVERIFY(std::find(texts.begin(), texts.end(), read->files.at("a.sim").text) != texts.end());
        }
    }

    // A complete record with a correct checksum that does not fit the text: nothing from it on is used.
    void recordsThatDoNotFitAreCut_data() {
        using Fields = std::vector<std::string>;
        QTest::addColumn<char>("kind");
        QTest::addColumn<Fields>("fields");
        const auto change = [](const char* name, Fields fields) {
            QTest::newRow(name) << char(JournalRecord::Change) << std::move(fields);
        };
        change("begins behind the end", {"a.sim", "6", "0", "x", "3"});
        change("ends behind the end", {"a.sim", "2", "4", "x", "3"});
        change("a length that overflows", {"a.sim", "2", "18446744073709551615", "x", "3"});
        change("a negative place", {"a.sim", "-1", "0", "x", "3"});
        change("no number", {"a.sim", "two", "0", "x", "3"});
        change("another file", {"b.sim", "0", "0", "x", "3"});
        change("a field is missing", {"a.sim", "0", "0", "x"});
        change("no time", {"a.sim", "0", "0", "x", "soon"});
        QTest::newRow("an unknown kind") << 'X' << Fields{"a.sim"};
        QTest::newRow("a beginning without a text") << char(JournalRecord::Begin) << Fields{"b.sim"};
        QTest::newRow("forgets two files") << char(JournalRecord::Forget) << Fields{"a.sim", "b.sim"};
    }
    void recordsThatDoNotFitAreCut() {
        QFETCH(const char, kind);
        QFETCH(const std::vector<std::string>, fields);
        const auto with = [&](const JournalRecord& third) {
            std::string bytes(kJournalMark);
            for (const JournalRecord& record : {JournalRecord{JournalRecord::Head, {"main.sim", "", "1", "1", "host"}},
                                                JournalRecord{JournalRecord::Begin, {"a.sim", "12345", "1"}},
                                                JournalRecord{JournalRecord::Change, {"a.sim", "0", "1", "I", "2"}}, third,
                                                JournalRecord{JournalRecord::Change, {"a.sim", "4", "1", "V", "4"}}})
                bytes += journalBytes(record);
            return readJournal(bytes);
        };
        const auto whole = with({JournalRecord::Change, {"a.sim", "2", "3", "iii", "3"}}), cut = with({kind, fields});
        QVERIFY(whole && cut);
        QCOMPARE(whole->files.at("a.sim").text, std::string("I2iiV"));
        QCOMPARE(cut->files.at("a.sim").text.substr(0, 5),
                 kind == JournalRecord::Change && fields.back() == "soon" ? std::string("xI234") : std::string("I2345"));
        QCOMPARE(cut->time, std::int64_t(2));
    }

    void readsAnyBytes() {
        std::mt19937 random(1);
        for (int round = 0; round < 2000; ++round) {
            std::string bytes = "TRUNDLE JOURNAL 1\n";
            for (std::uint32_t count = random() % 200; count > 0; --count) bytes += static_cast<char>(random() % 256);
            QVERIFY(!readJournal(bytes));
        }
        fs::create_directories(journals() + "/folder.journal");
        write(journals() + "/empty.journal", "");
        QVERIFY(findRecoveries(m_project).empty());
    }

    void removesEmptyJournalsAfterADay() {
        const std::string folder = journals();
        fs::create_directories(folder);
        for (const char* name : {"/old.journal", "/old.journal.new", "/young.journal"})
            write(folder + name, "TRUNDLE JOURNAL 1\n");
        for (const char* name : {"/old.journal", "/old.journal.new"})
            fs::last_write_time(folder + name, fs::file_time_type::clock::now() - std::chrono::hours(25));
        QVERIFY(findRecoveries(m_project).empty());
        QCOMPARE(entriesIn(folder), 1u);
        QVERIFY(fs::exists(folder + "/young.journal"));
    }

    void aLongDayStaysSmall() {
        std::string path;
        {
            Journal journal(m_project, {m_project + "/main.sim", {}});
            std::string text(20000, 'x');
            for (int edit = 0; edit < 300; ++edit) {
                text.assign(20000, static_cast<char>('a' + edit % 26));
                QVERIFY(journal.note("a.sim", shared("base"), shared(text)).ok());
            }
            path = journal.file()->path();
            QVERIFY(fs::file_size(path) < 4u << 20);
            QVERIFY(findRecoveries(m_project).empty()); // the lock is still held
        }
        const auto found = findRecoveries(m_project);
        QCOMPARE(found.size(), 1u);
        QCOMPARE(found[0].files.at("a.sim").text, std::string(20000, static_cast<char>('a' + 299 % 26)));
    }

    void aPlainFolderStaysPlain() {
        const std::string plain = m_folder + "/plain";
        fs::create_directories(plain);
        {
            Journal journal(plain, {plain + "/main.sim", {}});
            QVERIFY(journal.note("a.sim", shared("a"), shared("b")).ok());
            const ProjectLock lock(plain, plain + "/main.sim");
            QVERIFY(lock.taken());
            QCOMPARE(entriesIn(plain), 0u);
        }
        QCOMPARE(findRecoveries(plain).size(), 1u);
    }

    void aFolderThatCannotBeWritten() {
        write(m_folder + "/state", "a file where a folder should be");
        Journal journal(m_project, {m_project + "/main.sim", {}});
        const Status noted = journal.note("a.sim", shared("a"), shared("b"));
        QVERIFY(!noted.ok());
        QVERIFY2(noted.error().message.find(m_folder + "/state/") != std::string::npos, noted.error().message.c_str());
        QVERIFY(findRecoveries(m_project).empty());
    }

    void oneWindowForEachProject() {
        auto first = std::make_unique<ProjectLock>(m_project, m_project + "/a.sim");
        QVERIFY(first->taken());
        const ProjectLock second(m_project, m_project + "/b.sim");
        QVERIFY(!second.taken());
        QCOMPARE(second.holder().opened, m_project + "/a.sim");
        QCOMPARE(second.holder().process, thisProcess());
        QVERIFY(second.holder().description().starts_with("another window (process "));
        first.reset();
        QVERIFY(ProjectLock(m_project, "c").taken());
        QCOMPARE(entriesIn(m_project), 1u); // .trundle itself
    }

    void aLockOfADeadProcessIsNone() {
        ProcessIdentity dead = thisProcess();
        dead.start += 1; // as if this process had reused the process id
        write(m_project + "/.trundle/lock",
              std::to_string(dead.pid) + "\n" + std::to_string(dead.start) + "\n" + dead.host + "\n5\n/x.sim\n");
        QVERIFY(ProjectLock(m_project, "a").taken());
        write(m_project + "/.trundle/lock", "no words of ours \xff\n\n\n");
        QVERIFY(ProjectLock(m_project, "a").taken());
    }

    void ignoresLockOfEndedProcess() {
        const pid_t ended = ::fork();
        if (ended == 0) ::_exit(0);
        siginfo_t how;
        QCOMPARE(::waitid(P_PID, id_t(ended), &how, WEXITED | WNOWAIT), 0); // it stays a zombie
        write(m_project + "/.trundle/lock", std::to_string(ended) + "\n0\n" + thisProcess().host + "\n5\n/x.sim\n");
        QVERIFY(ProjectLock(m_project, "a").taken());
        QCOMPARE(::waitpid(ended, nullptr, 0), ended);
    }

    // Where file locks do not work, the process id in the file decides.
    void respectsLockOfRunningProcess() {
        const auto init = thisProcess();
        write(m_project + "/.trundle/lock", "1\n0\n" + init.host + "\n5\n/x.sim\n");
        const ProjectLock lock(m_project, "a");
        QVERIFY(!lock.taken());
        QCOMPARE(lock.holder().opened, "/x.sim");
    }

    void aLinkInTheLocksPlaceIsNotWritten() {
        write(m_folder + "/precious", "kept");
        fs::create_symlink(m_folder + "/precious", m_project + "/.trundle/lock");
        const ProjectLock lock(m_project, "a");
        QCOMPARE(bytesOf(m_folder + "/precious"), "kept");
    }

    // The project's .trundle folder is a symbolic link to another folder: nothing is written there.
    void aLinkInTheProjectsFolderIsNotUsed() {
        fs::create_directories(m_folder + "/elsewhere");
        write(m_folder + "/elsewhere/lock", "kept");
        write(m_folder + "/elsewhere/probe", "kept");
        fs::remove_all(m_project + "/.trundle");
        fs::create_symlink(m_folder + "/elsewhere", m_project + "/.trundle");
        {
            const ProjectLock lock(m_project, "a");
            QVERIFY(lock.taken());
            QVERIFY(!ProjectLock(m_project, "b").taken()); // the lock is held in another folder instead
        }
        QCOMPARE(bytesOf(m_folder + "/elsewhere/lock"), "kept");
        QCOMPARE(bytesOf(m_folder + "/elsewhere/probe"), "kept");
    }

    void aHardLinkInTheLocksPlaceIsNotWritten() {
        write(m_folder + "/precious", "kept");
        fs::create_hard_link(m_folder + "/precious", m_project + "/.trundle/lock");
        const ProjectLock lock(m_project, "a");
        QCOMPARE(bytesOf(m_folder + "/precious"), "kept");
    }

    void namesHostileLockHolderInOneLine() {
        write(m_project + "/.trundle/lock", "1\n0\n\x1b[2J<b>" + std::string(500, 'x') + "\xff\n5\n/x.sim\n");
        LockHolder holder;
        holder.process = {1, 0, "\x1b[2J<b>" + std::string(500, 'x') + "\xff"};
        QVERIFY(holder.description().size() < 200);
        QVERIFY(holder.description().find('\x1b') == std::string::npos);
    }

private:
    [[nodiscard]] std::string journals() const { return projectStateFolder(m_project) + "/journal"; }

    /// Bytes of the journal left by a window that recorded these texts one after the other.
    std::string leave(const std::string& base, const std::vector<std::string>& texts) {
        Journal journal(m_project, {m_project + "/main.sim", {}});
        for (const std::string& text : texts)
            if (!journal.note("a.sim", shared(base), shared(text))) return {};
        return bytesOf(journal.file()->path());
    }

    std::unique_ptr<QTemporaryDir> m_dir;
    std::string m_folder, m_project;
};

QTEST_APPLESS_MAIN(JournalTest)
#include "journal_test.moc"
