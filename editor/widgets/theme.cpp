#include "editor/widgets/theme.h"

#include <array>

#include <QEvent>
#include <QFile>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QSvgRenderer>
#include <QWidget>

#include "editor/widgets/painted_icon.h"
#include "editor/widgets/resources.h"

namespace trundle {
namespace {

struct Colours {
    const char *window, *base, *alternate, *text, *faint, *accent, *onAccent, *button, *line, *disabled;
    const char *error, *warning, *hint, *good;
    const char *keyword, *number, *string, *comment, *type;
    const char *axisX, *axisY, *axisZ;
};

constexpr Colours kLight{"#f3f4f6", "#ffffff", "#f7f8fa", "#1d2330", "#5d6675", "#1f6feb", "#ffffff", "#ffffff",
                         "#d3d8e0", "#a3abb8", "#c62828", "#9a5b00", "#3a6ea5", "#1b7f3b", "#8a2da5", "#0b61a4",
                         "#1b7f3b", "#68717f", "#a8480c", "#d32f2f", "#2e8b3d", "#1f6feb"};
constexpr Colours kDark{"#22262d", "#1a1d23", "#1f2329", "#e4e7ec", "#9aa3b2", "#4c9aff", "#0d1117", "#2c313a",
                        "#3a404b", "#697080", "#ff7b72", "#e3a341", "#79b8ff", "#56d364", "#d2a8ff", "#79c0ff",
                        "#8ddb8c", "#8b949e", "#ffb070", "#ff6b61", "#5fd068", "#5aa2ff"};

ThemeKind g_kind = ThemeKind::Light; // global per process, like QApplication's palette
FontSizes g_sizes;

const Colours& colours() { return g_kind == ThemeKind::Dark ? kDark : kLight; }
QColor colour(const char* name) { return QColor(QLatin1String(name)); }

void loadFonts() {
    static const bool loaded = [] {
        for (const char* file :
             {"Inter-Regular.otf", "Inter-SemiBold.otf", "JetBrainsMono-Regular.ttf", "JetBrainsMono-Bold.ttf"})
            QFontDatabase::addApplicationFont(resourcePath(QStringLiteral("fonts/") + QLatin1String(file)));
        return true;
    }();
    Q_UNUSED(loaded);
}

/// Paints an SVG in a colour of the theme at the time of painting.
void paintSvg(QPainter& painter, const QRectF& box, const QString& path, const QColor& colour) {
    QSvgRenderer svg(path);
    svg.setAspectRatioMode(Qt::KeepAspectRatio);
    QImage image((box.size() * painter.device()->devicePixelRatioF()).toSize(), QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter inside(&image);
    svg.render(&inside, QRectF(image.rect()));
    inside.setCompositionMode(QPainter::CompositionMode_SourceIn);
    inside.fillRect(image.rect(), colour);
    inside.end();
    painter.drawImage(box, image);
}

} // namespace

ThemeKind systemTheme() {
    static const ThemeKind kind = [] {
        const QPalette palette = QGuiApplication::palette();
        return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness() ? ThemeKind::Dark
                                                                                                             : ThemeKind::Light;
    }();
    return kind;
}

ThemeKind currentTheme() { return g_kind; }

void setCurrentTheme(ThemeKind kind, const FontSizes& sizes) {
    (void)systemTheme(); // queries the palette before it is replaced
    g_kind = kind;
    g_sizes = sizes;
}

QColor ink(Ink which) {
    const Colours& c = colours();
    switch (which) {
    case Ink::Text: return colour(c.text);
    case Ink::Faint: return colour(c.faint);
    case Ink::Accent: return colour(c.accent);
    case Ink::Error: return colour(c.error);
    case Ink::Warning: return colour(c.warning);
    case Ink::Hint: return colour(c.hint);
    case Ink::Good: return colour(c.good);
    case Ink::Keyword: return colour(c.keyword);
    case Ink::Number: return colour(c.number);
    case Ink::String: return colour(c.string);
    case Ink::Comment: return colour(c.comment);
    case Ink::Type: return colour(c.type);
    case Ink::AxisX: return colour(c.axisX);
    case Ink::AxisY: return colour(c.axisY);
    case Ink::AxisZ: return colour(c.axisZ);
    case Ink::Line: return colour(c.line);
    }
    return {};
}

QPalette themePalette() {
    const Colours& c = colours();
    QPalette p;
    p.setColor(QPalette::Window, colour(c.window));
    p.setColor(QPalette::Base, colour(c.base));
    p.setColor(QPalette::AlternateBase, colour(c.alternate));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
        p.setColor(role, colour(c.text));
    p.setColor(QPalette::PlaceholderText, colour(c.faint));
    p.setColor(QPalette::Button, colour(c.button));
    p.setColor(QPalette::ToolTipBase, colour(c.base));
    p.setColor(QPalette::Highlight, colour(c.accent));
    p.setColor(QPalette::HighlightedText, colour(c.onAccent));
    p.setColor(QPalette::Link, colour(c.accent));
    p.setColor(QPalette::Mid, colour(c.line));
    p.setColor(QPalette::Midlight, colour(c.line));
    p.setColor(QPalette::Dark, colour(c.line));
    p.setColor(QPalette::Light, colour(c.alternate));
    p.setColor(QPalette::Shadow, colour(c.line));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
        p.setColor(QPalette::Disabled, role, colour(c.disabled));
    p.setColor(QPalette::Disabled, QPalette::Highlight, colour(c.line));
    return p;
}

QFont interfaceFont() {
    loadFonts();
    QFont font(QStringLiteral("Inter"));
    font.setPixelSize(g_sizes.interface);
    return font;
}

QFont monospaceFont() {
    loadFonts();
    QFont font(QStringLiteral("JetBrains Mono"));
    font.setStyleHint(QFont::Monospace);
    font.setPixelSize(g_sizes.text);
    return font;
}

int scaledToFont(int atDefault) { return qRound(double(atDefault) * g_sizes.interface / FontSizes().interface); }

QFont figuresFont(int atDefault) {
    QFont font = monospaceFont();
    font.setPixelSize(scaledToFont(atDefault));
    return font;
}

namespace {

/// Sets the widget's font again whenever a theme is applied.
class FontFollower final : public QObject {
public:
    FontFollower(QWidget& widget, std::function<QFont()> font) : QObject(&widget), m_font(std::move(font)) {
        widget.installEventFilter(this);
        widget.setFont(m_font());
    }

private:
    bool eventFilter(QObject* watched, QEvent* event) override {
        auto& widget = *static_cast<QWidget*>(watched);
        if (event->type() == QEvent::StyleChange && widget.font() != m_font()) widget.setFont(m_font());
        return false;
    }

    std::function<QFont()> m_font;
};

} // namespace

void useFont(QWidget& widget, std::function<QFont()> font) { new FontFollower(widget, std::move(font)); }
void useMonospaceFont(QWidget& widget) { useFont(widget, monospaceFont); }

namespace {

template <class Colour> QIcon svgIcon(const QString& name, Colour colourFor) {
    if (name.isEmpty()) return {};
    const QString path = resourcePath(QStringLiteral("icons/") + name + QStringLiteral(".svg"));
    if (!QFile::exists(path)) return {};
    return paintedIcon([path, colourFor](QPainter& painter, const QRectF& box, QIcon::Mode mode) {
        paintSvg(painter, box, path, colourFor(mode));
    });
}

} // namespace

QIcon themedIcon(const QString& name) {
    return svgIcon(name, [](QIcon::Mode mode) {
        const Colours& c = colours();
        return colour(mode == QIcon::Disabled ? c.disabled : mode == QIcon::Selected ? c.onAccent : c.text);
    });
}

QIcon inkedIcon(const QString& name, Ink which) {
    return svgIcon(name, [which](QIcon::Mode) { return ink(which); });
}

} // namespace trundle
