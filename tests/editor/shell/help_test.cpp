// F1 opens the right section, and the guide's menu paths exist in the window.

#include <QDir>
#include <QFile>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QTreeView>
#include <QtTest>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/shell/window_fixture.h"
#include "editor/text/code/code_edit.h"
#include "editor/text/pages/file_page.h"
#include "editor/text/text_panel.h"
#include "editor/widgets/actions.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QByteArray kExperiment = "#import robots/simple_robot.sim\n"
                               "#import arenas/medium_arena.sim\n"
                               "#loadModule controllers/linear_motion\n"
                               "Static arena { Config=MediumArena }\n"
                               "Robot robot0 { Config=SimpleRobot  LinearMotion brain { Distance=1.0 Speed=0.2 } }\n"
                               "PoseLog path { Robot=robot0 }\n";

} // namespace

class HelpTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_fixture.start(); }
    void init() {
        QSettings().clear();
        const QString path = m_folder.filePath(QStringLiteral("trial.sim"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(kExperiment) > 0);
        file.close();
        m_window = m_fixture.window();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kTimeoutMs));
        QVERIFY(m_window->open(path));
        EVENTUALLY(!m_window->document().opening().isOpening());
    }
    void cleanup() { m_window.reset(); }

    void f1OpensThePageOfWhatIsSelected() {
        auto* guide = m_window->findChild<QTextBrowser*>(QStringLiteral("guide"));
        const auto helpOn = [&](const std::string& object) {
            m_window->selection().select(object);
            m_window->actions().at("help.guide").trigger();
            return guide->source().fileName() + QLatin1Char('#') + guide->source().fragment();
        };
        m_window->findChild<QTreeView*>(QStringLiteral("outlineTree"))->setFocus();
        QCOMPARE(helpOn("robot0"), QStringLiteral("language.md#configs-and-instances"));
        QVERIFY(guide->isVisible());
        QCOMPARE(helpOn("robot0.leftAxle"), QStringLiteral("language.md#joints"));
        QCOMPARE(helpOn("robot0.brain"), QStringLiteral("language.md#controllers"));
        QCOMPARE(helpOn(""), QStringLiteral("language.md#a-text"));
        QCOMPARE(helpOn("arena"), QStringLiteral("language.md#configs-and-instances"));
        QCOMPARE(helpOn("RobotConfig.SimpleRobot"), QStringLiteral("language.md#configs-and-instances"));
        QCOMPARE(helpOn("robot0.chassis"), QStringLiteral("language.md#bodies-and-mass"));
        QCOMPARE(helpOn("robot0.leftWheel.tyre"), QStringLiteral("language.md#geoms"));
        QCOMPARE(helpOn("robot0.leftMotor"), QStringLiteral("language.md#devices"));
        QCOMPARE(helpOn("robot0.base"), QStringLiteral("language.md#devices"));
        QCOMPARE(helpOn("path"), QStringLiteral("logs.md#logs"));
        QCOMPARE(helpOn("Material.black"), QStringLiteral("language.md#materials-surfaces-lights"));
        m_window->selection().clear();
        m_window->actions().at("help.guide").trigger();
        QCOMPARE(guide->source().fileName(), QStringLiteral("index.md"));

        auto* text = m_window->findChild<TextPanel*>(); // the word at the caret, regardless of the selection
        text->page()->edit().setFocus();
        EVENTUALLY(text->hasKeyboard());
        const std::string_view all = m_window->document().loaded()->trees[text->page()->id()]->source().bytes();
        const auto helpAt = [&](std::string_view word) {
            const auto at = static_cast<std::uint32_t>(all.find(word) + 2);
            text->page()->edit().setFocus();
            text->page()->edit().select({at, at});
            m_window->actions().at("help.guide").trigger();
            return guide->source().fileName() + QLatin1Char('#') + guide->source().fragment();
        };
        QCOMPARE(helpAt("PoseLog"), QStringLiteral("logs.md#logs"));
        QCOMPARE(helpAt("#import"), QStringLiteral("language.md#imports-and-modules"));
        QCOMPARE(helpAt("#loadModule"), QStringLiteral("language.md#imports-and-modules"));
        QCOMPARE(helpAt("LinearMotion"), QStringLiteral("language.md#controllers"));
    }

    /// For example "*Insert ▸ Sensors and Actuators ▸ Camera*" is an entry of the menu while a body is selected.
    void menuPathsOfTheGuideExist() {
        m_window->selection().select("RobotConfig.SimpleRobot.chassis");
        QStringList paths;
        const auto walk = [&](const auto& self, QMenu& menu, const QString& above) -> void {
            Q_EMIT menu.aboutToShow();
            for (QAction* action : menu.actions()) {
                const QString here = above + action->text().remove(QLatin1Char('&'));
                paths << here;
                if (action->menu()) self(self, *action->menu(), here + QStringLiteral(" ▸ "));
            }
        };
        for (QAction* menu : m_window->menuBar()->actions())
            walk(walk, *menu->menu(), menu->text().remove(QLatin1Char('&')) + QStringLiteral(" ▸ "));
        static const QRegularExpression reportOf(QStringLiteral("\\*([A-Z][^*\n]* ▸ [^*]*)\\*"));
        int count = 0;
        const QDir guide(QStringLiteral(TRUNDLE_SOURCE_DIR "/resources/guide"));
        for (const QString& page : guide.entryList({QStringLiteral("*.md")})) {
            QFile file(guide.filePath(page));
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QString text = QString::fromUtf8(file.readAll());
            for (auto at = reportOf.globalMatch(text); at.hasNext(); ++count) {
                const QString way = at.next().captured(1).simplified();
                const bool there = std::ranges::any_of(
                    paths, [&](const QString& p) { return p == way || p.endsWith(QStringLiteral(" ▸ ") + way); });
                QVERIFY2(there, qPrintable(page + QStringLiteral(": ") + way));
            }
        }
        QVERIFY(count >= 8);
    }

private:
    QTemporaryDir m_folder;
    WindowFixture m_fixture;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(HelpTest)
#include "help_test.moc"
