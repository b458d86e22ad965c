// Takes crates from one pile to another with an arm of four servos and a latch: the inverse kinematics of two links in a plane that turns.
#include <algorithm>
#include <array>
#include <cmath>

#include <trundle/controller.h>

namespace {

constexpr double kHover = 0.12;   // m above a pile
constexpr double kSettle = 0.3;   // s that it waits where it takes hold of a crate and where it puts one down
constexpr double kShortest = 0.4; // s of a way

/// Where the wrist is to be: distance from the yaw axis, angle about it, height.
struct Place {
    double radius = 0, yaw = 0, height = 0;
};

struct PickAndPlace : trundle::Controller {
    int count = 3;
    std::array<double, 2> from{0.3, 0.2}, to{0.3, -0.2};
    double crate = 0.06, speed = 0.25;
    double shoulderHeight = 0.25, upper = 0.25, fore = 0.25, tool = 0.08;
    std::string latchName = "suction";
    trundle::OutputSlot<int> moved;

    static void describe(trundle::Describe<PickAndPlace>& d) {
        using C = PickAndPlace;
        d.help(
             "Takes crates from one pile to another with an arm of four servos, yaw, shoulder, elbow and wrist, and a latch, and "
             "ends the run when all are there.")
            .independent();
        d.field("Count", &C::count, trundle::number().within(1, 20), "Crates of the pile.");
        d.field("From", &C::from, trundle::metres().within(-10, 10), "x, y of the pile, from the yaw axis.");
        d.field("To", &C::to, trundle::metres().within(-10, 10), "x, y of the new pile.");
        d.field("Crate", &C::crate, trundle::metres().within(0.005, 1), "Height of a crate.");
        d.field("Speed", &C::speed, trundle::metresPerSecond().above(0).atMost(10), "Of its hand, at most.");
        d.field("ShoulderHeight", &C::shoulderHeight, trundle::metres().within(0, 10), "Above the floor.");
        d.field("Upper", &C::upper, trundle::metres().within(0.01, 10), "From shoulder to elbow.");
        d.field("Fore", &C::fore, trundle::metres().within(0.01, 10), "From elbow to wrist.");
        d.field("Tool", &C::tool, trundle::metres().within(0, 10), "From the wrist down to the latch.");
        d.field("Latch", &C::latchName, trundle::needs("Latch"), "The robot's Latch.");
        d.output("moved", &C::moved, "", "Crates on the new pile.");
    }

    void setup(trundle::RobotPorts& robot) override {
        yaw = robot.servo("yaw");
        shoulder = robot.servo("shoulder");
        elbow = robot.servo("elbow");
        wrist = robot.servo("wrist");
        latch = robot.latch(latchName);
        now = next = {upper + 0.5 * fore, 0, shoulderHeight};
        enter(Step::ToPile, hover(from, count));
    }

    void update(trundle::Seconds) override {
        const double share = std::clamp((time() - since) / duration, 0.0, 1.0), smooth = share * share * (3 - 2 * share);
        reach({now.radius + smooth * (next.radius - now.radius), now.yaw + smooth * (next.yaw - now.yaw),
               now.height + smooth * (next.height - now.height)});
        if (time() - since >= duration + kSettle) proceed();
    }

private:
    enum class Step { ToPile, Lower, Lift, Carry, PutDown, Leave };

    /// The way to `place`, from where it is.
    void enter(Step what, const Place& place) {
        now = next;
        next = place;
        step = what;
        since = time();
        const double turn = std::max(now.radius, next.radius) * std::abs(next.yaw - now.yaw);
        const double way = std::hypot(next.radius - now.radius, next.height - now.height, turn);
        duration = std::max(kShortest, 1.5 * way / speed); // its fastest moment is 1.5 times the mean
    }

    void proceed() {
        const int left = count - moved.get();
        switch (step) {
        case Step::ToPile: return enter(Step::Lower, above(from, left, 0.004));
        case Step::Lower:
            latch.setEngage(true);
            if (!latch.inReach()) return fail("there is no crate where the pile should be");
            return enter(Step::Lift, hover(from, left));
        case Step::Lift: return enter(Step::Carry, hover(to, count));
        case Step::Carry: return enter(Step::PutDown, above(to, moved.get() + 1, 0.006));
        case Step::PutDown:
            latch.setEngage(false);
            moved.set(moved.get() + 1);
            return enter(Step::Leave, hover(to, count));
        case Step::Leave:
            if (moved.get() < count) return enter(Step::ToPile, hover(from, count));
            finish("all crates are on the new pile");
        }
    }

    /// The latch at a height above so many crates.
    [[nodiscard]] Place above(const std::array<double, 2>& pile, int crates, double height) const {
        return {std::hypot(pile[0], pile[1]), std::atan2(pile[1], pile[0]), crates * crate + height + tool};
    }
    [[nodiscard]] Place hover(const std::array<double, 2>& pile, int crates) const {
        return above(pile, crates + 1, kHover - crate);
    }

    /// Law of cosines for the elbow, which stays above the line from shoulder to wrist; the wrist keeps the tool upright. Angles about the
    /// joints' y axes, positive downwards.
    void reach(const Place& p) {
        const double down = shoulderHeight - p.height, square = p.radius * p.radius + down * down;
        const double cosine = (square - upper * upper - fore * fore) / (2 * upper * fore);
        const double bend = std::acos(std::clamp(cosine, -1.0, 1.0));
        const double lift = std::atan2(down, p.radius) - std::atan2(fore * std::sin(bend), upper + fore * std::cos(bend));
        yaw.setTarget(p.yaw);
        shoulder.setTarget(lift);
        elbow.setTarget(bend);
        wrist.setTarget(-lift - bend);
    }

    trundle::ServoPort yaw, shoulder, elbow, wrist;
    trundle::LatchPort latch;
    Step step = Step::ToPile;
    Place now, next;
    double since = 0, duration = 1; // s
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<PickAndPlace>("PickAndPlace"); }
