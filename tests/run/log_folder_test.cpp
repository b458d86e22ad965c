// The log folder and the removal of the last run's logs.
#include <filesystem>

#include <QtTest>

#include "run/logs/log_folder.h"

using namespace trundle;

class LogFolderTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_outer;
    std::string folder() const { return m_outer.filePath("logs").toStdString(); }
    static QByteArray contentOf(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(missing)");
    }

private Q_SLOTS:
    void init() { QVERIFY(QDir(m_outer.filePath("logs")).removeRecursively()); }
    void namesThatLeaveTheFolderAreRefused_data();
    void namesThatLeaveTheFolderAreRefused();
    void namesAreCleaned();
    void theFolderIsMadeWhenTheFirstFileIs();
    void oneRunReplacesItsOwnFilesOnly();
    void twoWritersOfOneFileAreRefused();
    void twoRunsInOneFolderAreRefused();
    void linksAreNotFollowed();
    void keepsContentOfHardLink();
    void keepsNonFiles();
    void largeTextsPassThroughTheBuffer();
    void reportsFullDiskOnce();
    void removesLogsOfLastRun();
    void keepsLogsOfAnotherExperiment();
    void aHostileListRemovesNothingElse();
};

void LogFolderTest::namesThatLeaveTheFolderAreRefused_data() {
    QTest::addColumn<QByteArray>("name");
    for (const char* name : {"", "/etc/passwd", "..", "../x.csv", "a/../../x.csv", "a\\..\\x.csv", "\\x.csv", "C:x.csv", "a/",
                             "a/.", ".", "tab\tname.csv"})
        QTest::newRow(*name ? name : "(empty)") << QByteArray(name);
    QTest::newRow("nul inside") << QByteArray("a\0b", 3);
    QTest::newRow("too long") << QByteArray(300, 'a');
}

void LogFolderTest::namesThatLeaveTheFolderAreRefused() {
    QFETCH(QByteArray, name);
    LogFolder logs(folder());
    const Result<LogFile*> file = logs.create(name.toStdString());
    QVERIFY(!file);
    QCOMPARE(file.error().code, Code::LogUnwritable);
    QVERIFY(!QFileInfo::exists(m_outer.filePath("x.csv")));
    QVERIFY(!QFileInfo::exists(m_outer.filePath("logs")));
}

void LogFolderTest::namesAreCleaned() {
    QCOMPARE(cleanLogName("a\\b//./c.csv").value(), std::string("a/b/c.csv"));
    QCOMPARE(cleanLogName("..csv").value(), std::string("..csv"));
}

void LogFolderTest::theFolderIsMadeWhenTheFirstFileIs() {
    LogFolder logs(folder());
    QVERIFY(!QFileInfo::exists(m_outer.filePath("logs")));
    QVERIFY(logs.create("deep/er/x.csv").ok());
    QVERIFY(QFileInfo::exists(m_outer.filePath("logs/deep/er/x.csv")));
}

void LogFolderTest::twoRunsInOneFolderAreRefused() {
    LogFolder first(folder());
    QVERIFY(first.create("x.csv").ok());
    first.files().front()->write("first");
    LogFolder second(folder()), elsewhere(folder() + "/below");
    const Result<LogFile*> refused = second.create("y.csv");
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, Code::LogUnwritable);
    QVERIFY2(refused.error().message.starts_with("cannot write " + folder() + ": another run writes its logs there"),
             refused.error().message.c_str());
    QVERIFY(elsewhere.create("x.csv").ok());
    QVERIFY(first.create("z.csv").ok());
    first.release();
    QVERIFY(second.create("y.csv").ok());
}

void LogFolderTest::oneRunReplacesItsOwnFilesOnly() {
    {
        LogFolder first(folder());
        first.create("mine.csv").value()->write("a long old text");
        first.create("other.csv").value()->write("stays");
    }
    LogFolder second(folder());
    LogFile* mine = second.create("mine.csv").value();
    mine->write("new");
    QVERIFY(mine->close().ok());
    QCOMPARE(contentOf(m_outer.filePath("logs/mine.csv")), QByteArray("new"));
    QCOMPARE(contentOf(m_outer.filePath("logs/other.csv")), QByteArray("stays"));
}

