#include "editor/outline/block_mime.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMimeData>

#include "lang/tree.h"
#include "project/edits/insert_positions.h"
#include "project/edits/plans.h"
#include "project/loading/search.h"
#include "project/objects/name_references.h"

namespace trundle {
namespace {

constexpr qsizetype kMaxText = 16 << 20; // the clipboard can have any size

Error notBlocks(std::string reason) { return {Code::EditRefused, std::move(reason)}; }

/// The first syntax error: "line 3: expected a value".
std::string firstError(const Tree& tree) {
    for (const Diagnostic& d : tree.diagnostics())
        if (d.severity == Severity::Error)
            return "line " + std::to_string(tree.source().position(d.range.range.begin).line) + ": " + d.message;
    return {};
}

std::string lineOf(const Tree& tree, const Item& item) {
    return "line " + std::to_string(tree.source().position(item.range.begin).line);
}

/// Collects the blocks that copied blocks refer to, and the modules that define their kinds.
class Needs {
public:
    /// `elsewhere`: the target is a window of another project, which cannot import this project's files.
    Needs(const LoadedProject& loaded, bool elsewhere) : m_loaded(loaded), m_elsewhere(elsewhere) {
        std::map<const BlockItem*, const Part*> named;
        for (const auto& part : loaded.outline->parts)
            for (const Role role : {Role::Config, Role::Material, Role::Surface, Role::Pattern})
                if (part->is(role)) named.emplace(part->block, part.get());
        for (const NameReference& reference : referencesIn(loaded)) // includes references made through a Param or an override
            if (const auto it = named.find(reference.target); reference.user && it != named.end())
                m_named[reference.user].push_back(it->second);
    }

    void collect(const Part& part) {
        for (const ModuleSpec& module : m_loaded.experiment->modules)
            if (part.kind && !module.library.empty() && part.kind->module == module.library)
                modules.insert("#loadModule " + module.written);
        if (const auto it = m_named.find(&part); it != m_named.end())
            for (const Part* named : it->second) need(*named);
        for (const Part& inner : part.parts) collect(inner);
    }

    /// Whether the target cannot import this file.
    bool isOwn(FileId file) const {
        const std::string& folder = m_loaded.projectFolder;
        return file == 0 || (m_elsewhere && !folder.empty() && m_loaded.paths[file].starts_with(folder + "/"));
    }

    std::set<FileId> files;
    std::set<std::string> modules;
    std::vector<const Part*> own; ///< needed blocks of files that the target cannot import: the opened file, or any project file

private:
    void need(const Part& part) {
        if (part.file == kNoFile) return;
        if (!isOwn(part.file)) {
            files.insert(part.file);
        } else if (std::find(own.begin(), own.end(), &part) == own.end()) {
            own.push_back(&part);
            collect(part);
        }
    }

