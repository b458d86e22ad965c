// Not a test: edits and saves a file until the crash test kills it. Prints each edit before it is made, and after each journal
// write and each save what they contain, so that the test can compare it with what is restored.
//   edit_and_save FILE SEED
// With a third argument it groups objects into a piece, undoes and redoes that instead, and saves now and then:
//   edit_and_save FILE SEED pieces
// or it changes the configs of robot0, for all, and of robot1, in a copy, and prints a hash of all texts with each edit:
//   edit_and_save FILE SEED configs

#include <cstdio>
#include <functional>
#include <random>
#include <string_view>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTimer>

#include "editor/document/document.h"
#include "editor/document/group_edit.h"
#include "editor/document/structure_edits.h"
#include "project/edits/plan_group.h"

using namespace trundle;

namespace {

/// Small and large texts, so that some writes are interrupted half-way.
std::string textOf(int number, std::mt19937& random) {
    std::string text = "Seed = " + std::to_string(number) + "\n";
    for (std::uint32_t lines = random() % 3 == 0 ? random() % 20000 : random() % 20; lines > 0; --lines)
        text += "// " + std::to_string(number) + " is the number of the edit\n";
    return text + "// end " + std::to_string(number) + "\n";
}

/// Groups objects into a piece: an edit that creates a file.
bool group(Document& document) {
    const auto plan = planGroup(*document.loaded(), {"a", "b"}, "Piece");
    return plan.ok() && applyGroup(document, u"Group"_qs, plan.value()).ok();
}

bool groupOrUndo(Document& document, std::mt19937& random) {
    if (random() % 3 == 0) return document.saving().save().ok();
    if (document.edits().history().canUndo()) return document.edits().undo(), true;
    return document.edits().history().canRedo() ? (document.edits().redo(), true) : group(document);
}

/// The first question about Cart is answered with a copy, all others with a change for all.
void answerQuestions(Document& document) {
    document.structure().setShareQuestionHandler([](const ShareQuestion& question, const StructureEdits::ShareAnswer& answer) {
        answer(question.config == u"Cart" ? ShareChoice::MakeCopy : ShareChoice::ChangeForAll);
    });
}

bool changeConfigs(Document& document, std::mt19937& random, int number) {
    const std::string robot = random() % 2 ? "robot0" : "robot1", name = "part" + std::to_string(number);
    switch (random() % 8) {
    case 0: return document.saving().save().ok();
    case 1:
    case 2: return document.edits().undo(), true;
    case 3: return document.edits().redo(), true;
    case 4: {
        const std::vector<std::string> paths{robot + ".chassis.hull.Mass", "row.Count", "row_1.goal.Size", "row.tall.left.r",
                                             "rope.Stiffness"};
        const std::string value = std::to_string(number % 9 + 2), &path = paths[random() % paths.size()];
        return document.structure()
            .setValues(u"Set"_qs, {{path, path.ends_with("Size") ? "1,1," + value
                                          : path.ends_with(".r") ? "0." + value
                                                                 : value}})
            .ok();
    }
    default:
        return document.structure()
            .apply(u"Insert"_qs, {robot},
                   [&](const LoadedProject& loaded, const auto& renamed) {
                       return planInsert(loaded, renamed(robot), "Body " + name + " { Sphere ball { Radius=0.1 Mass=1 } }");
                   })
            .ok();
    }
}

std::size_t hashOf(const Document& document) {
    std::string all;
    for (const std::string& file : document.texts().files()) all += *document.texts().text(file) + '\0';
    return std::hash<std::string>()(all);
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    if (argc < 3) return 2;
    const std::string_view what = argc > 3 ? argv[3] : "";
    const bool pieces = what == "pieces", configs = what == "configs";
    const std::unique_ptr<Application> trundleApplication = makeApplication();
    Document document(*trundleApplication);
    if (!document.opening().open(argv[1])) return 1;
    std::mt19937 random(static_cast<unsigned>(std::atoi(argv[2])));
    int number = 0;
    answerQuestions(document);
    QTimer edits;
    QObject::connect(&edits, &QTimer::timeout, &document, [&] {
        if (configs) {
            if (!changeConfigs(document, random, ++number)) std::_Exit(6);
            std::printf("edit %d %zu\n", number, hashOf(document));
        } else if (pieces) {
            if (!groupOrUndo(document, random)) std::_Exit(5);
            std::printf("edit %d\n", ++number);
        } else if (random() % 60 == 0 && number > 0) {
            if (!document.saving().save()) std::_Exit(3);
            std::printf("saved %d\n", number);
        } else {
            ++number;
            if (!document.edits().replaceText(u"Typing"_qs, document.path(), textOf(number, random))) std::_Exit(4);
            std::printf("edit %d\n", number);
        }
        std::fflush(stdout);
        edits.start(static_cast<int>(random() % (pieces || configs ? 700 : 40))); // the journal is written after half a second
    });
    edits.setSingleShot(true);
    edits.start(0);
    std::printf("ready\n");
    if (configs) std::printf("edit 0 %zu\n", hashOf(document));
    std::fflush(stdout);
    return QCoreApplication::exec();
}
