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
    bool elsewhere = false; ///< for a window of another project, which cannot import the files of this one
    std::set<FileId> files;
    std::set<std::string> modules;
    std::vector<const Part*> own; ///< of the opened file, which nobody imports, or of others that cannot be
};

bool isOfProject(const Loaded& loaded, FileId file) {
    return !loaded.projectFolder.empty() && loaded.paths[file].starts_with(loaded.projectFolder + "/");
}

void collect(const Loaded& loaded, const Part& part, Needs& needs);

void need(const Loaded& loaded, const Part* part, Needs& needs) {
    if (!part || part->file == kNoFile) return;
    if (part->file != 0 && !(needs.elsewhere && isOfProject(loaded, part->file))) {
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

/// What goes in with blocks.
struct Company {
    std::vector<std::string> imports;
    std::vector<NeededBlock> needs;
    std::vector<std::string> params;
    [[nodiscard]] bool empty() const { return imports.empty() && needs.empty() && params.empty(); }
};

Company companyOf(const Loaded& loaded, const std::vector<std::string>& paths, bool elsewhere) {
    Needs needs;
    needs.elsewhere = elsewhere;
    std::vector<SourceRange> taken;
    for (const std::string& path : paths)
        if (const auto place = placeOf(loaded, path); place && place->part) {
            collect(loaded, *place->part, needs);
            taken.push_back(place->part->range);
        }
    Company company;
    company.imports.assign(needs.modules.begin(), needs.modules.end());
    for (const FileId file : needs.files)
        if (!loaded.paths[file].empty()) company.imports.push_back(loaded.paths[file]);
    std::reverse(needs.own.begin(), needs.own.end()); // what is named stands before what names it
    for (const Part* part : needs.own)
        if (const std::string path = part->kind->name + "." + part->name;
            std::find(paths.begin(), paths.end(), path) == paths.end())
            company.needs.push_back({path, textOf(loaded, {path})});
    for (const Part* part : needs.own) taken.push_back(part->range);
    company.params = paramsIn(loaded, std::move(taken), needs.files);
    return company;
}

QJsonObject jsonOf(const Company& company) {
    QJsonArray files, blocks, names;
    for (const std::string& file : company.imports) files.append(QString::fromStdString(file));
    for (const std::string& param : company.params) names.append(QString::fromStdString(param));
    for (const NeededBlock& block : company.needs)
        blocks.append(QJsonObject{{QStringLiteral("path"), QString::fromStdString(block.path)},
                                  {QStringLiteral("text"), QString::fromStdString(block.text)}});
    return {{QStringLiteral("imports"), files}, {QStringLiteral("needs"), blocks}, {QStringLiteral("params"), names}};
}

QByteArray jsonOf(const std::string& kind, const std::string& text, const Company& here, const Company& elsewhere) {
    QJsonObject object = jsonOf(here);
    object.insert(QStringLiteral("kind"), QString::fromStdString(kind));
    object.insert(QStringLiteral("text"), QString::fromStdString(text));
    object.insert(QStringLiteral("elsewhere"), jsonOf(elsewhere));
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
    const Company company = companyOf(loaded, paths, false);
    const Kind* kind = paths.empty() ? nullptr : kindAt(loaded, paths.front());
    if (!company.empty())
        mime->setData(QLatin1String(kLibraryMime), jsonOf(kind ? kind->name : "", text, company, companyOf(loaded, paths, true)));
    return mime;
}

QMimeData* libraryMime(const std::string& kind, const std::string& text, const std::vector<std::string>& imports) {
    auto* mime = new QMimeData;
    mime->setText(QString::fromStdString(text));
    const Company company{imports, {}, {}};
    mime->setData(QLatin1String(kLibraryMime), jsonOf(kind, text, company, company));
    return mime;
}

Result<Blocks> blocksIn(const QMimeData& mime, const MayImport& mayImport) {
    if (mime.hasFormat(QLatin1String(kLibraryMime))) {
        const QJsonObject object = QJsonDocument::fromJson(mime.data(QLatin1String(kLibraryMime))).object();
        Result<Blocks> blocks = blocksFrom(object.value(QStringLiteral("text")).toString().toStdString());
        if (!blocks) return blocks;
        Blocks all = std::move(blocks).value();
        const QJsonArray files = object.value(QStringLiteral("imports")).toArray();
        const bool here = std::all_of(files.begin(), files.end(), [&](const QJsonValue& file) {
            const QString path = file.toString();
            return !path.startsWith(QLatin1Char('/')) || mayImport(path.toStdString());
        });
        const QJsonObject company = here ? object : object.value(QStringLiteral("elsewhere")).toObject();
        for (const QJsonValue& file : company.value(QStringLiteral("imports")).toArray())
            all.imports.push_back(file.toString().toStdString());
        for (const QJsonValue& param : company.value(QStringLiteral("params")).toArray())
            all.params.push_back(param.toString().toStdString());
        for (const QJsonValue& value : company.value(QStringLiteral("needs")).toArray()) {
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
