// Measures the window: window_bench typing FILE KEYS | filter FILE ROUNDS | gaps FILE | frames FILE SECONDS | sensors FILE SECONDS | start MS [FILE].
// One JSON object on standard output. `start` takes the time at which the program was started, in ms of the monotonic
// clock. Run by run_bench.py; QT_QPA_PLATFORM=offscreen.

#include <cstdio>

#include <QJsonDocument>

#include "bench/window/bench_window.h"

using namespace trundle;

int main(int argc, char** argv) {
    QApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
    BenchApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("Trundle"));
    QApplication::setOrganizationName(QStringLiteral("Trundle"));
    const QStringList words = QApplication::arguments();
    const QString what = words.value(1), file = words.value(2);
    QJsonObject found;
    if (what == QStringLiteral("typing")) found = measureTyping(file, words.value(3).toInt());
    else if (what == QStringLiteral("filter")) found = measureFilter(file, words.value(3).toInt());
    else if (what == QStringLiteral("gaps")) found = measureGaps(file);
    else if (what == QStringLiteral("frames")) found = measureFrames(file, words.value(3).toDouble());
    else if (what == QStringLiteral("sensors")) found = measureSensors(file, words.value(3).toDouble());
    else if (what == QStringLiteral("start")) found = measureStart(words.value(3), file.toDouble());
    else return std::fprintf(stderr, "window_bench: typing, filter, gaps, frames, sensors or start?\n"), 2;
    std::puts(QJsonDocument(found).toJson().constData());
    return 0;
}
