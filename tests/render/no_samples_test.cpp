// OpenGL without multisampling and with too little memory, using Mesa's simplest driver. A separate program, because Mesa selects
// its driver once per process.
#include <QtTest>

#include <cstdlib>

#include "render/render_thread_state.h"
#include "render/sample_experiment.h"

using namespace trundle;

class NoSamplesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
        ::setenv("GALLIUM_DRIVER", "softpipe", 1);
        auto opened = RenderThreadState::open();
        QVERIFY2(opened.ok(), opened.ok() ? "" : opened.error().message.c_str());
        m_state = std::move(opened).value();
        QCOMPARE(m_state->context().renderer(), std::string("softpipe"));
        m_state->add(SceneId(1), sampleExperiment({2}), nullptr);
        m_request.scene = SceneId(1);
        m_request.width = 160;
        m_request.height = 120;
    }
    void cleanupTestCase() { m_state.reset(); }

    void edgesStayRough() {
        m_request.samples = 1;
        const Result<Image> rough = m_state->draw(m_request, LookChoice::Fast);
        m_request.samples = 4;
        const Result<Image> smooth = m_state->draw(m_request, LookChoice::Fast);
        QVERIFY(rough.ok() && smooth.ok());
        QVERIFY(rough.value() == smooth.value());
        QCOMPARE(m_state->takeWarning(), std::string());
    }

    void fallsBackToFastStyle() {
        m_request.samples = 4;
        const Result<Image> fast = m_state->draw(m_request, LookChoice::Fast), rich = m_state->draw(m_request, LookChoice::Rich);
        QVERIFY2(rich.ok(), rich.ok() ? "" : rich.error().message.c_str());
        QVERIFY(rich.value() == fast.value());
        QCOMPARE(m_state->takeWarning(), std::string("the rich look is not available, so pictures have the fast one: OpenGL "
                                                     "has no 4 samples for a pixel"));
        QVERIFY(m_state->draw(m_request, LookChoice::Rich).ok());
        QCOMPARE(m_state->takeWarning(), std::string()); // once
    }

    /// The service limits image sizes, but a graphics card may have too little memory for an allowed size.
    void reportsUnavailableFramebuffer_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("samples");
        QTest::newRow("too wide") << 1'000'000 << 1;
        QTest::newRow("more samples than there are") << 64 << 64;
    }
    void reportsUnavailableFramebuffer() {
        QFETCH(int, width);
        QFETCH(int, samples);
        osg::ref_ptr<GraphicsContext> context = new GraphicsContext;
        const auto target = Target::create(*context, {std::uint32_t(width), 48, samples});
        QVERIFY(!target);
        QCOMPARE(codeName(target.error().code), std::string("E511"));
        QCOMPARE(target.error().message, "no room to draw a picture of " + std::to_string(width) + " x 48");
        QVERIFY(Target::create(*context, {64, 48, 1}).ok()); // the failure released its resources
        context->release();
    }

private:
    std::unique_ptr<RenderThreadState> m_state;
    PictureRequest m_request;
};

QTEST_APPLESS_MAIN(NoSamplesTest)
#include "no_samples_test.moc"
