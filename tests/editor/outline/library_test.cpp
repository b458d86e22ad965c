// The Library: its items, their preview images, and inserting them.

#include <QAbstractButton>
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMimeData>

#include "app/locations.h"
#include "editor/document/structure_edits.h"
#include "editor/outline/block_mime.h"
#include "editor/outline/library_items.h"
#include "editor/outline/library_model.h"
#include "editor/outline/library_panel.h"
#include "editor/outline/library_view.h"
#include "eventually.h"
#include "outline_fixture.h"
#include "project/objects/unplaced_configs.h"
#include "render/service.h"

using namespace trundle;

namespace {

struct LibraryFixture : OutlineFixture {
    LibraryPanel library;

    explicit LibraryFixture(RenderService* render = nullptr)
        : library(document, selection, *application, render, application->locations()) {
        library.resize(300, 900);
        library.show();
        (void)QTest::qWaitForWindowExposed(&library, kTimeoutMs);
    }
    bool filled() {
        return QTest::qWaitFor([this] { return !library.isReading(); });
    }
    const LibraryItem* item(const char* title) {
        for (const LibraryItem& item : library.model().items())
            if (item.title == QLatin1String(title)) return &item;
        return nullptr;
    }
    LibraryList& list(LibrarySection section) {
        return *library.findChild<LibraryList*>(QStringLiteral("libraryList.%1").arg(int(section)));
    }
    QModelIndex row(LibrarySection section, const char* title) {
        QAbstractItemModel& model = *list(section).model();
        for (int i = 0; i < model.rowCount(); ++i)
            if (model.index(i, 0).data() == QLatin1String(title)) return model.index(i, 0);
        return {};
    }
};

} // namespace

class LibraryTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void listsShippedItems();
    void robotsAndArenasGoIn_data();
    void robotsAndArenasGoIn();
    void partsGoIntoTheSelectedRobot_data();
    void partsGoIntoTheSelectedRobot();
    void partsFitTheOnlyRobotConfig();
    void insertsModuleWithController();
    void aDoubleClickPutsItAtAFreePlace();
    void aDragCarriesKindTextAndImports();
    void findsTheProjectsOwn();
    void aRobotOfPartsIsDrawnWithThem();
    void aSearchLeavesWhatMatches();
    void drawsPictures();
    void showsWholeNames();
    void showsFirstSteps();
    void templatesLoadWithoutDiagnostics_data();
    void templatesLoadWithoutDiagnostics();
};

/// In a panel three columns wide: long names have two lines.
void LibraryTest::showsWholeNames() {
    LibraryFixture s;
    QVERIFY(s.filled());
    const QFontMetrics metrics = s.library.fontMetrics();
    QCOMPARE(libraryTitleLines(QStringLiteral("Box"), metrics, 60), QStringList{QStringLiteral("Box")});
    const int width = metrics.horizontalAdvance(QStringLiteral("Differential")) + 2;
    QCOMPARE(libraryTitleLines(QStringLiteral("DifferentialDrive"), metrics, width),
             (QStringList{QStringLiteral("Differential"), QStringLiteral("Drive")}));
    QCOMPARE(libraryTitleLines(QStringLiteral("Differential drive"), metrics, width).size(), qsizetype(2));
    QVERIFY(libraryTitleLines(QStringLiteral("abcdefghijklmnopqrstuvw"), metrics, width)[0].endsWith(QChar(0x2026)));
    int elided = 0, lists = 0;
    for (auto* list : s.library.findChildren<LibraryList*>()) {
        if (!list->isVisible() || list->model()->rowCount() == 0) continue;
        ++lists;
        for (int row = 0; row < list->model()->rowCount(); ++row) {
            const QString title = list->model()->index(row, 0).data().toString();
            const QStringList lines = libraryTitleLines(title, list->fontMetrics(), list->gridSize().width() - 8);
            elided += lines.join(QString()).contains(QChar(0x2026));
            QVERIFY2(list->gridSize().height() > 84 || lines.size() == 1, qPrintable(title));
        }
    }
    QVERIFY(lists > 3);
    QCOMPARE(elided, 0);
}

