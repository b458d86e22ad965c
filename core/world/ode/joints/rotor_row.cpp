// ODE has no joint whose row acts on two bodies with different torques, so the row of a joint that the program has no other use for
// is written here: a shared library calls the program's definition of a function that both have. Needs: ODE 0.16 as a shared library;
// with any other way of linking ODE keeps its own row, and rotor_test fails.

#include "world/ode/joints/rotor_row.h"

#include <cmath>
#include <memory>
#include <string_view>
#include <utility>

#include <ode/version.h>

#include <Eigen/Dense>

#include "world/ode/joints/axis_motor.h"
#include "world/ode/objects/ode_fault.h"
#include "world/ode/objects/ode_math.h"

static_assert(std::string_view(dODE_VERSION).starts_with("0.16."), "getInfo2 may have other parameters in this version of ODE");

/// A rotor's row, by its OdeRotor as user data; ODE's first body is the child. A row has three numbers for the velocity and three for
/// the rate of its body, all 0 before; the pair has the value to reach and the softness.
struct dxJointTransmission {
    __attribute__((visibility("default"))) void getInfo2(double stepsPerSecond, double errorReduction, int rowSkip, double* child,
                                                         double* parent, int pairSkip, double* pair, double* limits,
                                                         int* friction);
};

void dxJointTransmission::getInfo2(double stepsPerSecond, double, int, double* child, double* parent, int, double* pair, double*,
                                   int*) {
    using trundle::vec;
    using trundle::Vec3;
    const dJointID id = reinterpret_cast<dJointID>(this);
    const auto& rotor = *static_cast<const trundle::OdeRotor*>(dJointGetData(id));
    const dBodyID bodies[] = {dJointGetBody(id, 0), dJointGetBody(id, 1)};
    const Vec3 axis = trundle::turn(dBodyGetRotation(bodies[rotor.axisOf]), rotor.axis);
    Eigen::Map<Vec3>(child + 3) = rotor.ratio * axis;
    Eigen::Map<Vec3>(parent + 3) = (1 - rotor.ratio) * axis;
    pair[0] = axis.dot(rotor.ratio * vec(dBodyGetAngularVel(bodies[0])) + (1 - rotor.ratio) * vec(dBodyGetAngularVel(bodies[1])));
    pair[1] = 1 / (stepsPerSecond * rotor.inertia);
}

namespace trundle {

Status RotorRows::add(std::uint32_t index, double inertia, double ratio) {
    OdeJoint& joint = m_joints[index];
    const bool turns =
        joint.type == JointType::Hinge || joint.type == JointType::Universal || joint.type == JointType::Suspension;
    if (!turns || !(inertia >= 0) || !std::isfinite(inertia) || !std::isfinite(ratio))
        return Error{Code::BadJoint, "takes no such rotor"};
    if (inertia == 0) return {};
    const int axisOf = joint.type == JointType::Universal ? 1 : 0;
    auto rotor =
        std::make_shared<OdeRotor>(OdeRotor{inertia, ratio, nullptr, axisOf, axisOf ? joint.parentAxis : joint.childAxis});
    try {
        prepareThread();
        rotor->row = dJointCreateTransmission(dBodyGetWorld(m_bodies[joint.child].id), nullptr);
        dJointAttach(rotor->row, m_bodies[joint.child].id, m_bodies[joint.parent].id);
        dJointSetData(rotor->row, rotor.get());
    } catch (const OdeFault&) { return Error{Code::BadJoint, "takes no such rotor"}; }
    if (joint.rotors.empty()) m_withRotors.push_back(index);
    joint.rotors.push_back(std::move(rotor));
    joint.rotorAxis = axisNow(joint, m_bodies);
    return {};
}

void RotorRows::update(double h) {
    for (const std::uint32_t index : m_withRotors) turn(m_joints[index], h);
}

/// With the momentum S of a rotor along its axis a: I dw = S (h a x dw / 2 - da). da is how the axis turned in the last tick: a tick
/// late, as the solver turns what hangs on joints, so that the momenta of rotor and child cancel where they are opposite. The other
/// term keeps a gyroscope from gaining energy.
void RotorRows::turn(OdeJoint& joint, double h) const {
    const OdeBody &child = m_bodies[joint.child], &parent = m_bodies[joint.parent];
    const Vec3 axis = axisNow(joint, m_bodies), rate = vec(parent.w);
    const Vec3 turned = axis - std::exchange(joint.rotorAxis, axis);
    double momentum = 0;
    for (const auto& rotor : joint.rotors)
        momentum += rotor->inertia * axis.dot(rotor->ratio * vec(child.w) + (1 - rotor->ratio) * rate);
    if (momentum == 0 || turned.isZero(0)) return;
    dMass mass;
    dBodyGetMass(parent.id, &mass);
    const Mat3 rotation = matrix(parent.r), inertia = rotation * matrix(mass.I) * rotation.transpose();
    const Vec3 change = (inertia - h / 2 * momentum * crossing(axis)).inverse() * (-momentum * turned),
               torque = inertia * change / h;
    dBodyAddTorque(parent.id, torque.x(), torque.y(), torque.z());
}

} // namespace trundle
