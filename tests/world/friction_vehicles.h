#pragma once
// What vehicles do whose wheels slip, against Coulomb friction.

#include "world/friction_cases.h"

namespace fixture {

/// Some wheels driven at a steady rate that keeps them slipping: the acceleration between two times. `sign` -1: backwards.
inline Measure startsOff(Vehicle v, double angle, double sign, double drop = 0) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        scene.spec->settings.gravity = slopeGravity(angle, 180);
        Vehicle copy = v;
        addVehicle(scene, copy, drop);
        scene.scenery({plane("floor", {}, copy.ground)});
        auto world = scene.build(beltOrRow);
        if (!world) return {};
        driveAll(*world, copy, sign * 10 / v.radius);
        const double settle = drop > 0 ? 0 : 0.3;
        if (settle > 0 && !run(*world, settle)) return {};
        const double v0 = velocity(*world, "v/chassis").x(), t0 = world->time();
        if (!run(*world, 0.51 + drop)) return {};
        const double a = (velocity(*world, "v/chassis").x() - v0) / (world->time() - t0);
        return {sign * a, copy.traction(angle, sign) - g * std::sin(rad(angle))};
    };
}

/// Braking with locked wheels.
inline Measure stops(Vehicle v, double speed) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        Vehicle copy = v;
        addVehicle(scene, copy, 0);
        scene.scenery({plane("floor", {}, copy.ground)});
        auto world = scene.build(beltOrRow);
        if (!world) return {};
        driveAll(*world, copy, speed / v.radius);
        if (!run(*world, 1.5)) return {};
        driveAll(*world, copy, 0);
        if (!run(*world, 0.06)) return {};
        const double v0 = velocity(*world, "v/chassis").x(), t0 = world->time();
        const double span = std::round(0.5 * speed / (v.friction * g) / 0.03) * 0.03;
        if (!run(*world, span)) return {};
        return {(v0 - velocity(*world, "v/chassis").x()) / (world->time() - t0), copy.traction(0, -1)};
    };
}

/// Skid steering on four wheels or on the corners of two tracks: the steady turn rate from the balance of moments.
inline double skidRate(const std::vector<Eigen::Vector2d>& points, double speed) {
    double low = 0, high = 50;
    for (int i = 0; i < 100; ++i) {
        const double w = (low + high) / 2;
        double moment = 0;
        for (const Eigen::Vector2d& p : points) {
            const double belt = p.y() > 0 ? -speed : speed;
            const Eigen::Vector2d slip(-w * p.y() - belt, w * p.x());
            moment += (p.x() * -slip.y() + p.y() * slip.x()) / std::max(1e-12, slip.norm());
        }
        (moment > 0 ? low : high) = w;
    }
    return low;
}

/// Mean turn rate about z over some seconds, in rad/s; empty where the run fails.
inline std::optional<double> turnRate(World& world, const char* body, double seconds) {
    const int n = static_cast<int>(std::lround(seconds / world.experiment().settings.tick));
    double turned = 0;
    for (int i = 0; i < n; ++i) {
        if (!world.tick()) return std::nullopt;
        turned += spin(world, body).z();
    }
    return turned / n;
}

inline Measure skidSteers(Vehicle v, double speed) {
    return [=](const Conditions& c) -> Figures {
        Vehicle copy = v;
        Scene scene = sceneOf(c);
        addVehicle(scene, copy, 0);
        scene.scenery({plane("floor", {}, copy.ground)});
        auto world = scene.build(beltOrRow);
        if (!world) return {};
        std::vector<Eigen::Vector2d> points;
        for (std::size_t i = 0; i < copy.wheels.size(); ++i) {
            const Vec3& at = copy.wheels[i];
            drive(*world, copy, i, (at.y() > 0 ? -1 : 1) * speed / v.radius);
            points.push_back({at.x() - copy.centre.x(), at.y()});
        }
        if (!run(*world, 1.5)) return {};
        const std::optional<double> rate = turnRate(*world, "v/chassis", 1.5);
        if (!rate) return {};
        return {*rate, skidRate(points, speed)};
    };
}

} // namespace fixture
