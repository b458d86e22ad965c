// Texts held by an editor in place of files, and how much of a load is reused after an edit.

#include <QTest>

#include "sample_project.h"

using namespace trundle;
using sample::ProjectFixture;

namespace {

std::shared_ptr<const std::string> shared(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

std::string canonical(const std::string& path) { return std::filesystem::weakly_canonical(path).string(); }

} // namespace

class OverlayTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void overlayReplacesFile() {
        ProjectFixture fixture;
        const std::string path = canonical(fixture.write("main.sim", "Tick = 1 ms\n"));
        fixture.options.texts[path] = shared("Tick = 2 ms\n");
        const auto loaded = fixture.openFile(path);
        QCOMPARE(loaded->experiment->settings.tick, 0.002);
        QCOMPARE(loaded->paths, std::vector<std::string>{path});
    }

    void overlayNeedsNoFile() {
        ProjectFixture fixture;
        const std::string path = canonical(fixture.folder() + "/untitled.sim"),
                          part = canonical(fixture.folder() + "/parts/part.sim");
        fixture.options.texts[path] = shared("#import parts/part.sim\nRobot robot0 { Config=Rover }\n");
        fixture.options.texts[part] = shared(sample::kGoodRobot);
        const auto loaded = fixture.openFile(path);
        QCOMPARE(sample::messages(*loaded), "");
        QCOMPARE(loaded->experiment->robots.size(), 1u);
        QCOMPARE(loaded->paths, (std::vector<std::string>{path, part}));
    }

    void aTextOutsideTheProjectIsNotFound() {
        ProjectFixture fixture;
        const std::string path = canonical(fixture.folder() + "/inner/main.sim"),
                          part = canonical(fixture.folder() + "/part.sim");
        fixture.options.texts[path] = shared("#import ../part.sim\n");
        fixture.options.texts[part] = shared("Tick = 1 ms\n");
        const auto loaded = fixture.openFile(path);
        QVERIFY2(sample::messages(*loaded).starts_with("E311"), sample::messages(*loaded).c_str());
    }

    void namesStartAtTheProject() {
        ProjectFixture fixture;
        fixture.write("configs/robots/rover.sim", "Robot { Config=None }\n");
        const std::string path = fixture.write("configs/main.sim", "#import robots/rover.sim\n");
        fixture.options.shownFromProject = true;
        const auto loaded = fixture.openFile(path);
        QCOMPARE(loaded->trees[0]->source().path(), "main.sim");
        QCOMPARE(loaded->trees[1]->source().path(), "robots/rover.sim");
    }

    void oneEditIsOneParse() {
        ProjectFixture fixture;
        fixture.write("a.sim", "#import b.sim\n");
        const std::string b = canonical(fixture.write("b.sim", sample::kGoodRobot));
        const std::string path = canonical(fixture.write("main.sim", "#import a.sim\nRobot robot0 { Config=Rover }\n"));
        const auto first = fixture.openFile(path);
        QCOMPARE(first->parses, 3u);

        fixture.options.previous = first;
        const auto same = fixture.openFile(path);
        QCOMPARE(same->parses, 0u);
        QCOMPARE(same->trees, first->trees);
        QCOMPARE(same->experiment->robots.size(), 1u);

        fixture.options.texts[b] = shared(std::string(sample::kGoodRobot) + "Robot robot1 { Config=Rover }\n");
        const auto edited = fixture.openFile(path);
        QCOMPARE(edited->parses, 1u);
        QCOMPARE(edited->experiment->robots.size(), 2u);
        QVERIFY(edited->trees[0] == first->trees[0]);
        QVERIFY(edited->trees[2] != first->trees[2]);
    }

    void reparsesChangedTrees() {
        ProjectFixture fixture;
        fixture.write("a.sim", "Tick = 1 ms\n");
        fixture.write("b.sim", sample::kGoodRobot);
        const std::string path = canonical(fixture.write("main.sim", "#import b.sim\n"));
        fixture.options.previous = fixture.openFile(path);
        // b.sim has a different FileId now: source ranges of the old tree would refer to a.sim
        fixture.options.texts[path] =
            shared("#import a.sim\n#import b.sim\nRobot robot0 { Config=Rover chassis.hull.Mass=-1 }\n");
        const auto loaded = fixture.openFile(path);
        QCOMPARE(loaded->parses, 3u);
        for (FileId file = 0; file < loaded->trees.size(); ++file) QCOMPARE(loaded->trees[file]->file(), file);
    }

    void theFormerLoadMayGo() {
        ProjectFixture fixture;
        const std::string path =
            canonical(fixture.write("main.sim", std::string(sample::kGoodRobot) + "Robot robot0 { Config=Rover }\n"));
        fixture.options.previous = fixture.openFile(path);
        const auto loaded = fixture.openFile(path);
        fixture.options.previous = nullptr;
        QCOMPARE(loaded->outline->world.all().size(), 1u);
        QCOMPARE(loaded->trees[0]->items().size(), 4u);
    }

    void setsAreTriedOnHeldTexts() {
        ProjectFixture fixture;
        const std::string path = canonical(fixture.write("main.sim", "Tick = 1 ms\n"));
        fixture.options.texts[path] = shared("Tick = 2 ms\nDuration = 1\n");
        fixture.options.sets = {"Duration=2"};
        const auto loaded = fixture.openFile(path);
        QCOMPARE(loaded->experiment->settings.duration, 2.0);
        QCOMPARE(loaded->paths, (std::vector<std::string>{path, ""}));
    }

    void aHeldTextMayBeTooLarge() {
        ProjectFixture fixture;
        const std::string path = canonical(fixture.write("main.sim", ""));
        fixture.options.texts[path] = shared(std::string((64u << 20) + 1, ' '));
        const auto result = fixture.tryOpen(path);
        QVERIFY(!result.ok());
        QCOMPARE(result.error().code, Code::TooLarge);
    }
};

QTEST_APPLESS_MAIN(OverlayTest)
#include "overlay_test.moc"
