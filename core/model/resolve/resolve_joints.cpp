#include <cmath>

#include "lang/tree_edit.h"
#include "model/kinds/config_fields.h"
#include "model/resolve/reference_check.h"
#include "model/resolve/resolve_steps.h"

namespace trundle {

namespace {

JointFields jointFields(const std::string& kind, const Record& record, JointType& type) {
    if (kind == "Slider") {
        type = JointType::Slider;
        return fieldsFrom<SliderFields>(record);
    }
    if (kind == "Ball") {
        type = JointType::Ball;
        return fieldsFrom<BallFields>(record);
    }
    if (kind == "Universal") {
        type = JointType::Universal;
        return fieldsFrom<UniversalFields>(record);
    }
    if (kind == "Fixed") {
        type = JointType::Fixed;
        return fieldsFrom<FixedFields>(record);
    }
    if (kind == "Suspension") {
        type = JointType::Suspension;
        return fieldsFrom<SuspensionFields>(record);
    }
    type = JointType::Hinge;
    return fieldsFrom<HingeFields>(record);
}

class JointReader {
public:
    /// `scope`: of the Params in its values; nullptr: no instance gives them.
    JointReader(ResolveContext& context, const Part& part, const Record& record, ParamScope* scope = nullptr)
        : m_context(context), m_part(part), m_record(record), m_scope(scope) {}

    bool read(JointSpec& joint) {
        const JointFields f = jointFields(m_part.kind->name, m_record, joint.type);
        if (f.parent == f.child) {
            reportTwo(m_context, m_record, m_part, "Parent", "Child",
                      "the child of " + m_part.title() + " is its parent as well");
            return false;
        }
        joint.name = m_part.name;
        joint.range = m_part.range;
        joint.nameRange = m_part.nameRange();
        if (f.anchor) joint.anchor = vec3(*f.anchor);
        joint.damping = f.damping;
        joint.friction = f.friction;
        joint.stiffness = f.stiffness;
        joint.travel = f.travel;
        joint.lowStop = f.lowStop;
        joint.highStop = f.highStop;
        joint.rest = f.rest;
        joint.lowStop2 = f.lowStop2;
        joint.highStop2 = f.highStop2;
        joint.stiffness2 = f.stiffness2;
        joint.damping2 = f.damping2;
        joint.swingStop = f.swingStop;
        return readAxes(joint, f) && checkStops("LowStop", f.lowStop, "HighStop", f.highStop) &&
               checkStops("LowStop2", f.lowStop2, "HighStop2", f.highStop2);
    }

private:
    bool fail(const char* property, const std::string& message) {
        m_context.diagnostics.error(Code::BadJoint, m_record.rangeOf(property, m_part.nameRange()), message);
        return false;
    }

    bool readAxes(JointSpec& joint, const JointFields& f) {
        const Vec3 axis = vec3(f.axis), axis2 = vec3(f.axis2);
        if (!(axis.norm() > 1e-9)) return fail("Axis", "the Axis of " + m_part.title() + " is zero, it has no direction");
        joint.axis = axis.normalized();
        if (joint.type != JointType::Universal && joint.type != JointType::Suspension) return true;
        if (!(axis2.norm() > 1e-9)) return fail("Axis2", "the Axis2 of " + m_part.title() + " is zero, it has no direction");
        joint.axis2 = axis2.normalized();
        const double along = std::abs(joint.axis.dot(joint.axis2));
        if (along > 0.999) return fail("Axis2", "Axis and Axis2 of " + m_part.title() + " point the same way");
        if (joint.type != JointType::Universal) return true;
        if (along > 1e-3) return fail("Axis2", "Axis and Axis2 of " + m_part.title() + " are not at a right angle");
        joint.axis2 = (joint.axis2 - joint.axis.dot(joint.axis2) * joint.axis).normalized();
        return true;
    }

