// A run whose camera images have reduced quality reports it once. A program of its own: Mesa reads these variables at start, and
// then offers an OpenGL without antialiasing under the name of a graphics card.
#include <QtTest>

#include <trundle/abi.h>

#include "editor/running/session_fixture.h"
#include "eventually.h"

using namespace trundle;

class PicturesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        qputenv("LIBGL_ALWAYS_SOFTWARE", "1");
        qputenv("GALLIUM_DRIVER", "softpipe");
        qputenv("force_gl_renderer", "A card");
    }

    void reportsFallbackStyleInConsole() {
        SessionFixture o;
        QVERIFY(o.open(R"(Tick = 0.01   Duration = 0.3
#import robots/camera_robot.sim
#import arenas/medium_arena.sim
#loadModule controllers/blob_follow
Static arena { Config=MediumArena }
Robot robot0 { Config=CameraRobot Pos=-0.5,0,0 eye.Resolution=32,24 BlobFollow brain { KeepEvery=0 } }
View inside { Eye=0,0,1 Target=0,0,1 }
FrameLog film { View=inside Size=64,48 Interval=0.1 }
)"));
        QStringList warnings;
        QObject::connect(&o.session.messages(), &RunMessages::consoleLines, &o.session, [&](const std::vector<LiveLine>& lines) {
            for (const LiveLine& line : lines)
                if (line.severity == TRUNDLE_WARNING) warnings.append(QString::fromStdString(line.text));
        });
        o.session.setSpeed(0);
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Ended);
        QVERIFY(!o.session.results().end->failure);
        QCOMPARE(warnings, QStringList(QStringLiteral("the rich look is not available, so pictures have the fast one: "
                                                      "OpenGL has no 4 samples for a pixel")));
        // If images cannot be drawn at all, that is a problem.
        QCOMPARE(o.session.messages().problems().size(), 1u);
        QCOMPARE(QString::fromStdString(o.session.messages().problems().front().message),
                 QStringLiteral(
                     "FrameLog film leaves out pictures, the first is film_000000.jpg: no picture can be taken from this view"));
    }
};

QTEST_MAIN(PicturesTest)
#include "pictures_test.moc"
