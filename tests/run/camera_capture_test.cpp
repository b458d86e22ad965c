// Camera images of a run, with a renderer that only records its requests.
#include <QtTest>

#include "run/camera_capture.h"

using namespace trundle;

namespace {

// Not inside a class, where moc takes `slots` for its keyword.
std::span<double> valuesOf(SignalBlock& block) { return block.slots(); }
std::span<const double> valuesOf(const SignalBlock& block) { return block.slots(); }

std::shared_ptr<const ExperimentSpec> robotWithCameras() {
    auto config = std::make_shared<RobotConfigSpec>();
    ComponentSpec still, stream;
    still.kind = stream.kind = "Camera";
    still.name = "still";
    stream.name = "stream";
    stream.values["UpdatePeriod"] = {{PropertyType::Number, {0.03}, {}}, {}, Origin::Config};
    config->devices = {still, stream};
    auto powered = std::make_shared<RobotConfigSpec>();
    ComponentSpec battery;
    battery.kind = "Battery";
    battery.name = "battery";
    powered->devices = {still, battery};
    auto experiment = std::make_shared<ExperimentSpec>();
    experiment->robots.resize(2);
    experiment->robots[1].name = "robot1";
    experiment->robots[1].config = powered;
    experiment->robots[0].name = "robot0";
    experiment->robots[0].config = config;
    return experiment;
}

/// A world that consists only of its signal block.
class BlockWorld final : public World {
public:
    BlockWorld() : m_experiment(robotWithCameras()) {
        m_layout.beginRobot("robot0");
        m_layout.add("place", "m", SignalType::Real, SignalDirection::Truth);
        m_layout.add("still/frame", "", SignalType::Integer, SignalDirection::Output); // not used: it has no period
        m_frame = m_layout.add("stream/frame", "", SignalType::Integer, SignalDirection::Output);
        m_layout.beginRobot("robot1");
        m_poweredFrame = m_layout.add("still/frame", "", SignalType::Integer, SignalDirection::Output);
        m_block = std::make_unique<SignalBlock>(m_layout);
    }
    const ExperimentSpec& experiment() const override { return *m_experiment; }
    const SignalLayout& layout() const override { return m_layout; }
    SignalBlock& block() override { return *m_block; }
    const SignalBlock& block() const override { return *m_block; }
    Status tick() override {
        ++m_block->header().tick;
        valuesOf(*m_block)[0] = static_cast<double>(m_block->header().tick);
        if (hasPower) ++valuesOf(*m_block)[m_poweredFrame];
        valuesOf(*m_block)[m_frame] = std::floor(static_cast<double>(m_block->header().tick) / 3);
        return {};
    }
    const Fault* fault() const override { return nullptr; }
    std::uint64_t ticks() const override { return m_block->header().tick; }
    std::uint64_t stateHash() const override { return 0; }
    Pose robotPose(std::size_t) const override { return {}; }
    RobotEnergy robotEnergy(std::size_t) const override { return {}; }
    const std::vector<WorldContact>& contacts() const override { return m_contacts; }
    Status push(const std::string&, const Vec3&, const Vec3&) override { return {}; }
    Status place(const std::string&, const Pose&) override { return {}; }
    Status setSurface(const SurfaceSpec&) override { return {}; }
    Status setProperty(const std::string&, const std::string&, const PropertyValue&) override { return {}; }
    void setDeviceText(DeviceText) override {}
    bool hasPower = true;

private:
    std::shared_ptr<const ExperimentSpec> m_experiment;
    SignalLayout m_layout;
    std::unique_ptr<SignalBlock> m_block;
    std::uint32_t m_frame = 0, m_poweredFrame = 0;
    std::vector<WorldContact> m_contacts;
};

struct Painter final : ImageSource {
    explicit Painter(std::string& asked) : story(asked) {}
    Result<CameraImage> capture(const std::string& camera, const SignalBlock& block) override {
        story += camera + "@" + std::to_string(int(valuesOf(block)[0])) + " ";
        if (camera == "robot0/blind") return Error{Code::NoGraphics, "no OpenGL"};
        CameraImage frame;
        frame.tick = block.header().tick;
        return frame;
    }
    Result<CameraImage> view(const std::string& name, std::uint32_t, std::uint32_t, const SignalBlock&) override {
        story += "view " + name + " ";
        return CameraImage{};
    }
    Result<std::string> encode(const CameraImage& frame, const std::string& camera, const std::string& fileName) override {
        return fileName + " of " + camera + " at tick " + std::to_string(frame.tick);
    }
    std::string& story;
};

} // namespace

class CameraCaptureTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_story.clear();
        m_world = std::make_unique<BlockWorld>();
        m_cameraCapture = std::make_unique<CameraCapture>(*m_world, [this](const ExperimentSpec&, const SignalLayout&) {
            m_story += "made ";
            return Result<std::unique_ptr<ImageSource>>(std::make_unique<Painter>(m_story));
        });
    }
    void drawsOnlyOnRequest() {
        ticks(10);
        QCOMPARE(m_story, std::string());
        QVERIFY(m_cameraCapture->capture("robot0/still").ok());
        QCOMPARE(m_story, std::string("made robot0/still@10 "));
    }
    void onePictureIsDrawnOncePerTick() {
        ticks(1);
        const CameraImage* first = m_cameraCapture->capture("robot0/still").value();
        QCOMPARE(m_cameraCapture->capture("robot0/still").value(), first);
        ticks(1);
        QVERIFY(m_cameraCapture->capture("robot0/still").ok());
        QCOMPARE(m_story, std::string("made robot0/still@1 robot0/still@2 "));
    }
    /// A camera without a period, of a robot with a battery: once that is empty, the last picture that it had power for stays.
    void withoutPowerThereIsNoNewPicture() {
        QVERIFY(m_cameraCapture->capture("robot1/still").ok());
        ticks(4);
        QCOMPARE(m_cameraCapture->capture("robot1/still").value()->tick, std::uint64_t(4));
        m_world->hasPower = false;
        ticks(3);
        QCOMPARE(m_cameraCapture->capture("robot1/still").value()->tick, std::uint64_t(4));
        QCOMPARE(m_cameraCapture->capture("robot0/still").value()->tick, std::uint64_t(7));
        m_world->hasPower = true;
        ticks(2);
        QCOMPARE(m_cameraCapture->capture("robot1/still").value()->tick, std::uint64_t(9));
    }
    void aStreamShowsTheTickItCameTo() {
        QVERIFY(m_cameraCapture->capture("robot0/stream").ok());
        ticks(5);
        QCOMPARE(m_cameraCapture->capture("robot0/stream").value()->tick, std::uint64_t(3));
        ticks(2);
        QCOMPARE(m_cameraCapture->capture("robot0/stream").value()->tick, std::uint64_t(6));
        QVERIFY(m_cameraCapture->capture("robot0/stream").ok());
        QCOMPARE(m_story, std::string("made robot0/stream@0 robot0/stream@3 robot0/stream@6 "));
    }
    /// An image is recent until the next one is overdue, by the interval between the last two.
    void theNewestImagesAreKept() {
        QVERIFY(m_cameraCapture->images().empty());
        ticks(10);
        QVERIFY(m_cameraCapture->capture("robot0/still").ok());
        const RunImage first = m_cameraCapture->images().at("robot0/still");
        QVERIFY(first.image->tick == 10 && first.isRecentAt(10) && first.isRecentAt(12) && !first.isRecentAt(13));
        QVERIFY(!first.isRecentAt(9)); // it is of a later state
        ticks(4);
        const CameraImage* second = m_cameraCapture->capture("robot0/still").value();
        QVERIFY(m_cameraCapture->capture("robot0/still").ok()); // the same image
        const RunImage& kept = m_cameraCapture->images().at("robot0/still");
        QVERIFY(kept.image.get() == second && kept.image->tick == 14 && kept.interval == 4);
        QVERIFY(kept.isRecentAt(19) && !kept.isRecentAt(20));
        QCOMPARE(first.image->tick, std::uint64_t(10)); // images that someone holds do not change
        QVERIFY(!m_cameraCapture->capture("robot0/blind").ok() && m_cameraCapture->images().size() == 1);
    }
    void aFileIsOfWhatWasCaptured() {
        ticks(4);
        QCOMPARE(m_cameraCapture->file("robot0/stream", "a.png").value(), std::string("a.png of robot0/stream at tick 3"));
        QCOMPARE(m_cameraCapture->file("robot0/still", "b.png").value(), std::string("b.png of robot0/still at tick 4"));
        QCOMPARE(m_cameraCapture->viewFile("front", 4, 3, "c.png").value(), std::string("c.png of  at tick 0"));
        QVERIFY(m_story.ends_with("view front "));
    }
    void triesOpenGlOnce() {
        QCOMPARE(m_cameraCapture->capture("robot0/blind").error().message, std::string("no OpenGL"));
        QCOMPARE(m_cameraCapture->capture("robot0/still").error().message, std::string("no OpenGL"));
        QCOMPARE(m_story, std::string("made robot0/blind@0 "));
    }
    void reportsMissingRenderer() {
        CameraCapture cameraCapture(*m_world, nullptr);
        QCOMPARE(int(cameraCapture.capture("robot0/still").error().code), int(Code::NoGraphics));
    }

private:
    void ticks(int count) {
        for (int i = 0; i < count; ++i) {
            QVERIFY(m_world->tick().ok());
            m_cameraCapture->afterTick();
        }
    }

    std::string m_story;
    std::unique_ptr<BlockWorld> m_world;
    std::unique_ptr<CameraCapture> m_cameraCapture;
};

QTEST_APPLESS_MAIN(CameraCaptureTest)
#include "camera_capture_test.moc"
