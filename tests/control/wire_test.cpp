// What passes between a run and its host processes, as bytes: all of it arrives, and damaged bytes are seen. Also the words of faults.
#include <QtTest>

#include <csignal>

#include "control/host/controller_record.h"
#include "control/host/host_fault.h"
#include "control/kept_outputs.h"
#include "control/kinds_json.h"
#include "control/module_kinds.h"

using namespace trundle;

namespace {

ResolvedValue number(double value) { return {{PropertyType::Number, {value}, {}}, {}, Origin::Instance}; }

HostEnd endBy(HostEnd::Cause cause, int code = 0) {
    HostEnd end;
    end.cause = cause;
    end.code = code;
    end.during.phase = HostPhase::Update;
    return end;
}

} // namespace

class WireTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void errorsArriveWithTheirPlaces() {
        const Status good, bad = Error{Code::UnknownPort, "no port", {"brain.cpp", 17}};
        const std::string bytes = WireWriter().status(good).status(bad).number<std::uint8_t>(9).take();
        WireReader in(bytes);
        QVERIFY(in.status());
        const Status back = in.status();
        QVERIFY(!back && back.error().code == Code::UnknownPort && back.error().message == "no port");
        QVERIFY(back.error().place.file == "brain.cpp" && back.error().place.line == 17);
        QCOMPARE(in.number<std::uint8_t>(), std::uint8_t(9));
        QVERIFY(in.ok() && in.atEnd());
        WireReader cut(std::string_view(bytes).substr(1, 3)); // within the code
        const Status damaged = cut.status();
        QVERIFY(!damaged && damaged.error().code == Code::Internal && !cut.ok());
    }

    /// A count that does not fit counts as 0, so that nothing of that size is made; texts at the very end fit.
    void countsFitIntoTheirBytes() {
        const PropertyValue value{PropertyType::Text, {0.5, -2}, {"one", "", "three"}};
        const std::string bytes = WireWriter().value(value).take();
        WireReader in(bytes);
        const PropertyValue back = in.value();
        QVERIFY(back.type == value.type && back.numbers == value.numbers && back.texts == value.texts && in.ok() && in.atEnd());
        for (const auto& [count, fits] :
             {std::pair<std::uint64_t, bool>(2, true), {3, false}, {1ull << 40, false}, {~0ull, false}}) {
            const std::string two = WireWriter().number(count).number<std::uint8_t>(1).number<std::uint8_t>(2).take();
            WireReader reader(two);
            QCOMPARE(reader.count(), fits ? count : 0);
            QCOMPARE(reader.ok(), fits);
        }
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            WireReader shorter(std::string_view(bytes).substr(0, size));
            (void)shorter.value();
            QVERIFY(!shorter.ok());
        }
    }

    /// Of a robot with two controllers, of which the second one runs in the host.
    void aRecordHasAllOfItsController() {
        RobotSpec robot;
        robot.name = "rover";
        auto config = std::make_shared<RobotConfigSpec>();
        config->devices = {{"Camera", "eye", {{"UpdatePeriod", number(0.25)}}, {}, {}}, {"Led", "lamp", {}, {}, {}}};
        robot.config = config;
        robot.controllers = {{{"First", "one", {{"Speed", number(1)}}, {}, {}}, {}},
                             {{"Second", "two", {{"Speed", number(2)}}, {}, {}}, {}}};
        robot.controllers[1].published = {{"seen", "m", "", TRUNDLE_REAL_SIGNAL, 3, TRUNDLE_OUTPUT, {}}};
        SignalLayout layout;
        layout.beginRobot("other");
        layout.add("pose", "m", SignalType::Real, SignalDirection::Truth, 7);
        layout.beginRobot("rover");
        layout.add("lamp/lit", "", SignalType::Boolean, SignalDirection::Output);
        layout.add("two/seen", "m", SignalType::Integer, SignalDirection::Command, 3);
        SettingsSpec settings;
        settings.seed = 41;
        settings.tick = 0.025;
        WireWriter out;
        write(out, robot, 1, settings, layout.entriesOf("rover"), 12);
        WireReader in(out.view());
        const ControllerRecord record = readControllerRecord(in);
        QVERIFY(in.ok() && in.atEnd());
        QVERIFY(record.offset == 12 && record.settings.seed == 41 && record.settings.tick == 0.025 && record.controller == 1);
        QCOMPARE(record.robot.name, std::string("rover"));
        QCOMPARE(record.robot.controllers.size(), std::size_t(2));
        QVERIFY(record.robot.controllers[0].name == "one" && record.robot.controllers[0].kind.empty());
        const ControllerSpec& own = record.robot.controllers[1];
        QVERIFY(own.name == "two" && own.kind == "Second" && own.find("Speed")->value.numbers == std::vector{2.});
        QVERIFY(own.published.size() == 1 && own.published[0].name == "seen" && own.published[0].count == 3);
        const auto& devices = record.robot.config->devices;
        QVERIFY(devices.size() == 2 && devices[0].kind == "Camera" && devices[1].name == "lamp");
        QVERIFY(devices[0].number("UpdatePeriod") == 0.25 && devices[1].number("UpdatePeriod") == 0);
        const auto seen = record.layout.find("rover/two/seen");
        QVERIFY(seen && seen->count == 3 && seen->type == SignalType::Integer && seen->direction == SignalDirection::Command);
        QVERIFY(record.layout.find("rover/lamp/lit") && !record.layout.find("other/pose"));
    }

    /// What one of several puts out is kept, each kind of it, and passed on once, in the order of the calls.
    void keptOutputsComeOnce() {
        QStringList got;
        ControllerOutputs own;
        own.print = [&](int severity, std::string_view text) {
            got += QStringLiteral("print %1 %2").arg(severity).arg(QString::fromUtf8(text.data(), qsizetype(text.size())));
        };
        own.writeLog = [&](int log, std::string_view bytes) { got += QStringLiteral("log %1 %2").arg(log).arg(bytes.size()); };
        own.finish = [&](const std::string& reason) { got += QString::fromStdString("finish " + reason); };
        own.gaveUp = [&](const std::string& reason) { got += QString::fromStdString("gave up " + reason); };
        KeptOutputs kept;
        const ControllerOutputs used = kept.inPlaceOf(own);
        const auto all = [&] {
            used.writeLog(3, std::string("12345"));
            used.print(1, std::string("text of its own"));
            used.gaveUp("no wall");
            used.finish("done");
        };
        const QStringList expected{"log 3 5", "print 1 text of its own", "gave up no wall", "finish done"};
        all();
        QCOMPARE(std::exchange(got, {}), expected); // at once
        kept.keep();
        all();
        QVERIFY(got.isEmpty());
        kept.pass();
        QCOMPARE(std::exchange(got, {}), expected);
        kept.pass();
        QVERIFY(got.isEmpty());
        QVERIFY(!KeptOutputs().inPlaceOf({}).print);
    }

    void endsHaveTheirWords_data() {
        QTest::addColumn<int>("which");
        QTest::addColumn<QString>("text");
        const char* const texts[] = {
            "brain (lib.so) ended its process in update, by exit() or the like",
            "brain (lib.so) ended its process in update with exit code 0",
            "brain (lib.so) ended its process in update with exit code 3",
            "brain (lib.so) did not return from update within 0.3 s and was stopped",
            "brain (lib.so) did not return from update within 12.0 s of the request to end and was stopped",
            "brain (lib.so) did not return from update within 1.5 s and was stopped",
            "brain (lib.so) ended its process in update: a file grew too large",
            "brain (lib.so) ended its process in update: SIGTERM",
            "brain (lib.so) damaged the messages of its process in update and was stopped",
            "brain (lib.so) wrote to a sensor value in update, which only the simulation may set"};
        for (int i = 0; i < int(std::size(texts)); ++i) QTest::addRow("%d", i) << i << texts[i];
    }
    void endsHaveTheirWords() {
        QFETCH(int, which);
        QFETCH(QString, text);
        using Cause = HostEnd::Cause;
        HostEnd ends[] = {endBy(Cause::Exit, -1),        endBy(Cause::Exit, 0),         endBy(Cause::Exit, 3),
                          endBy(Cause::NotResponding),   endBy(Cause::NotResponding),   endBy(Cause::NotResponding),
                          endBy(Cause::Killed, SIGXFSZ), endBy(Cause::Killed, SIGTERM), endBy(Cause::Damaged),
                          endBy(Cause::Crash, SIGSEGV)};
        ends[3].limitS = 0.3;
        ends[4].limitS = 12;
        ends[4].afterRequest = true;
        ends[5].limitS = 1.5;
        ends[9].ofSensorImage = true;
        QCOMPARE(QString::fromStdString(faultOf(ends[which], "brain", "lib.so").reason), text);
    }

    /// Of the module where no controller is known; a message about loading has no such beginning.
    void endsOfAModule() {
        HostEnd end = endBy(HostEnd::Cause::Exit, 3);
        end.during.phase = HostPhase::Load;
        QCOMPARE(faultOf(end, {}, "lib.so").reason, std::string("the module lib.so ended its process in load with exit code 3"));
        QCOMPARE(errorOfLoading(Code::ModuleUnreadable, end, "lib.so").message,
                 std::string("lib.so ended its process in load with exit code 3"));
        end.ofThread = true;
        QCOMPARE(faultOf(end, {}, "lib.so").reason,
                 std::string("a thread of the module lib.so ended its process in load with exit code 3"));
        const ControllerFault thrown = faultOfException("it failed", {}, {}, "lib.so");
        QVERIFY(thrown.reason == "it failed" && thrown.backtrace.empty());
        const ControllerFault at = faultOfException("it failed", {}, {0x1234}, "/nowhere/lib.so");
        QCOMPARE(at.backtrace.size(), std::size_t(1));
    }

    /// All of a description of kinds, with open ends of ranges and counts by fields.
    void kindsAreReadFromTheirText() {
        Kind kind;
        kind.name = "Array";
        kind.role = Role::Device;
        kind.help = "Measures.";
        Property beams;
        beams.name = "Beams";
        beams.type = PropertyType::Integer;
        beams.minimum = 1;
        beams.maximum = std::numeric_limits<double>::infinity();
        beams.maxExclusive = true;
        beams.live = true;
        beams.minCount = beams.maxCount = 1;
        beams.defaultValue = PropertyValue{PropertyType::Integer, {4}, {}};
        Property way = beams;
        way.name = "Way";
        way.type = PropertyType::Number;
        way.minimum = -std::numeric_limits<double>::infinity();
        way.maximum = 7;
        way.minExclusive = true;
        way.maxExclusive = way.live = false;
        way.required = true;
        way.scale = 0.001;
        way.minCount = 0;
        way.maxCount = 3;
        way.defaultValue.reset();
        kind.properties = {beams, way};
        kind.signals = {{"ranges", "m", "", TRUNDLE_REAL_SIGNAL, 2, TRUNDLE_OUTPUT, {"Beams"}}};
        const std::string text = kindsToJson({kind});
        const auto read = kindsFromJson(text, "libarray.so");
        QVERIFY2(read.ok(), read.ok() ? "" : read.error().message.c_str());
        const Kind& back = read.value().at(0);
        for (std::size_t i = 0; i < 2; ++i) {
            const Property &a = kind.properties[i], &b = back.properties.at(i);
            QVERIFY(a.name == b.name && a.type == b.type && a.minimum == b.minimum && a.maximum == b.maximum &&
                    a.scale == b.scale);
            QVERIFY(a.minExclusive == b.minExclusive && a.maxExclusive == b.maxExclusive && a.required == b.required);
            QVERIFY(a.live == b.live && a.minCount == b.minCount && a.maxCount == b.maxCount);
            QCOMPARE(b.defaultValue.has_value(), i == 0);
        }
        QCOMPARE(back.signals.at(0).countFields, std::vector<std::string>{"Beams"});
        for (const char* format : {"0", "2"}) {
            std::string other = text;
            other.replace(other.find("\"format\": 1") + 10, 1, format);
            QVERIFY(!kindsFromJson(other, "libarray.so").ok());
        }
    }
};

QTEST_APPLESS_MAIN(WireTest)
#include "wire_test.moc"
