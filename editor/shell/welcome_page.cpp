#include "editor/shell/welcome_page.h"

#include <algorithm>

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QScrollArea>

#include "editor/shell/recent_files.h"
#include "editor/widgets/resources.h"
#include "editor/widgets/theme.h"
#include "project/journal/journal.h"
#include "project/loading/search.h"

namespace trundle {
namespace {

/// A sample with its image, title and one sentence. A button, so that it works with the keyboard.
class SampleCard final : public QAbstractButton {
public:
    SampleCard(const Sample& sample, QWidget* parent) : QAbstractButton(parent), m_sample(sample) {
        setText(sample.title);
        setToolTip(sample.path);
        setCursor(Qt::PointingHandCursor);
        setFocusPolicy(Qt::StrongFocus);
        setAttribute(Qt::WA_Hover);
        setObjectName(QStringLiteral("sample.") + QFileInfo(sample.path).completeBaseName());
    }

    /// So high that all its words can be read.
    [[nodiscard]] int heightAt(int width) const {
        const QRect words =
            fontMetrics().boundingRect(QRect(0, 0, width - 2 * kMargin, 10000), Qt::TextWordWrap, m_sample.description);
        return descriptionTop(width) + words.height() + 10;
    }

protected:
    void paintEvent(QPaintEvent*) override {
        if (m_picture.isNull()) m_picture.load(m_sample.picture);
        const int picture = pictureHeight(width());
        QPainter p(this);
        p.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
        const QRectF frame = QRectF(rect()).adjusted(0.75, 0.75, -0.75, -0.75);
        QPainterPath card;
        card.addRoundedRect(frame, 8, 8);
        p.fillPath(card, palette().base());
        p.save();
        p.setClipPath(card);
        if (!m_picture.isNull()) {
            const QSizeF shown = QSizeF(m_picture.size()).scaled(frame.width(), picture, Qt::KeepAspectRatioByExpanding);
            const QRectF place((frame.width() - shown.width()) / 2, (picture - shown.height()) / 2, shown.width(),
                               shown.height());
            p.setClipRect(QRectF(0, 0, width(), picture), Qt::IntersectClip);
            p.drawImage(place, m_picture);
        }
        p.restore();
        p.setPen(palette().color(QPalette::Text));
        QFont bold = font();
        bold.setWeight(QFont::DemiBold);
        p.setFont(bold);
        p.drawText(QRect(kMargin, picture + 10, width() - 2 * kMargin, lineHeight()), Qt::AlignLeft | Qt::AlignVCenter, text());
        p.setFont(font());
        p.setPen(ink(Ink::Faint));
        const int top = descriptionTop(width());
        p.drawText(QRect(kMargin, top, width() - 2 * kMargin, height() - top), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                   m_sample.description);
        const bool hot = underMouse() || hasFocus();
        p.setPen(QPen(hot ? ink(Ink::Accent) : ink(Ink::Line), hot ? 2 : 1));
        p.drawPath(card);
    }
    void keyPressEvent(QKeyEvent* event) override {
        if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) click();
        else QAbstractButton::keyPressEvent(event);
    }

private:
    static constexpr int kMargin = 14;
    static int pictureHeight(int width) { return width * 9 / 16; }
    [[nodiscard]] int lineHeight() const { return std::max(20, fontMetrics().lineSpacing()); }
    [[nodiscard]] int descriptionTop(int width) const { return pictureHeight(width) + 12 + lineHeight(); }
    Sample m_sample;
    QImage m_picture; ///< empty until the card is first seen: reading the pictures of all cards delays the window's start
};

QLabel* heading(const QString& text, int size) {
    auto* label = new QLabel(text);
    useFont(*label, [size] {
        QFont font = QApplication::font();
        font.setPixelSize(scaledToFont(size));
        font.setWeight(QFont::DemiBold);
        return font;
    });
    return label;
}

class LinkButton final : public QPushButton {
public:
    using QPushButton::QPushButton;

protected:
    void keyPressEvent(QKeyEvent* event) override {
        if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) click();
        else QPushButton::keyPressEvent(event);
    }
};

/// A button that looks like a link.
QPushButton* linkButton(const QString& text, const QIcon& icon = {}) {
    auto* button = new LinkButton(icon, text);
    button->setFlat(true);
    button->setCursor(Qt::PointingHandCursor);
    button->setStyleSheet(
        QStringLiteral("QPushButton { text-align: left; border: none; background: transparent; padding: 4px 2px; }"
                       "QPushButton:hover, QPushButton:focus { color: palette(link); }"));
    return button;
}

/// Lays out cards in as many columns as fit, stretched to the full width.
class CardFlow final : public QWidget {
public:
    using QWidget::QWidget;
    void add(SampleCard* card) { m_cards.append(card); }

protected:
    void resizeEvent(QResizeEvent*) override { place(); }
    void showEvent(QShowEvent*) override { place(); }
    bool event(QEvent* event) override {
        if (event->type() == QEvent::LayoutRequest) place(); // a card has another font
        return QWidget::event(event);
    }

private:
    void place() {
        if (m_cards.isEmpty()) return;
        const int columns = std::clamp((width() + kGap) / (kLeast + kGap), 1, int(m_cards.size()));
        const int wide = std::min(kMost, (width() - (columns - 1) * kGap) / columns);
        int high = 0;
        for (const SampleCard* card : m_cards) high = std::max(high, card->heightAt(wide));
        for (int i = 0; i < m_cards.size(); ++i)
            m_cards[i]->setGeometry((i % columns) * (wide + kGap), (i / columns) * (high + kGap), wide, high);
        const int rows = (int(m_cards.size()) + columns - 1) / columns;
        setMinimumHeight(rows * (high + kGap));
    }
    static constexpr int kGap = 16, kLeast = 212, kMost = 340;
    QList<SampleCard*> m_cards;
};

