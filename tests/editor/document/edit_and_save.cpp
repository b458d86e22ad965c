// Not a test: edits and saves a file until the crash test kills it. Prints each edit before it is made, and after each journal
// write and each save what they contain, so that the test can compare it with what is restored.
//   edit_and_save FILE SEED
// With a third argument it groups objects into a piece, undoes and redoes that instead, and saves now and then:
//   edit_and_save FILE SEED pieces

#include <cstdio>
#include <random>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTimer>

#include "editor/document/document.h"
#include "editor/document/group_edit.h"
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
    if (random() % 3 == 0) return document.save().ok();
    if (document.history().canUndo()) return document.undo(), true;
    return document.history().canRedo() ? (document.redo(), true) : group(document);
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    if (argc < 3) return 2;
    const bool pieces = argc > 3;
    const std::unique_ptr<Application> trundleApplication = makeApplication();
    Document document(*trundleApplication);
    if (!document.open(argv[1])) return 1;
    std::mt19937 random(static_cast<unsigned>(std::atoi(argv[2])));
    int number = 0;
    QTimer edits;
    QObject::connect(&edits, &QTimer::timeout, &document, [&] {
        if (pieces) {
            if (!groupOrUndo(document, random)) std::_Exit(5);
            std::printf("edit %d\n", ++number);
        } else if (random() % 60 == 0 && number > 0) {
            if (!document.save()) std::_Exit(3);
            std::printf("saved %d\n", number);
        } else {
            ++number;
            if (!document.replaceText(u"Typing"_qs, document.path(), textOf(number, random))) std::_Exit(4);
            std::printf("edit %d\n", number);
        }
        std::fflush(stdout);
        edits.start(static_cast<int>(random() % (pieces ? 700 : 40))); // the journal is written after half a second
    });
    edits.setSingleShot(true);
    edits.start(0);
    std::printf("ready\n");
    std::fflush(stdout);
    return QCoreApplication::exec();
}
