// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// What a controller says in its describe() of the devices that it needs. Since 1.12.

#include <trundle/quantity.h>

namespace trundle {

/// A text field with the names of devices of the robot, without which setup fails: "the field Lidar names a Lidar". `kinds` are those of
/// the ports that setup binds, separated by '|'; "DifferentialDrive" includes what such a port drives too. An empty name needs nothing.
/// The check of a model reports a robot that lacks one of them.
constexpr Quantity needs(const char* kinds) {
    Quantity q;
    q.choices = kinds;
    q.type = TRUNDLE_TEXT;
    return q;
}

} // namespace trundle
