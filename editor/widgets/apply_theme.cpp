#include "editor/widgets/apply_theme.h"

#include <QApplication>

#include "editor/widgets/plain_text.h"
#include "editor/widgets/program_style.h"
#include "editor/widgets/style_sheet.h"

namespace trundle {

void applyTheme(QApplication& application, ThemeKind kind, const FontSizes& sizes) {
    setCurrentTheme(kind, sizes);
    showTextPlainly(application);
    application.setStyle(new ProgramStyle);
    application.setFont(interfaceFont());
    const QPalette palette = themePalette();
    application.setPalette(palette);
    application.setStyleSheet(styleSheet({{QStringLiteral("window"), palette.color(QPalette::Window)},
                                          {QStringLiteral("base"), palette.color(QPalette::Base)},
                                          {QStringLiteral("alternate"), palette.color(QPalette::AlternateBase)},
                                          {QStringLiteral("text"), palette.color(QPalette::Text)},
                                          {QStringLiteral("faint"), palette.color(QPalette::PlaceholderText)},
                                          {QStringLiteral("accent"), palette.color(QPalette::Highlight)},
                                          {QStringLiteral("button"), palette.color(QPalette::Button)},
                                          {QStringLiteral("disabled"), palette.color(QPalette::Disabled, QPalette::Text)},
                                          {QStringLiteral("line"), palette.color(QPalette::Mid)}}));
}

} // namespace trundle
