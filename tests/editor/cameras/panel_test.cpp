// The Cameras dock: tiles, display modes and saved images.

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMouseEvent>
#include <QToolButton>
#include <QtTest>

#include "editor/cameras/camera_window.h"
#include "editor/document/structure_edits.h"
#include "editor/widgets/painted_text.h"
#include "eventually.h"
#include "model/object_numbers.h"

using namespace trundle;

namespace {

/// The approximate number of colours in an image.
int coloursIn(const QImage& image) {
    QSet<QRgb> seen;
    for (int y = 0; y < image.height(); y += 2)
        for (int x = 0; x < image.width(); x += 2) seen.insert(image.pixel(x, y) & 0xf0f0f0);
    return int(seen.size());
}

constexpr int kWide = 160, kHigh = 120; ///< pixels of the cameras of kTwoEyes

/// A pixel whose neighbours are of the same object as itself, which is `object`, or any but 0 and `other` where no `object` is given.
std::optional<QPoint> pixelOf(const CameraImage& image, std::optional<std::uint32_t> object, std::uint32_t other = 0) {
    for (int y = 2; y + 2 < kHigh; ++y)
        for (int x = 2; x + 2 < kWide; ++x) {
            const std::uint32_t here = image.objects[std::size_t(y * kWide + x)];
            bool alike = object ? here == *object : here != 0 && here != other;
            for (int i = 0; i < 25; ++i)
                alike = alike && image.objects[std::size_t((y - 2 + i / 5) * kWide + x - 2 + i % 5)] == here;
            if (alike) return QPoint(x, y);
        }
    return std::nullopt;
}

} // namespace

class CamerasPanelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }
    void init() { m_window = std::make_unique<CameraWindow>(m_render.get()); }
    void cleanup() { m_window.reset(); }

    void showsHintWithoutCamera() {
        QVERIFY(m_window->open(kRoom));
        auto* words = m_window->cameras.findChild<QLabel*>(QStringLiteral("camerasEmpty"));
        QVERIFY(words->isVisible());
        QVERIFY(words->text().contains(QStringLiteral("Insert")));
        QVERIFY(m_window->open(kTwoEyes));
        QVERIFY(!words->isVisible());
    }

    void showsStartSceneBeforeRun() {
        QVERIFY(m_window->open(kTwoEyes));
        EVENTUALLY(m_window->tile("robot0/eye") && m_window->tile("robot0/eye")->picture.frame);
        QCOMPARE(m_window->tile("robot0/eye")->picture.image.size(), QSize(160, 120));
        QVERIFY(coloursIn(m_window->tile("robot0/eye")->picture.image) > 8);
        const QImage before = m_window->tile("robot0/eye")->picture.image;
        // An edit changes the image without a run.
        QVERIFY(m_window->document.structure().setValues(QStringLiteral("Turn"), {{"robot0.HPR", "40, 0, 0"}}).ok());
        EVENTUALLY(m_window->cameras.isSettled() && m_window->tile("robot0/eye")->picture.image != before);
        m_window->document.edits().undo();
        EVENTUALLY(m_window->cameras.isSettled() && m_window->tile("robot0/eye")->picture.image == before);
    }

    void inARunItShowsWhatTheControllersGet() {
        QVERIFY(m_window->open(kTwoEyes));
        for (const std::uint64_t ticks : {40u}) {
            QVERIFY(m_window->runTicks(ticks));
            const auto runner = m_window->headless(ticks);
            QVERIFY(runner);
            for (const char* camera : {"robot0/eye", "robot1/eye"}) {
                const Result<const CameraImage*> expected = runner->cameras().capture(camera);
                QVERIFY2(expected.ok(), camera);
                const std::shared_ptr<const CameraImage> shown = m_window->tile(camera)->picture.frame;
                QVERIFY2(shown && shown->tick == ticks, camera);
                QVERIFY2(shown->pixels == expected.value()->pixels, camera);
                QVERIFY2(shown->depth == expected.value()->depth, camera);
            }
        }
        QVERIFY(!m_window->tile("robot1/eye")->picture.frame->depth.empty());
    }

    /// robot0's controller captures its camera in every tick; nothing in the run uses that of robot1.
    void showsTheRunsImagesWithoutRenderingThemAgain() {
        QVERIFY(m_window->open(kTwoEyes));
        m_window->cameras.setChosen({"robot0/eye"});
        m_window->session.setSpeed(0.25);
        m_window->session.run();
        const auto fromTheRun = [&] {
            const auto& images = m_window->session.results().snapshot->images;
            const auto made = images.find("robot0/eye");
            const CameraTiles::Tile* tile = m_window->tile("robot0/eye");
            return made != images.end() && tile->picture.shot.made && tile->picture.frame == tile->picture.shot.made;
        };
        EVENTUALLY(m_window->session.results().snapshot && fromTheRun());
        // Eight of them, none of which was rendered; on a slow machine others are, as an image of the run may be overdue.
        int before = m_window->cameras.drawnCount(), renderedAgain = 0;
        QSet<std::uint64_t> seen; // their ticks: an image may lie where an earlier one lay
        const auto watched = QObject::connect(&m_window->cameras, &CamerasPanel::pictureShown, &m_window->document, [&] {
            const bool isRendered = std::exchange(before, m_window->cameras.drawnCount()) != m_window->cameras.drawnCount();
            const CameraPicture& shown = m_window->tile("robot0/eye")->picture;
            if (!shown.shot.made) return;
            renderedAgain += isRendered;
            if (seen.size() < 8) seen.insert(shown.frame->tick);
        });
        EVENTUALLY(seen.size() >= 8);
        QObject::disconnect(watched);
        QCOMPARE(renderedAgain, 0);
        EVENTUALLY(fromTheRun());
        const int drawn = m_window->cameras.drawnCount();
        // Another mode is not what the run made.
        m_window->cameras.setMode(CameraMode::Segmentation);
        EVENTUALLY(m_window->cameras.drawnCount() > drawn && !m_window->tile("robot0/eye")->picture.frame->objects.empty());
        m_window->cameras.setMode(std::nullopt);
        EVENTUALLY(fromTheRun());
        // While it is paused the image is that of the state shown in the views: rendered once.
        before = m_window->cameras.drawnCount();
        m_window->session.pause();
        EVENTUALLY(m_window->session.state() == RunState::Paused && m_window->cameras.isSettled());
        QCOMPARE(m_window->tile("robot0/eye")->picture.frame->tick, m_window->session.results().snapshot->tick);
        QCOMPARE(m_window->cameras.drawnCount(), before + 1);
    }

    void rendersWhatTheRunDoesNotCapture() {
        QVERIFY(m_window->open(kTwoEyes));
        m_window->cameras.setChosen({"robot1/eye"});
        EVENTUALLY(m_window->cameras.isSettled());
        const int before = m_window->cameras.drawnCount();
        m_window->session.run();
        EVENTUALLY(m_window->cameras.drawnCount() >= before + 3);
        QVERIFY(!m_window->session.results().snapshot->images.contains("robot1/eye"));
        QVERIFY(m_window->session.results().snapshot->images.contains("robot0/eye"));
    }

    void theRunIsTheSameWithTheDockOpen() {
        QVERIFY(m_window->open(kTwoEyes));
        m_window->cameras.setMode(CameraMode::Segmentation);
        QVERIFY(m_window->runTicks(300));
        QVERIFY(m_window->cameras.drawnCount() > 2);
        const auto runner = m_window->headless(300);
        QVERIFY(runner);
        QCOMPARE(*m_window->session.results().snapshot->hash, runner->world().stateHash());
    }

    void drawsOnlyVisibleTiles() {
        QVERIFY(m_window->openSample("camera_swarm.sim"));
        EVENTUALLY(m_window->cameras.isSettled());
        QCOMPARE(m_window->cameras.wall().tiles().size(), std::size_t(4)); // of twenty, until the user chooses
        std::vector<std::string> all;
        for (int i = 0; i < 20; ++i) all.push_back("swarm_" + std::to_string(i) + "/eye");
        m_window->cameras.resize(340, 200);
        m_window->cameras.setChosen(all);
        EVENTUALLY(m_window->cameras.isSettled());
        const std::size_t seen = m_window->cameras.wall().visibleTiles().size();
        QVERIFY2(seen > 0 && seen < 12, qPrintable(QString::number(seen)));
        std::size_t drawn = 0;
        for (const CameraTiles::Tile& tile : m_window->cameras.wall().tiles()) drawn += tile.picture.frame != nullptr;
        QVERIFY2(drawn >= seen && drawn < 16, qPrintable(QString::number(drawn)));
        // A hidden dock draws no images.
        m_window->cameras.hide();
        const int before = m_window->cameras.drawnCount();
        m_window->session.setSpeed(0);
        m_window->session.runFor(0.5);
        QTRY_COMPARE_WITH_TIMEOUT(m_window->session.state(), RunState::Paused, 60000);
        QCOMPARE(m_window->cameras.drawnCount(), before);
        m_window->cameras.show();
        EVENTUALLY(m_window->cameras.drawnCount() > before);
    }

    void pictureReportsDistancesAndNames() {
        QVERIFY(m_window->open(kTwoEyes));
        EVENTUALLY(m_window->cameras.isSettled());
        auto* mode = m_window->cameras.findChild<QComboBox*>(QStringLiteral("cameraMode"));
        mode->setCurrentText(QStringLiteral("Segmentation"));
        EVENTUALLY(m_window->cameras.isSettled());
        const CameraTiles::Tile* tile = m_window->tile("robot0/eye");
        QCOMPARE(tile->picture.frame->objects.size(), std::size_t(160 * 120));
        mode->setCurrentText(QStringLiteral("Depth"));
        EVENTUALLY(m_window->cameras.isSettled() && !m_window->tile("robot0/eye")->picture.frame->depth.empty());
        mode->setCurrentIndex(0); // each camera's own mode
        EVENTUALLY(m_window->cameras.isSettled() && m_window->tile("robot0/eye")->picture.frame->depth.empty());
        QVERIFY(!m_window->tile("robot1/eye")->picture.frame->depth.empty());
    }

    /// In a segmentation its object, in a depth image its distance.
    void thePixelUnderTheMouseIsRead() {
        QVERIFY(m_window->open(kTwoEyes));
        m_window->cameras.setChosen({"robot0/eye"});
        CameraTiles& wall = m_window->cameras.wall();
        const auto frame = [&] { return m_window->tile("robot0/eye")->picture.frame; };
        const auto read = [&](const QPoint& pixel) {
            const QRect place = m_window->tile("robot0/eye")->place;
            const double scale = double(place.width()) / kWide;
            const QPointF at = place.topLeft() + QPointF((pixel.x() + 0.5) * scale, (pixel.y() + 0.5) * scale);
            QMouseEvent move(QEvent::MouseMove, at, wall.mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
            QCoreApplication::sendEvent(&wall, &move);
            QStringList texts = paintedTexts(wall);
            texts.removeAll(QStringLiteral("robot0/eye"));
            return texts.join(u' ');
        };
        m_window->cameras.setMode(CameraMode::Segmentation);
        EVENTUALLY(m_window->cameras.isSettled() && frame() && !frame()->objects.empty());
        for (int renamed = 0; renamed < 2; ++renamed) { // the names are those of the experiment now
            const std::vector<std::string> names = objectNames(*m_window->document.loaded()->experiment);
            const auto robot = std::ranges::find_if(names, [&](const std::string& name) {
                return name.starts_with(renamed ? "other" : "robot1") && pixelOf(*frame(), std::uint32_t(&name - names.data()));
            });
            QVERIFY(robot != names.end());
            const auto number = std::uint32_t(robot - names.begin());
            QCOMPARE(read(*pixelOf(*frame(), number)), QString::fromStdString(*robot));
            const auto another = pixelOf(*frame(), std::nullopt, number);
            QVERIFY(another);
            QCOMPARE(read(*another),
                     QString::fromStdString(names[frame()->objects[std::size_t(another->y() * kWide + another->x())]]));
            if (const auto sky = pixelOf(*frame(), 0)) QCOMPARE(read(*sky), QStringLiteral("nothing"));
            if (renamed) break;
            const std::string file = m_window->document.texts().files().front();
            const QByteArray text = QByteArray(kTwoEyes).replace("Robot robot1", "Robot other");
            QVERIFY(m_window->document.edits().replaceText(QStringLiteral("Rename"), file, text.toStdString()).ok());
            m_window->cameras.setChosen({"robot0/eye"});
            EVENTUALLY(m_window->cameras.isSettled() && m_window->tile("robot0/eye") && frame() && !frame()->objects.empty());
        }
        const QPoint body = *pixelOf(*frame(), std::nullopt);
        m_window->cameras.setMode(CameraMode::Depth);
        EVENTUALLY(m_window->cameras.isSettled() && frame() && !frame()->depth.empty());
        float nearest = 1e9F, farthest = 0; // of the neighbours too: the mouse is between two pixels
        for (int i = 0; i < 9; ++i) {
            const float depth = frame()->depth[std::size_t((body.y() - 1 + i / 3) * kWide + body.x() - 1 + i % 3)];
            nearest = std::min(nearest, depth);
            farthest = std::max(farthest, depth);
        }
        const QString text = read(body);
        QVERIFY2(text.endsWith(QStringLiteral(" m")), qPrintable(text));
        const double shown = text.chopped(2).toDouble();
        QVERIFY2(shown > 0 && shown >= double(nearest) - 0.006 && shown <= double(farthest) + 0.006, qPrintable(text));
    }

    /// By any letters of their names; what is checked stays so.
    void theListIsFiltered() {
        QVERIFY(m_window->open(kTwoEyes));
        auto* list = m_window->cameras.findChild<QListWidget*>(QStringLiteral("cameraList"));
        auto* filter = m_window->cameras.findChild<QLineEdit*>(QStringLiteral("cameraFilter"));
        const std::vector<std::string> chosen = m_window->cameras.chosen();
        const auto listed = [&](const char* typed) {
            filter->clear();
            QTest::keyClicks(filter, QLatin1String(typed));
            QStringList names;
            for (int i = 0; i < list->count(); ++i)
                if (!list->item(i)->isHidden()) names << list->item(i)->text();
            return names.join(u' ');
        };
        QCOMPARE(listed("eye"), QStringLiteral("robot0/eye robot1/eye"));
        QCOMPARE(listed("1/E"), QStringLiteral("robot1/eye"));
        QCOMPARE(listed("robot0"), QStringLiteral("robot0/eye"));
        QCOMPARE(listed("eyes"), QString());
        QCOMPARE(m_window->cameras.chosen(), chosen);
        QCOMPARE(listed(""), QStringLiteral("robot0/eye robot1/eye"));
    }

    void thePictureCanBeSaved_data() {
        QTest::addColumn<QString>("name");
        QTest::newRow("PNG") << "eye.png";
        QTest::newRow("JPEG") << "eye.jpg";
    }
    void thePictureCanBeSaved() {
        QFETCH(QString, name);
        QVERIFY(m_window->open(kTwoEyes));
        EVENTUALLY(m_window->cameras.isSettled());
        m_window->cameras.wall().setCurrent("robot1/eye");
        QVERIFY(m_window->cameras.findChild<QToolButton*>(QStringLiteral("cameraSave"))->isEnabled());
        const QString path = m_window->folder.filePath(name);
        m_window->cameras.savePicture(path);
        EVENTUALLY(!m_window->reportOf.empty());
        QVERIFY2(m_window->reportOf.front().startsWith(QStringLiteral("Wrote")), qPrintable(m_window->reportOf.front()));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("camera = robot1/eye"));
        QCOMPARE(QImage(path).size(), QSize(160, 120));
        // A failed save is reported.
        m_window->reportOf.clear();
        m_window->cameras.savePicture(m_window->folder.filePath(QStringLiteral("none/") + name));
        EVENTUALLY(!m_window->reportOf.empty());
        QVERIFY(!m_window->reportOf.front().startsWith(QStringLiteral("Wrote")));
    }

    void showsCheckedCameras() {
        QVERIFY(m_window->open(kTwoEyes));
        auto* list = m_window->cameras.findChild<QListWidget*>(QStringLiteral("cameraList"));
        QCOMPARE(list->count(), 2);
        list->item(0)->setCheckState(Qt::Unchecked);
        QCOMPARE(m_window->cameras.chosen(), std::vector<std::string>{"robot1/eye"});
        QVERIFY(!m_window->tile("robot0/eye"));
        // The chosen cameras stay after an edit.
        QVERIFY(m_window->document.structure().setValues(QStringLiteral("Move"), {{"robot0.Pos", "-1.2, 0, 0"}}).ok());
        QCOMPARE(m_window->cameras.chosen(), std::vector<std::string>{"robot1/eye"});
        list->item(1)->setCheckState(Qt::Unchecked);
        auto* facts = m_window->cameras.findChild<QLabel*>(QStringLiteral("cameraFacts"));
        QVERIFY(facts->text().contains(QStringLiteral("Check a camera")));
    }

    void reportsMissingOpenGl() {
        CameraWindow blind(nullptr);
        QVERIFY(blind.open(kTwoEyes));
        auto* words = blind.cameras.findChild<QLabel*>(QStringLiteral("camerasEmpty"));
        QVERIFY(words->isVisible() && words->text().contains(QStringLiteral("OpenGL")));
        QVERIFY(blind.cameras.isSettled());
    }

private:
    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<CameraWindow> m_window;
};

QTEST_MAIN(CamerasPanelTest)
#include "panel_test.moc"
