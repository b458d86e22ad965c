#pragma once
// Tests by rows: what the model check finds in a text, and what is left of that once its fix is applied.

#include "check/check_fixture.h"

namespace fixture {

struct FindingRows {
    CheckFixture m_fixture;

    static void columns() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<std::string>("said"); ///< the first finding contains it; empty: nothing is found
        QTest::addColumn<std::string>("fix");  ///< its title; empty: none
    }
    static void row(const char* name, const std::string& text, const std::string& said, const std::string& fix = {}) {
        QTest::newRow(name) << text << said << fix;
    }
    /// The fix leaves nothing to find in that place.
    void check() {
        QFETCH(const std::string, text);
        QFETCH(const std::string, said);
        QFETCH(const std::string, fix);
        QVERIFY(!text.empty());
        const auto loaded = m_fixture.open(kThings + text);
        QVERIFY(loaded);
        const Diagnostics found = CheckFixture::check(*loaded);
        const std::string story = CheckFixture::shown(*loaded, found);
        QVERIFY2(!loaded->diagnostics.hasErrors() && found.all().empty() == said.empty(), story.c_str());
        if (said.empty()) return;
        const Diagnostic& d = found.all()[0];
        QVERIFY2(d.message.find(said) != std::string::npos, story.c_str());
        QCOMPARE(d.fixes.empty() ? std::string() : d.fixes[0].title, fix);
        if (fix.empty()) return;
        const auto again = m_fixture.open(CheckFixture::applied(*loaded, d.fixes[0]));
        const Diagnostics after = CheckFixture::check(*again);
        for (const Diagnostic& each : after.all())
            QVERIFY2(each.range.range.begin != d.range.range.begin, CheckFixture::shown(*again, after).c_str());
    }
};

} // namespace fixture