void LibraryTest::listsShippedItems() {
    LibraryFixture s;
    QVERIFY(s.filled());
    for (const char* title : {"SimpleRobot", "EvBot", "MediumArena", "Wall", "Crate", "Driven wheel", "Box", "Hinge", "Encoder"})
        QVERIFY2(s.item(title), title);
    QCOMPARE(s.item("Wall")->section, LibrarySection::Objects);
    QVERIFY(s.item("Wall")->help.startsWith(QStringLiteral("A straight wall")));
    QCOMPARE(s.item("LinearMotion")->section, LibrarySection::Controllers);
    QVERIFY(!s.item("settings"));
}

void LibraryTest::robotsAndArenasGoIn_data() {
    QTest::addColumn<QString>("title");
    LibraryFixture s;
    QVERIFY(s.filled());
    for (const LibraryItem& item : s.library.model().items())
        if (item.section <= LibrarySection::Objects) QTest::newRow(qPrintable(item.title)) << item.title;
}

void LibraryTest::robotsAndArenasGoIn() {
    QFETCH(QString, title);
    LibraryFixture s;
    QVERIFY(s.filled());
    QVERIFY(s.open("Tick = 0.01\n"));
    QVERIFY(s.filled());
    const LibraryItem item = *s.item(qPrintable(title));
    s.library.insert(item);
    s.library.insert(item); // again, under another name
    QCOMPARE(s.refusals, QStringList());
    EVENTUALLY_EQUAL(s.errors(), QString()); // after the images that it uses are read
    const ExperimentSpec& experiment = *s.document.loaded()->experiment;
    QCOMPARE(experiment.robots.size() + experiment.statics.size(), std::size_t(2));
    QCOMPARE(s.text().count("#import"), 1);
    s.document.edits().undo();
    s.document.edits().undo();
    QCOMPARE(s.text(), QByteArray("Tick = 0.01\n"));
    s.library.insert(item); // what is selected is gone
    QCOMPARE(s.refusals, QStringList());
    QVERIFY(s.text() != QByteArray("Tick = 0.01\n"));
}

void LibraryTest::partsGoIntoTheSelectedRobot_data() {
    QTest::addColumn<QString>("title");
    LibraryFixture s;
    QVERIFY(s.filled());
    for (const LibraryItem& item : s.library.model().items())
        if (item.section == LibrarySection::RobotParts) QTest::newRow(qPrintable(item.title)) << item.title;
}

void LibraryTest::partsGoIntoTheSelectedRobot() {
    QFETCH(QString, title);
    LibraryFixture s;
    // The robot's body has another name than the text of the part uses.
    const QByteArray text = "RobotConfig Cart { Body frame { Box b { Size=0.3,0.2,0.1 Mass=2 } } }\nRobot cart { Config=Cart }\n";
    QVERIFY(s.open(text));
    QVERIFY(s.filled());
    QVERIFY(!s.item(qPrintable(title))->text.starts_with("//")); // the title is for the Library
    s.selection.select("cart");
    s.library.insert(*s.item(qPrintable(title)));
    s.selection.select("cart");
    s.library.insert(*s.item(qPrintable(title)));
    QCOMPARE(s.refusals, QStringList());
    QCOMPARE(s.errors(), QString());
    QCOMPARE(s.document.loaded()->experiment->robots[0].config->bodies.size(), std::size_t(3));
    s.document.edits().moveTo(0);
    QCOMPARE(s.text(), text);
}

/// Of several configs with nothing selected none is meant, however many they are.
void LibraryTest::partsFitTheOnlyRobotConfig() {
    LibraryFixture s;
    QVERIFY(s.filled());
    QByteArray text;
    for (const char* number : {"1", "2", "3"}) {
        text += QByteArray("RobotConfig CartN { Body frameN { Box b { Size=0.3,0.2,0.1 Mass=2 } } }\n").replace('N', number);
        QVERIFY(s.open(text));
        QVERIFY(s.filled() && s.selection.empty());
        const QModelIndex wheel = s.row(LibrarySection::RobotParts, "Driven wheel");
        const std::unique_ptr<QMimeData> mime(wheel.model()->mimeData({wheel}));
        const QJsonObject json = QJsonDocument::fromJson(mime->data(QStringLiteral("application/x-trundle-library"))).object();
        const QString dragged = json.value(QStringLiteral("text")).toString();
        const QString parent = *number == '1' ? QStringLiteral("Parent=frame1") : QStringLiteral("Parent=chassis");
        QVERIFY2(dragged.contains(parent), qPrintable(dragged));
    }
}

