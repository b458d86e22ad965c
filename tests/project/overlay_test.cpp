// Texts that an editor holds instead of the files, and how little of a load an edit does again.

#include <QTest>

#include "sample_project.h"

using namespace trundle;
using sample::Desk;

namespace {

std::shared_ptr<const std::string> shared(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

std::string canonical(const std::string& path) { return std::filesystem::weakly_canonical(path).string(); }

} // namespace

class OverlayTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aTextStandsInForItsFile() {
        Desk desk;
        const std::string path = canonical(desk.write("main.sim", "Tick = 1 ms\n"));
        desk.options.texts[path] = shared("Tick = 2 ms\n");
        const auto loaded = desk.openFile(path);
        QCOMPARE(loaded->experiment->settings.tick, 0.002);
        QCOMPARE(loaded->paths, std::vector<std::string>{path});
    }

    void aTextNeedsNoFile() {
        Desk desk;
        const std::string path = canonical(desk.folder() + "/untitled.sim"), part = canonical(desk.folder() + "/parts/part.sim");
        desk.options.texts[path] = shared("#import parts/part.sim\nRobot robot0 { Config=Rover }\n");
        desk.options.texts[part] = shared(sample::kGoodRobot);
        const auto loaded = desk.openFile(path);
        QCOMPARE(sample::messages(*loaded), "");
        QCOMPARE(loaded->experiment->robots.size(), 1u);
        QCOMPARE(loaded->paths, (std::vector<std::string>{path, part}));
    }

    void aTextOutsideTheProjectIsNotFound() {
        Desk desk;
        const std::string path = canonical(desk.folder() + "/inner/main.sim"), part = canonical(desk.folder() + "/part.sim");
        desk.options.texts[path] = shared("#import ../part.sim\n");
        desk.options.texts[part] = shared("Tick = 1 ms\n");
        const auto loaded = desk.openFile(path);
        QVERIFY2(sample::messages(*loaded).starts_with("E311"), sample::messages(*loaded).c_str());
    }

    void namesStartAtTheProject() {
        Desk desk;
        desk.write("configs/robots/rover.sim", "Robot { Config=None }\n");
        const std::string path = desk.write("configs/main.sim", "#import robots/rover.sim\n");
        desk.options.shownFromProject = true;
        const auto loaded = desk.openFile(path);
        QCOMPARE(loaded->trees[0]->source().path(), "main.sim");
        QCOMPARE(loaded->trees[1]->source().path(), "robots/rover.sim");
    }

    void oneEditIsOneParse() {
        Desk desk;
        desk.write("a.sim", "#import b.sim\n");
        const std::string b = canonical(desk.write("b.sim", sample::kGoodRobot));
        const std::string path = canonical(desk.write("main.sim", "#import a.sim\nRobot robot0 { Config=Rover }\n"));
        const auto first = desk.openFile(path);
        QCOMPARE(first->parses, 3u);

        desk.options.previous = first;
        const auto same = desk.openFile(path);
        QCOMPARE(same->parses, 0u);
        QCOMPARE(same->trees, first->trees);
        QCOMPARE(same->experiment->robots.size(), 1u);

        desk.options.texts[b] = shared(std::string(sample::kGoodRobot) + "Robot robot1 { Config=Rover }\n");
        const auto edited = desk.openFile(path);
        QCOMPARE(edited->parses, 1u);
        QCOMPARE(edited->experiment->robots.size(), 2u);
        QVERIFY(edited->trees[0] == first->trees[0]);
        QVERIFY(edited->trees[2] != first->trees[2]);
    }

    void treesThatMovedAreParsedAnew() {
        Desk desk;
        desk.write("a.sim", "Tick = 1 ms\n");
        desk.write("b.sim", sample::kGoodRobot);
        const std::string path = canonical(desk.write("main.sim", "#import b.sim\n"));
        desk.options.previous = desk.openFile(path);
        // b.sim is another FileId now: what the old tree says about places would lead to a.sim
        desk.options.texts[path] = shared("#import a.sim\n#import b.sim\nRobot robot0 { Config=Rover chassis.hull.Mass=-1 }\n");
        const auto loaded = desk.openFile(path);
        QCOMPARE(loaded->parses, 3u);
        for (FileId file = 0; file < loaded->trees.size(); ++file) QCOMPARE(loaded->trees[file]->file(), file);
    }

    void theFormerLoadMayGo() {
        Desk desk;
        const std::string path =
            canonical(desk.write("main.sim", std::string(sample::kGoodRobot) + "Robot robot0 { Config=Rover }\n"));
        desk.options.previous = desk.openFile(path);
        const auto loaded = desk.openFile(path);
        desk.options.previous = nullptr;
        QCOMPARE(loaded->outline->world.all().size(), 1u);
        QCOMPARE(loaded->trees[0]->items().size(), 4u);
    }

    void setsAreTriedOnHeldTexts() {
        Desk desk;
        const std::string path = canonical(desk.write("main.sim", "Tick = 1 ms\n"));
        desk.options.texts[path] = shared("Tick = 2 ms\nDuration = 1\n");
        desk.options.sets = {"Duration=2"};
        const auto loaded = desk.openFile(path);
        QCOMPARE(loaded->experiment->settings.duration, 2.0);
        QCOMPARE(loaded->paths, (std::vector<std::string>{path, ""}));
    }

    void aHeldTextMayBeTooLarge() {
        Desk desk;
        const std::string path = canonical(desk.write("main.sim", ""));
        desk.options.texts[path] = shared(std::string((64u << 20) + 1, ' '));
        const auto result = desk.tryOpen(path);
        QVERIFY(!result.ok());
        QCOMPARE(result.error().code, Code::TooLarge);
    }
};

QTEST_APPLESS_MAIN(OverlayTest)
#include "overlay_test.moc"
