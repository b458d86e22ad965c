#pragma once
// One vehicle in one tick: its supports as rows of a Gauss-Seidel solver.
//
// Needs: the unit, its supports and wheels as the last tick left them.
// Method: one rigid body with six degrees of freedom and the spin of each wheel, in the axes of its heading. Each support has a soft normal
//   row; friction and the motor of a wheel are one block, solved exactly inside the friction cone. Rows start with the impulses of the last
//   tick. Every second sweep runs backwards, so that left and right are treated alike.
// Result: velocities and impulses, written back by finish().

#include <array>

#include "world/wheeled/motor_law.h"
#include "world/wheeled/wheeled_objects.h"

namespace trundle {

class VehicleRows {
public:
    void prepare(const WheeledObjects& objects, std::uint32_t unit, const Vec3& gravity, double h);
    /// The largest change of an impulse, N s.
    double sweep(bool backwards);
    void finish(WheeledObjects& objects) const;

    /// Speed of a point of the vehicle along a level direction, and what an impulse there does. Vectors from the centre of mass, world axes.
    struct Push {
        std::array<double, 5> row{}, change{}; ///< vx, vy, wx, wy, wz
    };
    [[nodiscard]] Push pushAt(const Vec3& arm, const Vec2& way) const;
    [[nodiscard]] double* velocities() { return m_v.data(); } ///< that a Push is of

private:
    struct Normal {
        double ax = 0, ay = 0;      ///< arm
        Vec3 change = Vec3::Zero(); ///< of the angular velocity per impulse
        double inverse = 0, bias = 0, soft = 0, impulse = 0;
    };
    struct Way { ///< a direction of friction
        double x = 0, y = 0;
        Vec3 arm = Vec3::Zero(), change = Vec3::Zero(); ///< of the angular velocity
        double mass = 0;                                ///< inverse, without the wheel: 1/kg
    };
    struct Friction {
        Way along, across;
        double coupling = 0, limit = 0, lever = 0; ///< limit: of the load
        double alongImpulse = 0, acrossImpulse = 0;
        std::uint32_t wheel = 0;
        bool round = true;
    };

    void setAxes(const WheeledUnit& unit);
    void addSupport(const Support& support, const SupportState& state, double friction, double h);
    void addWheels(const WheeledObjects& objects, const WheeledUnit& unit, double h);
    [[nodiscard]] Way wayOf(const Vec3& arm, double x, double y) const;
    [[nodiscard]] double speed(const Way& way) const;
    void apply(const Way& way, double impulse);
    [[nodiscard]] double solveNormal(Normal& row);
    [[nodiscard]] double solveFriction(Friction& row, double load);
    [[nodiscard]] double solveAlong(const Friction& row, double speed, double& mass) const;

    const ActorShape* m_shape = nullptr;
    std::uint32_t m_unit = 0;
    double m_h = 0, m_inverseMass = 0, m_c = 1, m_s = 0;
    Mat3 m_inverse = Mat3::Identity(); ///< inertia's, in the axes of the heading
    Mat3 m_axes = Mat3::Identity();    ///< of the vehicle, in those of the heading
    std::array<double, 6> m_v{};       ///< vx, vy, wx, wy, wz, vz
    std::size_t m_count = 0, m_wheelCount = 0;
    std::array<Normal, kMostSupports> m_normals;
    std::array<Friction, kMostSupports> m_frictions;
    std::array<double, kMostSupports> m_momenta{}; ///< of wheels, without their motors
    std::array<MotorLaw, kMostSupports> m_motors;
};

} // namespace trundle