void LibraryTest::insertsModuleWithController() {
    LibraryFixture s;
    QVERIFY(s.open(kRovers));
    QVERIFY(s.filled());
    s.selection.select("robot0");
    s.library.insert(*s.item("LinearMotion"));
    QCOMPARE(s.refusals, QStringList());
    QVERIFY2(s.text().contains("#loadModule controllers/linear_motion"), s.text());
    QCOMPARE(s.errors(), QString());
    QCOMPARE(s.document.loaded()->experiment->robots[0].controllers.size(), 1u);
}

void LibraryTest::aDoubleClickPutsItAtAFreePlace() {
    LibraryFixture s;
    QVERIFY(s.open(kRovers));
    QVERIFY(s.filled());
    const QModelIndex wall = s.row(LibrarySection::Objects, "Wall");
    QVERIFY(wall.isValid());
    LibraryList& list = s.list(LibrarySection::Objects);
    QVERIFY(list.isVisible());
    const QPoint at = list.visualRect(wall).center();
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(list.viewport(), Qt::LeftButton, {}, at);
    QCOMPARE(s.selected(), QStringLiteral("wall"));
    QVERIFY2(s.text().contains("#import objects/wall.sim"), s.text());
    const Vec3 placed = s.document.loaded()->experiment->statics.back().pose.position; // robot0 is at the origin
    QVERIFY2(placed.norm() > 0.1 && placed.norm() < 1.5 && std::abs(placed.z()) < 1e-4, s.text());
    QCOMPARE(s.document.edits().history().entries().size(), std::size_t(1));
    QCOMPARE(s.document.edits().history().entries()[0].name, QStringLiteral("Add Wall"));
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_Return);
    QVERIFY(s.selection.current().starts_with("wall") && s.selection.current() != "wall");
    QCOMPARE(s.document.loaded()->experiment->statics.size(), std::size_t(3));
    QCOMPARE(s.errors(), QString());
}

void LibraryTest::aDragCarriesKindTextAndImports() {
    LibraryFixture s;
    QVERIFY(s.open(kRovers));
    QVERIFY(s.filled());
    const QModelIndex wall = s.row(LibrarySection::Objects, "Wall");
    const std::unique_ptr<QMimeData> mime(wall.model()->mimeData({wall}));
    const QJsonObject json = QJsonDocument::fromJson(mime->data(QStringLiteral("application/x-trundle-library"))).object();
    QCOMPARE(json.value(QStringLiteral("kind")).toString(), QStringLiteral("Static"));
    QVERIFY(json.value(QStringLiteral("text")).toString().startsWith(QStringLiteral("Static wall {")));
    QCOMPARE(json.value(QStringLiteral("imports")).toArray().at(0).toString(), QStringLiteral("objects/wall.sim"));
    QVERIFY(!mime->hasText()); // an editor of text refuses it
    // The tree accepts the drag data.
    QVERIFY(s.model().dropMimeData(mime.get(), Qt::CopyAction, -1, -1, {}));
    QCOMPARE(s.selected(), QStringLiteral("wall"));
    QCOMPARE(s.errors(), QString());
    const QModelIndex box = s.row(LibrarySection::Shapes, "Box");
    const std::unique_ptr<QMimeData> shape(box.model()->mimeData({box}));
    QVERIFY(s.model().dropMimeData(shape.get(), Qt::CopyAction, -1, -1, s.at("RobotConfig.Rover.chassis")));
    QVERIFY(s.selection.current().starts_with("RobotConfig.Rover.chassis.box"));
    QCOMPARE(s.errors(), QString());
}

