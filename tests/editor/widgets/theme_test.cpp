// Theme colours have enough contrast, and all icons exist.

#include <cmath>

#include <QApplication>
#include <QCheckBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMessageBox>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStandardItemModel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <QtTest>

#include "editor/widgets/apply_theme.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/preferences.h"
#include "eventually.h"

using namespace trundle;

namespace {

double channel(double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }
double luminance(const QColor& c) {
    return 0.2126 * channel(c.redF()) + 0.7152 * channel(c.greenF()) + 0.0722 * channel(c.blueF());
}
/// Contrast ratio of WCAG 2.1.
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

    void progressIsReadOverBothPartsOfItsBar() {
        for (const ThemeKind kind : {ThemeKind::Light, ThemeKind::Dark}) {
            applyTheme(*qApp, kind);
            QProgressBar bar;
            bar.setTextVisible(false);
            bar.resize(300, 24);
            bar.setValue(50);
            const QImage drawn = bar.grab().toImage();
            const QColor filled = drawn.pixelColor(75, 12), empty = drawn.pixelColor(225, 12);
            QVERIFY(filled != empty);
            for (const QColor& part : {filled, empty}) QVERIFY(contrast(ink(Ink::Text), part) >= 4.5);
        }
    }

    void iconsUseThemeColour() {
        QVERIFY(themedIcon(QStringLiteral("no such icon")).isNull());
        for (const ThemeKind kind : {ThemeKind::Light, ThemeKind::Dark}) {
            applyTheme(*qApp, kind);
            const QImage drawn = themedIcon(QStringLiteral("run")).pixmap(32, 32).toImage();
            const QColor middle = drawn.pixelColor(drawn.width() * 2 / 5, drawn.height() / 2);
            QCOMPARE(middle.alpha(), 255);
            QCOMPARE(middle.rgb(), ink(Ink::Text).rgb());
        }
    }

    /// Texts smaller or larger than the interface font keep their proportion to it, also if the font changes later.
    void smallAndLargeTextsFollowTheFont() {
        applyTheme(*qApp, ThemeKind::Light, {13, 13});
        QLabel figures;
        useFont(figures, [] { return figuresFont(); });
        figures.show();
        QCOMPARE(figures.font().pixelSize(), 11);
        QCOMPARE(scaledToFont(24), 24);
        for (const int size : {17, kLargestInterfaceFont, kSmallestFont}) {
            applyTheme(*qApp, ThemeKind::Light, {size, 13});
            QApplication::processEvents();
            QCOMPARE(figures.font().pixelSize(), qRound(11 * size / 13.0));
            QCOMPARE(figures.font().family(), monospaceFont().family());
            QCOMPARE(scaledToFont(26), 2 * size);
        }
        applyTheme(*qApp, ThemeKind::Light);
    }

    void cellsOfATableStandBelowTheirHeading() {
        applyTheme(*qApp, ThemeKind::Light);
        for (const LineFont font : {LineFont::Interface, LineFont::Monospace}) {
            QStandardItemModel model;
            model.setHorizontalHeaderLabels({QStringLiteral("H")});
            model.appendRow(new QStandardItem(QStringLiteral("H")));
            const std::unique_ptr<QTableView> table(makeLineTable("table", &model, font));
            table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
            table->resize(200, 100);
            table->show();
            const auto firstInk = [](QWidget& widget, int height) {
                const QImage image = widget.grab().toImage();
                for (int x = 0; x < image.width(); ++x)
                    for (int y = 2; y < height - 2; ++y)
                        if (image.pixelColor(x, y).lightness() < 150) return x;
                return -1;
            };
            const int heading = firstInk(*table->horizontalHeader()->viewport(), table->horizontalHeader()->height());
            const int cell = firstInk(*table->viewport(), table->rowHeight(0));
            QVERIFY2(heading > 0 && std::abs(heading - cell) <= 1, qPrintable(QStringLiteral("%1 %2").arg(heading).arg(cell)));
        }
    }

    /// No icon is Qt's own: each has the theme colour of its severity and a cut-out symbol.
    void messagesHaveTheProgramsIcons() {
        using Message = std::pair<QMessageBox::Icon, Ink>;
        for (const ThemeKind kind : {ThemeKind::Light, ThemeKind::Dark}) {
            applyTheme(*qApp, kind);
            for (const auto& [icon, which] :
                 {Message(QMessageBox::Information, Ink::Accent), Message(QMessageBox::Question, Ink::Accent),
                  Message(QMessageBox::Warning, Ink::Warning), Message(QMessageBox::Critical, Ink::Error)}) {
                const QMessageBox box(icon, QStringLiteral("t"), QStringLiteral("x"));
                const QImage image = box.iconPixmap().toImage();
                QVERIFY(image.width() >= 16);
                int inked = 0, empty = 0, others = 0;
                for (int y = 0; y < image.height(); ++y)
                    for (int x = 0; x < image.width(); ++x) {
                        const QColor c = image.pixelColor(x, y);
                        if (c.alpha() == 0) ++empty;
                        else if (c.alpha() == 255) ++(c.rgb() == ink(which).rgb() ? inked : others);
                    }
                QVERIFY2(inked > image.width() * image.height() / 4 && empty > 0 && others == 0,
                         qPrintable(QString::number(icon)));
                QVERIFY(image.pixelColor(image.width() / 2, image.height() / 2).rgba() !=
                            image.pixelColor(image.width() / 2, image.height() / 5).rgba() ||
                        icon == QMessageBox::Critical);
            }
        }
    }

