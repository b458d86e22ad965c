#include "editor/outline/block_mime.h"

#include <algorithm>
#include <set>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMimeData>

#include "editor/outline/placing.h"
#include "lang/tree.h"
#include "project/plans.h"
#include "project/search.h"

namespace trundle {
namespace {

constexpr qsizetype kMostText = 16 << 20; // a clipboard may hold anything

Error notBlocks(std::string reason) { return {Code::Internal, std::move(reason)}; }

/// "line 3: expected a value".
std::string firstError(const Tree& tree) {
    for (const Diagnostic& d : tree.diagnostics())
        if (d.severity == Severity::Error)
            return "line " + std::to_string(tree.source().position(d.range.range.begin).line) + ": " + d.message;
    return {};
}

std::string lineOf(const Tree& tree, const Item& item) {
    return "line " + std::to_string(tree.source().position(item.range.begin).line);
}

void addFileOf(const Part* part, std::set<FileId>& files) {
    if (part && part->file != kNoFile && part->file != 0) files.insert(part->file);
}

/// The files that define what the words of a part's values name.
void collect(const Loaded& loaded, const Part& part, std::set<FileId>& files) {
    for (const PlacedAssignment& a : part.assignments.all())
        for (const Element& e : a.value->elements) {
            if (a.key == "Config") addFileOf(loaded.outline->configs.find(e.text), files);
            if (a.key == "Material") addFileOf(loaded.outline->materials.find(e.text), files);
            if (a.key == "Surface") addFileOf(loaded.outline->surfaces.find(e.text), files);
        }
    for (const Part& inner : part.parts) collect(loaded, inner, files);
}

std::vector<std::string> importsFor(const Loaded& loaded, const std::vector<std::string>& paths) {
    std::set<FileId> files;
    for (const std::string& path : paths)
        if (const auto place = placeOf(loaded, path); place && place->part) collect(loaded, *place->part, files);
    std::vector<std::string> imports;
    for (const FileId file : files)
        if (!loaded.paths[file].empty()) imports.push_back(loaded.paths[file]);
    return imports;
}

QByteArray jsonOf(const std::string& kind, const std::string& text, const std::vector<std::string>& imports) {
    QJsonArray files;
    for (const std::string& file : imports) files.append(QString::fromStdString(file));
    const QJsonObject object{{QStringLiteral("kind"), QString::fromStdString(kind)},
                             {QStringLiteral("text"), QString::fromStdString(text)},
                             {QStringLiteral("imports"), files}};
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

} // namespace

Result<Blocks> blocksFrom(const std::string& text) {
    if (std::all_of(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }))
        return notBlocks("there is no text to insert");
    const auto tree = parse(std::make_shared<const SourceText>("clipboard", text), 0);
    if (const std::string error = firstError(*tree); !error.empty()) return notBlocks("this text cannot be inserted: " + error);
    Blocks blocks{text, {}, {}, {}};
    for (const Item& item : tree->items()) {
        if (const auto* block = item.as<BlockItem>()) {
            blocks.kinds.push_back(block->type.text);
            blocks.names.push_back(block->name ? block->name->text : std::string());
        } else if (!item.as<ImportItem>() && !item.as<ModuleItem>()) {
            return notBlocks("this text cannot be inserted: " + lineOf(*tree, item) +
                             " is a setting of its own; only blocks such as \"Box box { Size=1,1,1 }\" can be");
        }
    }
    if (blocks.kinds.empty()) return notBlocks("this text holds no block that could be inserted");
    return blocks;
}

QMimeData* mimeOf(const Loaded& loaded, const std::vector<std::string>& paths) {
    const std::string text = textOf(loaded, paths);
    auto* mime = new QMimeData;
    mime->setText(QString::fromStdString(text));
    const std::vector<std::string> imports = importsFor(loaded, paths);
    const Kind* kind = paths.empty() ? nullptr : kindAt(loaded, paths.front());
    if (!imports.empty()) mime->setData(QLatin1String(kLibraryMime), jsonOf(kind ? kind->name : "", text, imports));
    return mime;
}

QMimeData* libraryMime(const std::string& kind, const std::string& text, const std::vector<std::string>& imports) {
    auto* mime = new QMimeData;
    mime->setText(QString::fromStdString(text));
    mime->setData(QLatin1String(kLibraryMime), jsonOf(kind, text, imports));
    return mime;
}

Result<Blocks> blocksIn(const QMimeData& mime) {
    if (mime.hasFormat(QLatin1String(kLibraryMime))) {
        const QJsonObject object = QJsonDocument::fromJson(mime.data(QLatin1String(kLibraryMime))).object();
        Result<Blocks> blocks = blocksFrom(object.value(QStringLiteral("text")).toString().toStdString());
        if (!blocks) return blocks;
        Blocks all = std::move(blocks).value();
        for (const QJsonValue& file : object.value(QStringLiteral("imports")).toArray())
            all.imports.push_back(file.toString().toStdString());
        return all;
    }
    if (!mime.hasText()) return notBlocks("there is no text to insert");
    const QString text = mime.text();
    if (text.size() > kMostText) return notBlocks("this text is too long to be inserted");
    return blocksFrom(text.toStdString());
}

std::vector<std::string> pathsIn(const QMimeData& mime) {
    std::vector<std::string> paths;
    for (const QByteArray& line : mime.data(QLatin1String(kObjectsMime)).split('\n'))
        if (!line.isEmpty()) paths.push_back(line.toStdString());
    return paths;
}

} // namespace trundle
