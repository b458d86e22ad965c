// Actions with shortcuts of their own, lists of names, tables, sizes of dialogs, palettes, default buttons and preferences.

#include <QHeaderView>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QStandardItemModel>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>

#include "editor/widgets/actions.h"
#include "editor/widgets/apply_theme.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/name_list.h"
#include "editor/widgets/plain_text.h"
#include "editor/widgets/preferences.h"
#include "editor/widgets/style_sheet.h"

using namespace trundle;

namespace {

constexpr ActionRow kRows[] = {
    {"edit.cut", "Edit", "Cu&t…", "", "Ctrl+X", "Cuts it.", false},
    {"edit.cutAll", "Edit", "Cut &All", "", "Ctrl+Shift+X", "Cuts all.", true},
    {"edit.none", "Edit", "&None", "", "", "Without keys.", false},
};

QColor colourOf(const QIcon& icon, QIcon::Mode mode) {
    const QImage image = icon.pixmap(QSize(32, 32), mode).toImage();
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.pixelColor(x, y).alpha() == 255) return image.pixelColor(x, y).rgb();
    return {};
}

} // namespace

class WidgetPartsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        QCoreApplication::setOrganizationName(QStringLiteral("trundle-test"));
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
        applyTheme(*qApp, ThemeKind::Light);
    }
    void init() { QSettings().clear(); }

    /// The user's own ones are kept, also none at all; a reset brings that of the table back, of this action alone.
    void shortcutsOfActions() {
        const auto keys = [](const Actions& actions, const char* id) {
            return actions.at(id).shortcut().toString(QKeySequence::PortableText);
        };
        Actions actions(kRows);
        QCOMPARE(keys(actions, "edit.cut"), QStringLiteral("Ctrl+X"));
        QCOMPARE(keys(actions, "edit.none"), QString());
        actions.setShortcut("edit.cut", QKeySequence(QStringLiteral("Ctrl+Alt+K")));
        actions.setShortcut("edit.cutAll", QKeySequence());
        Actions later(kRows);
        QCOMPARE(keys(later, "edit.cut"), QStringLiteral("Ctrl+Alt+K"));
        QCOMPARE(keys(later, "edit.cutAll"), QString());
        later.resetShortcut("edit.cut");
        QCOMPARE(keys(later, "edit.cut"), QStringLiteral("Ctrl+X"));
        QCOMPARE(keys(later, "edit.cutAll"), QString());
        Actions last(kRows);
        QCOMPARE(keys(last, "edit.cut"), QStringLiteral("Ctrl+X"));
        QCOMPARE(keys(last, "edit.cutAll"), QString());
    }

    void actionsSayWhatTheyDo() {
        Actions actions(kRows);
        QVERIFY(!actions.at("edit.cut").isCheckable() && actions.at("edit.cutAll").isCheckable());
        QCOMPARE(actions.at("edit.cut").statusTip(), QStringLiteral("Cuts it."));
        const QString native = QKeySequence(QStringLiteral("Ctrl+X")).toString(QKeySequence::NativeText);
        QCOMPARE(actions.at("edit.cut").toolTip(), QStringLiteral("Cut  ") + native + QStringLiteral("\nCuts it."));
        QCOMPARE(actions.at("edit.none").toolTip(), QStringLiteral("None\nWithout keys."));
        actions.setShortcut("edit.cut", QKeySequence());
        QCOMPARE(actions.at("edit.cut").toolTip(), QStringLiteral("Cut\nCuts it."));
        actions.at("edit.none").setText(QStringLiteral("&Some"));
        QCOMPARE(actions.at("edit.none").toolTip(), QStringLiteral("Some\nWithout keys."));
    }

    void listsOfNames_data() {
        QTest::addColumn<QStringList>("names");
        QTest::addColumn<QString>("text");
        QTest::newRow("none") << QStringList() << QString();
        QTest::newRow("one") << QStringLiteral("a").split(u' ') << QStringLiteral("a");
        QTest::newRow("as many as fit") << QStringLiteral("a b c").split(u' ') << QStringLiteral("a, b, c");
        QTest::newRow("one more") << QStringLiteral("a b c d").split(u' ') << QStringLiteral("a, b, c and 1 more");
        QTest::newRow("several more") << QStringLiteral("a b c d e").split(u' ') << QStringLiteral("a, b, c and 2 more");
    }
    void listsOfNames() {
        QFETCH(QStringList, names);
        QTEST(listed(names, 3), "text");
    }

    void ampersandsAreShown() {
        QCOMPARE(withoutMnemonics(QStringLiteral("R&D & more")), QStringLiteral("R&&D && more"));
        QCOMPARE(withoutMnemonics(QStringLiteral("plain")), QStringLiteral("plain"));
    }

    /// The rows of a table have the height of its font, also of a later one.
    void rowsHaveTheHeightOfTheirFont() {
        QStandardItemModel model(2, 1);
        const std::unique_ptr<QTableView> plain(makeLineTable("plain", &model, LineFont::Interface)),
            fixed(makeLineTable("fixed", &model, LineFont::Monospace));
        QVERIFY(plain->font().family() != monospaceFont().family());
        QCOMPARE(fixed->font().family(), monospaceFont().family());
        QFont large = plain->font();
        large.setPixelSize(31);
        const int before = plain->rowHeight(0);
        plain->setFont(large);
        QCOMPARE(plain->verticalHeader()->defaultSectionSize(), QFontMetrics(plain->font()).height() + 4);
        QVERIFY(plain->verticalHeader()->defaultSectionSize() > before);
    }

    /// In proportion to the font, and not larger than the screen.
    void dialogsHaveTheSizeOfTheFont() {
        QWidget dialog;
        resizeToFont(dialog, {260, 130});
        QCOMPARE(dialog.size(), QSize(260, 130));
        applyTheme(*qApp, ThemeKind::Light, {20, 13});
        resizeToFont(dialog, {260, 130});
        QCOMPARE(dialog.size(), QSize(400, 200));
        resizeToFont(dialog, {9000, 130});
        QVERIFY(dialog.width() < dialog.screen()->availableSize().width() && dialog.height() == 200);
        resizeToFont(dialog, {260, 9000});
        QVERIFY(dialog.height() < dialog.screen()->availableSize().height() && dialog.width() == 400);
        applyTheme(*qApp, ThemeKind::Light);
    }

    void coloursOfStates_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("light") << int(ThemeKind::Light);
        QTest::newRow("dark") << int(ThemeKind::Dark);
    }
    /// What is disabled or selected is drawn otherwise, and every ink is a colour of its own.
    void coloursOfStates() {
        QFETCH(int, kind);
        applyTheme(*qApp, ThemeKind(kind));
        const QPalette palette = themePalette();
        const QIcon icon = themedIcon(QStringLiteral("run"));
        QCOMPARE(colourOf(icon, QIcon::Normal), palette.color(QPalette::Text));
        QCOMPARE(colourOf(icon, QIcon::Selected), palette.color(QPalette::HighlightedText));
        QCOMPARE(colourOf(icon, QIcon::Disabled), palette.color(QPalette::Disabled, QPalette::Text));
        QVERIFY(palette.color(QPalette::Disabled, QPalette::Text) != palette.color(QPalette::Text));
        QCOMPARE(palette.color(QPalette::Disabled, QPalette::Highlight), ink(Ink::Line));
        QCOMPARE(colourOf(inkedIcon(QStringLiteral("run"), Ink::Warning), QIcon::Disabled), ink(Ink::Warning));
        const Ink severities[] = {Ink::Error, Ink::Warning, Ink::Hint, Ink::Good, Ink::Faint, Ink::Text};
        for (const Ink a : severities)
            for (const Ink b : severities) QCOMPARE(ink(a) == ink(b), a == b);
        applyTheme(*qApp, ThemeKind::Light);
    }

    /// Between the accent and the window, a checked button is nearer to the window; text on the accent is light on a light theme.
    void coloursOfTheStyleSheet() {
        const auto mixed = [](const QColor& window) {
            const QString sheet = styleSheet({{QStringLiteral("accent"), QColor(200, 100, 0)},
                                              {QStringLiteral("window"), window},
                                              {QStringLiteral("base"), QColor(255, 255, 255)}});
            const QString checked = sheet.section(QStringLiteral("QToolButton:checked { background: "), 1).left(7),
                          chunk = sheet.section(QStringLiteral("QProgressBar::chunk { background: "), 1).left(7),
                          on = sheet.section(QStringLiteral("QMenu::item:selected { background: #c86400; color: "), 1).left(7);
            return QStringList{checked, chunk, on};
        };
        const auto near = [](const QString& name, const QColor& colour) {
            const QColor c(name);
            return std::abs(c.red() - colour.red()) < 2 && std::abs(c.green() - colour.green()) < 2 &&
                   std::abs(c.blue() - colour.blue()) < 2;
        };
        const QStringList light = mixed(QColor(240, 240, 240)), dark = mixed(QColor(20, 40, 60));
        QVERIFY2(near(light[0], QColor(231, 209, 187)), qPrintable(light[0])); // 0.22 of the accent
        QVERIFY2(near(light[1], QColor(233, 193, 153)), qPrintable(light[1])); // 0.4 of it
        QVERIFY2(near(dark[0], QColor(60, 53, 47)), qPrintable(dark[0]));
        QCOMPARE(light[2], QStringLiteral("#ffffff"));
        QVERIFY(dark[2] != light[2] && QColor(dark[2]).lightness() < 50);
    }

    void defaultButtons_data() {
        using Role = QMessageBox::ButtonRole;
        QTest::addColumn<QList<int>>("roles"); // in the order in which they are added
        QTest::addColumn<int>("chosen");       // by the caller; -1: none
        QTest::addColumn<int>("best");
        const auto row = [](const char* name, QList<int> roles, int chosen, int best) {
            QTest::newRow(name) << roles << chosen << best;
        };
        row("accepting one", {Role::RejectRole, Role::AcceptRole}, -1, 1);
        row("yes", {Role::NoRole, Role::YesRole}, -1, 1);
        row("the first of others", {Role::RejectRole, Role::ActionRole}, -1, 0);
        row("no reset", {Role::ResetRole, Role::RejectRole}, -1, 1);
        row("reset was chosen", {Role::AcceptRole, Role::ResetRole}, 1, 0);
        row("as chosen", {Role::AcceptRole, Role::RejectRole}, 1, 1);
    }
    /// Never one that destroys or resets something.
    void defaultButtons() {
        QFETCH(QList<int>, roles);
        QFETCH(int, chosen);
        QFETCH(int, best);
        QMessageBox box;
        QList<QPushButton*> buttons;
        for (const int role : roles) buttons << box.addButton(QString::number(buttons.size()), QMessageBox::ButtonRole(role));
        if (chosen >= 0) box.setDefaultButton(buttons[chosen]);
        box.show();
        for (int i = 0; i < buttons.size(); ++i) QCOMPARE(buttons[i]->isDefault(), i == best);
    }

    void preferencesOneByOne_data() {
        QTest::addColumn<QByteArray>("key");
        QTest::addColumn<QVariant>("value");
        QTest::addColumn<int>("theme");
        QTest::addColumn<QList<int>>("fonts");
        const auto row = [](const char* key, const QVariant& value, ThemeChoice theme, QList<int> fonts) {
            QTest::addRow("%s %s", key, qPrintable(value.toString())) << QByteArray(key) << value << int(theme) << fonts;
        };
        row("theme", QStringLiteral("light"), ThemeChoice::Light, {13, 13});
        row("theme", QStringLiteral("system"), ThemeChoice::System, {13, 13});
        row("darkTheme", false, ThemeChoice::Light, {13, 13});
        row("darkTheme", true, ThemeChoice::Dark, {13, 13});
        row("fonts/interface", 15, ThemeChoice::System, {15, 13});
        row("fonts/interface", 99, ThemeChoice::System, {kLargestInterfaceFont, 13});
        row("fonts/interface", 1, ThemeChoice::System, {kSmallestFont, 13});
        row("fonts/text", 30, ThemeChoice::System, {13, 30});
        row("fonts/text", QStringLiteral("large"), ThemeChoice::System, {13, 13});
    }
    void preferencesOneByOne() {
        QFETCH(QByteArray, key);
        QFETCH(QVariant, value);
        QFETCH(int, theme);
        QFETCH(QList<int>, fonts);
        QSettings().setValue(QLatin1String(key), value);
        const Preferences p = loadPreferences();
        QCOMPARE(int(p.theme), theme);
        QCOMPARE((QList<int>{p.fonts.interface, p.fonts.text}), fonts);
    }

    /// A saved choice counts before the key of earlier versions, also if it is the first one of its list.
    void savedPreferencesCountFirst() {
        QSettings().setValue(QStringLiteral("darkTheme"), true);
        const Preferences first{ThemeChoice::System, {11, 17}, WrapLines::InNarrowPanes, NavigationStyle::Trundle};
        savePreferences(first);
        QVERIFY(loadPreferences() == first);
        QCOMPARE(themeOf(ThemeChoice::Light), ThemeKind::Light);
        QCOMPARE(themeOf(ThemeChoice::Dark), ThemeKind::Dark);
        QCOMPARE(themeOf(ThemeChoice::System), systemTheme());
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(WidgetPartsTest)
#include "parts_test.moc"
