// Movies and large images that the window exports.

#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QtTest>

#include "editor/cameras/camera_window.h"
#include "editor/cameras/movie_dialog.h"
#include "editor/cameras/picture_dialog.h"
#include "editor/cameras/size_choice.h"
#include "editor/viewport/view/picture_request.h"
#include "eventually.h"

using namespace trundle;

namespace {

/// "width,height,rate,images"
QByteArray factsOf(const QString& movie) {
    QProcess probe;
    probe.start(QStringLiteral("ffprobe"),
                {QStringLiteral("-v"), QStringLiteral("error"), QStringLiteral("-count_frames"),
                 QStringLiteral("-select_streams"), QStringLiteral("v:0"), QStringLiteral("-show_entries"),
                 QStringLiteral("stream=width,height,r_frame_rate,nb_read_frames"), QStringLiteral("-of"),
                 QStringLiteral("csv=p=0"), movie});
    return probe.waitForFinished(60000) ? probe.readAllStandardOutput().trimmed() : QByteArray();
}

constexpr int kEyeBytes = 160 * 120 * 3; // bytes of one image of robot0/eye

/// The pixels of all images of the movie.
QByteArray pixelsOf(const QString& movie) {
    QProcess reader;
    reader.start(QStringLiteral("ffmpeg"),
                 {QStringLiteral("-v"), QStringLiteral("error"), QStringLiteral("-i"), movie, QStringLiteral("-f"),
                  QStringLiteral("rawvideo"), QStringLiteral("-pix_fmt"), QStringLiteral("rgb24"), QStringLiteral("-")});
    return reader.waitForFinished(60000) ? reader.readAllStandardOutput() : QByteArray();
}

} // namespace

class MovieTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Numbers and names of sizes follow each other.
    void sizesHaveNames() {
        for (const QSize shown : {QSize(), QSize(640, 400)}) {
            SizeChoice choice(shown);
            auto* named = choice.findChild<QComboBox*>(QStringLiteral("pictureSize"));
            auto* width = choice.findChild<QSpinBox*>(QStringLiteral("pictureWidth"));
            auto* height = choice.findChild<QSpinBox*>(QStringLiteral("pictureHeight"));
            QCOMPARE(choice.size(), shown.isEmpty() ? QSize(1280, 720) : shown);
            QCOMPARE(named->currentText(), shown.isEmpty() ? QStringLiteral("HD") : QStringLiteral("Screen size"));
            QSignalSpy changed(&choice, &SizeChoice::changed);
            choice.setSize({3840, 2160});
            QCOMPARE(named->currentText(), QStringLiteral("4K"));
            QCOMPARE(changed.count(), 1);
            height->setValue(2159);
            QCOMPARE(named->currentText(), QStringLiteral("Other"));
            width->setValue(1920);
            height->setValue(1080);
            QCOMPARE(named->currentText(), QStringLiteral("Full HD"));
            QCOMPARE(changed.count(), 4);
            named->setCurrentIndex(named->findText(QStringLiteral("HD")));
            Q_EMIT named->activated(named->currentIndex());
            QCOMPARE(choice.size(), QSize(1280, 720));
            named->setCurrentIndex(named->count() - 1); // Other keeps the numbers
            Q_EMIT named->activated(named->currentIndex());
            QCOMPARE(choice.size(), QSize(1280, 720));
            choice.setSize({1, 99999}); // limits
            QCOMPARE(choice.size(), QSize(16, 4096));
        }
    }

    void initTestCase() { m_render = RenderService::startInBackground(); }
    void init() {
        m_window = std::make_unique<CameraWindow>(m_render.get());
        QVERIFY(m_window->open(kTwoEyes));
    }
    void cleanup() { m_window.reset(); }

    void aMovieHasExactlyItsPictures_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("camera");
        QTest::newRow("MP4 of a camera") << "a.mp4" << true;
        QTest::newRow("MP4 of the view") << "a.mp4" << false;
        QTest::newRow("WebM of the view") << "a.webm" << false;
    }
    void aMovieHasExactlyItsPictures() {
        QFETCH(QString, name);
        QFETCH(bool, camera);
        MovieJob job = jobFor(name);
        if (camera) job.camera = "robot0/eye";
        job.begin = 0.5;
        job.end = 1.5;
        job.framesPerSecond = 24;
        QCOMPARE(job.frameCount(), 25u);
        QCOMPARE(recorded(job), QString());
        QCOMPARE(factsOf(m_window->folder.filePath(name)), QByteArray(camera ? "160,120,24/1,25" : "96,64,24/1,25"));
        QCOMPARE(hiddenFiles(), QStringList());
    }

    /// The same with and without other drawing, and in the CLI.
    void allRecordingsHaveTheSamePixels() {
        QByteArray pixels[2];
        for (QByteArray& each : pixels) {
            MovieJob job = jobFor(QStringLiteral("a.mp4"));
            job.camera = "robot0/eye";
            job.framesPerSecond = 10;
            MovieRecorder recorder(*m_window->application, *m_render);
            QSignalSpy finished(&recorder, &MovieRecorder::finished);
            recorder.start(job);
            if (&each == &pixels[1]) m_window->view().camera().lookThrough("robot1/eye");
            QVERIFY(finished.wait(60000));
            QCOMPARE(finished.front().front().toString(), QString());
            each = pixelsOf(m_window->folder.filePath(QStringLiteral("a.mp4")));
            QCOMPARE(each.size(), 6 * kEyeBytes);
            QVERIFY(each.left(kEyeBytes) != each.right(kEyeBytes)); // the robot moved
        }
        QVERIFY(pixels[0] == pixels[1]);
        QVERIFY(pixels[0] == pixelsOf(filmedWithoutAWindow("robot0/eye")));
    }

    /// A camera with an UpdatePeriod: the movie has the images that the robot receives, in the window and in the CLI.
    void recordsStreamAsRobotReceivesIt() {
        QByteArray text = kTwoEyes;
        text.replace("BlobFollow brain", "eye.UpdatePeriod=0.3 BlobFollow brain");
        QVERIFY(m_window->open(text));
        MovieJob job = jobFor(QStringLiteral("a.mp4"));
        job.camera = "robot0/eye";
        job.framesPerSecond = 10;
        QCOMPARE(recorded(job), QString());
        const QString here = m_window->folder.filePath(QStringLiteral("a.mp4"));
        QVERIFY(pixelsOf(here) == pixelsOf(filmedWithoutAWindow("robot0/eye")));
        QVERIFY(!pixelsOf(here).isEmpty());
    }

    void recordsManualCommands() {
        QVERIFY(m_window->runTicks(10));
        m_window->session.robots().place("robot1", {Vec3(-0.6, 0, 0), rotationFromHpr({3, 0, 0})});
        m_window->session.runFor(0.1);
        EVENTUALLY(m_window->session.state() == RunState::Paused && m_window->session.results().snapshot->tick == 20);
        QCOMPARE(m_window->session.robots().all().size(), std::size_t(1));
        QByteArray films[2];
        for (const bool byHand : {false, true}) {
            MovieJob job = jobFor(byHand ? QStringLiteral("hand.mp4") : QStringLiteral("alone.mp4"));
            job.loaded = m_window->session.results().built;
            job.camera = "robot0/eye"; // the other robot is directly in front of it now
            job.end = 0.2;
            job.framesPerSecond = 100; // one picture in each tick
            if (byHand) job.commands = m_window->session.robots().all();
            MovieRecorder recorder(*m_window->application, *m_render);
            QSignalSpy finished(&recorder, &MovieRecorder::finished);
            recorder.start(job);
            QVERIFY(finished.wait(60000));
            films[byHand] = pixelsOf(QString::fromStdString(job.path));
            QCOMPARE(films[byHand].size(), 21 * kEyeBytes);
        }
        const auto changedIn = [&](int picture) {
            int changed = 0;
            for (auto i = picture * kEyeBytes; i < (picture + 1) * kEyeBytes; ++i)
                changed += std::abs(int(uchar(films[0][i])) - int(uchar(films[1][i]))) > 60;
            return changed;
        };
        const int from = int(m_window->session.robots().all().front().tick) + 1; // the first that the command has changed
        QVERIFY2(changedIn(20) > 2000, qPrintable(QString::number(changedIn(20))));
        QVERIFY2(changedIn(from) > 2000, qPrintable(QString::number(changedIn(from))));
        QVERIFY2(changedIn(from - 1) < 500, qPrintable(QString::number(changedIn(from - 1))));
    }

    void cancelledRecordingLeavesNoFile() {
        MovieJob job = jobFor(QStringLiteral("a.mp4"));
        job.end = 1e5;
        MovieRecorder recorder(*m_window->application, *m_render);
        QSignalSpy finished(&recorder, &MovieRecorder::finished), progressed(&recorder, &MovieRecorder::progressed);
        recorder.start(job);
        QVERIFY(progressed.wait(60000));
        QVERIFY(progressed.wait(60000));
        QVERIFY(recorder.isRecording());
        recorder.cancel();
        QVERIFY(finished.wait(60000));
        QVERIFY(finished.front().at(1).toBool());
        QVERIFY(!QFile::exists(m_window->folder.filePath(QStringLiteral("a.mp4"))));
        QCOMPARE(hiddenFiles(), QStringList());
    }

    void destroyingRecorderRemovesMovie() {
        {
            MovieJob job = jobFor(QStringLiteral("a.mp4"));
            job.end = 1e5;
            MovieRecorder recorder(*m_window->application, *m_render);
            QSignalSpy progressed(&recorder, &MovieRecorder::progressed);
            recorder.start(job);
            QVERIFY(progressed.wait(60000));
        }
        QTRY_COMPARE_WITH_TIMEOUT(hiddenFiles(), QStringList(), 60000); // its thread ends after the current image
    }

    void reportsFailures() {
        MovieJob job = jobFor(QStringLiteral("none/a.mp4"));
        MovieRecorder recorder(*m_window->application, *m_render);
        QSignalSpy finished(&recorder, &MovieRecorder::finished);
        recorder.start(job);
        QVERIFY(finished.wait(60000));
        QVERIFY(!finished.front().at(1).toBool());
        QVERIFY2(finished.front().front().toString().contains(QStringLiteral("cannot be")),
                 qPrintable(finished.front().front().toString()));
    }

    void dialogRecordsMovie() {
        QVERIFY(m_window->runTicks(30));
        MovieDialogOptions offer;
        offer.text = m_window->document.loaded();
        offer.run = m_window->session.results().built;
        offer.commands = m_window->session.robots().all();
        offer.runTime = m_window->session.results().time();
        offer.view = [this](std::uint32_t width, std::uint32_t height) {
            return m_window->view().camera().movingView(width, height);
        };
        offer.look = stillRequest(m_window->view(), 96, 64);
        offer.file = m_window->folder.filePath(QStringLiteral("run.avi"));
        auto* dialog = new MovieDialog(*m_window->application, *m_render, offer, m_window->panel.get());
        dialog->show();
        auto* record = dialog->findChild<QPushButton*>(QStringLiteral("movieRecord"));
        auto* sum = dialog->findChild<QLabel*>(QStringLiteral("movieSum"));
        auto* open = dialog->findChild<QPushButton*>(QStringLiteral("movieOpen"));
        auto* show = dialog->findChild<QPushButton*>(QStringLiteral("movieShowInFolder"));
        QVERIFY(!open->isVisible() && !show->isVisible()); // there is no movie yet
        QVERIFY(!record->isEnabled());
        QVERIFY(sum->text().contains(QStringLiteral(".webm")));
        dialog->findChild<QLineEdit*>(QStringLiteral("movieFile"))->setText(m_window->folder.filePath(QStringLiteral("run.mp4")));
        QVERIFY(record->isEnabled());
        QCOMPARE(dialog->job().end, 0.3); // the simulated time so far
        QCOMPARE(dialog->job().loaded, m_window->session.results().built);
        dialog->findChild<QSpinBox*>(QStringLiteral("pictureWidth"))->setValue(96);
        dialog->findChild<QSpinBox*>(QStringLiteral("pictureHeight"))->setValue(64);
        QVERIFY2(sum->text().contains(QStringLiteral("10 pictures")), qPrintable(sum->text()));
        QSignalSpy recorded(dialog, &MovieDialog::recorded);
        QTest::mouseClick(record, Qt::LeftButton);
        QVERIFY(dialog->isRecording());
        QVERIFY(recorded.wait(60000));
        QCOMPARE(factsOf(m_window->folder.filePath(QStringLiteral("run.mp4"))), QByteArray("96,64,30/1,10"));
        EVENTUALLY(open->isVisible() && show->isVisible());
        QVERIFY(open->isDefault());
        QStringList opened;
        dialog->setOpener([&opened](const QString& path) {
            opened << path;
            return false; // there is no such program
        });
        open->click();
        QVERIFY2(sum->text().contains(QStringLiteral("run.mp4")) && sum->text().contains(QStringLiteral("No program")),
                 qPrintable(sum->text()));
        show->click();
        QVERIFY2(sum->text().contains(QStringLiteral("No file manager")), qPrintable(sum->text()));
        QCOMPARE(opened, (QStringList{m_window->folder.filePath(QStringLiteral("run.mp4")), m_window->folder.path()}));
        dialog->close();
    }

    void aViewIsSavedInEverySize_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<QString>("name");
        QTest::newRow("4K") << QSize(3840, 2160) << "view.png";
        QTest::newRow("small JPEG") << QSize(64, 200) << "view.jpg";
    }
    void aViewIsSavedInEverySize() {
        QFETCH(QSize, size);
        QFETCH(QString, name);
        const auto still = [this](std::uint32_t width, std::uint32_t height) {
            return stillRequest(m_window->view(), width, height);
        };
        auto* dialog = new PictureDialog(*m_render, still, {900, 700}, m_window->folder.filePath(name), m_window->panel.get());
        dialog->open();
        dialog->findChild<QSpinBox*>(QStringLiteral("pictureWidth"))->setValue(size.width());
        dialog->findChild<QSpinBox*>(QStringLiteral("pictureHeight"))->setValue(size.height());
        QSignalSpy written(dialog, &PictureDialog::written);
        QTest::keyClick(dialog->findChild<QSpinBox*>(QStringLiteral("pictureHeight")), Qt::Key_Return);
        QVERIFY(written.wait(60000));
        QCOMPARE(QImage(m_window->folder.filePath(name)).size(), size);
    }

