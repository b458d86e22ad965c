// Loads the render library by name at run time, as the programs do.
#include <QtTest>

#include <dlfcn.h>

#include <QFile>
#include <QImage>
#include <QTemporaryDir>

#include "render/render_entry.h"
#include "render/sample_experiment.h"
#include "signals/block.h"

using namespace trundle;

class EntryTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        void* library = ::dlopen(TRUNDLE_BINARY_DIR "/lib/trundle/" TRUNDLE_RENDER_LIBRARY, RTLD_NOW | RTLD_LOCAL);
        QVERIFY2(library, ::dlerror());
        m_render = reinterpret_cast<decltype(m_render)>(::dlsym(library, "trundle_render_experiment"));
        QVERIFY(m_render);
        QVERIFY(!::dlsym(library, "_ZN7trundle13RenderService5startEv")); // only the entry point is exported
        m_experiment = sampleExperiment({2});
    }

    void aPictureIsWritten() {
        const QByteArray picture = draw({});
        QVERIFY(picture.startsWith("\x89PNG"));
        QVERIFY(draw({}) == picture);
    }

    void aViewOfOnesOwn() {
        RenderJob job;
        job.hasView = true;
        job.eye[0] = 2, job.eye[1] = 1, job.eye[2] = 1;
        job.fieldOfView = 1;
        const QByteArray picture = draw(job);
        QVERIFY(picture.startsWith("\x89PNG"));
        QVERIFY(picture != draw({}));
    }

    /// Upside down is the same picture turned by half a turn, as far as shadows are the same.
    void aViewThatIsUpsideDown() {
        RenderJob job;
        job.hasView = true;
        job.look = LookChoice::Fast;
        job.eye[0] = 2, job.eye[1] = 1, job.eye[2] = 1;
        job.fieldOfView = 1;
        const QImage upright = QImage::fromData(draw(job));
        for (const double up : {-1.0, -0.2}) {
            job.up[2] = up;
            const QImage turned = QImage::fromData(draw(job)).mirrored(true, true);
            QVERIFY(!upright.isNull() && turned.size() == upright.size());
            int unlike = 0;
            for (int y = 0; y < upright.height(); ++y)
                for (int x = 0; x < upright.width(); ++x)
                    unlike += std::abs(qGray(upright.pixel(x, y)) - qGray(turned.pixel(x, y))) > 40;
            QVERIFY2(unlike < upright.width() * upright.height() / 50, qPrintable(QString::number(unlike)));
        }
    }

    void usesRequestedRenderStyle() {
        std::string reported;
        const std::function<void(const std::string&)> warn = [&](const std::string& line) { reported += line; };
        RenderJob job;
        job.warn = &warn;
        job.look = LookChoice::Fast;
        const QByteArray fast = draw(job);
        job.look = LookChoice::Rich;
        const QByteArray rich = draw(job);
        QVERIFY(!fast.isEmpty() && !rich.isEmpty() && fast != rich);
        QCOMPARE(reported, std::string());
    }

    void readsPosesFromSignals() {
        SignalLayout layout;
        layout.beginRobot("robot0");
        for (const char* body : {"chassis", "leftWheel", "rightWheel"})
            layout.add(std::string(body) + "/pose", "m", SignalType::Real, SignalDirection::Truth, 7);
        SignalBlock block(layout);
        const auto put = [&](double x) {
            for (const SignalEntry& entry : layout.entries())
                block.slots()[entry.offset] = x, block.slots()[entry.offset + 3] = 1;
        };
        RenderJob job;
        job.layout = &layout;
        job.block = &block;
        put(0.5);
        const QByteArray here = draw(job);
        put(0.9);
        QVERIFY(here != draw(job));
        QVERIFY(here != draw({}));
    }

    void reportsFailureReasons_data() {
        QTest::addColumn<int>("which");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("words");
        QTest::newRow("no job") << 0 << 599 << "";
        QTest::newRow("another build") << 1 << 599 << "the render library is of another build";
        QTest::newRow("too large") << 2 << 511 << "a picture has 1 to 4096 pixels along each side, not 5000 x 720";
        QTest::newRow("no view") << 3 << 511 << "no picture can be taken from this view";
        QTest::newRow("ending") << 4 << 511 << "a picture is written as .png, .jpg or .jpeg, not \"x.gif\"";
        QTest::newRow("no experiment") << 5 << 599 << "no experiment or no file to write";
    }
    void reportsFailureReasons() {
        QFETCH(int, which);
        QFETCH(int, code);
        QFETCH(QString, words);
        char error[200] = "";
        RenderJob job;
        job.experiment = m_experiment.get();
        job.outputPath = "x.gif";
        job.error = error;
        job.errorSize = sizeof error;
        if (which == 1) job.structSize = 8;
        if (which == 2) job.width = 5000;
        if (which == 3) job.hasView = true; // eye and target both at 0
        if (which == 5) job.experiment = nullptr;
        QCOMPARE(m_render(which == 0 ? nullptr : &job), code);
        QCOMPARE(QString(error), words);
    }

    void truncatesLongNames() {
        char error[8] = "";
        RenderJob job;
        job.experiment = m_experiment.get();
        job.outputPath = "x.gif";
        job.error = error;
        job.errorSize = sizeof error;
        QCOMPARE(m_render(&job), 511);
        QCOMPARE(QString(error), QString("a pictu"));
    }

private:
    QByteArray draw(RenderJob job) {
        QTemporaryDir folder;
        const std::string path = folder.filePath("picture.png").toStdString();
        job.experiment = m_experiment.get();
        job.width = 200, job.height = 120;
        job.outputPath = path.c_str();
        if (m_render(&job) != 0) return {};
        QFile file(QString::fromStdString(path));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    int (*m_render)(const RenderJob*) = nullptr;
    std::shared_ptr<ExperimentSpec> m_experiment;
};

QTEST_APPLESS_MAIN(EntryTest)
#include "entry_test.moc"