    void noQuestionHasDiscardAsItsDefault() {
        applyTheme(*qApp, ThemeKind::Light);
        const auto defaultOf = [](QMessageBox& box) {
            box.show();
            const QPushButton* chosen = nullptr;
            for (QAbstractButton* button : box.buttons())
                if (auto* push = qobject_cast<QPushButton*>(button); push && push->isDefault()) chosen = push;
            return chosen ? chosen->text().remove(QLatin1Char('&')) : QString();
        };
        QMessageBox bare(QMessageBox::Question, QStringLiteral("t"), QStringLiteral("x"),
                         QMessageBox::Discard | QMessageBox::Cancel);
        QCOMPARE(defaultOf(bare), QStringLiteral("Cancel"));
        QMessageBox chosen(QMessageBox::Question, QStringLiteral("t"), QStringLiteral("x"),
                           QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
        chosen.setDefaultButton(QMessageBox::Discard);
        QCOMPARE(defaultOf(chosen), QStringLiteral("Save"));
        QMessageBox own;
        own.addButton(QStringLiteral("Stop Recording"), QMessageBox::DestructiveRole);
        own.addButton(QStringLiteral("Continue"), QMessageBox::RejectRole);
        QCOMPARE(defaultOf(own), QStringLiteral("Continue"));
        QMessageBox meant(QMessageBox::Question, QStringLiteral("t"), QStringLiteral("x"), QMessageBox::Yes | QMessageBox::No);
        meant.setDefaultButton(QMessageBox::No);
        QCOMPARE(defaultOf(meant), QStringLiteral("No"));
    }

    void fontsHaveTheirSizesAtOnce() {
        applyTheme(*qApp, ThemeKind::Light);
        QLabel plain, fixed;
        useMonospaceFont(fixed);
        plain.show();
        fixed.show();
        QCOMPARE(plain.font().pixelSize(), 13);
        QCOMPARE(fixed.font().pixelSize(), 13);
        applyTheme(*qApp, ThemeKind::Light, {16, 20});
        QCOMPARE(plain.font().pixelSize(), 16);
        QCOMPARE(fixed.font().pixelSize(), 20);
        QCOMPARE(fixed.font().family(), monospaceFont().family());
        applyTheme(*qApp, ThemeKind::Light);
        QCOMPARE(fixed.font().pixelSize(), 13);
    }

    void theFocusIsSeen_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    void theFocusIsSeen() {
        QFETCH(bool, dark);
        applyTheme(*qApp, dark ? ThemeKind::Dark : ThemeKind::Light);
        QWidget window;
        QVBoxLayout column(&window);
        QPushButton push(QStringLiteral("Save"));
        QToolButton tool;
        QCheckBox check(QStringLiteral("Snap"));
        QLineEdit other;
        for (QWidget* each : std::initializer_list<QWidget*>{&other, &push, &tool, &check}) column.addWidget(each);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window, kTimeoutMs));
        for (QWidget* each : std::initializer_list<QWidget*>{&push, &tool, &check}) {
            other.setFocus();
            const QImage without = each->grab().toImage();
            each->setFocus();
            QVERIFY(each->hasFocus());
            QVERIFY2(each->grab().toImage() != without, each->metaObject()->className());
        }
        applyTheme(*qApp, ThemeKind::Light);
    }

    /// Also of docks that exist already.
    void titlesOfDocksFollowTheFont() {
        applyTheme(*qApp, ThemeKind::Light);
        QMainWindow window;
        const auto titleOf = [&window](QDockWidget& dock) {
            window.resize(400, 300);
            window.show();
            QApplication::processEvents();
            return dock.grab(QRect(0, 0, 120, 30)).toImage();
        };
        auto* dock = new QDockWidget(QStringLiteral("Scene"), &window);
        dock->setWidget(new QLabel);
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
        const QImage before = titleOf(*dock);
        applyTheme(*qApp, ThemeKind::Light, {18, 13});
        const QImage after = titleOf(*dock);
        QVERIFY(after != before);
        delete dock;
        dock = new QDockWidget(QStringLiteral("Scene"), &window); // created with the new font
        dock->setWidget(new QLabel);
        window.addDockWidget(Qt::LeftDockWidgetArea, dock);
        QCOMPARE(after, titleOf(*dock));
        applyTheme(*qApp, ThemeKind::Light);
    }

    void preferencesAreKept() {
        QSettings().clear();
        QVERIFY(loadPreferences() == Preferences());
        QSettings().setValue(QStringLiteral("darkTheme"), true); // the setting of older versions
        QVERIFY(loadPreferences().theme == ThemeChoice::Dark);
        const Preferences chosen{ThemeChoice::Light, {15, 18}, WrapLines::Never, NavigationStyle::Cad};
        savePreferences(chosen);
        QVERIFY(loadPreferences() == chosen);
        QSettings().setValue(QStringLiteral("fonts/text"), 5000);
        QSettings().setValue(QStringLiteral("theme"), QStringLiteral("purple"));
        QCOMPARE(loadPreferences().fonts.text, kLargestTextFont);
        QVERIFY(loadPreferences().theme == ThemeChoice::Dark);
        QSettings().clear();
    }
};

QTEST_MAIN(ThemeTest)
#include "theme_test.moc"
