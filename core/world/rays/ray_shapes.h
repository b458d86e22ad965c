#pragma once
// Closed forms for convex shapes. A beam is inside a shape from `from` to `to`; it hits where it enters, or where it leaves if it starts
// inside. Needs: unit directions. Included only by the files of the kernels.

#include "world/rays/ray_kernel.h"
#include "world/rays/ray_lanes.h"

namespace trundle {
namespace {

struct Interval {
    Lanes from = all(-kFar), to = all(kFar);
};

inline Lanes3 directions(const BeamRow& row, const LocalBeams& l, int i) {
    const Lanes c = load(row.cosines + i), s = load(row.sines + i);
    return {l.a[0] * c + l.b[0] * s + l.c[0], l.a[1] * c + l.b[1] * s + l.c[1], l.a[2] * c + l.b[2] * s + l.c[2]};
}

inline void keep(const BeamRow& row, int i, Lanes t, double geom) {
    const Lanes old = load(row.distances + i), ids = load(row.geoms + i);
    const Mask nearer = (t < old) | ((t == old) & (geom < ids));
    if (!any(nearer)) return;
    store(row.distances + i, select(nearer, t, old));
    store(row.geoms + i, select(nearer, all(geom), ids));
}

inline void keep(const BeamRow& row, int i, const Interval& in, double geom) {
    const Lanes t = select(in.from < 0.0, in.to, in.from);
    keep(row, i, select((in.from > in.to) | (in.to < 0.0), all(kFar), t), geom);
}

constexpr double kTouch = 1e-20; // m; far beyond the range when divided by kTiny

/// Between two faces at -half and half, which belong to the shape: a beam in the plane of a face is inside.
inline void slab(Interval& in, Lanes d, double o, double half) {
    const Lanes inverse = 1.0 / nonZero(d), p = (-half - o - kTouch) * inverse, q = (half - o + kTouch) * inverse;
    in.from = most(in.from, least(p, q));
    in.to = least(in.to, most(p, q));
}

/// Where a quadric is met whose square of the distance from its middle is |o + t d|^2, with d.d = a and o.d = b. The point nearest to
/// the middle comes first, since the difference of the squares would lose digits far away. `rest` is radius^2 - |o + t d|^2 there.
inline Interval around(Lanes t, Lanes rest, Lanes a) {
    const Lanes h = rest / a, r = root(most(h, all(0)));
    return {select(h < 0.0, all(kFar), t - r), select(h < 0.0, all(-kFar), t + r)};
}

inline Interval inSphere(const double* o, const Lanes3& d, double radius) {
    const Lanes a = d.x * d.x + d.y * d.y + d.z * d.z, t = -dot(o, d) / a;
    const Lanes x = o[0] + t * d.x, y = o[1] + t * d.y, z = o[2] + t * d.z;
    return around(t, radius * radius - (x * x + y * y + z * z), a);
}

/// Of a cylinder without ends. A beam along it stays inside or outside.
inline Interval inTube(const double* o, const Lanes3& d, double radius) {
    const Lanes a = d.x * d.x + d.y * d.y;
    const Mask along = a < kTiny;
    const Lanes t = select(along, all(0), -(o[0] * d.x + o[1] * d.y) / most(a, all(kTiny)));
    const Lanes x = o[0] + t * d.x, y = o[1] + t * d.y;
    return around(t, radius * radius - (x * x + y * y), most(a, all(kTiny)));
}

inline Interval united(const Interval& p, const Interval& q) {
    const Mask empty = p.from > p.to; // that of q is empty only as around() makes it
    return {least(select(empty, all(kFar), p.from), q.from), most(select(empty, all(-kFar), p.to), q.to)};
}

template <class Shape> inline void castAll(const BeamRow& row, const LocalBeams& beams, double geom, Shape interval) {
    for (int i = row.first; i <= row.last; i += TRUNDLE_LANES) keep(row, i, interval(directions(row, beams, i)), geom);
}

void castPlane(const BeamRow& row, const LocalBeams& beams, const RayShape&, double geom, const RayRoots&) {
    for (int i = row.first; i <= row.last; i += TRUNDLE_LANES) {
        const Lanes t = -beams.origin[2] / directions(row, beams, i).z;
        keep(row, i, select(t >= 0.0, t, all(kFar)), geom);
    }
}

void castBox(const BeamRow& row, const LocalBeams& beams, const RayShape& shape, double geom, const RayRoots&) {
    const double* o = beams.origin;
    const bool flat = beams.a[2] == 0 && beams.b[2] == 0 && beams.c[2] == 0; // parallel to two faces: decided once
    if (flat && (o[2] > shape.half[2] || o[2] < -shape.half[2])) return;
    castAll(row, beams, geom, [&](const Lanes3& d) {
        Interval in;
        slab(in, d.x, o[0], shape.half[0]);
        slab(in, d.y, o[1], shape.half[1]);
        if (!flat) slab(in, d.z, o[2], shape.half[2]);
        return in;
    });
}

void castSphere(const BeamRow& row, const LocalBeams& beams, const RayShape& shape, double geom, const RayRoots&) {
    castAll(row, beams, geom, [&](const Lanes3& d) { return inSphere(beams.origin, d, shape.radius); });
}

void castCylinder(const BeamRow& row, const LocalBeams& beams, const RayShape& shape, double geom, const RayRoots&) {
    castAll(row, beams, geom, [&](const Lanes3& d) {
        Interval in = inTube(beams.origin, d, shape.radius);
        slab(in, d.z, beams.origin[2], shape.half[2]);
        return in;
    });
}

/// A cylinder and a ball at each end; together they are convex, so their intervals join.
void castCapsule(const BeamRow& row, const LocalBeams& beams, const RayShape& shape, double geom, const RayRoots&) {
    const double* o = beams.origin;
    const double low[3] = {o[0], o[1], o[2] + shape.half[2]}, high[3] = {o[0], o[1], o[2] - shape.half[2]};
    castAll(row, beams, geom, [&](const Lanes3& d) {
        Interval in = inTube(o, d, shape.radius);
        slab(in, d.z, o[2], shape.half[2]);
        return united(united(in, inSphere(low, d, shape.radius)), inSphere(high, d, shape.radius));
    });
}

/// Its faces belong to it, as those of a box.
void castHull(const BeamRow& row, const LocalBeams& beams, const RayShape& shape, double geom, const RayRoots&) {
    castAll(row, beams, geom, [&](const Lanes3& d) {
        Interval in;
        for (int f = 0; f < shape.planeCount; ++f) {
            const double* plane = shape.planes + 4 * f;
            const Lanes leaving = nonZero(dot(plane, d)), t = (plane[3] - dot(plane, beams.origin) + kTouch) / leaving;
            in.from = select(leaving < 0.0, most(in.from, t), in.from);
            in.to = select(leaving > 0.0, least(in.to, t), in.to);
        }
        return in;
    });
}

} // namespace
} // namespace trundle
