// An edit loads the project exactly once, for every kind of edit and any size of the experiment.

#include <QElapsedTimer>
#include <QTest>

#include "editor/document/structure_edits.h"
#include "sample_document.h"

using namespace trundle;
using namespace sample;

namespace {

/// The application, counting its loads.
class CountingApplication final : public Application {
public:
    std::shared_ptr<const Registry> builtIn() const override { return m_application->builtIn(); }
    std::vector<Kind> moduleKinds(const OpenOptions& options) const override { return m_application->moduleKinds(options); }
    const Locations& locations() const override { return m_application->locations(); }
    Result<std::shared_ptr<const LoadedProject>> open(const std::string& path, const OpenOptions& options) override {
        ++loads;
        return m_application->open(path, options);
    }
    std::unique_ptr<Runner> makeRunner(const LoadedProject& loaded, RunOptions options, Diagnostics& diagnostics) override {
        return m_application->makeRunner(loaded, std::move(options), diagnostics);
    }

    int loads = 0;

private:
    std::unique_ptr<Application> m_application = makeApplication();
};

} // namespace

class LoadsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aStepOfADragIsOneLoad_data() {
        QTest::addColumn<int>("robots");
        QTest::newRow("two robots") << 2;
        QTest::newRow("300 robots") << 300;
    }
    void aStepOfADragIsOneLoad() {
        QFETCH(int, robots);
        std::string text = "Tick = 0.01\n#import robots/simple_robot.sim\n";
        for (int i = 0; i < robots; ++i)
            text += "Robot robot" + std::to_string(i) + " { Config=SimpleRobot Pos=" + std::to_string(i % 20) + "," +
                    std::to_string(i / 20) + ",0 }\n";
        const DocumentFixture fixture;
        CountingApplication application;
        Document d(application);
        QVERIFY(d.opening().open(fixture.write("configs/many.sim", text)).ok());
        QVERIFY(!d.loaded()->diagnostics.hasErrors());
        application.loads = 0;
        QElapsedTimer clock;
        clock.start();
        constexpr int kSteps = 20;
        for (int i = 1; i <= kSteps; ++i) {
            QVERIFY(d.structure().setValues(u"Move robot1"_qs, {{"robot1.Pos", "0." + std::to_string(i) + ",0,0"}}, "drag").ok());
            QCOMPARE(application.loads, i);
            QCOMPARE(d.loaded()->parses, 1u);
        }
        qInfo("%d robots: %.1f ms a step", robots, double(clock.nsecsElapsed()) / 1e6 / kSteps);
        QVERIFY(!d.structure().setValues(u"Move robot1"_qs, {{"robot1.Pos", "0,0"}}, "drag").ok());
        QCOMPARE(application.loads, kSteps + 1); // one load, to find that the value is invalid
        QVERIFY(!d.structure().setValues(u"Move robot1"_qs, {{"robot1.Pos", "}"}}, "drag").ok());
        QVERIFY(!d.structure().setValues(u"Move ghost"_qs, {{"ghost.Pos", "0,0,0"}}, "drag").ok());
        QCOMPARE(application.loads, kSteps + 1); // an edit of an unknown object, or one that does not parse, causes no load
        d.edits().discardMerge("drag");
        QCOMPARE(application.loads, kSteps + 2);
        QCOMPARE(*d.texts().text(d.path()), text);
        QVERIFY(!d.texts().isModified());
    }
};

QTEST_GUILESS_MAIN(LoadsTest)
#include "loads_test.moc"
