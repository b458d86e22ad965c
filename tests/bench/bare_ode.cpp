// The minimum that a simulator on ODE must do for N shipped robots (configs/robots/simple_robot.sim) in a walled room: no text, no
// signals, no devices, no controllers. The time that Trundle takes beyond this is its overhead.
//
// Needs: ODE in double precision. Assumes: Trundle's settings, written out below. Method: per tick new wheel rates along ramps, ground
// contacts computed, a uniform grid for pairs of robots, ODE's colliders only for boxes and tyres that may touch, dWorldStep.
// Data: one array of robots; contacts are made in the order of robots.
//
// Both follow the same paths until the first collision and have similar contact counts after it: `x` and `y` of the first robot and the contacts per robot and tick are printed for comparison.
//
//   bare_ode -n 100 -t 20 -h 0.01 [-nx 10 -ny 10]     prints one line: rtf=... us_per_robot_tick=... contacts_per_robot=... x=... y=... kb=...

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <ode/ode.h>

#include "bench/crowd.h"

namespace {

using namespace crowd;

// Settings of Trundle.
constexpr double kStiffness = 2e5, kDamping = 1100;
constexpr int kMaxOfRobots = 2, kMaxOfWalls = 4;

struct Robot {
    dBodyID chassis = nullptr;
    std::array<dBodyID, 2> wheels{};
    std::array<dJointID, 2> hinges{};
    std::array<dGeomID, 4> geoms{}; // hull, bumper, tyres: can touch walls and other robots
    Drive drive;
};

class BareWorld {
public:
    explicit BareWorld(const Options& options) : m_options(options) {
        m_world = dWorldCreate();
        m_contacts = dJointGroupCreate(0);
        dWorldSetGravity(m_world, 0, 0, -9.81);
        dWorldSetCFM(m_world, 1e-9);
        dWorldSetERP(m_world, 0.8);
        dWorldSetContactMaxCorrectingVel(m_world, 0.1);
        dWorldSetContactSurfaceLayer(m_world, 0);
        m_halfX = halfRoom(options.columns);
        m_halfY = halfRoom(options.rows);
        m_walls = {wall(0, m_halfY + 0.05, 2 * m_halfX + 0.2, 0.1), wall(0, -m_halfY - 0.05, 2 * m_halfX + 0.2, 0.1),
                   wall(m_halfX + 0.05, 0, 0.1, 2 * m_halfY), wall(-m_halfX - 0.05, 0, 0.1, 2 * m_halfY)};
        for (int i = 0; i < options.count; ++i) addRobot(startOf(i, options));
        m_columns = static_cast<int>(2 * m_halfX / (2 * kReach)) + 2;
        m_rows = static_cast<int>(2 * m_halfY / (2 * kReach)) + 2;
        m_cells.resize(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows));
    }
    ~BareWorld() {
        for (const Robot& robot : m_robots)
            for (const dGeomID geom : robot.geoms) dGeomDestroy(geom);
        for (const dGeomID geom : m_walls) dGeomDestroy(geom);
        dJointGroupDestroy(m_contacts);
        dWorldDestroy(m_world);
    }
    BareWorld(const BareWorld&) = delete;
    BareWorld& operator=(const BareWorld&) = delete;

    void tick() {
        think();
        collide();
        dWorldStep(m_world, m_options.tick);
        dJointGroupEmpty(m_contacts);
        ++m_ticks;
    }

    [[nodiscard]] long contactCount() const { return m_contactCount; }
    [[nodiscard]] std::array<double, 2> firstRobot() const { // position of its config frame
        dVector3 at;
        dBodyGetRelPointPos(m_robots[0].chassis, -m_centre[0], -m_centre[1], -m_centre[2], at);
        return {at[0], at[1]};
    }
    [[nodiscard]] int robotsOutside() const {
        int outside = 0;
        for (const Robot& robot : m_robots) {
            const dReal* p = dBodyGetPosition(robot.chassis);
            if (!(std::fabs(p[0]) < m_halfX && std::fabs(p[1]) < m_halfY && p[2] > 0.02 && p[2] < 0.3)) ++outside;
        }
        return outside;
    }

private:
    static dGeomID wall(double x, double y, double sizeX, double sizeY) {
        const dGeomID geom = dCreateBox(nullptr, sizeX, sizeY, 0.3);
        dGeomSetPosition(geom, x, y, 0.15);
        return geom;
    }

