// Logs of radios and pictures, which files they write, and what a run warns of.
#include <fstream>

#include <QTemporaryDir>
#include <QtTest>

#include "base/platform/read_file.h"
#include "radio/medium.h"
#include "run/experiment_runner.h"
#include "run/fake_world.h"
#include "run/logs/log_kinds.h"
#include "run/logs/movie_file.h"
#include "run/run_pictures.h"
#include "run/world_warnings.h"

using namespace trundle;

namespace {

/// Robots with radios, all on channel 26 but that of "odd".
class RadioWorld final : public FakeWorld {
public:
    explicit RadioWorld(std::shared_ptr<const ExperimentSpec> experiment = experimentOf({"robot0", "robot1", "odd"}))
        : FakeWorld(std::move(experiment)), m_medium(settings()) {
        int i = 0;
        for (const char* path : {"robot0/radio", "robot1/radio", "odd/radio"}) {
            RadioDefinition d;
            d.path = path;
            d.minReceivePower = -90 - i;
            d.rssiStep = 0;
            if (i == 2) d.channel = 20;
            const RadioId id = m_medium.open(d);
            m_medium.place(id, Pose{Vec3(4. * i++, 0, 1), Quat::Identity()});
        }
        m_medium.setWalls([](RadioId, const Vec3&, RadioId, const Vec3&) { return 2; });
    }
    Medium* medium() const override { return &m_medium; }

private:
    static MediumSettings settings() {
        MediumSettings s;
        s.wallLoss = 1.5;
        return s;
    }
    mutable Medium m_medium;
};

struct Painter final : ImageSource {
    std::optional<Error> failure;
    Result<CameraImage> capture(const std::string&, const SignalBlock&) override {
        if (failure) return *failure;
        CameraImage image;
        image.tick = 3;
        return image;
    }
    Result<CameraImage> view(const std::string& name, std::uint32_t width, std::uint32_t height, const SignalBlock&) override {
        if (failure) return *failure;
        seen = name + " " + std::to_string(width) + "x" + std::to_string(height);
        return CameraImage{};
    }
    Result<std::string> encode(const CameraImage&, const std::string& camera, const std::string& file) override {
        return "image of " + camera + seen + " as " + file;
    }
    std::string seen;
};

QStringList cells(const std::string& csv, int row) { return QString::fromStdString(csv).split('\n').value(row).split(','); }
int rowsOf(const std::string& csv) { return int(std::ranges::count(csv, '\n')); }
std::vector<std::string> messagesOf(const std::vector<Diagnostic>& all) {
    std::vector<std::string> texts;
    for (const Diagnostic& d : all) texts.push_back(d.message);
    return texts;
}

} // namespace

class LogKindsTest : public QObject {
    Q_OBJECT

    static std::unique_ptr<RunLog> logOf(const World& world, const char* kind,
                                         std::map<std::string, ResolvedValue, std::less<>> values) {
        Diagnostics diagnostics;
        return makeLog(logSpec(kind, "log", std::move(values)), world, diagnostics);
    }
    static std::string textOf(RunLog& log, const World& world, double time = 0.5) {
        std::string text;
        log.header(text);
        log.rows(world, time, text);
        return text;
    }

private Q_SLOTS:
    void linkMatrix() {
        const RadioWorld world;
        const std::string csv = textOf(*logOf(world, "LinkMatrix", {}), world);
        QCOMPARE(rowsOf(csv), 3); // both ways between the two on one channel
        QCOMPARE(cells(csv, 0).size(), cells(csv, 1).size());
        const QStringList there = cells(csv, 1), back = cells(csv, 2);
        QCOMPARE(there.mid(0, 6), (QStringList{"0.5", "robot0/radio", "robot1/radio", "4", "0", "0"}));
        QCOMPARE(back.mid(0, 4), (QStringList{"0.5", "robot1/radio", "robot0/radio", "4"}));
        const LinkBudget link = world.medium()->link(0, 1);
        const auto is = [](const QString& cell, double number) { return std::abs(cell.toDouble() - number) < 0.00051; };
        QVERIFY(is(there[6], link.pathLoss) && is(there[7], 0) && is(there[8], 3) && is(there[9], link.power));
        QVERIFY(is(there[10], link.power + 91) && is(back[10], link.power + 90)); // of the receiver
        QCOMPARE(there[6], QString::number(std::round(link.pathLoss * 1000) / 1000, 'g', 10));
    }