    bool checkStops(const char* lowName, std::optional<double> lowStop, const char* highName, std::optional<double> highStop) {
        if (!lowStop || !highStop || *lowStop <= *highStop) {
            if (lowStop && *lowStop > 0) startsOutside(lowName, "below");
            if (highStop && *highStop < 0) startsOutside(highName, "above");
            return true;
        }
        Record record = m_record;
        for (const char* stop : {lowName, highName}) addSource(record, stop);
        const std::size_t before = m_context.diagnostics.all().size();
        reportTwo(m_context, record, m_part, highName, lowName,
                  std::string("the ") + lowName + " of " + m_part.title() + " is above its " + highName);
        const SourceRange low = m_record.find(lowName)->range, high = m_record.find(highName)->range;
        if (m_context.diagnostics.all().size() > before && isOwnText(lowName) && isOwnText(highName) && low.file == high.file) {
            const std::string lowText(m_context.texts.slice(low)), highText(m_context.texts.slice(high));
            m_context.diagnostics.at(before).fixes.push_back({"exchange them", {{low, highText}, {high, lowText}}});
        }
        return false;
    }

    /// Adds what a stop takes from a Param.
    void addSource(Record& record, const char* stop) {
        const SourceAssignment* a = m_part.assignments.find(stop);
        if (!a || !m_scope || m_record.find(stop)->range != a->valueRange()) return;
        if (std::optional<GivenValue> given = m_context.evaluator.evaluate(*a->value, a->file, *m_scope))
            record.names.emplace(indexOf(stop), std::move(*given));
    }

    std::size_t indexOf(const char* property) const {
        return static_cast<std::size_t>(m_record.kind->find(property) - m_record.kind->properties.data());
    }
    bool isOwnText(const char* stop) const { return m_record.literal[indexOf(stop)]; }

    /// A joint counts from where its bodies are placed.
    void startsOutside(const char* stop, const std::string& side) {
        m_context.diagnostics.warning(Code::BadJoint, m_record.rangeOf(stop, m_part.nameRange()),
                                      m_part.title() + " starts at 0, " + side + " its " + stop +
                                          ": it is pushed there at once; place its bodies between the stops");
    }

    ResolveContext& m_context;
    const Part& m_part;
    const Record& m_record;
    ParamScope* m_scope;
};

/// False: it exists but has errors of its own.
bool findBody(const BodyIndices& places, const std::string& name, int& index) {
    const auto it = places.find(name);
    if (it == places.end()) return false;
    index = it->second;
    return true;
}

} // namespace

std::optional<JointSpec> readJoint(ResolveContext& context, const Part& part, const Record& record) {
    JointSpec joint;
    if (!JointReader(context, part, record).read(joint)) return std::nullopt;
    return joint;
}

std::optional<JointSpec> resolveJoint(ResolveContext& context, const ExpandedPart& expanded, const std::vector<BodySpec>& bodies,
                                      const BodyIndices& places) {
    const Part& part = *expanded.part;
    ParamScope own(expanded.frame->scope);
    own.declare(part.params);
    context.evaluator.checkAll(own);
    Record record = context.read(part, own, expanded.overrides(), Origin::Config);
    const bool known = checkReferences(context, record, *expanded.frame);
    if (!record.complete || !known) return std::nullopt;
    JointSpec joint;
    const bool isGood = JointReader(context, part, record, &own).read(joint);
    const std::string &parent = record.find("Parent")->value.texts[0], &child = record.find("Child")->value.texts[0];
    if (!isGood || !findBody(places, child, joint.child) || (parent != "world" && !findBody(places, parent, joint.parent)))
        return std::nullopt;
    expanded.place(joint);
    joint.name = expanded.name();
    if (!record.given("Anchor")) joint.anchor = bodies[static_cast<std::size_t>(joint.child)].pose.position;
    return joint;
}

void warnAboutTwoJoints(ResolveContext& context, const Part& second, const std::string& oneName, const std::string& otherName) {
    context.diagnostics.warning(Code::DoubleJoint, second.nameRange(),
                                "two joints join the same bodies, " + oneName + " and " + otherName +
                                    ": they act against each other; keep one of them");
}

} // namespace trundle
