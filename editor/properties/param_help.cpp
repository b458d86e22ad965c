#include "editor/properties/param_help.h"

#include <QStringList>

#include "lang/tree_edit.h"
#include "model/dotted_path.h"
#include "project/objects/object_location.h"
#include "project/objects/value_text.h"

namespace trundle {
namespace {

const SourceParam* declarationOf(const LoadedProject& loaded, const std::string& path) {
    const std::string name(lastWord(path)), owner(withoutLastWord(path));
    if (owner.empty() || owner == "Param") {
        for (const SourceParam& param : loaded.outline->params)
            if (param.name->text == name) return &param;
        return nullptr;
    }
    const std::optional<ObjectLocation> place = placeOf(loaded, owner);
    if (!place || !place->part) return nullptr;
    if (const SourceParam* own = place->part->param(name)) return own;
    const Part* config = isPlaced(*place->part) ? configOf(loaded, *place->part) : nullptr;
    return config ? config->param(name) : nullptr;
}

/// The text of a comment without its comment marks.
QString commentText(std::string_view comment) {
    QString text = QString::fromUtf8(comment.data(), static_cast<qsizetype>(comment.size()));
    if (text.startsWith(QStringLiteral("//"))) {
        while (text.startsWith(QLatin1Char('/'))) text.remove(0, 1);
    } else {
        text.remove(QStringLiteral("/*")).remove(QStringLiteral("*/"));
    }
    return text.simplified();
}

} // namespace

QString rangeOf(const FieldValue& value) {
    if (value.property) return QString::fromStdString(unitAndRange(*value.property));
    return value.description ? QString::fromStdString(value.description->limits()) : QString();
}

QString paramHelp(const LoadedProject& loaded, const std::string& path) {
    const SourceParam* param = declarationOf(loaded, path);
    if (!param || param->file >= loaded.trees.size()) return {};
    const Tree& tree = *loaded.trees[param->file];
    const SourceText& source = tree.source();
    if (param->description && !param->description->property.help.empty())
        return QString::fromStdString(param->description->property.help);
    // With a --set the value is not in the file; the comment then follows the declaration's name.
    const std::uint32_t from = param->valueFile == param->file ? param->value->range.end : param->name->range.end;
    const std::uint32_t end = behindComments(tree, from);
    QStringList words;
    for (const Token& token : tree.tokens())
        if (token.range.begin >= from && token.range.end <= end &&
            (token.kind == TokenKind::LineComment || token.kind == TokenKind::BlockComment))
            words << commentText(source.slice(token.range));
    if (!words.isEmpty()) return words.join(QLatin1Char(' ')).simplified();
    for (std::uint32_t line = source.position(param->name->range.begin).line; --line > 0;) {
        const QString text = QString::fromStdString(std::string(source.line(line))).trimmed();
        if (!text.startsWith(QStringLiteral("//"))) break;
        words.prepend(commentText(text.toStdString()));
    }
    return words.join(QLatin1Char(' ')).simplified();
}

} // namespace trundle
