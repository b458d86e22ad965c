// Properties of which exactly one must be given.
#include <QTest>

#include "lang/tree_edit.h"
#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;

namespace {

/// A rover whose left motor has these values in place of `SpeedConstant=50`.
std::string withLeft(const std::string& values, const std::string& more = "Robot robot0 { Config=Rover }\n") {
    return sample::with(sample::rover(more), "SpeedConstant=50", values);
}

} // namespace

class AlternativesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void cases_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* name, const std::string& text, const char* said) {
            QTest::newRow(name) << QString::fromStdString(text) << said;
        };
        row("the first", withLeft("SpeedConstant=50"), "");
        row("the second", withLeft("BackEmfConstant=0.02"), "");
        row("none", withLeft(""), "E209 RotaryMotor leftMotor needs SpeedConstant or BackEmfConstant, exactly one of them\n");
        row("both", withLeft("SpeedConstant=50 BackEmfConstant=0.02"),
            "E214 RotaryMotor leftMotor has SpeedConstant and BackEmfConstant: they say the same thing, give one of them\n");
        row("misspelt", withLeft("SpedConstant=50"), "E201 RotaryMotor leftMotor has no property SpedConstant\n");
        row("one misspelt beside the other", withLeft("SpedConstant=50 BackEmfConstant=0.02"),
            "E201 RotaryMotor leftMotor has no property SpedConstant\n");
        row("one with an invalid value", withLeft("SpeedConstant=-50"), "E203 SpeedConstant is -50, it must be above 0\n");
        row("after a syntax error", withLeft("SpeedConstant="), "E107 ");
        row("the instance gives it", withLeft("", "Robot robot0 { Config=Rover leftMotor.SpeedConstant=50 }\n"),
            "E209 RotaryMotor leftMotor needs SpeedConstant or BackEmfConstant, exactly one of them\n"); // of the config itself
        row("the instance gives the other",
            withLeft("SpeedConstant=50", "Robot robot0 { Config=Rover leftMotor.BackEmfConstant=0.02 }\n"),
            "E214 RotaryMotor leftMotor has SpeedConstant and BackEmfConstant: they say the same thing, give one of them\n");
        row("the instance overrides it",
            withLeft("SpeedConstant=50", "Robot robot0 { Config=Rover leftMotor.SpeedConstant=40 }\n"), "");
    }
    void cases() {
        QFETCH(QString, text);
        QFETCH(QString, said);
        const Resolved r = sample::resolved(text.toStdString());
        if (said == "E107 ") {
            QCOMPARE(r.diagnostics.errorCount(), std::size_t{1}); // no follow-up
            return;
        }
        SAYS(r, said);
    }

    /// The fix for none gives the second from the value that it most likely equals.
    void fixesNone() {
        const Resolved r = sample::resolved(withLeft(""));
        const Diagnostic& d = r.diagnostics.all().at(0);
        QCOMPARE(d.fixes.at(0).title, std::string("BackEmfConstant=0.02"));
        const std::string fixed = applyEdits(r.texts->trees[0]->source().bytes(), d.fixes[0].edits).value();
        SAYS(sample::resolved(fixed), "");
    }

    /// Of two, either fix removes one and leaves the other.
    void fixesBoth() {
        const Resolved r = sample::resolved(withLeft("SpeedConstant=50 BackEmfConstant=0.02"));
        const Diagnostic& d = r.diagnostics.all().at(0);
        QCOMPARE(d.fixes.size(), std::size_t{2});
        for (const Fix& fix : d.fixes) {
            const std::string fixed = applyEdits(r.texts->trees[0]->source().bytes(), fix.edits).value();
            const Resolved again = sample::resolved(fixed);
            SAYS(again, "");
            const bool noSpeed = fix.title == "without SpeedConstant";
            QVERIFY(noSpeed || fix.title == "without BackEmfConstant");
            QCOMPARE(again.config().devices.at(0).find("SpeedConstant") == nullptr, noSpeed);
            QCOMPARE(again.config().devices[0].find("BackEmfConstant") == nullptr, !noSpeed);
        }
    }

    /// The value of an override is not in the block: the fix for it is left out.
    void offersNoFixElsewhere() {
        const Resolved r = sample::resolved(withLeft("SpeedConstant=50", "Robot robot0 { Config=Rover }\n"),
                                            {"RobotConfig.Rover.leftMotor.BackEmfConstant=0.02"});
        QCOMPARE(r.diagnostics.errorCount(), std::size_t{1});
        const Diagnostic& d = r.diagnostics.all().at(0);
        QCOMPARE(d.fixes.size(), std::size_t{1});
        QCOMPARE(d.fixes[0].title, std::string("without SpeedConstant"));
    }
};

QTEST_APPLESS_MAIN(AlternativesTest)
#include "alternatives_test.moc"