    const LoadedProject& m_loaded;
    const bool m_elsewhere;
    std::map<const Part*, std::vector<const Part*>> m_named; ///< by the block that refers to them
};

/// The text of a range in which every import that the target cannot resolve is replaced by the imported text. Appends to `read`
/// each range that was copied.
std::string wholeText(const LoadedProject& loaded, const Needs& needs, const std::vector<Item>& items, SourceRange range,
                      std::vector<SourceRange>& read) {
    read.push_back(range);
    const std::string_view bytes = loaded.sources.slice(range);
    std::string text;
    std::uint32_t at = range.range.begin;
    const auto upTo = [&](std::uint32_t end) {
        text += bytes.substr(at - range.range.begin, end - at);
        at = end;
    };
    const auto walk = [&](const auto& self, const std::vector<Item>& all) -> void {
        for (const Item& item : all) {
            if (item.range.begin < at || item.range.end > range.range.end) continue;
            if (const auto* block = item.as<BlockItem>()) self(self, block->items);
            const auto* import = item.as<ImportItem>();
            const auto& known = loaded.outline->texts().imports;
            const auto file = import ? known.find(import) : known.end();
            if (file == known.end() || !needs.isOwn(file->second) || read.size() > 1000) continue;
            upTo(item.range.begin);
            at = item.range.end;
            const Tree& tree = *loaded.trees[file->second];
            const auto size = static_cast<std::uint32_t>(tree.source().bytes().size());
            text += wholeText(loaded, needs, tree.items(), {file->second, {0, size}}, read) + "\n";
        }
    };
    walk(walk, items);
    upTo(range.range.end);
    return text;
}

/// The top-level Params that these ranges use, directly or through other Params, except those of files in `imported`.
std::vector<std::string> paramsIn(const LoadedProject& loaded, std::vector<SourceRange> where, const std::set<FileId>& imported) {
    const std::vector<NameReference> references = referencesIn(loaded);
    std::vector<std::string> texts;
    std::set<const ParamItem*> taken;
    for (std::size_t i = 0; i < where.size(); ++i) { // push_back below extends it
        for (const NameReference& m : references) {
            const SourceRange round = where[i];
            const bool inside =
                m.name.file == round.file && round.range.begin <= m.name.range.begin && m.name.range.end <= round.range.end;
            if (!m.param || !inside) continue;
            const auto global = std::ranges::find(loaded.outline->params, &m.param->name, &SourceParam::name);
            if (global == loaded.outline->params.end() || imported.contains(global->file)) continue;
            if (!taken.insert(m.param).second) continue;
            const SourceRange value{global->file, m.param->value.range};
            where.push_back(value);
            texts.push_back("Param " + m.param->name.text + " = " + std::string(loaded.sources.slice(value)));
        }
    }
    std::ranges::reverse(texts); // a Param must come after those it uses
    return texts;
}

/// Blocks and everything that must be pasted with them.
struct PasteContents {
    std::string text;
    std::vector<std::string> imports;
    std::vector<NeededBlock> needs;
    std::vector<std::string> params;
    std::set<std::string> inlined; ///< files whose texts replace their imports
    [[nodiscard]] bool empty() const { return imports.empty() && needs.empty() && params.empty() && inlined.empty(); }
};

PasteContents contentsOf(const LoadedProject& loaded, const std::vector<std::string>& paths, bool elsewhere) {
    Needs needs(loaded, elsewhere);
    PasteContents contents;
    std::vector<SourceRange> taken;
    const auto whole = [&](const std::string& path, const Part& part) {
        std::vector<SourceRange> read;
        const std::string text = wholeText(loaded, needs, part.block->items, part.range, read);
        taken.insert(taken.end(), read.begin(), read.end());
        for (const SourceRange& piece : std::span(read).subspan(1)) contents.inlined.insert(loaded.paths[piece.file]);
        return read.size() > 1 ? text + "\n" : textOf(loaded, {path});
    };
    for (const std::string& path : paths)
        if (const auto place = placeOf(loaded, path); place && place->part) {
            needs.collect(*place->part);
            contents.text += whole(path, *place->part);
        }
    if (contents.inlined.empty()) contents.text = textOf(loaded, paths); // in the order of the file
    contents.imports.assign(needs.modules.begin(), needs.modules.end());
    for (const FileId file : needs.files)
        if (!loaded.paths[file].empty()) contents.imports.push_back(loaded.paths[file]);
    std::reverse(needs.own.begin(), needs.own.end()); // a referenced block must come before the one that refers to it
    for (const Part* part : needs.own)
        if (const std::string path = part->kind->name + "." + part->name;
            std::find(paths.begin(), paths.end(), path) == paths.end())
            contents.needs.push_back({path, whole(path, *part)});
    contents.params = paramsIn(loaded, std::move(taken), needs.files);
    return contents;
}

QJsonObject jsonOf(const PasteContents& contents) {
    QJsonArray files, blocks, names;
    const QString text = QString::fromStdString(contents.text);
    for (const std::string& file : contents.imports) files.append(QString::fromStdString(file));
    for (const std::string& param : contents.params) names.append(QString::fromStdString(param));
    for (const NeededBlock& block : contents.needs)
        blocks.append(QJsonObject{{QStringLiteral("path"), QString::fromStdString(block.path)},
                                  {QStringLiteral("text"), QString::fromStdString(block.text)}});
    return {{QStringLiteral("text"), text},
            {QStringLiteral("imports"), files},
            {QStringLiteral("needs"), blocks},
            {QStringLiteral("params"), names}};
}

QByteArray jsonOf(const std::string& kind, const PasteContents& here, const PasteContents& elsewhere,
                  const std::string& from = {}) {
    QJsonArray inlined;
    for (const std::string& file : elsewhere.inlined) inlined.append(QString::fromStdString(file));
    QJsonObject object = jsonOf(here);
    object.insert(QStringLiteral("kind"), QString::fromStdString(kind));
    object.insert(QStringLiteral("from"), QString::fromStdString(from));
    object.insert(QStringLiteral("inlined"), inlined);
    object.insert(QStringLiteral("elsewhere"), jsonOf(elsewhere));
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

} // namespace

Result<Blocks> blocksFrom(const std::string& text) {
    if (std::all_of(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }))
        return notBlocks("there is no text to insert");
    const auto tree = parse(std::make_shared<const SourceText>("clipboard", text), 0);
    if (const std::string error = firstError(*tree); !error.empty()) return notBlocks("this text cannot be inserted: " + error);
    Blocks blocks{text, {}, {}, {}, {}, {}, {}};
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

QMimeData* mimeOf(const LoadedProject& loaded, const std::vector<std::string>& paths) {
    const PasteContents here = contentsOf(loaded, paths, false), elsewhere = contentsOf(loaded, paths, true);
    auto* mime = new QMimeData;
    mime->setText(QString::fromStdString(here.text));
    const Kind* kind = paths.empty() ? nullptr : kindAt(loaded, paths.front());
    if (!here.empty() || !elsewhere.empty())
        mime->setData(QLatin1String(kLibraryMime), jsonOf(kind ? kind->name : "", here, elsewhere, loaded.paths[0]));
    return mime;
}

QMimeData* libraryMime(const LibraryItem& item, const std::string& text) {
    auto* mime = new QMimeData; // no plain text: an editor of text would insert it without its imports, in the middle of a block
    const PasteContents contents{text, item.imports, {}, {}, {}};
    QJsonObject object = QJsonDocument::fromJson(jsonOf(item.kind, contents, contents)).object();
    object.insert(QStringLiteral("title"), item.title);
    object.insert(QStringLiteral("isTemplate"), item.text.empty());
    mime->setData(QLatin1String(kLibraryMime), QJsonDocument(object).toJson(QJsonDocument::Compact));
    return mime;
}

Result<Blocks> blocksIn(const QMimeData& mime, const MayImport& mayImport) {
    if (mime.hasFormat(QLatin1String(kLibraryMime))) {
        const QJsonObject object = QJsonDocument::fromJson(mime.data(QLatin1String(kLibraryMime))).object();
        const auto mayAll = [&](const QString& key) {
            const QJsonArray files = object.value(key).toArray();
            return std::all_of(files.begin(), files.end(), [&](const QJsonValue& file) {
                const QString path = file.toString();
                return !path.startsWith(QLatin1Char('/')) || mayImport(path.toStdString());
            });
        };
        const bool here = mayAll(QStringLiteral("imports")) && mayAll(QStringLiteral("inlined"));
        const QJsonObject contents = here ? object : object.value(QStringLiteral("elsewhere")).toObject();
        Result<Blocks> blocks = blocksFrom(contents.value(QStringLiteral("text")).toString().toStdString());
        if (!blocks) return blocks;
        Blocks all = std::move(blocks).value();
        all.from = object.value(QStringLiteral("from")).toString().toStdString();
        for (const QJsonValue& file : contents.value(QStringLiteral("imports")).toArray())
            all.imports.push_back(file.toString().toStdString());
        for (const QJsonValue& param : contents.value(QStringLiteral("params")).toArray())
            all.params.push_back(param.toString().toStdString());
        for (const QJsonValue& value : contents.value(QStringLiteral("needs")).toArray()) {
            const QJsonObject block = value.toObject();
            all.needs.push_back({block.value(QStringLiteral("path")).toString().toStdString(),
                                 block.value(QStringLiteral("text")).toString().toStdString()});
        }
        return all;
    }
    if (!mime.hasText()) return notBlocks("there is no text to insert");
    const QString text = mime.text();
    if (text.size() > kMaxText) return notBlocks("this text is too long to be inserted");
    return blocksFrom(text.toStdString());
}

} // namespace trundle