void LogFolderTest::twoWritersOfOneFileAreRefused() {
    LogFolder logs(folder());
    QVERIFY(logs.create("a/x.csv").ok());
    QVERIFY(!logs.create("a//./x.csv").ok());
    QVERIFY(!logs.create("a").ok());
}

void LogFolderTest::linksAreNotFollowed() {
    QVERIFY(QDir(m_outer.path()).mkpath("logs"));
    QVERIFY(QDir(m_outer.path()).mkpath("outside"));
    QVERIFY(QFile::link(m_outer.filePath("outside"), m_outer.filePath("logs/way")));
    QVERIFY(QFile::link(m_outer.filePath("outside/target.csv"), m_outer.filePath("logs/x.csv")));
    LogFolder logs(folder());
    QVERIFY(!logs.create("way/x.csv").ok());
    QVERIFY(!logs.create("x.csv").ok());
    QVERIFY(QDir(m_outer.filePath("outside")).isEmpty());
}

void LogFolderTest::keepsContentOfHardLink() {
    QVERIFY(QDir(m_outer.path()).mkpath("logs"));
    QFile precious(m_outer.filePath("precious"));
    QVERIFY(precious.open(QIODevice::WriteOnly));
    precious.write("precious");
    precious.close();
    std::error_code failed;
    std::filesystem::create_hard_link(m_outer.filePath("precious").toStdString(), folder() + "/x.csv", failed);
    QVERIFY(!failed);
    LogFolder logs(folder());
    logs.create("x.csv").value()->write("log");
    QCOMPARE(contentOf(m_outer.filePath("precious")), QByteArray("precious"));
}

void LogFolderTest::keepsNonFiles() {
    QVERIFY(QDir(m_outer.path()).mkpath("logs/x.csv"));
    LogFolder logs(folder());
    QVERIFY(!logs.create("x.csv").ok());
    QVERIFY(QFileInfo(m_outer.filePath("logs/x.csv")).isDir());
}

