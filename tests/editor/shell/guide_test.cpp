// The Guide dock: every link leads to a page, every image exists, tables are complete.

#include <QDir>
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextTable>
#include <QtTest>

#include "editor/shell/help_panel.h"
#include "editor/widgets/apply_theme.h"
#include "editor/widgets/resources.h"
#include "eventually.h"

using namespace trundle;

class GuideTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        applyTheme(*qApp, ThemeKind::Light);
        QVERIFY(!pages().isEmpty());
    }

    void linksLeadSomewhere() {
        static const QRegularExpression link(QStringLiteral(R"((!?)\[[^\]]*\]\(([^)#]+)[^)]*\))"));
        for (const QString& page : pages()) {
            QFile file(m_folder.filePath(page));
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QString text = QString::fromUtf8(file.readAll());
            for (auto at = link.globalMatch(text); at.hasNext();) {
                const QRegularExpressionMatch found = at.next();
                const QString target = found.captured(2);
                if (target.startsWith(QStringLiteral("http"))) continue;
                QVERIFY2(m_folder.exists(target), qPrintable(page + QStringLiteral(": ") + target));
                if (!found.captured(1).isEmpty()) QVERIFY2(!QImage(m_folder.filePath(target)).isNull(), qPrintable(target));
            }
        }
    }

    void whereNothingIsToScrollTheBarIsEmpty() {
        HelpPanel panel;
        panel.resize(400, 3000);
        panel.show();
        EVENTUALLY(!panel.verticalScrollBar()->isEnabled());
        panel.resize(400, 200);
        EVENTUALLY(panel.verticalScrollBar()->isEnabled());
    }

    void aKindIsExplainedWhereTheGuideNamesIt() {
        HelpPanel panel;
        panel.resize(400, 300);
        panel.show();
        const auto shown = [&](const char* name, Role role) {
            Kind kind;
            kind.name = name;
            kind.role = role;
            panel.showKind(&kind);
            const QTextCursor top = panel.cursorForPosition(QPoint(20, 4));
            return panel.source().fileName() + QStringLiteral(": ") + top.block().text();
        };
        QCOMPARE(shown("Hinge", Role::Joint), QStringLiteral("language.md: Joints"));
        QCOMPARE(shown("Box", Role::Geom), QStringLiteral("language.md: Geoms")); // the same page, another section
        QCOMPARE(shown("SignalLog", Role::Log), QStringLiteral("logs.md: Logs"));
        QCOMPARE(shown("RadioMedium", Role::Medium), QStringLiteral("radios.md: RadioMedium"));
        QCOMPARE(shown("SomebodysBrain", Role::Controller), QStringLiteral("language.md: Controllers"));
        QCOMPARE(shown("Nothing", Role::Log), QStringLiteral("index.md: The Trundle guide"));
        panel.backward();
        QCOMPARE(panel.source().fragment(), QStringLiteral("controllers"));
    }

    /// However the dock is resized before it is seen.
    void aPageBeginsAtItsTitle() {
        HelpPanel panel;
        panel.resize(200, 100);
        panel.show();
        QCoreApplication::processEvents();
        panel.resize(340, 600);
        QCoreApplication::processEvents();
        QCOMPARE(panel.verticalScrollBar()->value(), 0);
        QVERIFY(panel.verticalScrollBar()->maximum() > 0);
    }

    /// In the page that is shown, then in those after it.
    void searchesAllPages() {
        HelpPanel panel;
        panel.show();
        QCOMPARE(panel.source().fileName(), QStringLiteral("index.md"));
        QStringList found;
        for (int i = 0; i < 6 && panel.findNext(QStringLiteral("skidfactor")); ++i) {
            QCOMPARE(panel.textCursor().selectedText().toLower(), QStringLiteral("skidfactor"));
            if (!found.contains(panel.source().fileName())) found += panel.source().fileName();
        }
        QStringList with;
        for (const QString& page : pages()) {
            QFile file(m_folder.filePath(page));
            if (file.open(QIODevice::ReadOnly) && file.readAll().toLower().contains("skidfactor")) with += page;
        }
        found.sort(), with.sort();
        QVERIFY(with.size() > 1);
        QCOMPARE(found, with);
        const QUrl last = panel.source();
        QVERIFY(!panel.findNext(QStringLiteral("no page has these words")));
        QCOMPARE(panel.source(), last);
    }

    void tablesHaveNoEmptyHeads() {
        HelpPanel panel;
        int tables = 0;
        for (const QString& page : pages()) {
            panel.setSource(QUrl::fromLocalFile(m_folder.filePath(page)), QTextDocument::MarkdownResource);
            QVERIFY2(!panel.toPlainText().startsWith(QStringLiteral("Not found")), qPrintable(page));
            for (QTextFrame* frame : panel.document()->rootFrame()->childFrames()) {
                auto* table = qobject_cast<QTextTable*>(frame);
                if (!table) continue;
                ++tables;
                QString head;
                for (int column = 0; column < table->columns(); ++column)
                    head += table->cellAt(0, column).firstCursorPosition().block().text();
                QVERIFY2(!head.isEmpty(), qPrintable(page));
                QVERIFY(table->format().borderCollapse());
            }
        }
        QVERIFY(tables > 3);
    }

    void picturesAreNoWiderThanTheDock() {
        HelpPanel panel;
        panel.resize(340, 600);
        panel.show();
        int pictures = 0;
        for (const QString& page : pages()) {
            panel.setSource(QUrl::fromLocalFile(m_folder.filePath(page)), QTextDocument::MarkdownResource);
            for (QTextBlock block = panel.document()->begin(); block.isValid(); block = block.next())
                for (auto part = block.begin(); !part.atEnd(); ++part) {
                    if (!part.fragment().charFormat().isImageFormat()) continue;
                    ++pictures;
                    const double width = part.fragment().charFormat().toImageFormat().width();
                    QVERIFY2(width > 0 && width < panel.viewport()->width(), qPrintable(page));
                }
        }
        QVERIFY(pictures > 3);
    }

private:
    [[nodiscard]] QStringList pages() const { return m_folder.entryList({QStringLiteral("*.md")}, QDir::Files); }
    QDir m_folder{resourcePath(QStringLiteral("guide"))};
};

QTEST_MAIN(GuideTest)
#include "guide_test.moc"
