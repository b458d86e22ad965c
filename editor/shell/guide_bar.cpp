#include "editor/shell/guide_bar.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QTextBrowser>
#include <QToolButton>

#include "editor/widgets/plain_text.h"
#include "editor/widgets/theme.h"

namespace trundle {

GuideBar::GuideBar(QTextBrowser& pages, Acts acts) : QWidget(&pages), m_acts(std::move(acts)), m_words(new QLineEdit(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 4, 6, 4);
    row->setSpacing(2);
    const auto add = [&](const char* icon, const QString& name, const QString& tip, auto act) {
        auto* button = new QToolButton(this);
        button->setIcon(themedIcon(QString::fromLatin1(icon)));
        button->setAccessibleName(name);
        button->setToolTip(tip);
        connect(button, &QToolButton::clicked, &pages, act);
        row->addWidget(button);
        return button;
    };
    QToolButton* back = add("back", tr("Back"), tr("The page before (Alt+Left)"), &QTextBrowser::backward);
    QToolButton* forward = add("forward", tr("Forward"), tr("The page after (Alt+Right)"), &QTextBrowser::forward);
    add("home", tr("Contents"), tr("All pages of the guide"), [this] { m_acts.showContents(); });
    for (QToolButton* each : {back, forward}) each->setEnabled(false);
    connect(&pages, &QTextBrowser::backwardAvailable, back, &QToolButton::setEnabled);
    connect(&pages, &QTextBrowser::forwardAvailable, forward, &QToolButton::setEnabled);
    m_words->setPlaceholderText(tr("Search the guide"));
    m_words->setClearButtonEnabled(true);
    m_words->setAccessibleName(m_words->placeholderText());
    row->addWidget(m_words);
    connect(m_words, &QLineEdit::returnPressed, this, &GuideBar::search);
}

void GuideBar::focusSearch() {
    m_words->setFocus(Qt::ShortcutFocusReason);
    m_words->selectAll();
}

void GuideBar::search() {
    const QString words = m_words->text().trimmed();
    if (words.isEmpty() || m_acts.findNext(words)) return;
    showToolTip(m_words->mapToGlobal(QPoint(0, m_words->height())), tr("No page has “%1”").arg(words), m_words);
}

} // namespace trundle