void LogFolderTest::largeTextsPassThroughTheBuffer() {
    LogFolder logs(folder());
    LogFile* file = logs.create("big.csv").value();
    QByteArray expected;
    for (int i = 0; i < 3000; ++i) {
        const QByteArray line = QByteArray::number(i).repeated(i % 50 + 1) + "\n";
        expected += line;
        file->write(line.toStdString());
    }
    const QByteArray huge(200'000, 'x');
    expected += huge;
    file->write(huge.toStdString());
    QVERIFY(file->close().ok());
    QCOMPARE(contentOf(m_outer.filePath("logs/big.csv")), expected);
}

void LogFolderTest::reportsFullDiskOnce() {
    std::FILE* full = std::fopen("/dev/full", "wb");
    if (!full) QSKIP("no /dev/full here");
    std::setvbuf(full, nullptr, _IONBF, 0);
    LogFile file("x.csv", "logs/x.csv", full);
    file.write(std::string(100'000, 'x'));
    QVERIFY(file.failure().has_value());
    QCOMPARE(file.failure()->code, Code::LogUnwritable);
    QVERIFY(file.failure()->message.find("logs/x.csv") != std::string::npos);
    file.write("more"); // nothing happens
    QVERIFY(!file.close().ok());
}

void LogFolderTest::removesLogsOfLastRun() {
    for (const QStringList& names : {QStringList{"a.csv", "b.csv"}, QStringList{"b.csv", "c.csv"}}) {
        LogFolder logs(folder());
        for (const QString& name : names) QVERIFY(logs.create(name.toStdString()).ok());
        QFile own(m_outer.filePath("logs/notes.txt"));
        QVERIFY(own.open(QIODevice::WriteOnly));
        for (const auto& file : logs.files()) QVERIFY(file->close().ok());
        logs.settle();
    }
    QCOMPARE(QDir(m_outer.filePath("logs")).entryList(QDir::Files), QStringList({"b.csv", "c.csv", "notes.txt"}));
    LogFolder(folder()).settle(); // a run without logs removes those of the last run
    QCOMPARE(QDir(m_outer.filePath("logs")).entryList(QDir::Files | QDir::Hidden), QStringList({"notes.txt"}));
    QVERIFY(!LogFolder(folder()).create(".trundle-logs").ok());
}

/// Two texts have the same name and so the same folder: a run deletes only what the same text's run before it has written.
void LogFolderTest::keepsLogsOfAnotherExperiment() {
    const auto run = [this](const std::string& experiment, const QStringList& names) {
        LogLocation location = folder();
        location.experiment = experiment;
        LogFolder logs(location);
        for (const QString& name : names)
            if (LogFile* file = logs.create(name.toStdString()).value(); !file || !file->close().ok())
                return QStringList("failed");
        logs.settle();
        return QDir(m_outer.filePath("logs")).entryList(QDir::Files);
    };
    QCOMPARE(run("/a/my.sim", {"a.csv", "old.csv"}), QStringList({"a.csv", "old.csv"}));
    QCOMPARE(run("/a/my.sim", {"a.csv"}), QStringList({"a.csv"}));
    QCOMPARE(run("/b/my.sim", {}), QStringList({"a.csv"}));
    QCOMPARE(run("/a/my.sim", {"other.csv"}), QStringList({"other.csv"}));
    QCOMPARE(run("/b/my.sim", {"b.csv"}), QStringList({"b.csv", "other.csv"}));
    QCOMPARE(run("/b/my.sim", {"c.csv"}), QStringList({"c.csv", "other.csv"}));
    QCOMPARE(run("/a/my.sim", {"a.csv"}), QStringList({"a.csv", "c.csv", "other.csv"}));
    QVERIFY(logsOf("/p", "/p/x/my.sim").experiment != logsOf("/p", "/p/y/my.sim").experiment);
    QCOMPARE(logsOf("/p", "/p/x/my.sim").experiment, logsOf("/q", "/p/y/../x/my.sim", "/elsewhere").experiment);
}

void LogFolderTest::aHostileListRemovesNothingElse() {
    QVERIFY(QDir(m_outer.path()).mkpath("logs/sub"));
    const auto write = [this](const QString& name, const QByteArray& text) {
        QFile file(m_outer.filePath(name));
        return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
    };
    for (const char* name : {"x", "target", "logs/sub/x"}) QVERIFY(write(name, "precious"));
    QVERIFY(QFile::link(m_outer.filePath("target"), m_outer.filePath("logs/way")));
    QVERIFY(write("logs/old.csv", "old"));
    QVERIFY(write("logs/.trundle-logs", "logs of the last run, removed by the next\n../x\n" + m_outer.filePath("x").toUtf8() +
                                            "\nsub/x\nsub\nway\n.\n..\n\n./old.csv\nold.csv\n" + QByteArray("a\0b", 3) +
                                            "\nno end"));
    LogFolder(folder()).settle();
    for (const char* name : {"x", "target", "logs/sub/x"}) QCOMPARE(contentOf(m_outer.filePath(name)), QByteArray("precious"));
    QVERIFY(QFileInfo(m_outer.filePath("logs/way")).isSymLink());
    QVERIFY(!QFileInfo::exists(m_outer.filePath("logs/old.csv")));

    // The list itself is a symbolic link: neither read nor written through.
    QVERIFY(write("elsewhere", "logs of the last run, removed by the next\nmine.csv\n"));
    QVERIFY(write("logs/mine.csv", "precious"));
    QVERIFY(QFile::link(m_outer.filePath("elsewhere"), m_outer.filePath("logs/.trundle-logs")));
    LogFolder logs(folder());
    QVERIFY(logs.create("new.csv").ok());
    logs.settle();
    QCOMPARE(contentOf(m_outer.filePath("logs/mine.csv")), QByteArray("precious"));
    QVERIFY(contentOf(m_outer.filePath("elsewhere")).endsWith("mine.csv\n"));
}

QTEST_APPLESS_MAIN(LogFolderTest)
#include "log_folder_test.moc"