    void linksOfChosenRobots() {
        const RadioWorld world;
        const auto rows = [&](std::vector<std::string> robots) {
            return rowsOf(textOf(*logOf(world, "LinkMatrix", {{"Robot", textValue(std::move(robots))}}), world)) - 1;
        };
        QCOMPARE(rows({"robot0", "robot1"}), 2);
        QCOMPARE(rows({"robot*"}), 2);
        QCOMPARE(rows({"robot0"}), 0);
        QCOMPARE(rows({"odd"}), 0);
    }

    /// Of a chosen robot all contacts are logged, whether it is the first or the second of the two.
    void contactsOfChosenRobots() {
        FakeWorld world(experimentOf({"robot1", "robot10", "robot2"}));
        for (const auto& [first, second] : {std::pair("robot1/hull/box", "floor/plane"),
                                            {"robot10/hull/box", "robot1/hull/box"},
                                            {"robot10/hull/box", "robot2/hull/box"}}) {
            WorldContact contact;
            contact.first = first;
            contact.second = second;
            world.touching.push_back(contact);
        }
        const auto seconds = [&](std::vector<std::string> robots) {
            const std::string csv = textOf(*logOf(world, "ContactLog", {{"Robot", textValue(std::move(robots))}}), world);
            QStringList all;
            for (int row = 1; row < rowsOf(csv); ++row) all += cells(csv, row).value(2).section('/', 0, 0);
            return all;
        };
        QCOMPARE(seconds({"robot1"}), (QStringList{"floor", "robot1"}));
        QCOMPARE(seconds({"robot2"}), (QStringList{"robot2"}));
        QCOMPARE(seconds({"robot10"}), (QStringList{"robot1", "robot2"}));
        QCOMPARE(rowsOf(textOf(*logOf(world, "ContactLog", {}), world)), 4);
    }