    static void addMass(dMass& total, dMass part, const std::array<double, 3>& at) {
        dMassTranslate(&part, at[0], at[1], at[2]);
        dMassAdd(&total, &part);
    }

    void addRobot(std::array<double, 2> at) {
        const auto [x, y] = at;
        Robot robot{.drive = Drive(m_robots.size())};
        dMass total, part;
        dMassSetZero(&total);
        dMassSetBoxTotal(&part, kHullMass, kHullSize[0], kHullSize[1], kHullSize[2]);
        addMass(total, part, kHullAt);
        dMassSetBoxTotal(&part, kBumperMass, kBumperSize[0], kBumperSize[1], kBumperSize[2]);
        addMass(total, part, kBumperAt);
        dMassSetSphereTotal(&part, kSliderMass, kSliderRadius);
        addMass(total, part, kSliderAt);
        const std::array<double, 3> centre{total.c[0], total.c[1], total.c[2]};
        m_centre = centre;
        dMassTranslate(&total, -centre[0], -centre[1], -centre[2]);
        total.c[0] = total.c[1] = total.c[2] = 0;

        robot.chassis = dBodyCreate(m_world);
        dBodySetMass(robot.chassis, &total);
        dBodySetPosition(robot.chassis, x + centre[0], y + centre[1], centre[2]);
        robot.geoms[0] = chassisBox(robot.chassis, kHullSize, kHullAt);
        robot.geoms[1] = chassisBox(robot.chassis, kBumperSize, kBumperAt);
        for (int side = 0; side < 2; ++side) addWheel(robot, side, x, y);
        m_robots.push_back(robot);
    }

    [[nodiscard]] dGeomID chassisBox(dBodyID body, const std::array<double, 3>& size, const std::array<double, 3>& at) const {
        const dGeomID geom = dCreateBox(nullptr, size[0], size[1], size[2]);
        dGeomSetBody(geom, body);
        dGeomSetOffsetPosition(geom, at[0] - m_centre[0], at[1] - m_centre[1], at[2] - m_centre[2]);
        return geom;
    }

    void addWheel(Robot& robot, int side, double x, double y) {
        const double wheelY = y + (side == 0 ? kTrack / 2 : -kTrack / 2);
        const dBodyID body = dBodyCreate(m_world);
        dMass mass;
        dMassSetCylinderTotal(&mass, kWheelMass, 3, kWheelRadius, kWheelWidth);
        dBodySetMass(body, &mass);
        dBodySetPosition(body, x + kAxleX, wheelY, kWheelRadius);
        dMatrix3 lying;
        dRFromAxisAndAngle(lying, 1, 0, 0, M_PI / 2);
        dBodySetRotation(body, lying);
        dBodySetFiniteRotationMode(body, 1);
        const dGeomID tyre = dCreateCylinder(nullptr, kWheelRadius, kWheelWidth);
        dGeomSetBody(tyre, body);
        const dJointID hinge = dJointCreateHinge(m_world, nullptr);
        dJointAttach(hinge, body, robot.chassis);
        dJointSetHingeAnchor(hinge, x + kAxleX, wheelY, kWheelRadius);
        dJointSetHingeAxis(hinge, 0, 1, 0);
        dJointSetHingeParam(hinge, dParamFMax, kServoTorque);
        dJointSetHingeParam(hinge, dParamVel, 0);
        const auto index = static_cast<std::size_t>(side);
        robot.wheels[index] = body;
        robot.hinges[index] = hinge;
        robot.geoms[2 + index] = tyre;
    }

