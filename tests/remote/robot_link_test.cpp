// What another program may answer to a robot link: replies are written before they are asked for.
#include <QtTest>

#include "remote/peer.h"
#include "remote/remote_devices.h"
#include "remote/robot_link.h"

using namespace trundle;
using Json = nlohmann::json;

namespace {

struct Answer {
    std::string reply; ///< members of its JSON
    std::string bytes = {};
};

std::string doubles(const std::vector<double>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)};
}
std::string bytesOf(std::size_t count) {
    std::string bytes;
    for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>(i + 1);
    return bytes;
}

/// A link to the robot "r" with two signals, and its other end.
struct Other {
    std::string hello = "{}", status = R"({"tick_s":0.02,"state":"paused"})", robot = R"({"controller":null})";
    std::string entries = R"([["r/speed",1],["r/pose",7]])"; ///< of its signals
    std::vector<Answer> more;                                ///< to what is asked after that
    std::function<bool()> isCancelled;
    Peer peer = {};

    Result<std::unique_ptr<RobotLink>> open() {
        auto [here, there] = std::move(Socket::pair().value());
        peer.socket = std::move(there);
        std::uint64_t number = 0;
        const auto write = [&](const Answer& answer) {
            const Json given = Json::parse(answer.reply);
            Json reply{{"ok", true}};
            if (!given.contains("event") && !given.contains("id")) reply["id"] = ++number;
            reply.update(given);
            std::string bytes;
            appendFrame(bytes, reply.dump(), answer.bytes);
            peer.write(bytes);
        };
        const Json subscribed{{"subscription", 5}, {"signals", Json::parse(entries)}};
        for (const std::string& each : {hello, status, robot, subscribed.dump()}) write({each});
        write({"{}", doubles(std::vector<double>(8))});
        for (const Answer& each : more) write(each);
        return RobotLink::open(std::move(here), {"token", "r", 0.05, isCancelled});
    }
};

} // namespace

class RobotLinkTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatCannotBeUsedIsRefused_data() {
        QTest::addColumn<QByteArray>("member");
        QTest::addColumn<QByteArray>("value");
        QTest::addColumn<QByteArray>("message");
        const auto row = [](const char* name, const char* member, const char* value, const char* message) {
            QTest::newRow(name) << QByteArray(member) << QByteArray(value) << QByteArray(message);
        };
        row("nothing wrong", "hello", "{}", "");
        row("tick of 0", "status", R"({"tick_s":0,"state":"paused"})", "how long its tick is");
        row("no tick", "status", R"({"state":"paused"})", "how long its tick is");
        row("running", "status", R"({"tick_s":0.1,"state":"running"})", "has to be paused");
        row("signal of three", "entries", R"([["r/speed",1,1],["r/pose",7]])", "its list of signals cannot be read");
        row("signal of one", "entries", R"([["r/speed"],["r/pose",8]])", "its list of signals cannot be read");
        row("signal of less than nothing", "entries", R"([["r/speed",-1],["r/pose",9]])", "cannot be read");
        row("many numbers", "entries", R"([["r/a",1048576],["r/b",1048577]])", "too many signals");
        row("refused", "hello", R"({"ok":false,"message":"no"})", "r at the other end: no");
        row("refused without words", "hello", R"({"ok":false})", "it refused a request");
    }
    void whatCannotBeUsedIsRefused() {
        QFETCH(QByteArray, member);
        QFETCH(QByteArray, value);
        QFETCH(QByteArray, message);
        Other other;
        (member == "hello" ? other.hello : member == "status" ? other.status : other.entries) = value.toStdString();
        const auto link = other.open();
        QCOMPARE(link.ok(), message.isEmpty());
        if (!link) QVERIFY2(link.error().message.find(message.toStdString()) != std::string::npos, link.error().message.c_str());
        else QCOMPARE(link.value()->tick(), 0.02);
    }

    /// Events and late replies are skipped; a reset is the end.
    void eventsAreSkipped() {
        Other other;
        other.more = {{R"({"event":"console","ok":false})"},
                      {R"({"id":3,"ok":false})"},
                      {"{}", doubles({1, 2, 3, 4, 5, 6, 7, 8})},
                      {R"({"event":"reset"})"}};
        const auto opened = other.open();
        QVERIFY(opened);
        RobotLink& link = *opened.value();
        QVERIFY(link.step({{"r/speed", {2}}}));
        QCOMPARE(link.values()[7], 8.);
        QCOMPARE(link.signals()[1].offset, std::size_t(1));
        const Status reset = link.step({});
        QVERIFY(!reset && reset.error().message.find("was reset") != std::string::npos);
    }

    void valuesOfAnotherNumberAreRefused() {
        for (const std::size_t count : {7u, 9u}) {
            Other other;
            other.more = {{"{}", doubles(std::vector<double>(count))}};
            const auto link = other.open();
            QVERIFY(link && !link.value()->step({}));
        }
    }

    void imagesAreWholeOrRefused_data() {
        QTest::addColumn<QByteArray>("sizes"); // width, height, bytes of pixels, depth, objects
        QTest::addColumn<int>("bytes");
        QTest::addColumn<bool>("good");
        const auto row = [](const char* name, const char* sizes, int bytes, bool good) {
            QTest::newRow(name) << QByteArray(sizes) << bytes << good;
        };
        row("colours", "[3,2,18,0,0]", 18, true);
        row("with depths", "[3,2,18,24,0]", 42, true);
        row("with objects", "[3,2,18,0,24]", 42, true);
        row("with all", "[3,2,18,24,24]", 66, true);
        row("few pixels", "[3,2,17,0,0]", 17, false);
        row("many pixels", "[3,2,24,0,0]", 24, false);
        row("few depths", "[3,2,18,20,0]", 38, false);
        row("few objects", "[3,2,18,0,6]", 24, false);
        row("few bytes", "[3,2,18,24,24]", 65, false);
        row("many bytes", "[3,2,18,24,24]", 67, false);
        row("no objects", "[3,2,18,24,24]", 42, false);
        row("without area", "[0,2,0,0,0]", 0, false);
        row("too wide", "[65537,1,196611,0,0]", 196611, false);
        row("too high", "[1,65537,196611,0,0]", 196611, false);
    }
    void imagesAreWholeOrRefused() {
        QFETCH(QByteArray, sizes);
        QFETCH(int, bytes);
        QFETCH(bool, good);
        const Json s = Json::parse(sizes.toStdString());
        Other other;
        const Json reply{{"width", s[0]}, {"height", s[1]}, {"pixels", s[2]}, {"depth", s[3]}, {"objects", s[4]}, {"tick", 9}};
        other.more = {{reply.dump(), bytesOf(std::size_t(bytes))}};
        const auto link = other.open();
        QVERIFY(link);
        SignalLayout layout;
        layout.beginRobot("r");
        layout.add("speed", "m/s", SignalType::Real, SignalDirection::Command);
        SignalBlock block(layout);
        block.header().tick = 4;
        block.header().time = 0.5;
        RemoteImages images(*link.value(), [] {
            return Result<std::unique_ptr<ImageSource>>(Error{Code::PictureFailed, "none"});
        });
        const Result<CameraImage> image = images.capture("r/eye", block);
        QCOMPARE(image.ok(), good);
        if (!good) return;
        QCOMPARE(std::tuple(image.value().width, image.value().height), std::tuple(3u, 2u));
        QCOMPARE(std::tuple(image.value().tick, image.value().time), std::tuple(std::uint64_t(4), 0.5)); // those of here
        QCOMPARE(int(image.value().pixels[17]), 18);
        std::uint32_t word = 0;
        if (s[4] != 0) std::memcpy(&word, &image.value().objects[0], 4);
        const std::uint32_t first = s[3] != 0 ? 43 : 19;
        if (s[4] != 0) QCOMPARE(word & 0xff, first);
    }

    void namesOfObjectsAreAskedOnce() {
        Other other;
        other.more = {{R"({"objects":["","r/hull",3,"wall"]})"}};
        const auto opened = other.open();
        QVERIFY(opened);
        RobotLink& link = *opened.value();
        for (const auto& [number, name] : {std::pair(3u, "wall"), {1u, "r/hull"}, {2u, ""}, {4u, ""}})
            QCOMPARE(link.objectName(number), std::string(name));
    }

    /// The answer to a step says that the tick is executed: it is not lost.
    void aCancelledWaitEnds() {
        Other other;
        other.more = {{"{}", doubles(std::vector<double>(8))}};
        bool isCancelled = false;
        other.isCancelled = [&] { return isCancelled; };
        const auto link = other.open();
        QVERIFY(link);
        isCancelled = true;
        QVERIFY(link.value()->step({}).ok());
        other.peer.write("x"); // of a reply that never ends
        const Status stepped = link.value()->step({});
        QVERIFY(!stepped && stepped.error().code == Code::Interrupted);
    }

    /// The source of views and files is opened when it is needed, once.
    void theOtherSourceIsOpenedOnce() {
        struct Views final : ImageSource {
            Result<CameraImage> capture(const std::string&, const SignalBlock&) override {
                return Error{Code::PictureFailed, "no"};
            }
            Result<CameraImage> view(const std::string&, std::uint32_t width, std::uint32_t height, const SignalBlock&) override {
                CameraImage image;
                image.width = width, image.height = height;
                return image;
            }
            Result<std::string> encode(const CameraImage&, const std::string& camera, const std::string& file) override {
                return camera + " " + file;
            }
        };
        Other other;
        const auto link = other.open();
        QVERIFY(link);
        int opened = 0;
        RemoteImages images(*link.value(), [&]() -> Result<std::unique_ptr<ImageSource>> {
            if (++opened == 1) return Error{Code::PictureFailed, "not yet"};
            return std::unique_ptr<ImageSource>(std::make_unique<Views>());
        });
        SignalLayout layout;
        const SignalBlock block(layout);
        QVERIFY(!images.view("v", 3, 2, block));
        for (int i = 0; i < 2; ++i) {
            const auto view = images.view("v", 3, 2, block);
            QVERIFY(view && view.value().width == 3 && view.value().height == 2);
            QCOMPARE(images.encode({}, "r/eye", "a.png").value(), std::string("r/eye a.png"));
        }
        QCOMPARE(opened, 2);
    }
};

QTEST_APPLESS_MAIN(RobotLinkTest)
#include "robot_link_test.moc"
