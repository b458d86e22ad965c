#include "editor/outline/block_mime.h"

#include <algorithm>
#include <set>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMimeData>

#include "editor/outline/placing.h"
#include "lang/tree.h"
#include "project/mentions.h"
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

/// What the words of a part's values name, and the modules that bring its kinds.
struct Needs {
    std::set<FileId> files;
    std::set<std::string> modules;
    std::vector<const Part*> own; ///< of the opened file, which nobody imports
};

void collect(const Loaded& loaded, const Part& part, Needs& needs);

void need(const Loaded& loaded, const Part* part, Needs& needs) {
    if (!part || part->file == kNoFile) return;
    if (part->file != 0) {
        needs.files.insert(part->file);
    } else if (std::find(needs.own.begin(), needs.own.end(), part) == needs.own.end()) {
        needs.own.push_back(part);
        collect(loaded, *part, needs);
    }
}

void collect(const Loaded& loaded, const Part& part, Needs& needs) {
    for (const ModuleSpec& module : loaded.experiment->modules)
        if (part.kind && !module.library.empty() && part.kind->module == module.library)
            needs.modules.insert("#loadModule " + module.written);
    for (const PlacedAssignment& a : part.assignments.all())
        for (const Element& e : a.value->elements) {
            if (a.key == "Config") need(loaded, loaded.outline->configs.find(e.text), needs);
            if (a.key == "Material") need(loaded, loaded.outline->materials.find(e.text), needs);
            if (a.key == "Surface") need(loaded, loaded.outline->surfaces.find(e.text), needs);
        }
    for (const Part& inner : part.parts) collect(loaded, inner, needs);
}

/// The Params of the top level that stretches of the texts take, and those that they are made from. Not those of files that are
/// imported anyway.
std::vector<std::string> paramsIn(const Loaded& loaded, std::vector<SourceRange> where, const std::set<FileId>& imported) {
    const std::vector<Mention> mentions = mentionsIn(loaded);
    std::vector<std::string> texts;
    std::set<const ParamItem*> taken;
    for (std::size_t i = 0; i < where.size(); ++i) { // grows on the way
        for (const Mention& m : mentions) {
            const SourceRange round = where[i];
            const bool inside =
                m.name.file == round.file && round.range.begin <= m.name.range.begin && m.name.range.end <= round.range.end;
            if (!m.param || !inside) continue;
            const auto global = std::ranges::find(loaded.outline->params, &m.param->name, &PlacedParam::name);
            if (global == loaded.outline->params.end() || imported.contains(global->file)) continue;
            if (!taken.insert(m.param).second) continue;
            const SourceRange value{global->file, m.param->value.range};
            where.push_back(value);
            texts.push_back("Param " + m.param->name.text + " = " + std::string(loaded.sources.slice(value)));
        }
    }
    std::ranges::reverse(texts); // what is made from others stands behind them
    return texts;
}

QByteArray jsonOf(const std::string& kind, const std::string& text, const std::vector<std::string>& imports,
                  const std::vector<NeededBlock>& needs, const std::vector<std::string>& params) {
    QJsonArray files, blocks, names;
    for (const std::string& file : imports) files.append(QString::fromStdString(file));
    for (const std::string& param : params) names.append(QString::fromStdString(param));
    for (const NeededBlock& block : needs)
        blocks.append(QJsonObject{{QStringLiteral("path"), QString::fromStdString(block.path)},
                                  {QStringLiteral("text"), QString::fromStdString(block.text)}});
    const QJsonObject object{{QStringLiteral("kind"), QString::fromStdString(kind)},
                             {QStringLiteral("text"), QString::fromStdString(text)},
                             {QStringLiteral("imports"), files},
                             {QStringLiteral("needs"), blocks},
                             {QStringLiteral("params"), names}};
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

} // namespace

Result<Blocks> blocksFrom(const std::string& text) {
    if (std::all_of(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }))
        return notBlocks("there is no text to insert");
    const auto tree = parse(std::make_shared<const SourceText>("clipboard", text), 0);
    if (const std::string error = firstError(*tree); !error.empty()) return notBlocks("this text cannot be inserted: " + error);
    Blocks blocks{text, {}, {}, {}, {}, {}};
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
    Needs needs;
    std::vector<SourceRange> taken;
    for (const std::string& path : paths)
        if (const auto place = placeOf(loaded, path); place && place->part) {
            collect(loaded, *place->part, needs);
            taken.push_back(place->part->range);
        }
    std::vector<std::string> imports(needs.modules.begin(), needs.modules.end());
    for (const FileId file : needs.files)
        if (!loaded.paths[file].empty()) imports.push_back(loaded.paths[file]);
    std::vector<NeededBlock> own;
    std::reverse(needs.own.begin(), needs.own.end()); // what is named stands before what names it
    for (const Part* part : needs.own)
        if (const std::string path = part->kind->name + "." + part->name;
            std::find(paths.begin(), paths.end(), path) == paths.end())
            own.push_back({path, textOf(loaded, {path})});
    for (const Part* part : needs.own) taken.push_back(part->range);
    const std::vector<std::string> params = paramsIn(loaded, std::move(taken), needs.files);
    const Kind* kind = paths.empty() ? nullptr : kindAt(loaded, paths.front());
    if (!imports.empty() || !own.empty() || !params.empty())
        mime->setData(QLatin1String(kLibraryMime), jsonOf(kind ? kind->name : "", text, imports, own, params));
    return mime;
}

QMimeData* libraryMime(const std::string& kind, const std::string& text, const std::vector<std::string>& imports) {
    auto* mime = new QMimeData;
    mime->setText(QString::fromStdString(text));
    mime->setData(QLatin1String(kLibraryMime), jsonOf(kind, text, imports, {}, {}));
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
        for (const QJsonValue& param : object.value(QStringLiteral("params")).toArray())
            all.params.push_back(param.toString().toStdString());
        for (const QJsonValue& value : object.value(QStringLiteral("needs")).toArray()) {
            const QJsonObject block = value.toObject();
            all.needs.push_back({block.value(QStringLiteral("path")).toString().toStdString(),
                                 block.value(QStringLiteral("text")).toString().toStdString()});
        }
        return all;
    }
    if (!mime.hasText()) return notBlocks("there is no text to insert");
    const QString text = mime.text();
    if (text.size() > kMostText) return notBlocks("this text is too long to be inserted");
    return blocksFrom(text.toStdString());
}

} // namespace trundle
