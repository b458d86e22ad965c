// Controllers in Python with NumPy: arrays without a copy of what cameras and lidars have measured; and without NumPy, where it is not
// installed.
#include "flow/cli.h"

namespace {

const char* const kExperiment = R"(Duration = 1
#import robots/camera_robot.sim
#import arenas/medium_arena.sim
#loadModule seen.py
RobotConfig Seeing {
  Body hull { Box box { Size=0.2,0.2,0.1 Pos=0,0,0.06 Mass=1 Material=red Surface=plastic } }
  Camera eye  { Body=hull Pos=0.12,0,0.1 Resolution=32,24 UpdatePeriod=0.1 }
  Camera far  { Body=hull Pos=0.12,0,0.1 Resolution=32,24 Mode=depth }
  Camera mask { Body=hull Pos=0.12,0,0.1 Resolution=32,24 Mode=segmentation }
  Lidar lidar { Body=hull Pos=0,0,0.13 Beams=180 UpdatePeriod=0.1 }
}
Static arena { Config=MediumArena }
Robot seeing { Config=Seeing Seen brain { } }
)";

const char* const kSetup = R"(import trundle
HIDDEN

class Seen(trundle.Controller):
    """Looks, and says what it has seen."""

    def setup(self, robot):
        self.eye, self.far, self.mask = (robot.camera(name) for name in ("eye", "far", "mask"))
        self.lidar = robot.lidar("lidar")

    def check(self, what, holds):
        if not holds:
            self.fail(what)

    def update(self, since_last):
)";

const char* const kWithNumPy = R"(        import numpy
        picture, ranges = self.eye.capture(), numpy.asarray(self.lidar.ranges())
        pixels = picture.array
        self.check("shape", pixels.shape == (24, 32, 3) and pixels.dtype == numpy.uint8)
        self.check("a copy", not pixels.flags.owndata and numpy.shares_memory(pixels, numpy.asarray(picture.pixels)))
        self.check("writable", not pixels.flags.writeable and not ranges.flags.writeable)
        try:
            pixels[0, 0, 0] = 1
            self.fail("a picture was written")
        except ValueError:
            pass
        self.check("pixels", tuple(pixels[5, 7]) == picture.at(7, 5) and len(numpy.unique(pixels)) > 3)
        depths, objects = numpy.asarray(self.far.capture().depths), numpy.asarray(self.mask.capture().objects)
        self.check("depths", depths.shape == (24, 32) and depths.dtype == numpy.float32 and 0.5 < numpy.median(depths) < 5)
        self.check("objects", objects.shape == (24, 32) and objects.dtype == numpy.uint32)
        self.check("names", all(self.mask.object_name(int(n)).startswith("arena/") for n in numpy.unique(objects) if n))
        self.check("lidar", ranges.shape == (180,) and ranges.dtype == numpy.float64 and not ranges.flags.owndata)
        self.check("ranges", [float(r) for r in ranges] == list(self.lidar.ranges()))
        if self.lidar.fresh() and self.time > 0.5:
            self.kept = ranges  # shows each scan in place
            self.check("scan", bool(numpy.all(numpy.isfinite(ranges))) and 0.5 < ranges.min() < 5)
        if self.time > 0.9:
            self.check("another scan", numpy.array_equal(self.kept, ranges) and numpy.shares_memory(self.kept, ranges))
            self.finish(f"NumPy {numpy.__version__}")
)";

const char* const kWithout = R"(        picture, ranges = self.eye.capture(), self.lidar.ranges()
        self.check("shape", picture.pixels.shape == (24, 32, 3) and picture.pixels.readonly and ranges.readonly)
        self.check("pixels", picture.pixels[5, 7, 0] == picture.at(7, 5)[0] and len(set(picture.pixels.tobytes())) > 3)
        self.check("lidar", len(ranges) == 180 and ranges.format == "d")
        try:
            self.fail(f"there is an array {picture.array.shape}")
        except ImportError as error:
            if self.time > 0.5:
                self.finish(str(error))
)";

} // namespace

class NumpyTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    /// The PATH with the first python3 in it that has NumPy in front; empty if there is none.
    static QString pathWithNumPy() {
        const QString path = qEnvironmentVariable("PATH");
        for (const QString& folder : path.split(':'))
            if (QFile::exists(folder + "/python3") && callProgram(folder + "/python3", {"-c", "import numpy"}).code == 0)
                return folder + ":" + path;
        return {};
    }
    /// With `hidden` as a line at the start of the module.
    Outcome run(const QString& path, const QByteArray& update, const QByteArray& hidden, const QByteArray& isolation) {
        const QString file = m_folder.filePath("seen.sim");
        const bool written = writeFile(file, "Isolation = " + isolation + "\n" + kExperiment) &&
                             writeFile(m_folder.filePath("seen.py"), QByteArray(kSetup).replace("HIDDEN", hidden) + update);
        if (!written) return {};
        return callProgram("/usr/bin/env", {"PATH=" + path, programPath(), "run", file, "--trust", "--json", "--quiet"});
    }
    static QString reasonOf(const Outcome& outcome) {
        return QJsonDocument::fromJson(outcome.out).object()["finished"].toObject()["reason"].toString();
    }

private Q_SLOTS:
    void arraysWithoutACopy_data() {
        QTest::addColumn<QByteArray>("isolation");
        for (const char* isolation : {"module", "robot"}) QTest::newRow(isolation) << QByteArray(isolation);
    }
    void arraysWithoutACopy() {
        QFETCH(QByteArray, isolation);
        const QString path = pathWithNumPy();
        QVERIFY2(!path.isEmpty(), "no python3 here has NumPy; `./dev test` installs python3-numpy");
        const Outcome outcome = run(path, kWithNumPy, "", isolation);
        QVERIFY2(outcome.code == 0, shown(outcome).left(4000));
        QVERIFY2(reasonOf(outcome).startsWith("NumPy "), shown(outcome).left(4000));
    }

    /// The same without arrays, on a machine that has no NumPy.
    void worksWithoutNumPy() {
        const Outcome outcome = run(qEnvironmentVariable("PATH"), kWithout, "import sys\nsys.modules['numpy'] = None", "module");
        QVERIFY2(outcome.code == 0, shown(outcome).left(4000));
        QCOMPARE(reasonOf(outcome),
                 QString("Picture.array needs NumPy, which is not installed (python3-numpy); Picture.pixels does not"));
    }
};

QTEST_GUILESS_MAIN(NumpyTest)
#include "numpy_test.moc"