    void think() {
        for (Robot& robot : m_robots) {
            robot.drive.think(m_ticks, m_options.tick);
            const std::array<double, 2> rates = robot.drive.wheelRates();
            for (std::size_t side = 0; side < 2; ++side) dJointSetHingeParam(robot.hinges[side], dParamVel, rates[side]);
        }
    }

    // The first friction axis lies along `slide`; without one, along the slip.
    void addContact(dBodyID a, dBodyID b, const dReal* position, const dReal* normal, double depth, double friction,
                    const dReal* slide) {
        dContact contact;
        std::memset(&contact, 0, sizeof contact);
        const double give = m_options.tick * kStiffness + kDamping;
        contact.surface.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM;
        contact.surface.mu = friction;
        contact.surface.soft_erp = m_options.tick * kStiffness / give;
        contact.surface.soft_cfm = 1 / give;
        for (int k = 0; k < 3; ++k) {
            contact.geom.pos[k] = position[k];
            contact.geom.normal[k] = normal[k];
        }
        contact.geom.depth = depth;
        dVector3 own{};
        if (friction > 0 && slide == nullptr && slipAt(a, b, position, normal, own)) slide = own;
        if (friction > 0 && slide != nullptr) {
            contact.surface.mode |= dContactFDir1;
            for (int k = 0; k < 3; ++k) contact.fdir1[k] = slide[k];
        }
        dJointAttach(dJointCreateContact(m_world, m_contacts, &contact), a, b);
        ++m_contactCount;
    }

    static bool slipAt(dBodyID a, dBodyID b, const dReal* position, const dReal* normal, dReal* slip) {
        dVector3 va{}, vb{};
        dBodyGetPointVel(a, position[0], position[1], position[2], va);
        if (b != nullptr) dBodyGetPointVel(b, position[0], position[1], position[2], vb);
        double along = 0, length = 0;
        for (int k = 0; k < 3; ++k) along += (va[k] - vb[k]) * normal[k];
        for (int k = 0; k < 3; ++k) {
            slip[k] = va[k] - vb[k] - along * normal[k];
            length += slip[k] * slip[k];
        }
        if (length < 1e-14) return false;
        for (int k = 0; k < 3; ++k) slip[k] /= std::sqrt(length);
        return true;
    }

    void standOnFloor(const Robot& robot) {
        static constexpr dReal kUp[3] = {0, 0, 1};
        for (const dBodyID wheel : robot.wheels) {
            const dReal *p = dBodyGetPosition(wheel), *r = dBodyGetRotation(wheel);
            // The axle is the body's z axis; the contact lies downwards in the wheel's plane.
            const double axle[3] = {r[2], r[6], r[10]};
            const double flat = std::sqrt(1 - axle[2] * axle[2]);
            const dReal at[3] = {p[0] + kWheelRadius * axle[2] * axle[0] / flat, p[1] + kWheelRadius * axle[2] * axle[1] / flat,
                                 p[2] - kWheelRadius * flat};
            if (at[2] > 0) continue;
            const dReal slide[3] = {axle[1] / flat, -axle[0] / flat, 0};
            addContact(wheel, nullptr, at, kUp, -at[2], kTyreFriction, slide);
        }
        dVector3 slider;
        dBodyGetRelPointPos(robot.chassis, kSliderAt[0] - m_centre[0], kSliderAt[1] - m_centre[1], kSliderAt[2] - m_centre[2],
                            slider);
        const dReal at[3] = {slider[0], slider[1], slider[2] - kSliderRadius};
        if (at[2] <= 0) addContact(robot.chassis, nullptr, at, kUp, -at[2], 0, nullptr);
    }

    void collideGeoms(dGeomID a, dGeomID b, int most) {
        dReal boxA[6], boxB[6];
        dGeomGetAABB(a, boxA);
        dGeomGetAABB(b, boxB);
        for (int k = 0; k < 6; k += 2)
            if (boxA[k] > boxB[k + 1] || boxB[k] > boxA[k + 1]) return;
        dContactGeom found[8];
        const int count = dCollide(a, b, 8, found, sizeof(dContactGeom));
        for (int i = 0; i < std::min(count, most); ++i)
            addContact(dGeomGetBody(a), dGeomGetBody(b), found[i].pos, found[i].normal, found[i].depth, kPlasticFriction,
                       nullptr);
    }

