#pragma once
#include <string>

#include <QObject>

#include "editor/widgets/preferences.h"
#include "render/look_choice.h"

namespace trundle {

enum class Tool { Select, Move, Rotate, Scale, Measure, DrawWalls, DrawLine, DrawRoom, Connect };
/// Axes that the gizmo is aligned to.
enum class AxesOf { World, Parent, Local };

/// Overlays of a view.
enum Overlay : unsigned {
    kOverlayGrid = 1u << 0, ///< grid lines of the floor, and the scale bar
    kOverlayNames = 1u << 1,
    kOverlayJoints = 1u << 2,
    kOverlayContacts = 1u << 3,
    kOverlayMass = 1u << 4, ///< centres of mass
    kOverlayCollision = 1u << 5,
    kOverlayTrails = 1u << 6,
    kOverlayShadows = 1u << 7,
    kOverlayWireframe = 1u << 8,
    kOverlayFrusta = 1u << 9,    ///< camera frusta
    kOverlayLobes = 1u << 10,    ///< antenna lobes
    kOverlayLinks = 1u << 11,    ///< radio links
    kOverlayCoverage = 1u << 12, ///< radio coverage on the floor
    kOverlayBeams = 1u << 13,    ///< what range sensors measure
    kOverlayInertia = 1u << 14,  ///< solid ellipsoids of the same mass and inertia
    kOverlaySupport = 1u << 15,  ///< support polygons
};

/// Settings shared by all views of a panel.
class ViewSettings final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    [[nodiscard]] Tool tool() const { return m_tool; }
    /// The kind of joint that Connect inserts: "Hinge".
    [[nodiscard]] const std::string& jointKind() const { return m_jointKind; }
    [[nodiscard]] AxesOf axes() const { return m_axes; }
    [[nodiscard]] bool snaps() const { return m_snaps; }
    [[nodiscard]] double moveStep() const { return m_moveStep; }         ///< m
    [[nodiscard]] double rotationStep() const { return m_rotationStep; } ///< degrees
    [[nodiscard]] LookChoice look() const { return m_look; }
    [[nodiscard]] NavigationStyle navigation() const { return m_navigation; }
    [[nodiscard]] bool shows(Overlay overlay) const { return (m_overlays & overlay) != 0; }

    void setTool(Tool tool) { set(m_tool, tool); }
    void setJointKind(const std::string& kind) { set(m_jointKind, kind); }
    void setAxes(AxesOf axes) { set(m_axes, axes); }
    void setSnaps(bool snaps) { set(m_snaps, snaps); }
    void setLook(LookChoice look) { set(m_look, look); }
    void setNavigation(NavigationStyle style) { set(m_navigation, style); }
    /// Steps that are not positive are ignored.
    void setSteps(double moveM, double turnDegrees);
    /// Restores the settings of the user's last window and saves every further change. Excludes the tool, and the navigation
    /// style, which is a preference.
    void keepBetweenStarts();
    void show(Overlay overlay, bool shown) { set(m_overlays, shown ? m_overlays | overlay : m_overlays & ~unsigned(overlay)); }

Q_SIGNALS:
    void changed();

private:
    template <class T> void set(T& member, T value) {
        if (member == value) return;
        member = value;
        Q_EMIT changed();
    }
    Tool m_tool = Tool::Select;
    std::string m_jointKind = "Hinge";
    AxesOf m_axes = AxesOf::World;
    LookChoice m_look = LookChoice::Automatic;
    NavigationStyle m_navigation = NavigationStyle::Trundle;
    bool m_snaps = true;
    double m_moveStep = 0.05, m_rotationStep = 15;
    unsigned m_overlays = kOverlayGrid | kOverlayShadows;
};

} // namespace trundle