void LibraryTest::findsTheProjectsOwn() {
    LibraryFixture s;
    QVERIFY(QDir(s.folder.path()).mkpath(QStringLiteral("mine")));
    QVERIFY(QDir(s.folder.path()).mkpath(QStringLiteral("library")));
    QVERIFY(s.write("mine/sled.sim", "// Slides downhill.\nRobotConfig Sled { Body b { Box x { Size=1,1,1 Mass=1 } } }\n"));
    QVERIFY(
        s.write("mixed.sim", "RobotConfig Mixed { Body b { Box x { Size=1,1,1 Mass=1 } } }\nRobot placed { Config=Mixed }\n"));
    QVERIFY(s.write("mine/broken.sim", "RobotConfig Broken { Body {{{{ \n\xff\xfe"));
    QVERIFY(s.write("library/lamp.sim", "// Lamp post: stands and shines.\nBody lamp { Box post { Size=0.1,0.1,1 Mass=1 } }\n"));
    QVERIFY(s.open(kRovers));
    QVERIFY(s.filled());
    QVERIFY(s.item("Sled"));
    QCOMPARE(s.item("Sled")->help, QStringLiteral("Slides downhill."));
    QVERIFY(s.item("Lamp post"));
    QVERIFY(s.item("Rover")); // from the opened file itself
    s.library.insert(*s.item("Sled"));
    QVERIFY(s.text().contains("#import mine/sled.sim"));
    s.library.insert(*s.item("Rover"));
    s.library.insert(*s.item("Mixed")); // only the config, not the robot that its file places
    QCOMPARE(s.refusals, QStringList());
    QCOMPARE(s.errors(), QString());
    for (const RobotSpec& robot : s.document.loaded()->experiment->robots) QVERIFY(robot.name != "placed");
    QCOMPARE(s.document.loaded()->experiment->robots.size(), std::size_t(5));
}

/// A PartConfig is nothing to place in the world.
void LibraryTest::aRobotOfPartsIsDrawnWithThem() {
    LibraryFixture s;
    QVERIFY(s.open("PartConfig Foot { Body b { Box x { Size=1,1,1 Mass=1 } } }\n"
                   "RobotConfig Kit { Body hull { Box x { Size=1,1,1 Mass=1 } } Part foot { Config=Foot } }\n"));
    QVERIFY(s.filled());
    QVERIFY(!s.item("Foot"));
    QVERIFY(s.item("Kit"));
    QVERIFY2(s.item("Kit")->picture.find("PartConfig Foot") != std::string::npos, s.item("Kit")->picture.c_str());
}

void LibraryTest::aSearchLeavesWhatMatches() {
    LibraryFixture s;
    QVERIFY(s.filled());
    auto* search = s.library.findChild<QLineEdit*>(QStringLiteral("librarySearch"));
    QTest::keyClicks(search, QStringLiteral("wheel driven"));
    QVERIFY(s.row(LibrarySection::RobotParts, "Driven wheel").isValid());
    QVERIFY(!s.row(LibrarySection::RobotParts, "Slider").isValid());
    QVERIFY(!s.list(LibrarySection::Arenas).isVisible());
    search->setText(QStringLiteral("hinge"));
    QVERIFY(s.row(LibrarySection::Joints, "Hinge").isValid());
    QVERIFY(s.list(LibrarySection::Joints).isVisible()); // in a collapsed section, shown because it matches the filter
    for (const char* name : {"Cylinder", "Sphere"}) {    // not what has the word in its description
        search->setText(QString::fromLatin1(name).left(3).toLower());
        QCOMPARE(s.list(LibrarySection::Shapes).model()->index(0, 0).data().toString(), QLatin1String(name));
    }
    search->clear();
    QVERIFY(!s.list(LibrarySection::Joints).isVisible());
    QTest::mouseClick(s.library.findChild<QAbstractButton*>(QStringLiteral("librarySection.%1").arg(int(LibrarySection::Joints))),
                      Qt::LeftButton);
    QVERIFY(s.list(LibrarySection::Joints).isVisible());
    // What is searched for in another document or model is something else.
    search->setText(QStringLiteral("wall"));
    QVERIFY(s.open(kRovers));
    QCOMPARE(search->text(), QString());
    search->setText(QStringLiteral("wall"));
    s.document.editedModel().open("RobotConfig.Rover");
    QCOMPARE(search->text(), QString());
}

