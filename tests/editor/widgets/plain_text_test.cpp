// HTML in a name or a message is shown as plain text everywhere in the window.

#include <QtTest>
#include <QtWidgets>

#include "editor/widgets/apply_theme.h"
#include "editor/widgets/name_list.h"
#include "editor/widgets/plain_text.h"

using namespace trundle;

namespace {

const QString kName = QStringLiteral("<b>mine</b><img src='/dev/zero'>.sim");

QLabel* tip() {
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (widget->inherits("QTipLabel") && widget->isVisible()) return static_cast<QLabel*>(widget);
    return nullptr;
}

} // namespace

class PlainTextTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        QVERIFY(Qt::mightBeRichText(kName)); // Qt would treat it as HTML
        applyTheme(*qApp, ThemeKind::Light);
        applyTheme(*qApp, ThemeKind::Dark);
    }
    void cleanup() { QToolTip::hideText(); }

    void labelsAreOfPlainText() {
        QWidget window;
        QVBoxLayout column(&window);
        auto *guessed = new QLabel(kName), *html = new QLabel(QStringLiteral("<b>bold</b>")), *later = new QLabel;
        html->setTextFormat(Qt::RichText);
        for (QLabel* label : {guessed, html, later}) column.addWidget(label);
        window.show();
        QCOMPARE(guessed->textFormat(), Qt::PlainText);
        QCOMPARE(html->textFormat(), Qt::RichText);
        later->setText(kName);
        QCOMPARE(later->textFormat(), Qt::PlainText);
        QVERIFY(guessed->sizeHint().width() >= guessed->fontMetrics().horizontalAdvance(kName)); // every character is visible
        auto* added = new QLabel(kName, &window);
        added->show();
        QCOMPARE(added->textFormat(), Qt::PlainText);
    }

    /// A long line is wrapped, whether the tool tip is new or replaces another, and the next one is as narrow as its text.
    void longToolTipsAreWrapped() {
        QWidget window;
        window.show();
        const QString line = QStringLiteral("robot0 has ended by a fault and stays where it is. ").repeated(8);
        for (const QString& text : {line, QStringLiteral("short\n") + line, QStringLiteral("short")}) {
            showToolTip(window.mapToGlobal(QPoint(5, 5)), text, &window);
            const QLabel* shown = tip();
            QVERIFY(shown);
            QCOMPARE(shown->text(), text);
            const QFontMetrics metrics = shown->fontMetrics();
            QVERIFY2(shown->width() <= 80 * metrics.averageCharWidth(), qPrintable(QString::number(shown->width())));
            QVERIFY(shown->height() >= shown->heightForWidth(shown->width()));
            QCOMPARE(shown->height() > 3 * metrics.lineSpacing(), text.size() > 100);
            QVERIFY(shown->screen()->geometry().contains(shown->geometry()));
        }
        QVERIFY(tip()->width() < 20 * tip()->fontMetrics().averageCharWidth());
    }

    void messagesAreOfPlainText() {
        QMessageBox box(QMessageBox::Warning, kName, kName);
        box.setInformativeText(kName);
        box.show();
        QProgressDialog progress(kName, kName, 0, 10);
        progress.show();
        int labels = 0;
        for (const QWidget* dialog : std::initializer_list<QWidget*>{&box, &progress})
            for (const QLabel* label : dialog->findChildren<QLabel*>()) {
                if (label->text().isEmpty()) continue;
                QCOMPARE(label->text(), kName);
                QCOMPARE(label->textFormat(), Qt::PlainText);
                ++labels;
            }
        QCOMPARE(labels, 3);
    }

    void htmlMessagesAreExplicit() {
        QMessageBox box(QMessageBox::Question, {}, kName);
        setHtmlInformation(box, QStringLiteral("<pre>+ %1</pre>").arg(kName.toHtmlEscaped()));
        box.show();
        QCOMPARE(box.textFormat(), Qt::PlainText);
        QCOMPARE(box.findChild<QLabel*>(QStringLiteral("qt_msgbox_informativelabel"))->textFormat(), Qt::RichText);
    }

    // Of a widget, a list item and a menu action: Qt shows each by different code.
    void toolTipsAreOfPlainText() {
        QWidget window;
        QVBoxLayout column(&window);
        auto* button = new QPushButton(QStringLiteral("button"));
        button->setToolTip(kName);
        auto* list = new QListWidget;
        (new QListWidgetItem(kName, list))->setToolTip(kName);
        for (QWidget* widget : std::initializer_list<QWidget*>{button, list}) column.addWidget(widget);
        window.show();
        QMenu menu;
        menu.setToolTipsVisible(true);
        QAction* const action = menu.addAction(kName);
        action->setToolTip(kName);
        menu.popup({0, 0});
        const auto ask = [](QWidget& widget, const QPoint& at) {
            QHelpEvent event(QEvent::ToolTip, at, widget.mapToGlobal(at));
            QApplication::sendEvent(&widget, &event);
        };
        const std::tuple<QWidget*, QPoint> places[] = {{button, button->rect().center()},
                                                       {list->viewport(), list->visualItemRect(list->item(0)).center()},
                                                       {&menu, menu.actionGeometry(action).center()}};
        for (const auto& [widget, at] : places) {
            for (const bool afterHtml : {false, true}) {
                if (afterHtml) {
                    showHtmlToolTip(QPoint(5, 5), QStringLiteral("<b>bold</b>"), &window);
                    QVERIFY(tip());
                    QCOMPARE(tip()->textFormat(), Qt::RichText);
                }
                ask(*widget, at);
                QVERIFY(tip());
                QCOMPARE(tip()->text(), kName);
                QCOMPARE(tip()->textFormat(), Qt::PlainText);
            }
        }
        showHtmlToolTip(QPoint(5, 5), QStringLiteral("<b>bold</b>"), &window);
        showToolTip(QPoint(5, 5), kName, &window);
        QCOMPARE(tip()->textFormat(), Qt::PlainText);
        showHtmlToolTip(QPoint(5, 5), QStringLiteral("<i>once more</i>"), &window);
        QCOMPARE(tip()->textFormat(), Qt::RichText);
    }

    void namesAreListed() {
        const QStringList names{QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c"), QStringLiteral("d")};
        QCOMPARE(listed(names.mid(0, 1), 3), QStringLiteral("a"));
        QCOMPARE(listed(names.mid(0, 3), 3), QStringLiteral("a, b, c"));
        QCOMPARE(listed(names, 3), QStringLiteral("a, b, c and 1 more"));
        QCOMPARE(listed(names, 1), QStringLiteral("a and 3 more"));
    }

    void aPathIsOneLine() {
        QCOMPARE(shownLine("/a\nb\x1b[2J\xff/\xe2\x80\xae"
                           "c"),
                 QStringLiteral("/a b\uFFFD[2J\uFFFD/\uFFFDc"));
    }
};

QTEST_MAIN(PlainTextTest)
#include "plain_text_test.moc"