/// Begins a robot of one's own.
SampleCard* newRobotCard(QAction& action, QWidget* parent) {
    auto* card = new SampleCard({{},
                                 WelcomePage::tr("New robot from dimensions"),
                                 WelcomePage::tr("Five bases: give its size, mass and speed, and it drives."),
                                 resourcePath(QStringLiteral("pictures/gallery/new_robot.png"))},
                                parent);
    card->setToolTip(action.toolTip());
    card->setObjectName(QStringLiteral("welcome.newRobot"));
    QObject::connect(card, &QAbstractButton::clicked, &action, &QAction::trigger);
    return card;
}

/// Makes the content scroll, so that it does not limit the window's minimum height.
QScrollArea* scrolled(QWidget* content) {
    auto* scroll = new QScrollArea;
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus); // its content takes the focus
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->viewport()->setAutoFillBackground(false);
    content->setAutoFillBackground(false);
    return scroll;
}

constexpr int kStartWidth = 260;

/// Whether a crashed window has left edits of this file. Opening it offers to restore them.
bool hasUnsavedWork(const QString& file) {
    const std::string path = canonicalPath(file.toStdString());
    return std::ranges::any_of(findRecoveries(projectFolderOf(path)), [&](const Recovery& r) { return r.head.opened == path; });
}

} // namespace

WelcomePage::WelcomePage(const Actions& actions, const QString& configs, QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("welcome"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(48, 40, 48, 24);
    layout->setSpacing(48);
    layout->addWidget(m_start = makeStart(actions));
    layout->addWidget(makeSamples(actions, configs), 1);
    fitStart();
    refresh();
}

void WelcomePage::fitStart() { m_start->setFixedWidth(scaledToFont(kStartWidth)); }

void WelcomePage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange && m_start) fitStart();
}

QWidget* WelcomePage::makeStart(const Actions& actions) {
    auto* column = new QWidget;
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(heading(tr("Trundle"), 30));
    auto* line = new QLabel(tr("Describe robots, run them in 3D, measure, repeat."));
    line->setWordWrap(true);
    line->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(line);
    layout->addSpacing(24);
    layout->addWidget(heading(tr("Start"), 15));
    for (const char* id :
         {"file.newExperiment", "file.newRobot", "file.newFromDimensions", "file.newArena", "file.open", "help.guide"}) {
        QAction& action = actions.at(id);
        QString text = action.text().remove(QLatin1Char('&'));
        if (std::string_view(id).starts_with("file.new")) text = tr("New %1").arg(text.toLower());
        QPushButton* button = linkButton(text, themedIcon(std::string_view(id).starts_with("file.new") ? QStringLiteral("new")
                                                          : std::string_view(id) == "file.open"        ? QStringLiteral("open")
                                                                                                       : QStringLiteral("help")));
        button->setObjectName(QStringLiteral("welcome.") + QLatin1String(id));
        connect(button, &QPushButton::clicked, &action, &QAction::trigger);
        layout->addWidget(button);
    }
    layout->addSpacing(24);
    m_recent = new QVBoxLayout;
    m_recent->setSpacing(0);
    layout->addLayout(m_recent);
    layout->addStretch(1);
    QScrollArea* scroll = scrolled(column);
    return scroll;
}

QWidget* WelcomePage::makeSamples(const Actions& actions, const QString& configs) {
    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 10, 0, 0);
    layout->setSpacing(12);
    for (const auto& [title, samples, wanted] :
         {std::tuple(tr("Samples"), sampleExperiments(configs), &WelcomePage::openRequested),
          std::tuple(tr("Robots and arenas"), sampleParts(configs), &WelcomePage::tryRequested)}) {
        layout->addWidget(heading(title, 15));
        auto* flow = new CardFlow;
        if (wanted == &WelcomePage::tryRequested) flow->add(newRobotCard(actions.at("file.newFromDimensions"), flow));
        for (const Sample& sample : samples) {
            auto* card = new SampleCard(sample, flow);
            connect(card, &QAbstractButton::clicked, this, [this, path = sample.path, wanted = wanted] {
                Q_EMIT(this->*wanted)(path);
            });
            flow->add(card);
        }
        layout->addWidget(flow);
    }
    layout->addStretch(1);
    return scrolled(content);
}

void WelcomePage::refresh() {
    while (QLayoutItem* item = m_recent->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    const QStringList files = recentFiles();
    if (files.isEmpty()) return;
    m_recent->addWidget(heading(tr("Recent"), 15));
    const QStringList shown = files.mid(0, 8);
    for (const QString& file : shown) {
        const QString name = QFileInfo(file).fileName();
        const bool several =
            std::ranges::count_if(shown, [&](const QString& other) { return QFileInfo(other).fileName() == name; }) > 1;
        const QString label = several ? tr("%1 in %2").arg(name, QFileInfo(file).dir().dirName()) : name;
        QPushButton* button = linkButton({});
        constexpr int kBeside = 24; // of the text: padding and the scroll bar
        button->setText(button->fontMetrics().elidedText(hasUnsavedWork(file) ? tr("%1 – unsaved work").arg(label) : label,
                                                         Qt::ElideMiddle, scaledToFont(kStartWidth - kBeside)));
        button->setObjectName(QStringLiteral("recent.") + name);
        button->setToolTip(file);
        connect(button, &QPushButton::clicked, this, [this, file] { Q_EMIT openRequested(file); });
        m_recent->addWidget(button);
    }
}

} // namespace trundle
