// Reading ELF files that are made here byte by byte: each table on its own, and each offset beyond the end.
#include <optional>

#include "control/elf_reader.h"

#include <QtTest>

using namespace trundle;

namespace {

struct Section {
    std::uint32_t type = 0, link = 0;
    std::uint64_t offset = 0, size = 0;
};

/// A 64-bit little-endian file of 4096 bytes with sections at 1024, program headers at 512 and contents from 2048 on.
struct Elf {
    std::string bytes = std::string(4096, '\0');
    std::uint16_t sections = 0, segments = 0;

    Elf() {
        bytes.replace(0, 6,
                      std::string("\x7f"
                                  "ELF\x02\x01"));
        put(16, 3, 2);
        put(18, 62, 2);
        put(54, 56, 2);
        put(58, 64, 2);
    }
    void put(std::size_t at, std::uint64_t value, unsigned size) {
        for (unsigned i = 0; i < size; ++i) bytes[at + i] = static_cast<char>(value >> (8 * i));
    }
    void add(const Section& s) {
        const std::size_t at = 1024 + 64u * sections;
        put(at + 4, s.type, 4);
        put(at + 24, s.offset, 8);
        put(at + 32, s.size, 8);
        put(at + 40, s.link, 4);
        put(40, 1024, 8);
        put(60, ++sections, 2);
    }
    void addSegment(std::uint32_t type, std::uint64_t offset, std::uint64_t size) {
        const std::size_t at = 512 + 56u * segments;
        put(at, type, 4);
        put(at + 8, offset, 8);
        put(at + 32, size, 8);
        put(32, 512, 8);
        put(56, ++segments, 2);
    }
    void symbol(std::size_t index, std::uint32_t name, std::uint8_t info, std::uint16_t section) {
        const std::size_t at = 2048 + 24 * index;
        put(at, name, 4);
        put(at + 4, info, 1);
        put(at + 6, section, 2);
    }
    void dynamic(std::size_t index, std::uint64_t tag, std::uint64_t value) {
        put(2560 + 16 * index, tag, 8);
        put(2560 + 16 * index + 8, value, 8);
    }
    /// Names at 3072: 1 "alpha", 7 "alphabet", 16 "beta", 21 "$ORIGIN", 29 "/lib:/usr".
    void names() { bytes.replace(3072, 39, std::string("\0alpha\0alphabet\0beta\0$ORIGIN\0/lib:/usr\0", 39)); }
    [[nodiscard]] ElfReader reader() const { return ElfReader(bytes); }
};

constexpr std::uint32_t kStrings = 3, kDynamic = 6, kNoBits = 8, kDynamicSymbols = 11;

/// Sections 0: none, 1: names, 2: dynamic symbols, 3: dynamic entries.
Elf library() {
    Elf elf;
    elf.names();
    elf.add({});
    elf.add({kStrings, 0, 3072, 39});
    elf.add({kDynamicSymbols, 1, 2048, 24 * 4});
    elf.add({kDynamic, 1, 2560, 16 * 4});
    elf.symbol(1, 7, 0x12, 5);  // alphabet, defined
    elf.symbol(2, 16, 0xa1, 0); // beta, unique, not defined here
    elf.symbol(3, 21, 0xa2, 9); // $ORIGIN, unique, defined, the last one
    return elf;
}

} // namespace

class ElfReaderTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void header() {
        Elf elf;
        QVERIFY(elf.reader().isElf() && elf.reader().bits() == 64 && !elf.reader().bigEndian());
        QCOMPARE(elf.reader().type(), std::uint64_t{3});
        QCOMPARE(elf.reader().machine(), std::uint64_t{62});
        elf.put(18, 0x1234, 2);
        QCOMPARE(elf.reader().machine(), std::uint64_t{0x1234});
        elf.bytes[4] = 1;
        QCOMPARE(elf.reader().bits(), 32);
        elf.bytes[4] = 3;
        QCOMPARE(elf.reader().bits(), 0);
        elf.bytes[5] = 2;
        QVERIFY(elf.reader().bigEndian());
        QVERIFY(!ElfReader("\x7f"
                           "EL")
                     .isElf());
        QCOMPARE(ElfReader("\x7f"
                           "ELF")
                     .bits(),
                 0);
    }

    void bytesNeededByEachTable() {
        QCOMPARE(Elf().reader().bytesNeeded(), std::uint64_t{64});
        const auto withSegment = [](std::uint32_t type, std::uint64_t offset, std::uint64_t size) {
            Elf elf;
            elf.addSegment(type, 0, 0);
            elf.addSegment(type, offset, size);
            return elf.reader().bytesNeeded();
        };
        QCOMPARE(withSegment(1, 100, 20), std::uint64_t{512 + 2 * 56}); // the table itself
        QCOMPARE(withSegment(1, 3000, 20), std::uint64_t{3020});
        QCOMPARE(withSegment(2, 3000, 20), std::uint64_t{512 + 2 * 56}); // only what is loaded
        QCOMPARE(withSegment(1, 3000, ~0ull), 1ull << 62);
        QCOMPARE(withSegment(1, ~0ull, 1), 1ull << 62);
        const auto withSection = [](const Section& section) {
            Elf elf;
            elf.add({});
            elf.add(section);
            return elf.reader().bytesNeeded();
        };
        QCOMPARE(withSection({kStrings, 0, 10, 10}), std::uint64_t{1024 + 2 * 64});
        QCOMPARE(withSection({kStrings, 0, 5000, 77}), std::uint64_t{5077});
        QCOMPARE(withSection({kNoBits, 0, 5000, 77}), std::uint64_t{1024 + 2 * 64});
        QCOMPARE(withSection({0, 0, 5000, 77}), std::uint64_t{1024 + 2 * 64});
        QCOMPARE(withSection({kStrings, 0, 2, ~0ull}), 1ull << 62);
    }

    void exportedSymbols() {
        const Elf elf = library();
        QCOMPARE(elf.reader().exports("alphabet"), std::optional(true));
        QCOMPARE(elf.reader().exports("alpha"), std::optional(false)); // only the beginning of a name
        QCOMPARE(elf.reader().exports("alphabets"), std::optional(false));
        QCOMPARE(elf.reader().exports("beta"), std::optional(false)); // used, not defined
        QCOMPARE(elf.reader().exports("$ORIGIN"), std::optional(true));
        QCOMPARE(Elf().reader().exports("alpha"), std::nullopt);
    }

    void symbolTablesThatCannotBeUsed_data() {
        QTest::addColumn<int>("at");
        QTest::addColumn<qulonglong>("value");
        QTest::addColumn<bool>("isTable");
        const auto section = [](int index) { return 1024 + 64 * index; };
        QTest::newRow("names in a section that is missing") << section(2) + 40 << 4ull << false;
        QTest::newRow("names beyond the end") << section(1) + 24 << 4090ull << true;
        QTest::newRow("names without an end") << section(1) + 32 << ~0ull << true;
        QTest::newRow("symbols beyond the end") << section(2) + 24 << 4090ull << true;
        QTest::newRow("symbols without an end") << section(2) + 32 << (1ull << 61) << true;
    }
    void symbolTablesThatCannotBeUsed() {
        QFETCH(int, at);
        QFETCH(qulonglong, value);
        QFETCH(bool, isTable);
        Elf elf = library();
        elf.put(static_cast<std::size_t>(at), value, at % 64 == 40 ? 4 : 8);
        QCOMPARE(elf.reader().exports("alphabet"), isTable ? std::optional(false) : std::nullopt);
    }

    /// A name outside the table of names is no name; the entries after it count.
    void aNameOutsideItsTable() {
        Elf elf = library();
        elf.symbol(1, 39, 0x12, 5);
        QCOMPARE(elf.reader().exports("$ORIGIN"), std::optional(true));
        elf.dynamic(0, 1, 39);
        elf.dynamic(1, 1, 16);
        QCOMPARE(elf.reader().needs(), std::vector<std::string>{"beta"});
    }

    void requiredLibrariesAndSearchPath() {
        Elf elf = library();
        QVERIFY(elf.reader().needs().empty() && elf.reader().searched().empty());
        elf.dynamic(0, 1, 16);
        elf.dynamic(1, 15, 29);
        elf.dynamic(2, 1, 1);
        QCOMPARE(elf.reader().needs(), (std::vector<std::string>{"beta", "alpha"}));
        QCOMPARE(elf.reader().searched(), std::string("/lib:/usr")); // the older tag alone
        elf.dynamic(3, 29, 21);
        QCOMPARE(elf.reader().searched(), std::string("$ORIGIN"));
        elf.dynamic(2, 0, 0); // the end
        QCOMPARE(elf.reader().searched(), std::string("/lib:/usr"));
        elf.put(1024 + 64 * 3 + 40, 9, 4); // names in a section that is missing
        QVERIFY(elf.reader().needs().empty());
    }

    void uniqueSymbols() {
        QCOMPARE(library().reader().uniqueBindings(), (std::vector<std::size_t>{2048 + 2 * 24 + 4, 2048 + 3 * 24 + 4}));
        Elf elf = library();
        elf.put(1024 + 64 * 2 + 32, 1ull << 40, 8);
        QVERIFY(elf.reader().uniqueBindings().empty());
    }

    void machines() {
        QCOMPARE(elfMachineName(ownElfMachine()),
                 std::string(sizeof(void*) == 8 && ownElfMachine() == 62 ? "x86-64" : "AArch64"));
        const std::pair<std::uint64_t, const char*> all[] = {{3, "x86 (32 bit)"},  {8, "MIPS"},     {21, "PowerPC 64"},
                                                             {40, "ARM (32 bit)"}, {62, "x86-64"},  {183, "AArch64"},
                                                             {243, "RISC-V"},      {9, "machine 9"}};
        for (const auto& [number, name] : all) QCOMPARE(elfMachineName(number), std::string(name));
    }
};

QTEST_APPLESS_MAIN(ElfReaderTest)
#include "elf_reader_test.moc"
