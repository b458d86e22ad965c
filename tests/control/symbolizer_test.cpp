// The functions that addresses of a backtrace are in.
#include <QtTest>

#include <dlfcn.h>

#include <QStandardPaths>

#include "control/host/symbolizer.h"

using namespace trundle;

extern "C" {
// Each does something of its own, so that the linker keeps all of them.
[[gnu::noinline, gnu::used]] int symbolizerFirst(int x) { return x * 7 + 1; }
[[gnu::noinline, gnu::used]] int symbolizerSecond(int x) { return x * 11 + 2; }
[[gnu::noinline, gnu::used]] int symbolizerThird(int x) { return x * 13 + 3; }
}

namespace {

std::uint64_t offsetOf(int (*function)(int)) {
    Dl_info info{};
    return ::dladdr(reinterpret_cast<void*>(function), &info)
               ? static_cast<std::uint64_t>(reinterpret_cast<char*>(function) - static_cast<char*>(info.dli_fbase))
               : 0;
}

std::string functionAt(std::uint64_t offset) {
    const auto frames = symbolize(QCoreApplication::applicationFilePath().toStdString(), {{0, offset}});
    return frames.size() == 1 ? frames.front().function : std::to_string(frames.size()) + " frames";
}

} // namespace

class SymbolizerTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        QVERIFY2(!QStandardPaths::findExecutable(QStringLiteral("addr2line")).isEmpty(), "there is no addr2line");
    }

    /// A function may end with a call: the address that it would return to is the first of the next function.
    void aReturnAddressIsInTheFunctionOfItsCall_data() {
        QTest::addColumn<quint64>("start");
        QTest::addColumn<QString>("name");
        QTest::newRow("first") << quint64(offsetOf(&symbolizerFirst)) << "symbolizerFirst";
        QTest::newRow("second") << quint64(offsetOf(&symbolizerSecond)) << "symbolizerSecond";
        QTest::newRow("third") << quint64(offsetOf(&symbolizerThird)) << "symbolizerThird";
    }
    void aReturnAddressIsInTheFunctionOfItsCall() {
        QFETCH(quint64, start);
        QFETCH(QString, name);
        QVERIFY(start > 0);
        QCOMPARE(functionAt(start + 1), name.toStdString());
        QVERIFY(functionAt(start) != name.toStdString());
    }

    /// Wherever the repetitions are, also at the end; and what is no repetition is shown each time.
    void repetitionsAreCounted() {
        const auto frame = [](const char* function, int line) { return SourceFrame{function, "a.cpp", line, "liba.so+0x1"}; };
        const SourceFrame deep = frame("deep()", 7), other = frame("deep()", 8), start = frame("start()", 9),
                          sdk{"call()", "/opt/include/trundle/abi.h", 3, {}};
        const auto shown = [](const std::vector<SourceFrame>& frames) {
            QStringList lines;
            for (const std::string& line : backtraceOf(frames)) lines << QString::fromStdString(line);
            return lines.join(" | ");
        };
        const QString d = "deep() at a.cpp:7", o = "deep() at a.cpp:8", s = "start() at a.cpp:9",
                      more = "\u2026 %1 more of the same";
        QCOMPARE(shown({}), QString());
        QCOMPARE(shown({deep}), d);
        QCOMPARE(shown({deep, deep, deep, deep}), d + " | " + more.arg(3));
        QCOMPARE(shown({start, deep, deep}), s + " | " + d + " | " + more.arg(1));
        QCOMPARE(shown({deep, deep, deep, start}), d + " | " + more.arg(2) + " | " + s);
        QCOMPARE(shown({deep, deep, other, other, other}), d + " | " + more.arg(1) + " | " + o + " | " + more.arg(2));
        QCOMPARE(shown({deep, other, deep}), d + " | " + o + " | " + d);
        QCOMPARE(shown({deep, sdk, deep}), d + " | " + more.arg(1)); // frames of the SDK are not shown
    }

    void otherLibrariesAreLeftOut() {
        const std::string file = QCoreApplication::applicationFilePath().toStdString();
        const std::uint64_t at = offsetOf(&symbolizerSecond) + 1;
        const auto frames = symbolize(file, {{1, at}, {0, at}, {2, at}});
        QCOMPARE(frames.size(), std::size_t(1));
        QVERIFY(symbolize(file, {{1, at}}).empty());
    }
};

QTEST_GUILESS_MAIN(SymbolizerTest)
#include "symbolizer_test.moc"
