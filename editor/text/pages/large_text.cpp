#include "editor/text/pages/large_text.h"

#include <algorithm>

#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace trundle {
namespace {

QString sizeText(std::size_t bytes, int decimals) { return QLocale::c().formattedDataSize(static_cast<qint64>(bytes), decimals); }

/// A size above a limit, with as many decimals as are needed to see that: "4.2 MiB" above "4 MiB".
QString sizeAbove(std::size_t bytes, std::size_t limit) {
    constexpr int kMostDecimals = 3;
    for (int decimals = 0; decimals <= kMostDecimals; ++decimals)
        if (const QString text = sizeText(bytes, decimals); text != sizeText(limit, decimals)) return text;
    return LargeTextNotice::tr("%L1 bytes").arg(bytes);
}

} // namespace

TextSize sizeOf(std::string_view text) {
    TextSize size;
    size.bytes = text.size();
    std::uint32_t line = 1;
    for (std::size_t begin = 0; begin < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (end - begin > size.longestLine) {
            size.longestLine = end - begin;
            size.longestAt = line;
        }
        begin = end + 1;
    }
    return size;
}

LargeTextNotice::LargeTextNotice(QWidget* parent)
    : QWidget(parent), m_words(new QLabel(this)), m_open(new QPushButton(tr("Open as Text"), this)) {
    setObjectName(QStringLiteral("largeText"));
    setFocusProxy(m_open);
    m_words->setObjectName(QStringLiteral("largeTextWords"));
    m_words->setTextFormat(Qt::PlainText);
    m_words->setWordWrap(true);
    m_words->setAlignment(Qt::AlignCenter);
    m_open->setObjectName(QStringLiteral("openAsText"));
    m_open->setToolTip(
        tr("Shows and edits the text without colors, folds and wrapped lines; each edit takes time, and memory of several "
           "times the size of the text"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 24, 24, 24);
    layout->setSpacing(12);
    layout->addStretch(1);
    layout->addWidget(m_words);
    layout->addWidget(m_open, 0, Qt::AlignHCenter);
    layout->addStretch(2);
    connect(m_open, &QPushButton::clicked, this, &LargeTextNotice::openRequested);
}

void LargeTextNotice::setSize(const QString& file, const TextSize& size) {
    m_open->setVisible(size.isShowable());
    if (size.isShowable())
        m_words->setText(tr("%1 is a text of %2. Texts above %3 are not shown until you ask for it, to save memory and time.")
                             .arg(file, sizeAbove(size.bytes, kLargestFullText), sizeText(kLargestFullText, 0)));
    else
        m_words->setText(tr("Line %1 of %2 has %3. The text editor shows lines up to %4; use another program to edit this file.")
                             .arg(QString::number(size.longestAt), file, sizeAbove(size.longestLine, kLongestShownLine),
                                  sizeText(kLongestShownLine, 0)));
}

} // namespace trundle
