// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// The function table of a controller, as kind_table.h builds those of devices.

#include <string>
#include <type_traits>

#include <trundle/kind_table.h>

namespace trundle {
inline namespace sdk1 {

class Controller;
class RobotPorts;
struct Seconds;

namespace border {

template <class T, class Ports> std::int32_t setupController(void* handle, const TrundleRobot* robot) {
    auto& instance = at<T>(handle);
    bool complete = true;
    const std::int32_t failed = guarded(instance.error, [&] {
        Ports ports(*robot);
        instance.object.attach(robot);
        ports.publishOutputs(instance.object);
        instance.object.setup(ports);
        complete = ports.complete();
    });
    if (!failed && !complete) instance.error = "a port is missing";
    return failed || !complete;
}
template <class T, class Span> std::int32_t updateController(void* handle, double sinceLast) {
    auto& instance = at<T>(handle);
    return guarded(instance.error, [&] { instance.object.update(Span{sinceLast}); });
}
template <class T, class Base> std::int32_t saveState(void* handle, void (*write)(void*, const char*, std::uint64_t), void* to) {
    auto& instance = at<T>(handle);
    return guarded(instance.error, [&] {
        const std::string state = static_cast<const Base&>(instance.object).saveState();
        if (!state.empty()) write(to, state.data(), state.size());
    });
}
template <class T, class Base> std::int32_t loadState(void* handle, const char* bytes, std::uint64_t count) {
    auto& instance = at<T>(handle);
    return guarded(instance.error,
                   [&] { static_cast<Base&>(instance.object).loadState({bytes, static_cast<std::size_t>(count)}); });
}

} // namespace border

// The real classes are default template arguments, so that this header does not include controller.h.
template <class T, class Base = Controller, class Ports = RobotPorts, class Span = Seconds>
std::unique_ptr<KindTable> controllerTable(const char* name) {
    static_assert(std::is_base_of_v<Base, T>, "a controller derives from trundle::Controller");
    auto table = border::commonTable<T>(name, TRUNDLE_CONTROLLER);
    table->kind.setupController = &border::setupController<T, Ports>;
    table->kind.update = &border::updateController<T, Span>;
    table->kind.saveState = &border::saveState<T, Base>;
    table->kind.loadState = &border::loadState<T, Base>;
    return table;
}

} // namespace sdk1
} // namespace trundle
