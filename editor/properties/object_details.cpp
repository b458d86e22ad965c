#include "editor/properties/object_details.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "editor/properties/motor_curve.h"
#include "editor/properties/section.h"
#include "editor/running/session.h"
#include "lang/number_text.h"
#include "model/dotted_path.h"
#include "scene/queries/balance.h"

namespace trundle {
namespace {

QString threeDigits(double value) { return QString::number(value, 'g', 3); }

QString inMetres(const Vec3& v) {
    QStringList numbers;
    for (int k = 0; k < 3; ++k) numbers << QString::fromStdString(steppedNumber(v[k], 1e-4));
    return ObjectDetails::tr("%1 m").arg(numbers.join(QStringLiteral(", ")));
}

QString inertiaText(const MassProperties& mass) {
    const Vec3 moments = ellipsoidOf(mass).moments;
    return ObjectDetails::tr("%1, %2, %3 kg m²")
        .arg(threeDigits(moments.x()), threeDigits(moments.y()), threeDigits(moments.z()));
}

/// The robot or body of a path; of a config its first instance.
std::optional<ObjectRef> objectOf(const ObjectIndex& objects, const std::string& path) {
    if (const auto object = objects.find(path)) return object;
    const std::string_view inside = withoutFirstWord(path);
    if (firstWord(path) != "RobotConfig" || inside.empty()) return std::nullopt;
    for (const RobotSpec& robot : objects.experiment().robots)
        if (robot.config && robot.config->name == firstWord(inside)) {
            const std::string_view rest = withoutFirstWord(inside);
            return objects.find(rest.empty() ? robot.name : pathInside(robot.name, rest));
        }
    return std::nullopt;
}

} // namespace

ObjectDetails::ObjectDetails(QWidget* parent)
    : QWidget(parent), m_motor(new Section(tr("Motor curve"), true, this)),
      m_mass(new Section(tr("Mass properties"), true, this)), m_curve(new MotorCurve(m_motor->rows())),
      m_lines(new QWidget(m_mass->rows())), m_grid(new QGridLayout(m_lines)) {
    setObjectName(QStringLiteral("objectDetails"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(0);
    column->addWidget(m_motor);
    column->addWidget(m_mass);
    m_motor->add(m_curve);
    m_mass->add(m_lines);
    m_lines->setObjectName(QStringLiteral("massLines"));
    m_grid->setContentsMargins(10, 2, 6, 6);
    m_grid->setVerticalSpacing(3);
    m_grid->setColumnStretch(1, 1);
    hide();
}

void ObjectDetails::display(const std::string& path, const std::shared_ptr<const LoadedProject>& loaded,
                            const RunSession* session) {
    const auto motor = path.empty() ? std::nullopt : motorCharacteristic(*loaded, path);
    m_isMotor = motor.has_value();
    if (motor) {
        m_motor->setTitle(motor->voltage > 0 ? tr("Motor curve at %1 V").arg(threeDigits(motor->voltage)) : tr("Motor curve"));
        m_curve->display(*motor);
    }
    m_motor->setVisible(motor.has_value());
    const Lines lines = path.empty() ? Lines() : massLines(path, *loaded, session);
    showMass(lines);
    m_mass->setVisible(!lines.empty());
    setVisible(motor || !lines.empty());
}

/// Of a body in its own frame, of a robot in that of its config, at the start.
ObjectDetails::Lines ObjectDetails::massLines(const std::string& path, const LoadedProject& loaded, const RunSession* session) {
    const auto experiment = session ? session->source().shown() : loaded.experiment;
    if (!experiment) return {};
    const ObjectIndex objects(experiment);
    const auto object = objectOf(objects, path);
    if (!object || (object->kind != ObjectKind::Robot && object->kind != ObjectKind::Body)) return {};
    const RobotSpec* robot = objects.robotOf(*object);
    if (!robot || !robot->config || robot->scenery) return {};
    if (object->kind == ObjectKind::Body) {
        const MassProperties& mass = robot->config->bodies[object->body].mass;
        if (!(mass.mass > 0)) return {};
        return {{tr("Mass"), tr("%1 kg").arg(threeDigits(mass.mass))},
                {tr("Centre"), inMetres(mass.centre)},
                {tr("Inertia"), inertiaText(mass)}};
    }
    const BodyPoses poses = startPoses(*experiment);
    const MassProperties mass = massOf(objects, object->instance, poses);
    if (!(mass.mass > 0)) return {};
    Lines lines{{tr("Total mass"), tr("%1 kg").arg(QString::fromStdString(steppedNumber(mass.mass, 1e-3)))},
                {tr("Centre"), inMetres(robot->pose.inverse() * mass.centre)},
                {tr("Inertia"), inertiaText(mass)}};
    const auto balance = balanceOf(objects, object->instance, poses);
    if (balance) lines.push_back({tr("On level ground"), QString::fromStdString(balanceText(*balance))});
    if (balance && balance->isStable())
        lines.push_back(
            {tr("Tips on slopes"), QString::fromStdString(tippingText(*balance, hprFromRotation(robot->pose.rotation).x()))});
    return lines;
}

void ObjectDetails::showMass(const Lines& lines) {
    for (int row = 0; row < std::max(int(lines.size()), m_grid->count() / 2); ++row) {
        if (!m_grid->itemAtPosition(row, 0)) {
            auto *name = new QLabel(m_lines), *value = new QLabel(m_lines);
            name->setForegroundRole(QPalette::PlaceholderText);
            value->setWordWrap(true);
            value->setTextInteractionFlags(Qt::TextSelectableByMouse);
            value->setObjectName(QStringLiteral("massValue%1").arg(row));
            m_grid->addWidget(name, row, 0, Qt::AlignTop);
            m_grid->addWidget(value, row, 1, Qt::AlignTop);
        }
        const bool isUsed = row < int(lines.size());
        auto* name = static_cast<QLabel*>(m_grid->itemAtPosition(row, 0)->widget());
        auto* value = static_cast<QLabel*>(m_grid->itemAtPosition(row, 1)->widget());
        if (isUsed) name->setText(lines[std::size_t(row)].first);
        if (isUsed) value->setText(lines[std::size_t(row)].second);
        name->setVisible(isUsed);
        value->setVisible(isUsed);
    }
}

} // namespace trundle