private:
    /// Why the movie was not made; empty on success.
    QString recorded(const MovieJob& job) {
        MovieRecorder recorder(*m_window->application, *m_render);
        QSignalSpy finished(&recorder, &MovieRecorder::finished);
        recorder.start(job);
        return finished.wait(60000) ? finished.front().front().toString() : QStringLiteral("it does not end");
    }

    MovieJob jobFor(const QString& name) {
        MovieJob job;
        job.loaded = m_window->document.loaded();
        job.look = stillRequest(m_window->view(), 96, 64);
        job.look.samples = 1;
        job.view = m_window->view().camera().movingView(96, 64);
        job.end = 0.5;
        job.path = m_window->folder.filePath(name).toStdString();
        return job;
    }
    /// A movie of half a second of the open text, made by the CLI.
    QString filmedWithoutAWindow(const char* camera) {
        const QString movie = m_window->folder.filePath(QStringLiteral("headless.mp4"));
        const QString file = QString::fromStdString(m_window->document.path());
        const int code = QProcess::execute(QStringLiteral(TRUNDLE_BINARY_DIR "/bin/trundle-cli"),
                                           {QStringLiteral("run"), file, QStringLiteral("--quiet"),
                                            QStringLiteral("--duration=0.5"), QStringLiteral("--movie"), movie,
                                            QStringLiteral("--camera"), QString::fromLatin1(camera), QStringLiteral("--fps=10")});
        return code == 0 ? movie : QString();
    }
    /// Temporary files of movies that were not finished.
    QStringList hiddenFiles() {
        return QDir(m_window->folder.path()).entryList({QStringLiteral(".*.tmp")}, QDir::Files | QDir::Hidden);
    }
    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<CameraWindow> m_window;
};

QTEST_MAIN(MovieTest)
#include "movie_test.moc"