    void framesOfARadio() {
        const RadioWorld world;
        Medium& medium = *world.medium();
        const auto all = logOf(world, "RadioLog", {}), ofOne = logOf(world, "RadioLog", {{"Robot", textValue({"robot1"})}}),
                   ofOdd = logOf(world, "RadioLog", {{"Robot", textValue({"odd"})}});
        const std::vector<std::uint8_t> bytes(7, 0x55);
        QVERIFY(medium.send(0, bytes, kBroadcastAddress, -3));
        medium.advance(10'000);
        QVERIFY(medium.send(1, bytes, medium.radio(0).address, 0));
        medium.advance(20'000);
        const std::string csv = textOf(*all, world);
        QCOMPARE(rowsOf(csv), 3);
        const QStringList head = cells(csv, 0), first = cells(csv, 1), second = cells(csv, 2);
        QCOMPARE(head.mid(0, 7), (QStringList{"time [s]", "from", "to", "kind", "addressed to", "sequence", "bytes"}));
        QVERIFY(head.size() == 19 && first.size() == 19);
        const auto at = [&](const QStringList& row, const char* name) { return row[head.indexOf(name)]; };
        QCOMPARE(first.mid(0, 7), (QStringList{"0", "robot0/radio", "robot1/radio", "data", "all", "0", "7"}));
        QCOMPARE(second.mid(1, 3), (QStringList{"robot1/radio", "robot0/radio", "data"}));
        QCOMPARE(at(second, "addressed to"), QString::number(medium.radio(0).address));
        QVERIFY(at(first, "output power [dBm]") == "-3" && at(second, "output power [dBm]") == "0");
        QVERIFY(at(first, "distance [m]") == "4" && at(first, "wall loss [dB]") == "3" && first.last() == "delivered");
        const LinkBudget link = medium.link(0, 1);
        QCOMPARE(at(first, "path loss [dB]").toDouble(), std::round(link.pathLoss * 1000) / 1000);
        QVERIFY(std::abs(at(first, "received power [dBm]").toDouble() - (link.power - 3)) < 0.00051);
        QCOMPARE(at(first, "SINR [dB]").toDouble(), std::round(at(first, "SINR [dB]").toDouble() * 1000) / 1000);
        QCOMPARE(at(second, "LQI").toInt(), medium.counts(0).lastLqi);
        QCOMPARE(at(second, "RSSI [dBm]").toDouble(), medium.counts(0).lastRssi);
        QCOMPARE(rowsOf(textOf(*all, world)), 1);   // each frame once
        QCOMPARE(rowsOf(textOf(*ofOne, world)), 3); // from it or to it
        QCOMPARE(rowsOf(textOf(*ofOdd, world)), 1);
    }

    void packetCapture() {
        const RadioWorld world;
        const auto capture = [&](std::vector<std::string> robots) {
            return logOf(world, "RadioLog", {{"Format", textValue({"pcap"})}, {"Robot", textValue(std::move(robots))}});
        };
        const auto all = capture({}), ofOther = capture({"robot1"}), ofOdd = capture({"odd"});
        const std::vector<std::uint8_t> bytes(7, 0x55);
        QVERIFY(world.medium()->send(0, bytes, kBroadcastAddress, 0));
        world.medium()->advance(10'000);
        const std::string head = [&] {
            std::string text;
            all->header(text);
            return text;
        }();
        const std::string file = textOf(*all, world);
        QVERIFY(file.starts_with(head) && file.find(std::string(7, 0x55)) != std::string::npos);
        QCOMPARE(textOf(*all, world), head);
        QVERIFY(textOf(*ofOther, world) == file && textOf(*ofOdd, world) == head); // frames that it sends or receives
    }

    /// Frames are written before their Interval is over when the files are flushed or closed, each once.
    void framesOfAnIntervalThatIsNotOver() {
        const QTemporaryDir folder;
        const auto experiment = experimentOf({"robot0", "robot1"});
        experiment->logs = {logSpec("RadioLog", "a", {{"Interval", numberValue(1)}}),
                            logSpec("RadioLog", "b", {{"Interval", numberValue(1)}, {"Format", textValue({"pcap"})}})};
        RunOptions options;
        options.logFolder = folder.path().toStdString();
        auto world = std::make_unique<RadioWorld>(experiment);
        Medium& medium = *world->medium();
        ExperimentRunner runner(std::move(world), std::move(options));
        Diagnostics diagnostics;
        runner.openLogs(diagnostics);
        QVERIFY(!diagnostics.hasErrors());
        for (int frames = 1; frames <= 3; ++frames) {
            QVERIFY(medium.send(0, std::vector<std::uint8_t>(7, 0x55), kBroadcastAddress, 0));
            medium.advance(frames * 10'000);
            QVERIFY(runner.tick().ok());
            if (frames < 3) runner.flushLogs();
            else QVERIFY(runner.finish().ok());
            const auto content = [&](const char* name) { return readRegularFile(folder.filePath(name).toStdString()).value(); };
            QCOMPARE(rowsOf(content("a.csv")), 1 + frames);
            QCOMPARE(QByteArray::fromStdString(content("b.pcap")).count(QByteArray(7, 0x55)), frames);
        }
    }

    void withoutAMedium() {
        FakeWorld world(experimentOf({"robot0"}));
        for (const char* kind : {"RadioLog", "LinkMatrix", "NoLog"}) QVERIFY(!logOf(world, kind, {}));
    }

    void framesAreNumbered() {
        FakeWorld world(experimentOf({"robot0"}));
        std::vector<std::string> asked;
        const auto log = logOf(world, "FrameLog",
                               {{"Camera", textValue({"robot0/eye"})},
                                {"Size", {{PropertyType::Integer, {320, 200}, {}}, {}, Origin::Instance}},
                                {"Format", textValue({"png"})}});
        QCOMPARE(textOf(*log, world), std::string("time [s],picture\n0.5,\n")); // no pictures
        log->usePictures([&](const PictureOptions& o, const std::string& file) -> Result<double> {
            asked.push_back(o.camera + "|" + o.view + "|" + std::to_string(o.width) + "x" + std::to_string(o.height) + "|" +
                            file);
            if (asked.size() == 2) return Error{Code::PictureFailed, "dark"};
            return 0.25;
        });
        std::string rows;
        for (int i = 0; i < 3; ++i) log->rows(world, 0.75, rows);
        QCOMPARE(rows, std::string("0.25,log_000001.png\n0.75,\n0.25,log_000003.png\n"));
        QCOMPARE(asked[0], std::string("robot0/eye||320x200|log_000001.png"));
        const auto plain = logOf(world, "FrameLog", {{"View", textValue({"top"})}, {"Size", textValue({})}});
        plain->usePictures([&](const PictureOptions& o, const std::string& file) -> Result<double> {
            asked.push_back(o.camera + "|" + o.view + "|" + file);
            return o.width > 0 && o.height > 0 ? 1.0 : 0.0;
        });
        QCOMPARE(textOf(*plain, world), std::string("time [s],picture\n1,log_000000.jpg\n"));
        QCOMPARE(asked.back(), std::string("|top|log_000000.jpg"));
    }

    void filesThatLogsWrite() {
        ExperimentSpec experiment = *experimentOf({"robot0"});
        experiment.logs = {logSpec("PoseLog", "a", {}), logSpec("RadioLog", "b", {{"Format", textValue({"pcap"})}}),
                           logSpec("EnergyLog", "c", {{"File", textValue({"x//./y.csv"})}})};
        QVERIFY(logFileName(experiment.logs[0]) == "a.csv" && logFileName(experiment.logs[1]) == "b.pcap");
        Diagnostics fine;
        checkLogs(experiment, fine);
        QVERIFY(fine.all().empty());
        experiment.logs[0].values["File"] = textValue({"x/y.csv"});
        experiment.logs[1].values["File"] = textValue({"../b"});
        experiment.logs[0].nameRange = {0, {1, 2}};
        experiment.logs[1].nameRange = {0, {3, 4}};
        experiment.logs[2].nameRange = {0, {5, 6}};
        experiment.logs[2].values["File"].range = {0, {7, 9}};
        experiment.logs.push_back(logSpec("EnergyLog", "d", {{"Robot", textValue({"robbot0"})}}));
        Diagnostics wrong;
        checkLogs(experiment, wrong);
        QCOMPARE(wrong.all().size(), std::size_t{3});
        QCOMPARE(wrong.all()[0].range.range.begin, 3u); // the name of the log, without a place of the value
        const Diagnostic& twice = wrong.all()[1];
        QVERIFY(twice.code == Code::DuplicateName && twice.range.range.begin == 7);
        QCOMPARE(twice.message, std::string("two logs write the file x/y.csv"));
        QCOMPARE(twice.notes.at(0).second.range.begin, 1u);
        QVERIFY(wrong.all()[2].message.starts_with("no robot is called 'robbot0'"));
    }

    void aFileThatIsTheFolderOfAnother() {
        for (const auto& [first, second, fault] :
             {std::array{"sub", "sub/x.csv", "sub cannot be both a log file and the folder of sub/x.csv"},
              {"a/b/c/x.csv", "a\\b", "a/b cannot be both a log file and the folder of a/b/c/x.csv"},
              {"sub", "sub2/x.csv", ""}}) {
            ExperimentSpec experiment;
            for (const char* file : {first, second})
                experiment.logs.push_back(logSpec("EnergyLog", file, {{"File", textValue({file})}}));
            experiment.logs[0].nameRange = {0, {1, 2}};
            Diagnostics said;
            checkLogs(experiment, said);
            QCOMPARE(said.all().empty() ? std::string() : said.all()[0].message, std::string(fault));
            if (!said.all().empty()) QCOMPARE(said.all()[0].notes.at(0).second.range.begin, 1u);
        }
    }

    void signalsThatLogsName() {
        FakeWorld world(experimentOf({"robot0"}));
        ExperimentSpec experiment = world.experiment();
        experiment.logs = {logSpec("PoseLog", "a", {}), logSpec("SignalLog", "b", {{"Signals", textValue({"robot0/pose"})}})};
        Diagnostics diagnostics;
        checkLogSignals(experiment, world.layout(), diagnostics);
        QVERIFY(diagnostics.all().empty());
        experiment.logs.push_back(logSpec("SignalLog", "c", {{"Signals", textValue({"robot0/pos"})}}));
        checkLogSignals(experiment, world.layout(), diagnostics);
        QCOMPARE(diagnostics.all().size(), std::size_t{1});
    }

    void everyKindOfLog() {
        Registry registry;
        QVERIFY(addLogKinds(registry).ok());
        for (const char* name : {"PoseLog", "SignalLog", "ContactLog", "EnergyLog", "FrameLog", "RadioLog", "LinkMatrix"}) {
            const Kind* kind = registry.find(name);
            QVERIFY2(kind && kind->role == Role::Log && kind->find("Interval") && kind->find("File"), name);
        }
        QVERIFY(!addLogKinds(registry).ok()); // each once
    }

    void picturesOfARun() {
        const QTemporaryDir folder;
        FakeWorld world(experimentOf({"robot0"}));
        Painter* painter = nullptr;
        CameraCapture cameras(world, [&](const ExperimentSpec&, const SignalLayout&) -> Result<std::unique_ptr<ImageSource>> {
            auto made = std::make_unique<Painter>();
            painter = made.get();
            return Result<std::unique_ptr<ImageSource>>(std::move(made));
        });
        LogFolder logs({folder.path().toStdString()});
        std::vector<Diagnostic> warnings;
        RunPictures pictures(world, cameras, logs, warnings);
        const ComponentSpec a = logSpec("FrameLog", "a", {}), b = logSpec("FrameLog", "b", {});
        const auto content = [&](const char* name) { return readRegularFile(folder.filePath(name).toStdString()).value(); };
        for (int i = 0; i < 8; ++i) QVERIFY(world.tick().ok());
        QCOMPARE(pictures.saveFor(a, {"robot0/eye", "", 1, 1}, "1.png").value(), 0.03); // of the image's tick
        QCOMPARE(content("1.png"), std::string("image of robot0/eye as 1.png"));
        QCOMPARE(pictures.saveFor(a, {"", "top", 3, 2}, "2.png").value(), 0.08); // of now
        QCOMPARE(content("2.png"), std::string("image of top 3x2 as 2.png"));
        ControllerOutputs outputs;
        pictures.addTo(outputs, "robot0");
        QVERIFY(outputs.capture("eye").ok() && outputs.savePicture("eye", "3.png").ok());
        QVERIFY(outputs.objectName(0).empty() && outputs.objectName(99).empty()); // this world has no geoms
        QVERIFY(content("3.png").starts_with("image of robot0/eye"));
        QVERIFY(warnings.empty());
        // The same cause of the same log is reported once, whatever the name of the file.
        painter->failure = Error{Code::PictureFailed, "no light"};
        for (const char* file : {"4.png", "5.png"}) QVERIFY(!pictures.saveFor(a, {"", "top", 1, 1}, file).ok());
        QVERIFY(!pictures.saveFor(b, {"", "top", 1, 1}, "6.png").ok());
        for (int i = 0; i < 2; ++i) QVERIFY(!outputs.capture("eye").ok() && !outputs.savePicture("eye", "7.png").ok());
        QCOMPARE(messagesOf(warnings), (std::vector<std::string>{"FrameLog a leaves out pictures, the first is 4.png: no light",
                                                                 "FrameLog b leaves out pictures, the first is 6.png: no light",
                                                                 "a picture could not be taken: no light"}));
        painter->failure.reset();
        QVERIFY(!pictures.saveFor(a, {"", "", 1, 1}, "../9.png").ok());
        QVERIFY(!pictures.saveFor(a, {"", "", 1, 1}, "2.png").ok()); // open in this run already
        QCOMPARE(warnings.size(), std::size_t{5});
        painter->failure = Error{Code::NoGraphics, "no card"};
        QVERIFY(!pictures.saveFor(a, {"", "", 1, 1}, "8.png").ok() && !outputs.capture("eye").ok());
        painter->failure = Error{Code::NoSuchPath, "no camera ear"}; // the caller's own fault
        QVERIFY(!outputs.capture("ear").ok());
        QCOMPARE(warnings.size(), std::size_t{6});
        QVERIFY(warnings[5].code == Code::NoGraphics && warnings[5].severity == Severity::Warning);
        QCOMPARE(warnings[5].message, std::string("cameras take no pictures: no card"));
    }

    void warningsOfTheWorld() {
        const auto experiment = experimentOf({"robot0", "robot1"});
        experiment->settings.tick = 0.01;
        FakeWorld world(experiment);
        for (int i = 0; i < 30; ++i) QVERIFY(world.tick().ok());
        WorldWarnings reporter;
        std::vector<Diagnostic> warnings;
        const auto news = [&] {
            warnings.clear();
            reporter.update(world, warnings);
            return messagesOf(warnings);
        };
        QVERIFY(news().empty());
        world.cluster = 900;
        const auto cluster = news();
        QVERIFY(cluster.size() == 1 && cluster[0].starts_with("at t = 0.3 s 900 contacts hang together"));
        QVERIFY(warnings[0].fixes.empty()); // no text of the setting
        QVERIFY(news().empty());
        world.cluster = 0;
        QVERIFY(news().empty());
        world.cluster = 901; // again
        QCOMPARE(news().size(), std::size_t{1});
        world.swept.passed = {{"a", "b"}, {"c", "d"}};
        const auto passed = news();
        QVERIFY(passed.size() == 2 && passed[1].starts_with("at t = 0.3 s c passed through d: "));
        QVERIFY(passed[0].find("A Tick below 0.01 s") != std::string::npos && news().empty());
        world.faults.closedJoints = {{"robot0/arm", 0.1, "it was torn", {0, {4, 5}}}};
        QCOMPARE(news(), std::vector<std::string>{
                             "robot0/arm at t = 0.1 s: it was torn and was closed again; a Tick below 0.01 s keeps it closed"});
        QVERIFY(warnings[0].range.range.begin == 4 && news().empty());
        world.faults.ends = {{1, {"robot1/hull", 0.25, "too fast", {0, {6, 7}}}}};
        QCOMPARE(news(),
                 std::vector<std::string>{"robot1 has ended, all others continue: at t = 0.25 s robot1/hull stopped: too fast"});
        QVERIFY(warnings[0].range.range.begin == 6 && news().empty());
    }

    /// A frame is due at each multiple of the frame time, also where the tick's multiples miss it by rounding.
    void moviesWithEqualFrameTimes() {
        const QTemporaryDir folder;
        const auto made = MovieFile::open(folder.filePath("a.mp4").toStdString(), 10);
        QVERIFY2(made.ok(), made.ok() ? "" : made.error().message.c_str());
        MovieFile& movie = *made.value();
        CameraImage image{3, 3, 0, 0, std::vector<std::uint8_t>(27, 100), {}, {}};
        QVERIFY(movie.isDue(0, 0.01));
        QVERIFY(movie.add(image, 0, 0.01).ok());
        QCOMPARE(movie.frames(), std::uint64_t{1});
        QVERIFY(!movie.isDue(0.09, 0.01) && movie.isDue(0.1, 0.01) && movie.isDue(0.1 - 1e-12, 0.01));
        QVERIFY(movie.add(image, 0.35, 0.01).ok()); // frames of 0.1, 0.2 and 0.3 s
        QCOMPARE(movie.frames(), std::uint64_t{4});
        QVERIFY(!QFile::exists(folder.filePath("a.mp4")));
        const Status finished = movie.finish();
        QVERIFY2(finished.ok(), finished.ok() ? "" : finished.error().message.c_str());
        QVERIFY(QFileInfo(folder.filePath("a.mp4")).size() > 100);
        QVERIFY(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size() == 1);
        QVERIFY(movie.finish().ok());
        QCOMPARE(MovieFile::open(folder.path().toStdString(), 10).error().message,
                 "the movie " + folder.path().toStdString() + " cannot be made: it is a folder");
        {
            const auto dropped = MovieFile::open(folder.filePath("b.webm").toStdString(), 10);
            QVERIFY(dropped.value()->add(image, 0, 0.01).ok());
        }
        QVERIFY(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden) == QStringList{"a.mp4"});
        const auto nowhere = MovieFile::open(folder.filePath("no/b.mp4").toStdString(), 10);
        QVERIFY(!nowhere.ok() && nowhere.error().message.find("cannot be made") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(LogKindsTest)
#include "log_kinds_test.moc"
