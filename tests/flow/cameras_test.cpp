// The shipped experiments with cameras, run by the CLI: images, movies and controllers that use them.

#include "flow/cli.h"

namespace {

const QString kExperiment = configPath("experiments/blob_follow.sim");
constexpr double kTargetX = 1.9, kTargetY = 0.3;

/// x and y of the last row of a pose log.
QPair<double, double> lastPlace(const QString& path) {
    const QList<QByteArray> rows = contentOf(path).trimmed().split('\n');
    const QList<QByteArray> cells = rows.last().split(',');
    return cells.size() > 3 ? qMakePair(cells[2].toDouble(), cells[3].toDouble()) : qMakePair(1e9, 1e9);
}

/// One line per frame of a movie, with the checksum of its pixels.
QList<QByteArray> picturesOf(const QString& movie) {
    const Outcome reader = callProgram("ffmpeg", {"-v", "error", "-i", movie, "-map", "0:v", "-f", "framemd5", "-"});
    QList<QByteArray> pictures;
    for (const QByteArray& line : reader.out.split('\n'))
        if (!line.isEmpty() && !line.startsWith('#')) pictures.append(line);
    return pictures;
}

/// `environment`: arguments of env, "-u NAME" or "NAME=value".
Outcome cliWith(const QStringList& environment, const QStringList& arguments) {
    return callProgram("/usr/bin/env", environment + QStringList{programPath()} + arguments);
}

} // namespace

class CamerasFlowTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theBlobIsFoundFromEveryStart_data() {
        QTest::addColumn<int>("seed");
        const int last = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 20 : 3;
        for (int seed = 1; seed <= last; ++seed) QTest::addRow("seed %d", seed) << seed;
    }
    void theBlobIsFoundFromEveryStart() {
        QFETCH(int, seed);
        QTemporaryDir logs;
        const Outcome run = cli({"run", kExperiment, "--seed", QString::number(seed), "--log-dir", logs.path()});
        QVERIFY2(run.code == 0, shown(run));
        QVERIFY2(run.err.contains("there"), shown(run));
        const auto [x, y] = lastPlace(logs.filePath("blob_follow.csv"));
        const double away = std::hypot(x - kTargetX, y - kTargetY);
        QVERIFY2(away < 0.7, qPrintable(QStringLiteral("%1 m away").arg(away)));
        const QStringList pictures = QDir(logs.path()).entryList({"seeker_0_*.jpg"});
        QVERIFY(pictures.size() > 3);
        QVERIFY(contentOf(logs.filePath(pictures.last())).startsWith("\xff\xd8\xff"));
    }

    /// On omni wheels around the ball and to the goal with it, whose line is at x = 2.25 m, from different kick-offs.
    void scoresGoals() {
        for (const int seed : {1, 2, 3}) {
            QTemporaryDir logs;
            const Outcome run =
                cli({"run", configPath("experiments/soccer.sim"), "--seed", QString::number(seed), "--log-dir", logs.path()});
            QVERIFY2(run.code == 0, shown(run));
            QVERIFY2(run.err.contains("kicks"), shown(run));
            const QList<QByteArray> rows = contentOf(logs.filePath("soccer.csv")).trimmed().split('\n');
            const auto place = [&rows](const char* name) {
                for (auto row = rows.rbegin(); row != rows.rend(); ++row)
                    if (const QList<QByteArray> cells = row->split(','); cells.value(1) == name)
                        return std::pair(cells.value(2).toDouble(), cells.value(3).toDouble());
                return std::pair(0., 9.);
            };
            const auto [x, y] = place("ball_0");
            QVERIFY2(x > 2.25 && x < 2.45 && std::abs(y) < 0.36, qPrintable(QStringLiteral("%1, %2").arg(x).arg(y)));
            QVERIFY(place("striker").first < 2.1); // which stops before the goal
        }
    }

    void twoRunsKeepTheSamePictures() {
        QTemporaryDir one, two;
        for (const QTemporaryDir* logs : {&one, &two})
            QCOMPARE(cli({"run", kExperiment, "--duration", "3", "--log-dir", logs->path()}).code, 0);
        const QStringList pictures = QDir(one.path()).entryList({"*.jpg"});
        QCOMPARE(pictures.size(), 6);
        for (const QString& picture : pictures)
            QVERIFY2(contentOf(one.filePath(picture)) == contentOf(two.filePath(picture)), qPrintable(picture));
    }

    void rendersCameraView() {
        QTemporaryDir folder;
        const QString picture = folder.filePath("eye.png");
        const Outcome drawn = cli({"render", kExperiment, "--camera", "seeker_0/eye", "--at", "1", "-o", picture});
        QVERIFY2(drawn.code == 0, shown(drawn));
        QVERIFY(contentOf(picture).startsWith("\x89PNG"));
        QVERIFY(contentOf(picture).contains("camera = seeker_0/eye"));
        const Outcome wrong = cli({"render", kExperiment, "--camera", "seeker_0/ear", "-o", picture});
        QCOMPARE(wrong.code, 1);
        QVERIFY2(wrong.err.contains("there is no camera seeker_0/ear; there is seeker_0/eye"), shown(wrong));
    }

    void aViewOfTheTextCanBeDrawn() {
        QTemporaryDir folder;
        const auto draw = [&](const QString& view, const QString& at) {
            const QString picture = folder.filePath(view + at + ".png");
            const Outcome drawn = cli({"render", kExperiment, "--view", view, "--at", at, "--size", "160x100", "-o", picture});
            return drawn.code == 0 ? contentOf(picture) : shown(drawn);
        };
        QVERIFY2(draw("overview", "0").startsWith("\x89PNG"), draw("overview", "0"));
        QVERIFY2(draw("behind", "0").startsWith("\x89PNG"), draw("behind", "0"));
        QVERIFY(draw("behind", "0") != draw("behind", "12")); // the view moves with the robot
        QVERIFY2(draw("below", "0").contains("there is no view below; there is overview, behind"), draw("below", "0"));
    }

    void aFrameLogNumbersItsPictures() {
        QTemporaryDir folder;
        QFile::copy(kExperiment, folder.filePath("film.sim"));
        QVERIFY(writeFile(folder.filePath("film.sim"),
                          contentOf(kExperiment) + "FrameLog film { Camera=seeker_0/eye Interval=0.5 }\n"
                                                   "FrameLog above { View=overview Size=64,48 Format=png Interval=1 }\n"));
        const Outcome run = cli({"run", folder.filePath("film.sim"), "--duration", "1", "--log-dir", folder.filePath("logs")});
        QVERIFY2(run.code == 0, shown(run));
        const QDir logs(folder.filePath("logs"));
        QCOMPARE(logs.entryList({"film_*"}), (QStringList{"film_000000.jpg", "film_000001.jpg", "film_000002.jpg"}));
        QCOMPARE(logs.entryList({"above_*"}), (QStringList{"above_000000.png", "above_000001.png"}));
        QCOMPARE(contentOf(logs.filePath("film.csv")),
                 QByteArray("time [s],picture\n0,film_000000.jpg\n0.5,film_000001.jpg\n1,film_000002.jpg\n"));
    }

    void frameLogListsPictureTimes() {
        QTemporaryDir folder;
        QVERIFY(writeFile(folder.filePath("film.sim"), "#import robots/camera_robot.sim\n"
                                                       "Tick=0.01 Duration=0.15\n"
                                                       "Robot a { Config=CameraRobot eye.UpdatePeriod=0.1 }\n"
                                                       "FrameLog film { Camera=a/eye Interval=0.05 Format=png }\n"));
        const Outcome run = cli({"run", folder.filePath("film.sim"), "--log-dir", folder.path()});
        QVERIFY2(run.code == 0, shown(run));
        QCOMPARE(contentOf(folder.filePath("film.csv")), QByteArray("time [s],picture\n0,film_000000.png\n0,film_000001.png\n"
                                                                    "0.1,film_000002.png\n0.1,film_000003.png\n"));
        QVERIFY(contentOf(folder.filePath("film_000000.png")) == contentOf(folder.filePath("film_000001.png")));
        QVERIFY(contentOf(folder.filePath("film_000001.png")) != contentOf(folder.filePath("film_000002.png")));
    }

    /// A check reports these errors, before a run starts.
    void frameLogListsExistingFiles() {
        QTemporaryDir folder;
        const auto check = [&](const char* log) {
            if (!writeFile(folder.filePath("film.sim"), contentOf(kExperiment) + log)) return Outcome{};
            return cli({"check", folder.filePath("film.sim")});
        };
        const Outcome camera = check("FrameLog film { Camera=seeker_0/eyes }\n"),
                      view = check("FrameLog film { View=ovrview }\n");
        QCOMPARE(camera.code, 1);
        QVERIFY2(camera.err.contains("E208: Camera names seeker_0/eyes, but there is no such camera"), shown(camera));
        QVERIFY2(camera.err.contains("fix: seeker_0/eye"), shown(camera));
        QVERIFY2(view.code == 1 && view.err.contains("View names ovrview, but there is no such view"), shown(view));
        const Outcome both = check("FrameLog film { Camera=seeker_0/eye View=overview }\n");
        QVERIFY2(both.code == 0 && both.err.contains("has a Camera, so its View takes no pictures"), shown(both));
        const QByteArray before = "#import other.sim\n" + QByteArray(contentOf(kExperiment)) + "\n"; // both begin at one byte
        QVERIFY(writeFile(folder.filePath("other.sim"), QByteArray(before.size() - 1, '/') + "\nFrameLog a { View=one }\n"));
        QVERIFY(writeFile(folder.filePath("film.sim"), before + "FrameLog b { View=two }\n"));
        const Outcome two = cli({"check", folder.filePath("film.sim")});
        QVERIFY2(two.err.contains("View names one,") && two.err.contains("View names two,"), shown(two));
    }

    void runContinuesWithoutPictures() {
        QTemporaryDir logs;
        const QStringList environment{"-u", "DISPLAY", "__EGL_VENDOR_LIBRARY_FILENAMES=/nowhere/none.json"};
        const Outcome run = cliWith(
            environment, {"run", configPath("experiments/camera_swarm.sim"), "--duration", "1", "--log-dir", logs.path()});
        QVERIFY2(run.code == 0, shown(run));
        QCOMPARE(run.err.count("E510"), 1);
        QVERIFY2(run.err.contains("cannot see, stays where it is: no OpenGL to draw with"), shown(run));
    }

    void reportsFailedPictureOnce() {
        QTemporaryDir folder;
        QVERIFY(writeFile(folder.filePath("film.sim"), contentOf(kExperiment) +
                                                           "View inside { Eye=0,0,1 Target=0,0,1 }\n"
                                                           "FrameLog film { View=inside Size=64,48 Interval=0.1 }\n"));
        const Outcome run = cli({"run", folder.filePath("film.sim"), "--duration", "0.3", "--log-dir", folder.path()});
        QVERIFY2(run.code == 0, shown(run));
        QVERIFY2(run.err.count("warning E511: FrameLog film leaves out pictures, the first is film_000000.jpg: "
                               "no picture can be taken from this view") == 1,
                 shown(run));
        QCOMPARE(contentOf(folder.filePath("film.csv")), QByteArray("time [s],picture\n0,\n0.1,\n0.2,\n0.3,\n"));
    }

    void reportsTakenPictureNameOnce() {
        QTemporaryDir folder;
        QVERIFY(writeFile(folder.filePath("film.sim"), "#import robots/camera_robot.sim\n"
                                                       "Tick=0.01 Duration=0.02\n"
                                                       "Robot a { Config=CameraRobot }\n"
                                                       "PoseLog path { File=film_000001.png }\n"
                                                       "FrameLog film { Camera=a/eye Format=png }\n"));
        const Outcome run = cli({"run", folder.filePath("film.sim"), "--log-dir", folder.path()});
        QVERIFY2(run.code == 0, shown(run));
        QVERIFY2(run.err.count("warning E503: FrameLog film leaves out pictures, the first is film_000001.png: "
                               "film_000001.png is already written by this run") == 1,
                 shown(run));
        QCOMPARE(contentOf(folder.filePath("film.csv")),
                 QByteArray("time [s],picture\n0,film_000000.png\n0.01,\n0.02,film_000002.png\n"));
    }

    /// A shell with a small file size limit stands in for a full disk.
    void fullDiskLeavesNoPartialPictures() {
        QTemporaryDir folder;
        const QString logs = folder.filePath("logs");
        QVERIFY(writeFile(folder.filePath("film.sim"), "#import robots/camera_robot.sim\n"
                                                       "Tick=0.01 Duration=0.05\n"
                                                       "Robot a { Config=CameraRobot }\n"
                                                       "FrameLog film { Camera=a/eye Format=png }\n"
                                                       "FrameLog other { Camera=a/eye Format=png }\n"));
        const Outcome run = callProgram("/bin/sh", {"-c", "ulimit -f 1; trap '' XFSZ; exec \"$0\" run \"$1\" --log-dir \"$2\"",
                                                    programPath(), folder.filePath("film.sim"), logs});
        QVERIFY2(run.code == 1, shown(run));
        QVERIFY2(run.err.count("warning E503: FrameLog film leaves out pictures, the first is film_000000.png: cannot write") ==
                     1,
                 shown(run));
        QCOMPARE(run.err.count("warning E503: FrameLog other leaves out pictures"), 1);
        QCOMPARE(QDir(logs).entryList({"*.png"}), QStringList());
    }

    void aMovieWithoutItsProgramIsRefusedBeforeTheRun() {
        QTemporaryDir folder;
        const QStringList environment{"PATH=" + folder.path()};
        const Outcome run =
            cliWith(environment, {"run", kExperiment, "--movie", folder.filePath("a.mp4"), "--log-dir", folder.path()});
        QVERIFY2(run.code == 2, shown(run));
        QVERIFY2(run.err.contains("the program ffmpeg is not installed"), shown(run));
        QVERIFY(!QFile::exists(folder.filePath("blob_follow.csv")));
    }

    /// Before the run replaces its logs.
    void aMovieThatCannotBeMadeLeavesTheLastLogs() {
        QTemporaryDir folder;
        const QString logs = folder.filePath("logs");
        QVERIFY(cli({"run", kExperiment, "--duration", "0.1", "--log-dir", logs}).code == 0);
        const QStringList before = QDir(logs).entryList(QDir::Files);
        const QByteArray log = contentOf(logs + "/" + before.value(0));
        QVERIFY(!log.isEmpty());
        const auto refused = [&](const QStringList& movie, const QByteArray& why) {
            const Outcome run = cli(QStringList{"run", kExperiment, "--duration", "0", "--log-dir", logs} + movie);
            QVERIFY2(run.code == 1 && run.err.contains(why), shown(run));
            QVERIFY(QDir(logs).entryList(QDir::Files) == before && contentOf(logs + "/" + before[0]) == log);
        };
        const QString movie = folder.filePath("a.mp4");
        refused({"--movie", movie, "--view", "nope"}, "there is no view nope; there is ");
        refused({"--movie", movie, "--camera", "nope"}, "there is no camera nope; there is ");
        refused({"--movie", folder.filePath("none/a.mp4")}, "cannot be made");
    }

    /// An encoder that reads some input and then fails.
    void aMovieThatFailsLeavesTheOldOne() {
        QTemporaryDir folder;
        const QString ffmpeg = folder.filePath("ffmpeg"), movie = folder.filePath("a.mp4");
        QVERIFY(
            writeFile(ffmpeg, "#!/bin/sh\nfor out; do :; done\nhead -c 100000 > \"${out#file:}\"\necho no more >&2\nexit 1\n"));
        QVERIFY(QFile::setPermissions(ffmpeg, QFile::ReadOwner | QFile::ExeOwner));
        QVERIFY(writeFile(movie, "the old one"));
        const QStringList environment{"PATH=" + folder.path() + ":" + qEnvironmentVariable("PATH")};
        const Outcome run = cliWith(environment, {"run", kExperiment, "--duration", "2", "--movie", movie, "--camera",
                                                  "seeker_0/eye", "--log-dir", folder.filePath("logs")});
        QVERIFY2(run.code == 1 && run.err.contains("no more"), shown(run));
        QCOMPARE(contentOf(movie), QByteArray("the old one"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), (QStringList{"a.mp4", "ffmpeg"}));
    }

    /// The movie file is a link that came with the project: it is replaced, not followed. The temporary file of a movie whose
    /// program was killed is removed, a younger one and a link are not.
    void aMovieIsWrittenThroughNoLink() {
        QTemporaryDir folder, outside;
        const QString movie = folder.filePath("a.mp4"), precious = outside.filePath("precious");
        const QString abandoned = folder.filePath(".trundle-1-0.tmp"), young = folder.filePath(".trundle-1-1.tmp");
        QVERIFY(writeFile(precious, "precious") && writeFile(abandoned, "half a movie") && writeFile(young, "half a movie"));
        QFile old(abandoned);
        QVERIFY(old.open(QIODevice::ReadWrite) &&
                old.setFileTime(QDateTime::currentDateTime().addSecs(-120), QFileDevice::FileModificationTime));
        old.close();
        QVERIFY(QFile::link(precious, movie) && QFile::link(precious, folder.filePath(".trundle-1-2.tmp")));
        const Outcome again = cli({"run", kExperiment, "--duration", "0.2", "--movie", movie, "--camera", "seeker_0/eye",
                                   "--log-dir", folder.filePath("logs")});
        QCOMPARE(QDir(folder.path()).entryList({".*.tmp"}, QDir::Files | QDir::Hidden),
                 (QStringList{".trundle-1-1.tmp", ".trundle-1-2.tmp"}));
        QVERIFY2(again.code == 0 && !QFileInfo(movie).isSymLink() && QFileInfo(movie).size() > 100, shown(again));
        QCOMPARE(contentOf(precious), QByteArray("precious"));
    }

    void movieOptionsRequireMovie_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("camera") << QStringList{"--camera", "seeker_0/eye"};
        QTest::newRow("view") << QStringList{"--view", "overview"};
        QTest::newRow("pictures") << QStringList{"--fps", "10"};
        QTest::newRow("size") << QStringList{"--size", "64x48"};
        QTest::newRow("no name") << QStringList{"--movie", "a.mp4", "--camera", ""};
        QTest::newRow("no number") << QStringList{"--movie", "a.mp4", "--fps", "nan"};
        QTest::newRow("no size") << QStringList{"--movie", "a.mp4", "--size", "-5x10"};
        QTest::newRow("a camera's size") << QStringList{"--movie", "a.mp4", "--camera", "seeker_0/eye", "--size", "64x48"};
        QTest::newRow("no ending") << QStringList{"--movie", "a"};
        QTest::newRow("another ending") << QStringList{"--movie", "a.avi"};
    }
    void movieOptionsRequireMovie() {
        QFETCH(QStringList, arguments);
        QTemporaryDir folder;
        const Outcome refused = cli(QStringList{"run", kExperiment, "--log-dir", folder.path()} + arguments, folder.path());
        QVERIFY2(refused.code == 2 && !refused.err.isEmpty(), shown(refused));
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void aMovieHasExactlyItsPictures_data() {
        QTest::addColumn<QString>("ending");
        QTest::newRow("MP4") << "mp4";
        QTest::newRow("WebM") << "webm";
    }
    void aMovieHasExactlyItsPictures() {
        QFETCH(QString, ending);
        QTemporaryDir folder;
        const QString movie = folder.filePath("a." + ending);
        const Outcome run = cli({"run", kExperiment, "--duration", "1", "--movie", movie, "--camera", "seeker_0/eye", "--fps",
                                 "24", "--log-dir", folder.path()});
        QVERIFY2(run.code == 0, shown(run));
        const Outcome probe =
            callProgram("ffprobe", {"-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
                                    "stream=width,height,r_frame_rate,nb_read_frames", "-of", "csv=p=0", movie});
        QVERIFY2(probe.code == 0, shown(probe));
        QCOMPARE(probe.out.trimmed(), QByteArray("160,120,24/1,25")); // including t = 0 and t = 1
    }

    /// The file size limit stands in for a full disk.
    void aMovieThatDoesNotFitIsNoMovie() {
        QTemporaryDir folder;
        const QString movie = folder.filePath("a.mp4");
        QVERIFY(writeFile(movie, "an older one"));
        const QString command =
            QStringLiteral("ulimit -f 20; exec \"$0\" run \"$1\" --duration 2 --movie \"$2\" --view overview --size "
                           "640x480 --quiet --log-dir \"$3\"");
        const Outcome run = callProgram("/bin/sh", {"-c", command, programPath(), kExperiment, movie, folder.filePath("logs")});
        QVERIFY2(run.code != 0 && run.err.contains("cannot be made"), shown(run));
        QCOMPARE(contentOf(movie), QByteArray("an older one"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList("a.mp4"));
    }

    void twoMoviesAreTheSame_data() { aMovieHasExactlyItsPictures_data(); }
    void twoMoviesAreTheSame() {
        QFETCH(QString, ending);
        QTemporaryDir folder;
        QList<QByteArray> pictures[2];
        for (QList<QByteArray>& each : pictures) {
            const QString movie = folder.filePath("a." + ending);
            const Outcome run = cli({"run", kExperiment, "--duration", "1", "--movie", movie, "--camera", "seeker_0/eye", "--fps",
                                     "10", "--log-dir", folder.path()});
            QVERIFY2(run.code == 0, shown(run));
            each = picturesOf(movie);
            QCOMPARE(each.size(), 11);
            QVERIFY(each.first().split(',').last() != each.last().split(',').last()); // the robot moved
        }
        QCOMPARE(pictures[0], pictures[1]);
    }
};

QTEST_GUILESS_MAIN(CamerasFlowTest)
#include "cameras_test.moc"
