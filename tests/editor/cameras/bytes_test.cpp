// Camera images are byte-identical with the window (views and dock draw beside the run) and without it.

#include <QtTest>

#include "editor/cameras/camera_window.h"
#include "eventually.h"

using namespace trundle;

namespace {

QMap<QString, QByteArray> picturesIn(const QString& folder) {
    QMap<QString, QByteArray> pictures;
    for (const QFileInfo& file : QDir(folder).entryInfoList({QStringLiteral("*.png"), QStringLiteral("*.jpg")})) {
        QFile picture(file.filePath());
        if (picture.open(QIODevice::ReadOnly)) pictures[file.fileName()] = picture.readAll();
    }
    return pictures;
}

} // namespace

class CameraBytesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theWindowChangesNoPicture() {
        const auto render = RenderService::startInBackground();
        CameraWindow window(render.get());
        QVERIFY(window.open(kTwoEyes + "Duration = 1\nFrameLog film { Camera=robot0/eye Interval=0.1 Format=png }\n"
                                       "FrameLog depth { Camera=robot1/eye Interval=0.2 Format=png }\n"));
        QVERIFY2(!window.document.loaded()->diagnostics.hasErrors(),
                 window.document.loaded()->diagnostics.all().empty()
                     ? ""
                     : window.document.loaded()->diagnostics.all().front().message.c_str());
        window.selection.select("robot0");
        window.trigger("view.overlayFrusta");
        window.view().camera().lookThrough("robot0/eye");
        EVENTUALLY(window.cameras.isSettled());
        const int before = window.cameras.drawnCount();
        window.session.setSpeed(0.01); // slow until images were drawn, also on a loaded machine: the thread that draws yields to others
        window.session.run();
        EVENTUALLY(window.cameras.drawnCount() > before && window.view().image().redraws() > 2);
        QCOMPARE(window.session.state(), RunState::Running);
        window.session.setSpeed(0);
        EVENTUALLY_EQUAL(window.session.state(), RunState::Ended);
        QVERIFY(!window.session.results().end->failure);
        const auto seen = picturesIn(window.folder.filePath(QStringLiteral("logs/trial")));

        const QString alone = window.folder.filePath(QStringLiteral("alone"));
        const auto runner = window.headless(100, alone.toStdString());
        QVERIFY(runner && runner->finish().ok());
        const auto expected = picturesIn(alone);
        QCOMPARE(expected.size(), 11 + 6);
        QCOMPARE(seen.keys(), expected.keys());
        for (auto it = expected.begin(); it != expected.end(); ++it) QVERIFY2(seen[it.key()] == it.value(), qPrintable(it.key()));
        QVERIFY(expected.first() != expected[QStringLiteral("film_000010.png")]); // the robot moved
    }
};

QTEST_MAIN(CameraBytesTest)
#include "bytes_test.moc"
