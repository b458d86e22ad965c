#include "editor/shell/dialogs/mesh_dialog.h"

#include <algorithm>
#include <utility>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGuiApplication>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "assets/asset_reader.h"
#include "editor/properties/editors/amount_field.h"
#include "editor/shell/dialogs/mesh_preview.h"
#include "editor/shell/dialogs/plan_preview.h"
#include "editor/shell/dialogs/result_label.h"
#include "editor/widgets/strings.h"
#include "editor/widgets/theme.h"
#include "scene/shapes/bounds.h"

namespace trundle {
namespace {

constexpr int kShapeCharacters = 16;
constexpr double kExact = 1e-7;    // m
constexpr double kHullLead = 0.02; // of the radius of the mesh, by which a hull must be nearer to be proposed

AmountField* makeMassField() {
    Property property;
    property.name = MeshDialog::tr("The mass").toStdString();
    property.unit = "kg";
    property.minimum = 1e-6;
    property.maximum = 1e9;
    auto* field = new AmountField(property);
    field->setObjectName(QStringLiteral("meshMass"));
    field->setValue(1);
    return field;
}

QString shapeName(GeomShape shape) {
    switch (shape) {
    case GeomShape::Box: return MeshDialog::tr("Box");
    case GeomShape::Cylinder: return MeshDialog::tr("Cylinder");
    case GeomShape::Sphere: return MeshDialog::tr("Sphere");
    case GeomShape::Capsule: return MeshDialog::tr("Capsule");
    default: return MeshDialog::tr("Convex hull");
    }
}

QString length(double metres) {
    if (metres < kExact) return MeshDialog::tr("0 mm");
    return metres < 0.1 ? MeshDialog::tr("%1 mm").arg(QString::number(metres * 1e3, 'g', 3))
                        : MeshDialog::tr("%1 m").arg(QString::number(metres, 'g', 4));
}

} // namespace

MeshDialog::MeshDialog(Locations locations, const QString& folder, bool isOfBody, QWidget* parent)
    : QDialog(parent), m_locations(std::move(locations)), m_projectFolder(folder), m_isOfBody(isOfBody), m_file(new QLineEdit),
      m_unit(new QComboBox), m_up(new QComboBox), m_shape(new QComboBox), m_mass(makeMassField()),
      m_preview(new MeshPreview("meshPreview")), m_result(new ResultLabel("meshResult")) {
    setObjectName(QStringLiteral("meshDialog"));
    setWindowTitle(tr("Mesh from File"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_file->setObjectName(QStringLiteral("meshFile"));
    m_file->setPlaceholderText(tr("OBJ, STL, COLLADA, glTF or GLB"));
    constexpr int kFrame = 16; // left and right of the text
    m_file->setMinimumWidth(m_file->fontMetrics().horizontalAdvance(m_file->placeholderText()) + scaledToFont(kFrame));
    m_unit->setObjectName(QStringLiteral("meshUnit"));
    for (const auto& [name, metres] :
         {std::pair(tr("Metres"), 1.), {tr("Centimetres"), 0.01}, {tr("Millimetres"), 0.001}, {tr("Inches"), 0.0254}})
        m_unit->addItem(name, metres);
    m_up->setObjectName(QStringLiteral("meshUp"));
    m_up->addItems({tr("z"), tr("y")});
    m_shape->setObjectName(QStringLiteral("meshShape"));
    m_shape->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_shape->setMinimumContentsLength(kShapeCharacters);
    m_mass->setParent(this);
    m_mass->setVisible(isOfBody);
    makeLayout();
    connect(m_file, &QLineEdit::textChanged, this, &MeshDialog::read);
    for (QComboBox* box : {m_unit, m_up}) connect(box, &QComboBox::currentIndexChanged, this, &MeshDialog::place);
    connect(m_shape, &QComboBox::currentIndexChanged, this, &MeshDialog::check);
    connect(m_mass, &AmountField::changed, this, &MeshDialog::check);
    connect(m_mass, &AmountField::submitted, m_insert, [this] { m_insert->click(); });
    read();
    m_file->setFocus();
}

QString MeshDialog::file() const { return QFileInfo(m_file->text().trimmed()).absoluteFilePath(); }

void MeshDialog::makeLayout() {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* browse = new QToolButton;
    browse->setText(QStringLiteral("…"));
    browse->setToolTip(tr("Choose the mesh"));
    connect(browse, &QToolButton::clicked, this, &MeshDialog::choose);
    layout->addWidget(m_file, 1);
    layout->addWidget(browse);
    auto* label = new QLabel(tr("&File"));
    label->setBuddy(m_file);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->addRow(label, row);
    form->addRow(tr("&Unit of the file"), m_unit);
    form->addRow(tr("U&p axis"), m_up);
    form->addRow(tr("&Collides as"), m_shape);
    if (m_isOfBody) form->addRow(m_mass->makeLabel(tr("&Mass")), m_mass);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(16);
    middle->addLayout(form, 1);
    middle->addWidget(m_preview);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_insert = buttons->addButton(tr("Insert"), QDialogButtonBox::AcceptRole);
    m_insert->setObjectName(QStringLiteral("meshInsert"));
    m_insert->setDefault(true);
    auto* all = new QVBoxLayout(this);
    all->addLayout(middle, 1);
    all->addWidget(m_result);
    all->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void MeshDialog::choose() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Mesh from File"), m_projectFolder,
                                                      tr("Meshes (*.obj *.stl *.dae *.gltf *.glb);;All files (*)"));
    if (!file.isEmpty()) m_file->setText(file);
}

void MeshDialog::read() {
    m_mesh.reset();
    m_unreadable.clear();
    m_shape->clear();
    if (const QString name = m_file->text().trimmed(); QFileInfo(name).isFile()) {
        auto read = AssetReader(m_locations.meshReader).mesh(file().toStdString());
        if (read) m_mesh = std::move(read).value();
        else m_unreadable = toQString(read.error().message);
    } else if (!name.isEmpty()) {
        m_unreadable = tr("There is no file %1.").arg(name);
    }
    place();
}

/// In metres, z up, on the floor.
void MeshDialog::place() {
    m_placed = {};
    m_fits.clear();
    m_hulls.reset();
    if (m_mesh) {
        m_placed = *m_mesh;
        const double scale = m_unit->currentData().toDouble();
        Bounds bounds;
        for (auto& p : m_placed.points) {
            if (m_up->currentIndex() == 1) p = {p[0], -p[2], p[1]};
            for (double& number : p) number *= scale;
            bounds.add(Vec3(p.data()));
        }
        m_origin = {-bounds.centre().x(), -bounds.centre().y(), -bounds.low.z()};
        for (auto& p : m_placed.points)
            for (std::size_t k = 0; k < 3; ++k) p[k] += m_origin[k];
        m_fits = fitsAround(m_placed);
    }
    listShapes();
    check();
}

/// Each with its error. The one that was chosen stays; else the nearest simple one is proposed, or the hull where that is much nearer.
void MeshDialog::listShapes() {
    const QSignalBlocker quiet(m_shape);
    const int before = m_shape->currentIndex();
    m_shape->clear();
    Bounds bounds;
    for (const auto& p : m_placed.points) bounds.add(Vec3(p.data()));
    int nearest = 0;
    for (const MeshFit& fit : m_fits) {
        m_shape->addItem(tr("%1: %2, mean %3").arg(shapeName(fit.geom.shape), length(fit.largest), length(fit.mean)));
        const double lead = fit.geom.shape == GeomShape::Convex ? kHullLead * bounds.radius() : 0;
        if (fit.mean + lead < m_fits[std::size_t(nearest)].mean) nearest = m_shape->count() - 1;
    }
    if (!m_fits.empty() && m_fits.back().geom.shape == GeomShape::Convex) m_shape->addItem(tr("Several hulls"));
    m_shape->setEnabled(!m_fits.empty());
    if (!m_fits.empty()) m_shape->setCurrentIndex(before >= 0 && before < m_shape->count() ? before : nearest);
}

bool MeshDialog::wantsHulls() const { return !m_fits.empty() && m_shape->currentIndex() == int(m_fits.size()); }

const ConvexParts* MeshDialog::hulls() const { return wantsHulls() && m_hulls && !m_hulls->hulls.empty() ? &*m_hulls : nullptr; }

/// Takes up to a few seconds, so it waits until it is chosen.
void MeshDialog::computeHulls() {
    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
    m_hulls = convexPartsOf(m_placed);
    QGuiApplication::restoreOverrideCursor();
    m_shape->setItemText(
        m_shape->currentIndex(),
        tr("%1 hulls: %2, mean %3").arg(QString::number(m_hulls->hulls.size()), length(m_hulls->largest), length(m_hulls->mean)));
}

void MeshDialog::showShapes() {
    std::vector<GeomSpec> shapes;
    if (const ConvexParts* several = hulls()) {
        for (const TriangleMesh& hull : several->hulls) {
            GeomSpec geom;
            geom.shape = GeomShape::Convex;
            geom.mesh = std::make_shared<const TriangleMesh>(hull);
            shapes.push_back(std::move(geom));
        }
    } else if (const MeshFit* chosen = fit()) {
        shapes.push_back(chosen->geom);
    }
    if (shapes.empty()) m_preview->setText(tr("z is up."));
    else m_preview->show(m_placed, shapes);
}

const MeshFit* MeshDialog::fit() const {
    const int index = m_shape->currentIndex();
    return index >= 0 && index < int(m_fits.size()) ? &m_fits[std::size_t(index)] : nullptr;
}

void MeshDialog::check() {
    QString fault = m_unreadable;
    if (fault.isEmpty() && m_isOfBody && !m_mass->value()) fault = m_mass->fault();
    if (wantsHulls() && !m_hulls) computeHulls();
    m_insert->setEnabled(fault.isEmpty() && (fit() || hulls()));
    showShapes();
    m_result->show(fault.isEmpty() ? sentence() : fault, !fault.isEmpty());
}

QString MeshDialog::sentence() const {
    if (!m_mesh) return tr("Choose a mesh. It is drawn as it is; a simple shape around it collides, which is fast and steady.");
    Bounds bounds;
    for (const auto& p : m_placed.points) bounds.add(Vec3(p.data()));
    const Vec3 size = bounds.size();
    QString text = tr("%1 triangles, %2 × %3 × %4.")
                       .arg(QString::number(m_placed.triangles.size()), length(size.x()), length(size.y()), length(size.z()));
    if (const ConvexParts* several = hulls())
        text +=
            QLatin1Char(' ') + tr("Its surface is at most %1 away from those of %2 hulls that collide, on average %3.")
                                   .arg(length(several->largest), QString::number(several->hulls.size()), length(several->mean));
    if (const MeshFit* chosen = fit())
        text += QLatin1Char(' ') + tr("Its surface is at most %1 away from the shape that collides, on average %2.")
                                       .arg(length(chosen->largest), length(chosen->mean));
    if (!file().startsWith(m_projectFolder + QLatin1Char('/')))
        text += QLatin1Char(' ') + tr("It is copied to %1, with its textures.").arg(m_projectFolder + QStringLiteral("/meshes"));
    return text;
}

MeshPart MeshDialog::part(const std::string& written) const {
    MeshPart part;
    part.name = meshName(written);
    part.file = written;
    part.scale = m_unit->currentData().toDouble();
    part.isYUp = m_up->currentIndex() == 1;
    part.origin = m_origin;
    part.hasOwnLook = m_mesh && m_mesh->look;
    if (m_isOfBody) part.surface = "plastic", part.mass = m_mass->value();
    if (const ConvexParts* several = hulls()) {
        part.shape.kind = CollisionShape::Kind::Hulls;
        part.shape.volumes = several->volumes;
        return part;
    }
    const GeomSpec& geom = fit()->geom;
    part.shape.kind = static_cast<CollisionShape::Kind>(m_shape->currentIndex());
    part.shape.centre = {geom.pose.position.x(), geom.pose.position.y(), geom.pose.position.z()};
    const Vec3 axis = (geom.pose.rotation * Vec3::UnitZ()).cwiseAbs();
    axis.maxCoeff(&part.shape.axis);
    part.shape.size = {geom.size.x(), geom.size.y(), geom.size.z()};
    part.shape.radius = geom.radius, part.shape.length = geom.length;
    return part;
}

} // namespace trundle
