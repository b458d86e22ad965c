// The action table: menus, the command palette and shortcuts are built from it.

#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QKeySequenceEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QtTest>

#include "editor/shell/action_table.h"
#include "editor/shell/commands/command_palette.h"
#include "editor/shell/dialogs/preferences_dialog.h"
#include "editor/shell/menus.h"
#include "editor/widgets/apply_theme.h"
#include "editor/widgets/resources.h"

using namespace trundle;

class ActionsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, ThemeKind::Light); }
    void init() { QSettings().clear(); }

    void everyRowIsWhole() {
        QSet<QString> ids, keys;
        for (const ActionRow& row : actionTable()) {
            const QString id = QLatin1String(row.id);
            QVERIFY2(!ids.contains(id), row.id);
            ids.insert(id);
            QVERIFY2(QString::fromUtf8(row.help).endsWith(u'.'), row.id);
            const QString shortcut = QLatin1String(row.shortcut);
            QVERIFY2(shortcut.isEmpty() || !keys.contains(shortcut), row.id);
            QVERIFY2(shortcut.isEmpty() || !QKeySequence(shortcut).isEmpty(), row.id);
            keys.insert(shortcut);
            const QString icon = QLatin1String(row.icon);
            QVERIFY2(icon.isEmpty() || QFile::exists(resourcePath(QStringLiteral("icons/%1.svg").arg(icon))), row.id);
        }
    }

    void menusHoldEveryAction() {
        Actions actions(actionTable());
        QMenuBar bar;
        const auto menus = buildMenus(bar, actions);
        int count = 0;
        for (const auto& [path, menu] : menus)
            for (QAction* action : menu->actions()) count += !action->menu() && !action->isSeparator();
        QCOMPARE(count, int(actionTable().size()));
        for (const auto& [path, menu] : menus) {
            const auto entries = menu->actions();
            if (entries.isEmpty()) continue;
            QVERIFY2(!entries.first()->isSeparator() && !entries.last()->isSeparator(), qPrintable(path));
            QSet<QChar> letters; // mnemonics are unique in a menu
            for (const QAction* action : entries) {
                const qsizetype mark = action->text().indexOf(u'&');
                if (mark < 0) continue;
                const QChar letter = action->text().at(mark + 1).toLower();
                QVERIFY2(!letters.contains(letter), qPrintable(path + u' ' + action->text()));
                letters.insert(letter);
            }
        }
    }

    void appliesAndStoresPreferences() {
        Actions actions(actionTable());
        PreferencesDialog dialog(actions, nullptr);
        QSignalSpy changed(&dialog, &PreferencesDialog::changed);
        const auto choose = [&dialog](const char* name, int index) {
            dialog.findChild<QComboBox*>(QLatin1String(name))->setCurrentIndex(index);
        };
        choose("themeChoice", 2);
        QVERIFY(loadPreferences().theme == ThemeChoice::Dark);
        choose("wrapChoice", 1);
        QVERIFY(loadPreferences().wrapLines == WrapLines::Always);
        auto* buttons = dialog.findChild<QLabel*>(QStringLiteral("navigationButtons"));
        const QString before = buttons->text();
        choose("navigationChoice", 1);
        QVERIFY(loadPreferences().navigation == NavigationStyle::Blender);
        QVERIFY(buttons->text() != before);
        dialog.findChild<QSpinBox*>(QStringLiteral("interfaceFont"))->setValue(15);
        dialog.findChild<QSpinBox*>(QStringLiteral("textFont"))->setValue(17);
        QVERIFY(loadPreferences().fonts == (FontSizes{15, 17}));
        QCOMPARE(changed.count(), 5);
        choose("themeChoice", 2); // it is selected already
        QCOMPARE(changed.count(), 5);
        PreferencesDialog again(actions, nullptr);
        QCOMPARE(again.findChild<QSpinBox*>(QStringLiteral("textFont"))->value(), 17);
    }

    void aFewLettersFindACommand() {
        QVERIFY(CommandPalette::match(QStringLiteral("Frame Selection"), QStringLiteral("fra sel")) > 0);
        QVERIFY(CommandPalette::match(QStringLiteral("Frame Selection"), QStringLiteral("zzz")) == 0);
        QVERIFY(CommandPalette::match(QStringLiteral("Frame All"), QStringLiteral("fr")) >
                CommandPalette::match(QStringLiteral("World Frame"), QStringLiteral("fr")));
    }

    void thePaletteDoesWhatIsTyped() {
        Actions actions(actionTable());
        int runs = 0;
        connect(&actions.at("sim.run"), &QAction::triggered, this, [&runs] { ++runs; });
        CommandPalette palette(actions, {}, nullptr);
        palette.show();
        auto* search = palette.findChild<QLineEdit*>(QStringLiteral("paletteSearch"));
        QTest::keyClicks(search, QStringLiteral("run"));
        QTest::keyClick(search, Qt::Key_Return);
        QCOMPARE(runs, 1);
        QVERIFY(!palette.isVisible());
    }

    void preferencesNameCommandsAsTheTableDoes() {
        Actions actions(actionTable());
        actions.at("edit.undo").setText(QStringLiteral("&Undo Move robot0"));
        PreferencesDialog dialog(actions, nullptr);
        const auto* list = dialog.findChild<QTreeWidget*>(QStringLiteral("shortcuts"));
        QCOMPARE(list->findItems(QStringLiteral("Undo"), Qt::MatchExactly).size(), 1);
        dialog.show();
        auto* filter = dialog.findChild<QLineEdit*>(QStringLiteral("shortcutFilter"));
        QTest::keyClicks(filter, QStringLiteral("undo"));
        QTest::keyClick(filter, Qt::Key_Return); // neither closes the dialog nor changes shortcuts
        QVERIFY(dialog.isVisible());
        const auto shown = [list] {
            int count = 0;
            for (int i = 0; i < list->topLevelItemCount(); ++i) count += !list->topLevelItem(i)->isHidden();
            return count;
        };
        QCOMPARE(shown(), 1);
        filter->setText(QStringLiteral("ctrl+d"));
        QCOMPARE(shown(), 1);
        QCOMPARE(actions.at("edit.undo").shortcut(), QKeySequence(QStringLiteral("Ctrl+Z")));
    }

    void keysAreSetForTheRowThatIsSeen() {
        Actions actions(actionTable());
        PreferencesDialog dialog(actions, nullptr);
        auto* filter = dialog.findChild<QLineEdit*>(QStringLiteral("shortcutFilter"));
        auto* keys = dialog.findChild<QKeySequenceEdit*>(QStringLiteral("keys"));
        filter->setText(QStringLiteral("frame sel"));
        QCOMPARE(keys->keySequence(), actions.at("view.frame").shortcut());
        const QKeySequence first = actions.at(actionTable()[0].id).shortcut(), own(QStringLiteral("Ctrl+Alt+J"));
        keys->setKeySequence(own);
        button(dialog, QStringLiteral("Set")).click();
        QCOMPARE(actions.at("view.frame").shortcut(), own);
        QCOMPARE(actions.at(actionTable()[0].id).shortcut(), first);
        filter->setText(QStringLiteral("no such command"));
        QVERIFY(!button(dialog, QStringLiteral("Set")).isEnabled() && !button(dialog, QStringLiteral("Default")).isEnabled());
        filter->clear();
        QVERIFY(button(dialog, QStringLiteral("Set")).isEnabled());
    }

    void keysAreKeptUntilTheyAreReset() {
        const QKeySequence own(QStringLiteral("Ctrl+Alt+J"));
        Actions first(actionTable());
        const QKeySequence usual = first.at("view.frame").shortcut();
        first.setShortcut("view.frame", own);
        Actions second(actionTable());
        QCOMPARE(second.at("view.frame").shortcut(), own);
        second.resetShortcut("view.frame");
        QCOMPARE(second.at("view.frame").shortcut(), usual);
        QCOMPARE(Actions(actionTable()).at("view.frame").shortcut(), usual);
    }

    void defaultKeysMoveFromOtherAction() {
        Actions actions(actionTable());
        const QKeySequence keys = actions.at("file.save").shortcut();
        actions.setShortcut("file.save", {});
        actions.setShortcut("view.frame", keys);
        PreferencesDialog dialog(actions, nullptr);
        dialog.show();
        dialog.findChild<QLineEdit*>(QStringLiteral("shortcutFilter"))->setText(QStringLiteral("save"));
        auto* list = dialog.findChild<QTreeWidget*>(QStringLiteral("shortcuts"));
        list->setCurrentItem(list->findItems(QStringLiteral("Save"), Qt::MatchExactly).value(0));
        int asked = 0;
        const auto answer = [&](QMessageBox::StandardButton with) {
            QTimer::singleShot(0, &dialog, [&asked, with] {
                auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
                asked += box != nullptr;
                if (box) box->button(with)->click();
            });
            button(dialog, QStringLiteral("Default")).click();
        };
        answer(QMessageBox::No);
        QVERIFY(actions.at("file.save").shortcut().isEmpty());
        QCOMPARE(actions.at("view.frame").shortcut(), keys);
        answer(QMessageBox::Yes);
        QCOMPARE(asked, 2);
        QCOMPARE(actions.at("file.save").shortcut(), keys);
        QVERIFY(actions.at("view.frame").shortcut().isEmpty());
    }

    void storesAndRestoresShortcut() {
        {
            Actions actions(actionTable());
            actions.setShortcut("sim.run", QKeySequence(QStringLiteral("Ctrl+R")));
        }
        Actions actions(actionTable());
        QCOMPARE(actions.at("sim.run").shortcut(), QKeySequence(QStringLiteral("Ctrl+R")));
        QCOMPARE(PreferencesDialog::ownerOf(actions, QKeySequence(QStringLiteral("Ctrl+R")), "sim.pause"),
                 QStringLiteral("sim.run"));
        actions.resetShortcut("sim.run");
        QCOMPARE(actions.at("sim.run").shortcut(), QKeySequence(QStringLiteral("F5")));
    }

private:
    static QPushButton& button(const QWidget& dialog, const QString& text) {
        const auto buttons = dialog.findChildren<QPushButton*>();
        const auto it = std::ranges::find_if(buttons, [&](const QPushButton* b) { return b->text() == text; });
        if (it == buttons.end()) qFatal("no button %s", qPrintable(text));
        return **it;
    }
};

QTEST_MAIN(ActionsTest)
#include "actions_test.moc"
