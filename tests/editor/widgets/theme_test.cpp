// Colours that can be read, icons that are there.

#include <cmath>

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QtTest>

#include "editor/widgets/theme.h"

using namespace trundle;

namespace {

double channel(double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }
double luminance(const QColor& c) {
    return 0.2126 * channel(c.redF()) + 0.7152 * channel(c.greenF()) + 0.0722 * channel(c.blueF());
}
/// WCAG 2.1, contrast ratio.
double contrast(const QColor& a, const QColor& b) {
    const double x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

} // namespace

class ThemeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyInkCanBeRead_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    void everyInkCanBeRead() {
        QFETCH(bool, dark);
        applyTheme(*qApp, dark ? ThemeKind::Dark : ThemeKind::Light);
        for (const Ink which : {Ink::Text, Ink::Faint, Ink::Accent, Ink::Error, Ink::Warning, Ink::Hint, Ink::Good, Ink::Keyword,
                                Ink::Number, Ink::String, Ink::Comment, Ink::Type}) {
            const double ratio = contrast(ink(which), qApp->palette().color(QPalette::Base));
            QVERIFY2(ratio >= 4.5, qPrintable(QStringLiteral("ink %1 has %2 : 1").arg(int(which)).arg(ratio)));
        }
        const QPalette palette = qApp->palette();
        QVERIFY(contrast(palette.color(QPalette::HighlightedText), palette.color(QPalette::Highlight)) >= 4.5);
    }

    void iconsTakeTheColourOfTheTheme() {
        QVERIFY(themedIcon(QStringLiteral("no such icon")).isNull());
        for (const ThemeKind kind : {ThemeKind::Light, ThemeKind::Dark}) {
            applyTheme(*qApp, kind);
            const QImage drawn = themedIcon(QStringLiteral("run")).pixmap(32, 32).toImage();
            const QColor middle = drawn.pixelColor(drawn.width() * 2 / 5, drawn.height() / 2);
            QCOMPARE(middle.alpha(), 255);
            QCOMPARE(middle.rgb(), ink(Ink::Text).rgb());
        }
    }
};

QTEST_MAIN(ThemeTest)
#include "theme_test.moc"
