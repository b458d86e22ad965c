#include "editor/text/search/find_bar.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

#include "editor/widgets/theme.h"

namespace trundle {

FindBar::FindBar(QWidget* parent)
    : QWidget(parent), m_find(new QLineEdit(this)), m_replace(new QLineEdit), m_everywhere(new QCheckBox(tr("All files"), this)),
      m_said(new QLabel(this)), m_second(new QWidget(this)) {
    setObjectName(QStringLiteral("findBar"));
    m_find->setObjectName(QStringLiteral("findText"));
    m_find->setPlaceholderText(tr("Find"));
    m_find->setClearButtonEnabled(true);
    m_replace->setObjectName(QStringLiteral("replaceText"));
    m_replace->setPlaceholderText(tr("Replace with"));
    m_everywhere->setObjectName(QStringLiteral("findEverywhere"));
    m_everywhere->setToolTip(tr("In every text file of the project; what is found is listed, the Down key goes there"));
    m_said->setObjectName(QStringLiteral("findSaid"));
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(6, 4, 6, 4);
    rows->setSpacing(4);
    rows->addLayout(makeFindRow());
    makeReplaceRow();
    rows->addWidget(m_second);
    auto* third = new QHBoxLayout;
    third->addWidget(m_everywhere);
    third->addStretch(1);
    third->addWidget(m_said);
    rows->addLayout(third);
    setTabOrder(m_find, m_replace); // the row of buttons beside it comes after the replacement
    connect(m_find, &QLineEdit::textChanged, this, &FindBar::changed);
    connect(m_everywhere, &QCheckBox::toggled, this, &FindBar::changed);
    hide();
}

QHBoxLayout* FindBar::makeFindRow() {
    m_case = toggle(QStringLiteral("Aa"), QStringLiteral("findCase"), tr("Match case"));
    m_words = toggle(QStringLiteral("W"), QStringLiteral("findWords"), tr("Whole words only"));
    m_regex = toggle(QStringLiteral(".*"), QStringLiteral("findRegex"),
                     tr("A regular expression; \\1 in the replacement is its first group"));
    QToolButton* back = button(QStringLiteral("↑"), QStringLiteral("findBack"), tr("Find Previous (Shift+Enter)"));
    QToolButton* on = button(QStringLiteral("↓"), QStringLiteral("findOn"), tr("Find Next (Enter)"));
    QToolButton* shut = button({}, QStringLiteral("findClose"), tr("Close (Esc)"));
    shut->setIcon(themedIcon(QStringLiteral("close")));
    shut->setIconSize({14, 14});
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    row->addWidget(m_find, 1);
    for (QWidget* w : std::initializer_list<QWidget*>{m_case, m_words, m_regex, back, on, shut}) row->addWidget(w);
    for (QToolButton* b : {m_case, m_words, m_regex}) connect(b, &QToolButton::toggled, this, &FindBar::changed);
    connect(back, &QToolButton::clicked, this, [this] { Q_EMIT step(-1); });
    connect(on, &QToolButton::clicked, this, [this] { Q_EMIT step(+1); });
    connect(shut, &QToolButton::clicked, this, &FindBar::closed);
    return row;
}

void FindBar::makeReplaceRow() {
    auto* one = new QPushButton(tr("Replace"), m_second);
    auto* all = new QPushButton(tr("Replace All"), m_second);
    one->setObjectName(QStringLiteral("replaceOne"));
    all->setObjectName(QStringLiteral("replaceAll"));
    auto* row = new QHBoxLayout(m_second);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(m_replace, 1);
    row->addWidget(one);
    row->addWidget(all);
    connect(one, &QPushButton::clicked, this, &FindBar::replaceOne);
    connect(all, &QPushButton::clicked, this, &FindBar::replaceAll);
}

QToolButton* FindBar::button(const QString& text, const QString& name, const QString& tip) {
    auto* b = new QToolButton(this);
    b->setText(text);
    b->setObjectName(name);
    b->setToolTip(tip);
    b->setAutoRaise(true);
    return b;
}

QToolButton* FindBar::toggle(const QString& text, const QString& name, const QString& tip) {
    QToolButton* b = button(text, name, tip);
    b->setAccessibleName(tip);
    b->setCheckable(true);
    return b;
}

void FindBar::open(const QString& words, bool replacing) {
    m_second->setVisible(replacing);
    show();
    if (!words.isEmpty()) m_find->setText(words);
    m_find->setFocus();
    m_find->selectAll();
    Q_EMIT changed();
}

SearchOptions FindBar::searchOptions() const {
    return {m_find->text(), m_case->isChecked(), m_words->isChecked(), m_regex->isChecked()};
}

QString FindBar::replacement() const { return m_replace->text(); }

bool FindBar::everywhere() const { return m_everywhere->isChecked(); }

void FindBar::setEverywhere(bool everywhere) { m_everywhere->setChecked(everywhere); }

void FindBar::showStatus(const QString& text, bool wrong) {
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, ink(wrong ? Ink::Error : Ink::Faint));
    m_said->setPalette(colours);
    m_said->setText(text);
}

void FindBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        Q_EMIT closed();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        if (m_replace->hasFocus()) Q_EMIT replaceOne();
        else Q_EMIT step(event->modifiers() & Qt::ShiftModifier ? -1 : +1);
    } else if (event->key() == Qt::Key_Down && everywhere()) {
        Q_EMIT listRequested();
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace trundle
