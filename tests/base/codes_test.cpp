#include <QTest>
#include <set>

#include "base/diagnostic.h"

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
        // Each range is without holes, so a code without a row shows.
        int previous = 0;
        for (const CodeEntry& entry : allCodes()) {
            const int number = static_cast<int>(entry.code);
            if (entry.code != Code::Internal && previous / 100 == number / 100) QCOMPARE(number, previous + 1);
            previous = number;
        }
        QCOMPARE(codeName(Code::OutOfRange), std::string("E203"));
        QCOMPARE(allCodes().back().code, Code::Internal);
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
};

QTEST_APPLESS_MAIN(CodesTest)
#include "codes_test.moc"
