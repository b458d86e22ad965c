#pragma once
// How robots that stand in a heap push each other. An exact solution would cost the cube of their number; but each of them moves in the
// plane of its floor, and pushes hardly change from tick to tick. Method: each group of jointed bodies is one rigid body in its plane;
// walls and the grip of the floor hold it as far as they can, and what else accelerates it is taken to be as in the last tick;
// Gauss-Seidel over all contacts, from the impulses of the last tick on. The impulses between groups act as forces in the tick, so that
// joints, wheels and floor of each robot stay exact. All of a group act at one height, walls hold it there, and what would still tip it
// off the floor is taken back: nothing climbs.

#include <span>
#include <vector>

#include "world/ode/solver/body_clusters.h"

namespace trundle {

class HeapForces {
public:
    explicit HeapForces(const EngineSettings& settings) : m_settings(settings) {}
    /// Adds the forces of all contacts that are `outside` to their bodies, and writes them as feedback.
    void apply(double h, std::span<OdeContact> contacts, std::span<const OdeBody> bodies, std::span<const OdeGeom> geoms,
               const BodyClusters& clusters, std::span<dJointFeedback> feedbacks);
    /// Of a tick without any.
    void skip() { ++m_tick; }
    /// What was known of these bodies is of no use where they were put.
    void forget(Run bodies);

private:
    struct Group {
        std::uint32_t heaviest = 0;   ///< body
        double mass = 0, inertia = 0; ///< about the floor's normal
        Vec3 floor = Vec3::Zero(), centre = Vec3::Zero();
        Vec3 velocity = Vec3::Zero(), pushed = Vec3::Zero(); ///< pushed: by all but the contacts, in a tick
        double turn = 0, twisted = 0;                        ///< about the floor's normal, rad/s
        Vec3 pushing = Vec3::Zero();                         ///< N, of others
        bool walled = false;
        double load = 0, height = 0; ///< N and m from the centre of mass, of what pushes it
        Vec3 tip = Vec3::Zero();     ///< N m: by as much the load of the floor moves that way
        std::uint32_t feet = kNone;  ///< the first of m_feet
    };
    /// One direction of a contact.
    struct Row {
        Vec3 way = Vec3::Zero();
        double firstArm = 0, secondArm = 0; ///< about the floors' normals
        double mass = 0, impulse = 0;
    };
    /// Where a group touches its floor.
    struct Foot {
        Vec3 arm, force; ///< from the group's centre of mass; N, expected
        double most = 0; ///< N of grip
        std::uint32_t next = kNone;
    };
    enum class Kind { Pair, Wall, Floor };
    struct Push {
        std::size_t contact = 0;
        Kind kind = Kind::Pair;
        std::uint32_t first = 0, second = 0; ///< of m_groups; only of pairs
        Row normal, across;                  ///< of a floor: across the way a wheel rolls, and along it
        double friction = 0, target = 0;     ///< target: m/s; friction of a floor: N s
        bool rolls = false;
    };
    /// What a group was to do by its contacts alone.
    struct Expected {
        std::uint64_t tick = 0;
        Vec3 velocity = Vec3::Zero();
        double turn = 0;
    };
    [[nodiscard]] std::uint32_t groupIndex(std::uint32_t group);
    void gather(std::span<OdeContact> contacts, std::span<const OdeBody> bodies, std::span<const OdeGeom> geoms,
                const BodyClusters& clusters);
    void measure(std::span<const OdeBody> bodies, const BodyClusters& clusters);
    void prepare(Push& push, const OdeContact& contact, std::span<const OdeGeom> geoms, double h);
    void prepareFloor(Push& push, const OdeContact& contact, double h);
    [[nodiscard]] Row rowOf(const Push& push, const Vec3& at, const Vec3& way) const;
    void expectOthers(std::span<const OdeContact> contacts);
    void push(double h, std::span<OdeContact> contacts, std::span<const OdeBody> bodies, std::span<const OdeGeom> geoms,
              std::span<dJointFeedback> feedbacks);
    void findHeights(double h, std::span<OdeContact> contacts, std::span<const OdeBody> bodies, std::span<const OdeGeom> geoms);
    [[nodiscard]] static double heightOn(const Group& group, const Vec3& at);
    void findTip(Group& group, double h) const;
    [[nodiscard]] double standing(const Group& group) const;
    [[nodiscard]] static Vec3 forceOf(const Push& push, double h);
    void solve(Push& push);
    void bring(const Push& push, Row& row, double impulse);
    void give(const Push& push, const Row& row, double impulse);
    [[nodiscard]] double speed(const Push& push, const Row& row) const;

    const EngineSettings& m_settings;
    std::uint64_t m_tick = 2; ///< above what is 0 by more than one
    std::vector<Group> m_groups, m_before;
    std::vector<std::uint32_t> m_names, m_indexOf; ///< m_indexOf: by group name, of m_groups
    std::vector<Push> m_pushes;
    std::vector<Foot> m_feet;
    std::vector<Expected> m_expected; ///< by group name
};

} // namespace trundle
