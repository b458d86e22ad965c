// Replays earlier fuzzer findings and a sample of generated inputs in every test run.

#include <QtTest>

#include <vector>

#include "base/rng.h"
#include "fuzz/targets.h"

using namespace trundle;

namespace {

std::vector<std::uint8_t> randomBytes(std::uint64_t seed, std::size_t size) {
    std::vector<std::uint8_t> bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(randomBits(seed, 0, 0, i) >> 56);
    return bytes;
}

void replay(const QString& folder, void (*attempt)(std::span<const std::uint8_t>)) {
    QDirIterator at(QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/data/finds/") + folder, QDir::Files);
    while (at.hasNext()) {
        QFile file(at.next());
        QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
        qInfo("%s", qPrintable(file.fileName())); // the last name printed is the one that aborts
        const QByteArray bytes = file.readAll();
        attempt({reinterpret_cast<const std::uint8_t*>(bytes.data()), static_cast<std::size_t>(bytes.size())});
    }
}

std::size_t count(std::size_t few, std::size_t many) { return qEnvironmentVariableIsSet("TRUNDLE_LONG") ? many : few; }

} // namespace

class ReplayTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void textsThatWereFound() { replay("fuzz_text", fuzz::tryText); }
    void worldsThatWereFound() { replay("fuzz_world", fuzz::tryWorld); }
    void requestsThatWereFound() {
        replay("fuzz_remote", [](std::span<const std::uint8_t> bytes) { (void)fuzz::tryRemote(bytes); });
    }
    void randomRequests() {
        std::size_t requests = 0;
        for (std::uint64_t seed = 0; requests < count(100'000, 1'000'000); ++seed) requests += fuzz::tryRemote(randomBytes(seed, 3000));
        QVERIFY(requests >= 100'000);
    }
    void randomWorlds() {
        for (std::uint64_t seed = 0; seed < count(150, 20000); ++seed) fuzz::tryWorld(randomBytes(seed, 300 + seed % 900));
    }
    void randomTexts() {
        for (std::uint64_t seed = 0; seed < count(150, 20000); ++seed) fuzz::tryText(randomBytes(~seed, 1 + seed % 400));
    }
};

QTEST_APPLESS_MAIN(ReplayTest)
#include "replay_test.moc"
