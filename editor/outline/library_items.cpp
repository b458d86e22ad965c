#include "editor/outline/library_items.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <set>

#include <QCoreApplication>

#include "editor/outline/kind_icons.h"
#include "lang/tree.h"
#include "project/loading/import_path.h"
#include "project/loading/search.h"

namespace trundle {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMaxFiles = 300, kMaxBytes = std::size_t{1} << 20, kMaxItems = 200;
constexpr int kMaxDeep = 3, kMaxEntries = 20000; // limits, since a project may be in a home folder

QString titled(const std::string& text) { return QString::fromStdString(text); }

/// Sorted, so that the order in the library is stable.
std::vector<std::string> textsBelow(const std::string& folder, int deep) {
    std::vector<std::string> files;
    std::error_code error;
    fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end;
    int entries = 0;
    for (; !error && at != end && files.size() < kMaxFiles && ++entries < kMaxEntries; at.increment(error)) {
        const std::string name = at->path().filename().string();
        std::error_code none;
        if (at->is_directory(none)) {
            if (name.starts_with(".") || at.depth() >= deep) at.disable_recursion_pending();
        } else if (name.ends_with(".sim")) {
            files.push_back(at->path().string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::shared_ptr<const Tree> treeOf(const std::string& file) {
    Result<std::string> bytes = readFile(file, kMaxBytes);
    return bytes ? parse(std::make_shared<const SourceText>(file, std::move(bytes).value()), 0) : nullptr;
}

/// The text of the first comment if the file begins with it.
std::string firstComment(const Tree& tree) {
    std::string_view line = tree.source().line(1);
    if (line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    if (!line.starts_with("//")) return {};
    line.remove_prefix(2);
    while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
    return std::string(line);
}

std::string relativeTo(const std::string& folder, const std::string& file) {
    return pathBelow(file, std::array{folder}).value_or(file);
}

const char* const kPictureFloor = "\nStaticConfig LibraryFloor { Plane floor { Material=concrete Surface=ground } }\n"
                                  "#import common/materials.sim\n#import common/surfaces.sim\n"
                                  "Static libraryFloor { Config=LibraryFloor }\n";

bool holdsPlane(const BlockItem& config) {
    return std::any_of(config.items.begin(), config.items.end(), [](const Item& item) {
        const auto* block = item.as<BlockItem>();
        return block && block->type.text == "Plane";
    });
}

/// Whether a RobotConfig has bodies alone: a movable object. One with imports in its block may have more.
bool hasOnlyBodies(const BlockItem& config) {
    return config.type.text == "RobotConfig" && std::ranges::none_of(config.items, [](const Item& item) {
               const auto* block = item.as<BlockItem>();
               return item.as<ImportItem>() || (block && block->type.text != "Body");
           });
}

bool isPlaced(const BlockItem& block) {
    const std::string& type = block.type.text;
    return type == "Robot" || type == "Static" || type == "Grid" || type == "Scatter";
}

/// A file with configs, and how to import them.
struct ConfigFile {
    const Tree& tree;
    std::string import; ///< path that an #import uses
    std::string folder; ///< search folder of that path
    std::string stamp;  ///< a comment that changes with the file, so that cached previews are invalidated
    std::vector<const BlockItem*> configs;
    bool places = false; ///< it also contains robots or scenery, which an import would add
};

/// The config itself, with the imports of its file.
std::string copiedText(const ConfigFile& file, const BlockItem& config) {
    std::string text;
    const auto slice = [&](TextRange range) { return std::string(file.tree.source().slice(range)); };
    for (const Item& item : file.tree.items())
        if (item.as<ImportItem>()) text += slice(item.range) + "\n";
    return text + slice({config.type.range.begin, config.close.end}) + "\n";
}

LibraryItem itemOf(const ConfigFile& file, const BlockItem& block) {
    const bool movable = hasOnlyBodies(block), robot = block.type.text == "RobotConfig",
               object = movable || file.import.find("objects/") != std::string::npos;
    const std::string& config = block.name->text;
    LibraryItem item;
    item.section = object ? LibrarySection::Objects : robot ? LibrarySection::Robots : LibrarySection::Arenas;
    item.title = titled(config);
    if (file.configs.size() == 1) item.help = titled(firstComment(file.tree));
    item.icon = QString::fromLatin1(movable ? "kind-object" : robot ? "kind-robot" : "kind-static");
    item.kind = robot ? "Robot" : "Static";
    const std::string before = file.places ? copiedText(file, block) : std::string();
    item.text = before + item.kind + " " + (robot && !object ? "robot0" : nameFor(config)) + " { Config=" + config +
                " Pos=0,0,0 }";
    if (!file.places) item.imports = {file.import};
    item.folder = file.folder;
    item.picture = (file.places ? before : "#import " + file.import + "\n") + item.kind + " shown { Config=" + config + " }" +
                   (holdsPlane(block) ? "" : kPictureFloor) + file.stamp;
    return item;
}

LibrarySection sectionOf(const Kind& kind) {
    switch (kind.role) {
    case Role::Body:
    case Role::Geom: return LibrarySection::Shapes;
    case Role::Joint: return LibrarySection::Joints;
    case Role::Device: return LibrarySection::Devices;
    case Role::Controller: return LibrarySection::Controllers;
    case Role::Material:
    case Role::Surface: return LibrarySection::Looks;
    default: return LibrarySection::World;
    }
}

/// Shapes are shown with their default values.
std::string pictureOf(const Kind& kind) {
    const std::string& name = kind.name;
    const std::string look = " Material=blue Surface=plastic } }\nStatic shown { Config=Shown }" + std::string(kPictureFloor);
    if (name == "Box") return "StaticConfig Shown { Box b { Pos=0,0,0.1 Size=0.3,0.2,0.2" + look;
    if (name == "Sphere") return "StaticConfig Shown { Sphere b { Pos=0,0,0.12 Radius=0.12" + look;
    if (name == "Cylinder") return "StaticConfig Shown { Cylinder b { Pos=0,0,0.13 Radius=0.1 Length=0.26" + look;
    if (name == "Capsule") return "StaticConfig Shown { Capsule b { Pos=0,0,0.16 Radius=0.08 Length=0.16" + look;
    return {};
}

} // namespace

QString sectionTitle(LibrarySection section) {
    switch (section) {
    case LibrarySection::Robots: return QCoreApplication::translate("Library", "Robots");
    case LibrarySection::Arenas: return QCoreApplication::translate("Library", "Arenas");
    case LibrarySection::Objects: return QCoreApplication::translate("Library", "Objects");
    case LibrarySection::RobotParts: return QCoreApplication::translate("Library", "Robot Parts");
    case LibrarySection::Controllers: return QCoreApplication::translate("Library", "Controllers");
    case LibrarySection::Shapes: return QCoreApplication::translate("Library", "Bodies and Shapes");
    case LibrarySection::Joints: return QCoreApplication::translate("Library", "Joints");
    case LibrarySection::Devices: return QCoreApplication::translate("Library", "Sensors and Actuators");
    case LibrarySection::World: return QCoreApplication::translate("Library", "Experiment");
    case LibrarySection::Looks: return QCoreApplication::translate("Library", "Materials and Surfaces");
    }
    return {};
}

std::string nameFor(const std::string& config) {
    std::string name = config;
    if (!name.empty()) name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    return name;
}

std::string pictureOfConfig(const Tree& tree, const BlockItem& config) {
    static const std::set<std::string> kNeeded{"Material", "Surface", "PartConfig", "RobotConfig", "StaticConfig"};
    std::string text;
    for (const Item& item : tree.items()) {
        const auto* block = item.as<BlockItem>();
        if (item.as<ImportItem>() || item.as<ParamItem>() || (block && kNeeded.contains(block->type.text)))
            text += std::string(tree.source().slice(item.range)) + "\n";
    }
    const std::string kind = config.type.text == "RobotConfig" ? "Robot" : "Static";
    return text + kind + " shown { Config=" + config.name->text + " }" + (holdsPlane(config) ? "" : kPictureFloor);
}

std::vector<LibraryItem> configItems(const LibraryFolder& folder, const std::string& except) {
    std::vector<LibraryItem> items;
    for (const std::string& file : textsBelow(folder.path, kMaxDeep)) {
        if (items.size() >= kMaxItems) break;
        if (!except.empty() && canonicalPath(file) == except) continue;
        const auto tree = treeOf(file);
        if (!tree) continue;
        std::error_code none;
        const auto written = fs::last_write_time(file, none).time_since_epoch().count();
        ConfigFile texts{
            *tree, folder.imports + relativeTo(folder.path, file), folder.path, "\n// " + std::to_string(written), {}, false};
        for (const Item& item : tree->items()) {
            const auto* block = item.as<BlockItem>();
            if (!block) continue;
            texts.places |= isPlaced(*block);
            if (block->name && (block->type.text == "RobotConfig" || block->type.text == "StaticConfig"))
                texts.configs.push_back(block);
        }
        for (const BlockItem* block : texts.configs) items.push_back(itemOf(texts, *block));
    }
    return items;
}

std::vector<LibraryItem> snippetItems(const std::string& folder) {
    std::vector<LibraryItem> items;
    for (const std::string& file : textsBelow(folder, 0)) {
        const auto tree = treeOf(file);
        if (!tree) continue;
        LibraryItem item;
        for (const Item& part : tree->items())
            if (const auto* block = part.as<BlockItem>(); block && item.kind.empty()) item.kind = block->type.text;
        if (item.kind.empty()) continue;
        const std::string comment = firstComment(*tree), stem = fs::path(file).stem().string();
        const std::size_t colon = comment.find(':');
        item.section = LibrarySection::RobotParts;
        item.title = colon == std::string::npos ? titled(stem).replace(QLatin1Char('_'), QLatin1Char(' '))
                                                : titled(comment.substr(0, colon));
        item.help = titled(colon == std::string::npos ? comment : comment.substr(std::min(comment.size(), colon + 2)));
        for (QString* text : {&item.title, &item.help})
            if (!text->isEmpty()) (*text)[0] = text->at(0).toUpper();
        item.icon = QStringLiteral("kind-body");
        const std::string_view bytes = tree->source().bytes();
        const std::size_t line = comment.empty() ? 0 : bytes.find('\n') + 1; // the experiment does not contain the title
        item.text = std::string(bytes.substr(line));
        if (item.kind == "Body") {
            item.folder = folder;
            item.picture = "RobotConfig Shown { Body chassis { Sphere s { Radius=0.001 Mass=1 Visible=false } }\n" + item.text +
                           "\n}\nRobot shown { Config=Shown }" + kPictureFloor;
        }
        items.push_back(std::move(item));
    }
    return items;
}

std::vector<LibraryItem> kindItems(const std::vector<const Kind*>& kinds) {
    std::vector<LibraryItem> items;
    for (const Kind* kind : kinds) {
        if (kind->role == Role::Settings) continue;
        LibraryItem item;
        item.section = sectionOf(*kind);
        item.title = titled(kind->name);
        item.help = titled(kind->help);
        item.icon = kindIcon(kind);
        item.kind = kind->name;
        item.picture = pictureOf(*kind);
        items.push_back(std::move(item));
    }
    return items;
}

std::vector<LibraryItem> moduleItems(const std::vector<Kind>& kinds, const std::string& moduleFolder) {
    std::vector<const Kind*> all;
    for (const Kind& kind : kinds) all.push_back(&kind);
    std::vector<LibraryItem> items = kindItems(all);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const fs::path library = relativeTo(moduleFolder, kinds[i].module);
        std::string stem = library.stem().string();
        if (stem.starts_with("lib")) stem = stem.substr(3);
        items[i].imports = {"#loadModule " + (library.parent_path() / stem).generic_string()};
    }
    return items;
}

} // namespace trundle
