// Memory of the process.
#include <QtTest>

#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "base/platform/memory.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TRUNDLE_SANITIZED 1 // another heap
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TRUNDLE_SANITIZED 1
#endif
#endif

using namespace trundle;

class MemoryTest : public QObject {
    Q_OBJECT

    /// The flags of the mapping that has an address, as the system lists them; "hg": large pages were asked for.
    static std::string flagsAt(const void* at) {
        std::ifstream maps("/proc/self/smaps");
        bool isIn = false;
        for (std::string line; std::getline(maps, line);) {
            char* rest = nullptr;
            const std::uintptr_t from = std::strtoull(line.c_str(), &rest, 16);
            if (*rest == '-' && rest != line.c_str()) {
                const std::uintptr_t to = std::strtoull(rest + 1, nullptr, 16), address = reinterpret_cast<std::uintptr_t>(at);
                isIn = address >= from && address < to;
            } else if (isIn && line.starts_with("VmFlags:")) return line;
        }
        return {};
    }

private Q_SLOTS:
    /// Small and long blocks come from large pages then, and hold what is written to them.
    void largePagesForALargeWorld() {
        std::ifstream setting("/sys/kernel/mm/transparent_hugepage/enabled");
        std::string modes;
        std::getline(setting, modes);
        useLargePages(64u << 20);
        std::vector<std::unique_ptr<std::vector<std::uint32_t>>> blocks;
        int large = 0;
        for (std::uint32_t i = 0; i < 200; ++i) {
            blocks.push_back(std::make_unique<std::vector<std::uint32_t>>(i % 10 == 0 ? 250'000 : 20'000, i));
            large += flagsAt(blocks.back()->data()).find(" hg") != std::string::npos;
        }
        for (std::uint32_t i = 0; i < blocks.size(); ++i)
            for (const std::uint32_t number : *blocks[i]) QCOMPARE(number, i);
#ifndef TRUNDLE_SANITIZED
        if (modes.find("[never]") == std::string::npos && !modes.empty())
            QVERIFY2(large > 150, qPrintable(QString::number(large)));
#endif
    }
    void thePeakIsThatOfThisProcess() {
        const std::uint64_t before = peakMemoryKb();
        std::vector<char> much(80u << 20, 'x');
        QCOMPARE(much[much.size() / 2], 'x');
        QVERIFY(before > 1000 && peakMemoryKb() > before + 60'000);
    }
};

QTEST_GUILESS_MAIN(MemoryTest)
#include "memory_test.moc"
