// The table of diagnostic codes, and the limits on kept diagnostics.
#include <QTest>
#include <set>

#include "base/diagnostic.h"

Q_DECLARE_METATYPE(trundle::Severity)

using namespace trundle;

class CodesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyCodeHasOneRowInOrder() {
        int last = 0;
        std::set<std::string_view> titles;
        for (const CodeEntry& entry : allCodes()) {
            QVERIFY2(static_cast<int>(entry.code) > last, codeName(entry.code).c_str());
            last = static_cast<int>(entry.code);
            QVERIFY(!entry.title.empty());
            QVERIFY2(titles.insert(entry.title).second, codeName(entry.code).c_str());
        }
        // Each range of codes has no gaps, so a code without a table row fails here.
        int previous = 0;
        for (const CodeEntry& entry : allCodes()) {
            const int number = static_cast<int>(entry.code);
            if (entry.code != Code::Internal && previous / 100 == number / 100) QCOMPARE(number, previous + 1);
            previous = number;
        }
        QCOMPARE(codeName(Code::OutOfRange), std::string("E203"));
        QCOMPARE(allCodes().back().code, Code::NoDocument);
    }

    void diagnosticsAreCounted() {
        Diagnostics all;
        QVERIFY(!all.hasErrors());
        all.warning(Code::DefaultUsed, {}, "a warning");
        all.hint(Code::DefinedLater, {}, "a hint");
        QVERIFY(!all.hasErrors());
        all.error(Code::BadMass, {0, {1, 2}}, "an error").suggestions = {"x"};
        all.append({Diagnostic{}, Diagnostic{Severity::Warning}});
        QCOMPARE(all.errorCount(), std::size_t(2));
        QCOMPARE(all.all().size(), std::size_t(5));
        QCOMPARE(all.all()[2].message, std::string("an error"));
        QCOMPARE(all.all()[2].suggestions.size(), std::size_t(1));
    }

    /// A fixed number of messages is kept for each file; warnings do not displace errors, nor one file's messages another's.
    void keepsABoundedNumberOfEachFile() {
        Diagnostics all;
        for (std::uint32_t i = 0; i < 5000; ++i) all.warning(Code::DefaultUsed, {0, {i, i}}, "a warning");
        for (std::uint32_t i = 0; i < 3000; ++i) all.error(Code::BadMass, {0, {i, i}}, "an error");
        all.error(Code::BadMass, {1, {0, 0}}, "in another file");
        QCOMPARE(all.errorCount(), std::size_t(3001));
        QCOMPARE(all.all().size(), 2 * Diagnostics::kMaxOfOneFile + 1);
        QCOMPARE(all.all().back().message, std::string("in another file"));
        all.summarize();
        QCOMPARE(all.all().back().code, Code::TooManyMistakes);
        QCOMPARE(all.all().back().more, std::uint64_t(2000 + 4000));
        QCOMPARE(all.all().back().message,
                 std::string("and 2000 more errors and 4000 more warnings in this file; fix the ones above first"));
        QCOMPARE(all.all().back().range.range.begin, 1000u);

        Diagnostics files;
        for (std::uint32_t file = 0; file < 100; ++file)
            for (std::uint32_t i = 0; i < 1000; ++i) files.error(Code::BadMass, {file, {i, i}}, "an error");
        QCOMPARE(files.all().size(), Diagnostics::kMaxOfAll);
    }

    /// A config that many robots share gives the same message for each: it is kept once, but counted as an error for each robot.
    void keepsEachMessageOnce() {
        Diagnostics all;
        for (int i = 0; i < 10; ++i) all.error(Code::BadMass, {0, {1, 2}}, "an error").fixes.push_back({"x", {}});
        QCOMPARE(all.all().size(), std::size_t(1));
        QCOMPARE(all.errorCount(), std::size_t(10));
        all.error(Code::BadMass, {0, {1, 2}}, "another");
        QCOMPARE(all.all().size(), std::size_t(2));
        all.summarize();
        QCOMPARE(all.all().size(), std::size_t(2));
    }

    void cutsLongNames() {
        Diagnostics all;
        const std::string umlauts = QString(QChar(0xe4)).repeated(100000).toStdString();
        const std::string& message = all.error(Code::UnknownKey, {}, "unknown property " + umlauts + " of Box").message;
        QVERIFY(message.size() < 300);
        QVERIFY(message.starts_with("unknown property \xC3\xA4") && message.ends_with(" of Box"));
        QVERIFY(QString::fromStdString(message).contains(QChar(0x2026)) &&
                !QString::fromStdString(message).contains(QChar(0xfffd)));
        QCOMPARE(shortenedMessage("short words stay"), std::string("short words stay"));
        std::string words;
        for (int i = 0; i < 1000; ++i) words += "word ";
        QVERIFY(shortenedMessage(words).size() < 2100);
    }

    /// Errors and other messages fill limits of their own, of a file and of all files, whichever come first.
    void errorsLeaveRoomForWarnings_data() {
        QTest::addColumn<Severity>("first");
        QTest::addColumn<Severity>("then");
        QTest::newRow("warnings then errors") << Severity::Warning << Severity::Error;
        QTest::newRow("errors then warnings") << Severity::Error << Severity::Warning;
        QTest::newRow("errors then hints") << Severity::Error << Severity::Hint;
    }
    void errorsLeaveRoomForWarnings() {
        QFETCH(Severity, first);
        QFETCH(Severity, then);
        Diagnostics all;
        const auto fill = [&](Severity severity, FileId file, std::uint32_t count) {
            const std::size_t before = all.all().size();
            for (std::uint32_t i = 0; i < count; ++i) all.add(severity, Code::BadMass, {file, {i, i + 1}}, "again");
            return all.all().size() - before;
        };
        QCOMPARE(fill(first, 0, 1001), std::size_t{1000});
        QCOMPARE(fill(then, 0, 1001), std::size_t{1000});
        for (FileId file = 1; file < 5; ++file) QCOMPARE(fill(first, file, 1000), std::size_t{1000});
        QCOMPARE(fill(first, 5, 3), std::size_t{0}); // all files together
        for (FileId file = 1; file < 4; ++file) QCOMPARE(fill(then, file, 1000), std::size_t{1000});
        QCOMPARE(fill(then, 5, 1001), std::size_t{1000});
        QCOMPARE(fill(then, 6, 1), std::size_t{0});
        const std::size_t given = first == Severity::Error  ? 1001 + 4000 + 3
                                  : then == Severity::Error ? 1001 + 3000 + 1001 + 1
                                                            : 0;
        QCOMPARE(all.errorCount(), given);
    }
};

QTEST_APPLESS_MAIN(CodesTest)
#include "codes_test.moc"