void LibraryTest::drawsPictures() {
    const auto render = RenderService::start();
    QVERIFY2(render.ok(), render.ok() ? "" : render.error().message.c_str());
    LibraryFixture s(render.value().get());
    QVERIFY(s.filled());
    QTRY_VERIFY_WITH_TIMEOUT(s.library.isSettled(), 60000);
    s.library.resize(280, 600); // As in the window: the image fills its cell above the title, and nothing is clipped.
    const LibraryList& robots = s.list(LibrarySection::Robots);
    EVENTUALLY_EQUAL(robots.gridSize().width(), (robots.viewport()->width() - 1) / 2);
    const double room =
        double(robots.gridSize().width() - 8) / (robots.gridSize().height() - 8 - robots.fontMetrics().height() - 3);
    for (int i = 0; i < s.library.model().rowCount(); ++i) {
        const LibraryItem& item = s.library.model().items()[std::size_t(i)];
        if (item.picture.empty()) continue;
        const QPixmap picture = s.library.model().index(i).data(LibraryModel::PictureRole).value<QPixmap>();
        QVERIFY2(!picture.isNull(), qPrintable(item.title));
        QVERIFY2(std::abs(double(picture.width()) / picture.height() - room) < 0.2, qPrintable(item.title));
        std::set<QRgb> colours; // more than one colour: something is drawn
        const QImage image = picture.toImage().scaled(64, 44);
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) colours.insert(image.pixel(x, y));
        QVERIFY2(colours.size() > 50, qPrintable(item.title));
    }
    QVERIFY(s.row(LibrarySection::Robots, "SimpleRobot").data(LibraryModel::PictureRole).isValid());
    QVERIFY(s.row(LibrarySection::RobotParts, "Driven wheel").data(LibraryModel::PictureRole).isValid());

    // A config of the opened file is drawn with its own materials and values, and without the objects of the experiment.
    QVERIFY(s.open("Param side = 0.4\nMaterial signal { ColorRGB=1,0,0 }\nRobot far { Config=Cube Pos=90,0,0 }\n"
                   "RobotConfig Cube { Body b { Box x { Size=$side,$side,$side Pos=0,0,0.2 Mass=1 Material=signal } } }\n"));
    QVERIFY(s.filled());
    QTRY_VERIFY_WITH_TIMEOUT(s.library.isSettled(), 60000);
    const QImage cube =
        s.row(LibrarySection::Objects, "Cube").data(LibraryModel::PictureRole).value<QPixmap>().toImage().scaled(64, 44);
    QVERIFY(!cube.isNull());
    const QColor middle = cube.pixelColor(32, 22);
    QVERIFY2(middle.red() > 2 * middle.blue(), qPrintable(middle.name()));

    // One that an edit made has a picture before it is saved. With a joint it is a robot.
    QVERIFY(s.document.structure().rename(QStringLiteral("Rename"), "RobotConfig.Cube", "Lump").ok());
    QTRY_VERIFY_WITH_TIMEOUT(s.library.isSettled(), 60000);
    QVERIFY(s.row(LibrarySection::Objects, "Lump").data(LibraryModel::PictureRole).isValid());
    QVERIFY(s.document.edits()
                .apply({}, planInsert(*s.document.loaded(), "RobotConfig.Lump",
                                      "Body c { Sphere s { Radius=0.1 Mass=1 } }\n"
                                      "Hinge h { Parent=b Child=c Axis=0,0,1 }"))
                .ok());
    QVERIFY(s.row(LibrarySection::Robots, "Lump").isValid() && !s.row(LibrarySection::Objects, "Lump").isValid());
}

void LibraryTest::showsFirstSteps() {
    LibraryFixture s;
    QVERIFY(s.filled());
    s.library.insert(*s.item("Wall"));
    QCOMPARE(s.refusals.size(), 1);
    QVERIFY(s.open(kRovers));
    QVERIFY(s.filled());
    s.library.insert(*s.item("Compass")); // nothing is selected
    QCOMPARE(s.refusals.size(), 2);
    QVERIFY2(s.refusals[1].contains(QStringLiteral("RobotConfig")), qPrintable(s.refusals[1]));
    QCOMPARE(s.text(), kRovers);
}

void LibraryTest::templatesLoadWithoutDiagnostics_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"experiment", "robot", "arena"}) QTest::newRow(name) << QString::fromLatin1(name);
}

void LibraryTest::templatesLoadWithoutDiagnostics() {
    QFETCH(QString, name);
    OutlineFixture o;
    QFile file(QStringLiteral(TRUNDLE_SOURCE_DIR "/resources/templates/%1.sim").arg(name));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(o.open(file.readAll()));
    for (const Diagnostic& d : o.document.loaded()->diagnostics.all()) QFAIL(d.message.c_str());
    const ExperimentSpec& experiment = *o.document.loaded()->experiment;
    const bool places = name == QStringLiteral("experiment"); // the other files only define configs
    QCOMPARE(experiment.robots.empty(), !places);
    QCOMPARE(experiment.statics.empty(), !places);
    QCOMPARE(configsWithoutInstances(*o.document.loaded()).size(), std::size_t(places ? 0 : 1));
}

QTEST_MAIN(LibraryTest)
#include "library_test.moc"