    [[nodiscard]] std::size_t cellOf(const dReal* p) const {
        const int column = std::clamp(static_cast<int>((p[0] + m_halfX) / (2 * kReach)), 0, m_columns - 1);
        const int row = std::clamp(static_cast<int>((p[1] + m_halfY) / (2 * kReach)), 0, m_rows - 1);
        return static_cast<std::size_t>(row * m_columns + column);
    }

    // Each robot is tested against those of higher index in its own and the neighbouring cells, in ascending order.
    void collide() {
        for (auto& cell : m_cells) cell.clear();
        for (std::size_t i = 0; i < m_robots.size(); ++i) m_cells[cellOf(dBodyGetPosition(m_robots[i].chassis))].push_back(i);
        for (std::size_t i = 0; i < m_robots.size(); ++i) {
            const Robot& robot = m_robots[i];
            const dReal* p = dBodyGetPosition(robot.chassis);
            standOnFloor(robot);
            if (std::fabs(p[0]) > m_halfX - kReach || std::fabs(p[1]) > m_halfY - kReach)
                for (const dGeomID wall : m_walls)
                    for (const dGeomID geom : robot.geoms) collideGeoms(geom, wall, kMaxOfWalls);
            findPartners(i, p);
            for (const std::size_t partner : m_partners)
                for (const dGeomID a : robot.geoms)
                    for (const dGeomID b : m_robots[partner].geoms) collideGeoms(a, b, kMaxOfRobots);
        }
    }

    void findPartners(std::size_t i, const dReal* p) {
        m_partners.clear();
        const auto cell = static_cast<int>(cellOf(p));
        const int column = cell % m_columns, row = cell / m_columns;
        for (int y = std::max(row - 1, 0); y <= std::min(row + 1, m_rows - 1); ++y)
            for (int x = std::max(column - 1, 0); x <= std::min(column + 1, m_columns - 1); ++x)
                for (const std::size_t other : m_cells[static_cast<std::size_t>(y * m_columns + x)]) {
                    if (other <= i) continue;
                    const dReal* q = dBodyGetPosition(m_robots[other].chassis);
                    const double dx = p[0] - q[0], dy = p[1] - q[1];
                    if (dx * dx + dy * dy <= 4 * kReach * kReach) m_partners.push_back(other);
                }
        std::sort(m_partners.begin(), m_partners.end());
    }

    Options m_options;
    dWorldID m_world = nullptr;
    dJointGroupID m_contacts = nullptr;
    std::array<dGeomID, 4> m_walls{};
    std::vector<Robot> m_robots;
    std::array<double, 3> m_centre{};
    std::vector<std::vector<std::size_t>> m_cells;
    std::vector<std::size_t> m_partners;
    int m_columns = 0, m_rows = 0;
    double m_halfX = 0, m_halfY = 0;
    long m_ticks = 0, m_contactCount = 0;
};

} // namespace

int main(int argc, char** argv) {
    const Options options = parse("bare_ode", argc, argv);
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
    int outside = 0;
    {
        BareWorld world(options);
        const long ticks = std::lround(options.seconds / options.tick);
        const auto start = std::chrono::steady_clock::now();
        for (long i = 0; i < ticks; ++i) world.tick();
        const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        outside = world.robotsOutside();
        std::printf("rtf=%.4f us_per_robot_tick=%.4f contacts_per_robot=%.3f outside=%d x=%.9f y=%.9f kb=%ld\n",
                    options.seconds / wall, wall * 1e6 / static_cast<double>(ticks) / options.count,
                    static_cast<double>(world.contactCount()) / static_cast<double>(ticks) / options.count, outside,
                    world.firstRobot()[0], world.firstRobot()[1], peakKb());
    }
    dCloseODE();
    return outside == 0 ? 0 : 1;
}
