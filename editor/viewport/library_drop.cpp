#include "editor/viewport/library_drop.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMimeData>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/viewport/shown_world.h"
#include "editor/viewport/view.h"
#include "editor/viewport/view_settings.h"
#include "lang/number_text.h"
#include "lang/tree_edit.h"

namespace trundle {
namespace {

const QString kMime = QStringLiteral("application/x-trundle-library");
constexpr double kDefaultStep = 0.01; // m, where nothing snaps

QString trDrop(const char* text) { return QCoreApplication::translate("LibraryDrop", text); }

struct Cargo {
    std::string kind, text;
    std::vector<std::string> imports;
};

std::optional<Cargo> cargoOf(const QMimeData& data) {
    const QJsonObject json = QJsonDocument::fromJson(data.data(kMime)).object();
    Cargo cargo{json.value(QStringLiteral("kind")).toString().toStdString(),
                json.value(QStringLiteral("text")).toString().toStdString(),
                {}};
    for (const QJsonValue& file : json.value(QStringLiteral("imports")).toArray())
        cargo.imports.push_back(file.toString().toStdString());
    if (cargo.text.empty()) return std::nullopt;
    return cargo;
}

std::shared_ptr<const Tree> treeOf(const std::string& text) {
    return parse(std::make_shared<const SourceText>("block", text), 0);
}

/// The block that is placed; what stands beside it (the config of a robot, say) comes along.
const BlockItem* blockOf(const Tree& tree, std::string_view kind) {
    for (const Item& item : tree.items())
        if (const auto* block = item.as<BlockItem>(); block && block->type.text == kind) return block;
    return nullptr;
}

const AssignmentItem* assignmentOf(const BlockItem& block, std::string_view key) {
    for (const Item& item : block.items)
        if (const auto* a = item.as<AssignmentItem>(); a && a->path.size() == 1 && a->path[0].text == key) return a;
    return nullptr;
}

double numberIn(const BlockItem& block, std::string_view key, std::size_t index) {
    const AssignmentItem* a = assignmentOf(block, key);
    return a && index < a->value.elements.size() ? a->value.elements[index].number : 0;
}

/// How far the middle of a shape stands above what it lies on, where its own numbers say so.
double restingHeight(const std::string& kind, const BlockItem& block) {
    if (kind == "Box") return 0.5 * numberIn(block, "Size", 2);
    if (kind == "Sphere") return numberIn(block, "Radius", 0);
    if (kind == "Cylinder") return 0.5 * numberIn(block, "Length", 0);
    if (kind == "Capsule") return 0.5 * numberIn(block, "Length", 0) + numberIn(block, "Radius", 0);
    return 0;
}

std::string withPos(const std::string& text, std::string_view kind, const Vec3& pos) {
    const auto tree = treeOf(text);
    const BlockItem* block = blockOf(*tree, kind);
    if (!block) return text;
    std::string value;
    for (int k = 0; k < 3; ++k) value += (k ? "," : "") + steppedNumber(pos[k], 1e-6);
    const AssignmentItem* a = assignmentOf(*block, "Pos");
    const TextEdit edit = a ? editSetValue(*tree, a->value, value) : editAddAssignment(*tree, block, "Pos", value);
    const Result<std::string> changed = applyEdits(text, std::span(&edit, 1));
    return changed ? changed.value() : text;
}

/// What a drop falls on.
struct Ground {
    Vec3 point = Vec3::Zero();
    std::optional<ObjectRef> geom;
};

class Drop {
public:
    Drop(View& view, Cargo cargo, Ground ground) : m_view(view), m_cargo(std::move(cargo)), m_ground(std::move(ground)) {}

    void carryOut() {
        Document& document = m_view.parts().document;
        const Kind* kind = document.loaded()->registry->find(m_cargo.kind);
        if (!kind && m_cargo.imports.empty())
            return refuse(trDrop("Nothing is known of %1 here.").arg(QString::fromStdString(m_cargo.kind)));
        if (!kind || kind->role == Role::Controller) return dropController();
        if (kind->role == Role::Material && dropMaterial()) return;
        std::string parent;
        if (kind->role == Role::Instance || kind->role == Role::Layout) {
            place(Pose{}, 0);
        } else if (kind->role == Role::Geom || kind->role == Role::Body) {
            const auto owner = ownerFor(*kind);
            if (!owner) return;
            parent = *owner;
        } else if (const RobotSpec* robot = robotUnder(); robot && robot->config && kind->role != Role::Material) {
            parent = "RobotConfig." + robot->config->name;
        }
        const QString title = trDrop("Insert %1").arg(QString::fromStdString(m_cargo.kind));
        (void)document.carryOut(title, planInsert(*document.loaded(), parent, m_cargo.text, m_cargo.imports));
    }

private:
    /// Of a module that may not be loaded yet: its cargo says which.
    void dropController() {
        const RobotSpec* robot = robotUnder();
        if (!robot) return refuse(trDrop("A controller drives a robot: drop it onto one."));
        Document& document = m_view.parts().document;
        (void)document.carryOut(trDrop("Insert %1").arg(QString::fromStdString(m_cargo.kind)),
                                planInsert(*document.loaded(), robot->name, m_cargo.text, m_cargo.imports));
    }

