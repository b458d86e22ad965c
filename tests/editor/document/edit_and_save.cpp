// Not a test: edits and saves a file until somebody kills it. Says before each edit which one it is, and after each note of the
// journal and each save what they hold, so that whoever kills it knows what must have been kept.
//   edit_and_save FILE SEED

#include <cstdio>
#include <random>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTimer>

#include "editor/document/document.h"

using namespace trundle;

namespace {

/// Small edits and large ones, so that some writes are torn.
std::string textOf(int number, std::mt19937& random) {
    std::string text = "Seed = " + std::to_string(number) + "\n";
    for (std::uint32_t lines = random() % 3 == 0 ? random() % 20000 : random() % 20; lines > 0; --lines)
        text += "// " + std::to_string(number) + " is the number of the edit\n";
    return text + "// end " + std::to_string(number) + "\n";
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    if (argc != 3) return 2;
    const std::unique_ptr<Parts> parts = makeParts();
    Document document(*parts);
    if (!document.open(argv[1])) return 1;
    std::mt19937 random(static_cast<unsigned>(std::atoi(argv[2])));
    int number = 0;
    QTimer edits;
    QObject::connect(&edits, &QTimer::timeout, &document, [&] {
        if (random() % 60 == 0 && number > 0) {
            if (!document.save()) std::_Exit(3);
            std::printf("saved %d\n", number);
        } else {
            ++number;
            if (!document.replaceText(u"Typing"_qs, document.path(), textOf(number, random))) std::_Exit(4);
            std::printf("edit %d\n", number);
        }
        std::fflush(stdout);
        edits.start(static_cast<int>(random() % 40));
    });
    edits.setSingleShot(true);
    edits.start(0);
    std::printf("ready\n");
    std::fflush(stdout);
    return QCoreApplication::exec();
}
