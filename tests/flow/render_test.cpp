// trundle-cli render: PNG images from the command line, without a display.

#include "flow/cli.h"

namespace {

/// Width and height of a PNG, read from its header.
QPair<int, int> pngSize(const QByteArray& png) {
    const auto number = [&](int at) {
        return (quint8(png[at]) << 24) | (quint8(png[at + 1]) << 16) | (quint8(png[at + 2]) << 8) | quint8(png[at + 3]);
    };
    return png.size() > 24 && png.startsWith("\x89PNG") ? QPair<int, int>(number(16), number(20)) : QPair<int, int>();
}

} // namespace

class RenderFlowTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    Outcome render(const QString& picture, const QStringList& more, const QString& experiment = "experiments/linear_motion.sim") {
        const QStringList size = more.contains("--camera") ? QStringList{} : QStringList{"--size", "320x200"}; // it has its own
        return cli(QStringList{"render", configPath(experiment), "-o", m_folder.filePath(picture)} + size + more);
    }

private Q_SLOTS:
    void aPictureOfTheStart() {
        const Outcome drawn = render("start.png", {});
        QVERIFY2(drawn.code == 0 && drawn.err.isEmpty(), shown(drawn));
        QCOMPARE(pngSize(contentOf(m_folder.filePath("start.png"))), (QPair<int, int>(320, 200)));
    }
    void theSameMomentIsTheSamePictureAndAnotherIsNot() {
        QCOMPARE(render("a.png", {"--at", "2"}).code, 0);
        QCOMPARE(render("b.png", {"--at", "2"}).code, 0);
        QCOMPARE(render("c.png", {"--at", "4"}).code, 0);
        const QByteArray a = contentOf(m_folder.filePath("a.png"));
        QCOMPARE(pngSize(a).first, 320);
        QVERIFY(a == contentOf(m_folder.filePath("b.png")));
        QVERIFY(a != contentOf(m_folder.filePath("c.png")));
    }
    void fromAPlaceOfOnesOwn() {
        QCOMPARE(render("near.jpg", {"--eye", "-1,-1,0.5", "--target", "-1.5,0,0.1", "--fov", "40"}).code, 0);
        QVERIFY(contentOf(m_folder.filePath("near.jpg")).startsWith("\xFF\xD8\xFF"));
    }
    void rejectsWrongOptions_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("code");
        QTest::newRow("size") << QStringList{"--size", "big"} << 2;
        QTest::newRow("size of nothing") << QStringList{"--size", "0x100"} << 2;
        QTest::newRow("too large") << QStringList{"--size", "9000x100"} << 2;
        QTest::newRow("size below nothing") << QStringList{"--size", "-5x10"} << 2;
        QTest::newRow("half an eye") << QStringList{"--eye", "1,2"} << 2;
        QTest::newRow("eye in its target") << QStringList{"--eye", "1,1,1", "--target", "1,1,1"} << 1;
        QTest::newRow("before the start") << QStringList{"--at", "-1"} << 2;
        QTest::newRow("no time") << QStringList{"--at", "nan"} << 2;
        QTest::newRow("eye at no place") << QStringList{"--eye", "0,inf,1"} << 2;
        QTest::newRow("no angle") << QStringList{"--eye", "1,1,1", "--fov", "nan"} << 2;
        QTest::newRow("target without an eye") << QStringList{"--target", "1,1,1"} << 2;
        QTest::newRow("angle without an eye") << QStringList{"--fov", "40"} << 2;
        QTest::newRow("camera without a name") << QStringList{"--camera", ""} << 2;
        QTest::newRow("a camera's size") << QStringList{"--camera", "seeker_0/eye", "--size", "64x48"} << 2;
        QTest::newRow("view without a name") << QStringList{"--view", ""} << 2;
        QTest::newRow("no such property") << QStringList{"--set", "robot0.nothing=3"} << 1;
        QTest::newRow("a folder that is not there") << QStringList{"-o", "/nonexistent/picture.png"} << 1;
        QTest::newRow("no such ending") << QStringList{"-o", "picture.bmp"} << 2;
    }
    void rejectsWrongOptions() {
        QFETCH(QStringList, arguments);
        QFETCH(int, code);
        QStringList all{"render", configPath("experiments/linear_motion.sim")};
        if (!arguments.contains("-o")) all << "-o" << m_folder.filePath("never.png");
        const Outcome refused = cli(all + arguments, m_folder.path());
        QVERIFY2(refused.code == code, shown(refused));
        QVERIFY2(!refused.err.isEmpty(), shown(refused));
        QVERIFY2(!refused.err.contains("4294967"), shown(refused));
        QVERIFY(!QFile::exists(m_folder.filePath("never.png")));
    }
    /// A run of these experiments would never end.
    void reportsErrorsBeforeRun_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("reason");
        QTest::newRow("camera") << QStringList{"--camera", "robot0/ear"} << QByteArray("there is no camera robot0/ear");
        QTest::newRow("view") << QStringList{"--view", "below"} << QByteArray("there is no view below");
        QTest::newRow("ending") << QStringList{"-o", "picture.bmp"} << QByteArray(".png, .jpg or .jpeg");
        QTest::newRow("folder") << QStringList{"-o", "/nonexistent/picture.png"} << QByteArray("No such file or directory");
    }
    void reportsErrorsBeforeRun() {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, reason);
        QStringList all{"render", configPath("experiments/linear_motion.sim"), "--at", "1e8"};
        if (!arguments.contains("-o")) all << "-o" << m_folder.filePath("never.png");
        const Outcome refused = cli(all + arguments, m_folder.path());
        const int code = arguments.contains("picture.bmp") ? 2 : 1; // of the command line alone
        QVERIFY2(refused.code == code && refused.err.contains(reason), shown(refused));
    }
};

QTEST_GUILESS_MAIN(RenderFlowTest)
#include "render_test.moc"
