#include "control/kept_outputs.h"

#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

namespace trundle {

namespace {

/// A copy of an argument that lives until it is passed on.
template <class T>
using Copy = std::conditional_t<std::is_same_v<std::decay_t<T>, std::string_view>, std::string, std::decay_t<T>>;

} // namespace

template <class... Arguments> std::function<void(Arguments...)> KeptOutputs::kept(std::function<void(Arguments...)> own) {
    if (!own) return own;
    return [this, own = std::move(own)](Arguments... arguments) {
        if (!m_keeps) return own(arguments...);
        m_kept.emplace_back([&own, copies = std::tuple<Copy<Arguments>...>(arguments...)] { std::apply(own, copies); });
    };
}

ControllerOutputs KeptOutputs::inPlaceOf(ControllerOutputs own) {
    m_kept.clear();
    m_keeps = false;
    own.print = kept(std::move(own.print));
    own.writeLog = kept(std::move(own.writeLog));
    own.finish = kept(std::move(own.finish));
    own.gaveUp = kept(std::move(own.gaveUp));
    return own;
}

void KeptOutputs::pass() {
    m_keeps = false;
    for (const auto& each : m_kept) each();
    m_kept.clear();
}

} // namespace trundle
