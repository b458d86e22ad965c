// The field of a value: what is typed stays while the document changes.
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include "editor/properties/editors/value_field.h"
#include "editor/widgets/apply_theme.h"
#include "eventually.h"

using namespace trundle;

namespace {

struct FieldFixture {
    QWidget window;
    ValueField field{&window};
    QLineEdit other{&window};

    FieldFixture() {
        auto* column = new QVBoxLayout(&window);
        column->addWidget(&field);
        column->addWidget(&other);
        window.show();
        if (!QTest::qWaitForWindowActive(&window, kTimeoutMs)) qFatal("the window has no focus");
        field.setValue(QStringLiteral("3 cm"));
        other.setFocus();
    }
    void type(const char* text) {
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, QLatin1String(text));
    }
};

} // namespace

class ValueFieldTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, ThemeKind::Light); }

    void showsTheValueOfTheDocument() {
        FieldFixture o;
        QCOMPARE(o.field.text(), QStringLiteral("3 cm"));
        o.field.setValue(QStringLiteral("5 cm"));
        QCOMPARE(o.field.text(), QStringLiteral("5 cm"));
        o.field.setFocus(); // nothing is typed
        o.field.setValue(QStringLiteral("6 cm"));
        QCOMPARE(o.field.text(), QStringLiteral("6 cm"));
    }

    void typedTextStays() {
        FieldFixture o;
        QSignalSpy entered(&o.field, &ValueField::entered);
        o.type("40 m");
        for (const char* value : {"3 cm", "7 cm"}) { // another value was changed, then this one
            o.field.setValue(QLatin1String(value));
            QCOMPARE(o.field.text(), QStringLiteral("40 m"));
            QCOMPARE(o.field.cursorPosition(), 4);
        }
        QTest::keyClicks(&o.field, QStringLiteral("m"));
        QTest::keyClick(&o.field, Qt::Key_Return);
        QCOMPARE(entered.size(), 1);
        QCOMPARE(entered[0][0].toString(), QStringLiteral("40 mm"));
        // Esc gives back the newest value.
        o.type("1");
        o.field.setValue(QStringLiteral("8 cm"));
        QTest::keyClick(&o.field, Qt::Key_Escape);
        QCOMPARE(o.field.text(), QStringLiteral("8 cm"));
        QCOMPARE(entered.size(), 1);
    }

    /// Until it is corrected or the value itself changes.
    void refusedTextStays() {
        FieldFixture o;
        const auto refuse =
            QObject::connect(&o.field, &ValueField::entered, &o.field, [&] { o.field.setError(QStringLiteral("no length")); });
        o.type("1 kg");
        o.other.setFocus();
        QVERIFY(o.field.refused() && o.field.reason() == QStringLiteral("no length"));
        o.field.setValue(QStringLiteral("3 cm"));
        QCOMPARE(o.field.text(), QStringLiteral("1 kg"));
        QVERIFY(o.field.refused());
        o.field.setValue(QStringLiteral("9 cm"));
        QCOMPARE(o.field.text(), QStringLiteral("9 cm"));
        QVERIFY(!o.field.refused());
        // While it has the focus, it is being corrected.
        o.type("2 kg");
        QTest::keyClick(&o.field, Qt::Key_Return);
        QVERIFY(o.field.refused());
        o.field.setValue(QStringLiteral("4 cm"));
        QCOMPARE(o.field.text(), QStringLiteral("2 kg"));
        QVERIFY(o.field.refused());
        QObject::disconnect(refuse);
        QTest::keyClick(&o.field, Qt::Key_Escape);
        QCOMPARE(o.field.text(), QStringLiteral("4 cm"));
        QVERIFY(!o.field.refused());
    }
};

QTEST_MAIN(ValueFieldTest)
#include "value_field_test.moc"