    void refuse(const QString& why) { Q_EMIT m_view.parts().document.refused(why); }

    [[nodiscard]] const RobotSpec* robotUnder() const {
        return m_ground.geom ? m_view.parts().world.objects()->robotOf(*m_ground.geom) : nullptr;
    }

    void place(const Pose& frame, double lift) {
        const ViewSettings& settings = m_view.parts().settings;
        Vec3 at = m_ground.point + Vec3(0, 0, lift);
        const double step = settings.snaps() ? settings.moveStep() : kDefaultStep;
        for (int k = 0; k < 2; ++k) at[k] = step * std::round(at[k] / step);
        m_cargo.text = withPos(m_cargo.text, m_cargo.kind, frame.inverse() * at);
    }

    /// The path of the config (or body in it) that a shape or body goes into.
    std::optional<std::string> ownerFor(const Kind& kind) {
        const ShownWorld& world = m_view.parts().world;
        const auto tree = treeOf(m_cargo.text);
        const BlockItem* block = blockOf(*tree, m_cargo.kind);
        const double lift = block ? restingHeight(m_cargo.kind, *block) : 0;
        if (const RobotSpec* robot = robotUnder(); robot && robot->config) {
            const ObjectRef body = *world.objects()->ownerOf(*m_ground.geom);
            const std::string config = "RobotConfig." + robot->config->name;
            const bool intoBody = kind.role == Role::Geom;
            place(world.poseOf(intoBody ? body : ObjectRef{ObjectKind::Robot, body.instance}), lift);
            return intoBody ? config + "." + robot->config->bodies[body.body].name : config;
        }
        const StaticSpec* fixed = m_ground.geom ? world.objects()->staticOf(*m_ground.geom) : nullptr;
        if (fixed && kind.role == Role::Geom) {
            place(fixed->pose, lift);
            return "StaticConfig." + fixed->configName;
        }
        refuse(kind.role == Role::Geom ? trDrop("A shape is part of a robot or an arena: drop it onto one.")
                                       : trDrop("A body is part of a robot: drop it onto one."));
        return std::nullopt;
    }

    /// Onto a shape: the shape gets it. The material comes in by the import that holds it, or as a block of its own.
    bool dropMaterial() {
        if (!m_ground.geom) return false;
        Document& document = m_view.parts().document;
        const auto tree = treeOf(m_cargo.text);
        const BlockItem* block = blockOf(*tree, m_cargo.kind);
        if (!block || !block->name) return false;
        const std::string key = "drop " + std::to_string(document.revision());
        const QString title = trDrop("Use material %1").arg(QString::fromStdString(block->name->text));
        if (!document.loaded()->outline->materials.find(block->name->text) &&
            !document.carryOut(title, planInsert(*document.loaded(), {}, m_cargo.text, m_cargo.imports), key))
            return true;
        const std::string path = m_view.parts().world.objects()->pathOf(*m_ground.geom);
        if (!document.setValues(title, {{path + ".Material", block->name->text}}, key)) document.withdraw(key);
        document.endMerge();
        return true;
    }

    View& m_view;
    Cargo m_cargo;
    Ground m_ground;
};

} // namespace

bool canDrop(const QMimeData& data) { return data.hasFormat(kMime); }

void dropBlocks(View& view, const QMimeData& data, const QPointF& at) {
    const auto cargo = cargoOf(data);
    if (!cargo || !view.parts().document.isOpen()) return;
    const std::vector<RayHit> hits = view.parts().world.hitsAlong(view.rayAt(at), true);
    Ground ground{view.pointUnder(at), std::nullopt};
    if (!hits.empty()) ground.geom = hits.front().geom;
    Drop(view, *cargo, ground).carryOut();
}

} // namespace trundle
