#include "remote/dispatch.h"

#include <array>

#include "base/spelling.h"
#include "remote/query_operations.h"
#include "remote/radio_operations.h"
#include "remote/run_operations.h"

namespace trundle {
namespace {

struct Operation {
    const char* name;
    bool needsRun;
    Reply (*answer)(const RequestContext& request);
};
template <Reply (QueryOperations::*operation)()> Reply query(const RequestContext& request) {
    return (QueryOperations(request).*operation)();
}
template <Reply (RunOperations::*operation)()> Reply pace(const RequestContext& request) {
    return (RunOperations(request).*operation)();
}
/// What acts in a coming tick, which there must be.
template <Reply (RunOperations::*operation)()> Reply change(const RequestContext& request) {
    if (request.run.state() == ServedState::Ended)
        return Reply::failed("ended", "the run is over, reset it: " + request.run.endReason());
    return pace<operation>(request);
}
template <Reply (RadioOperations::*operation)()> Reply radio(const RequestContext& request) {
    return (RadioOperations(request).*operation)();
}
using Query = QueryOperations;
using Change = RunOperations;

constexpr std::array kOperations{
    Operation{"status", false, query<&Query::status>},
    Operation{"list", true, query<&Query::list>},
    Operation{"describe", true, query<&Query::describe>},
    Operation{"subscribe", true, query<&Query::subscribe>},
    Operation{"unsubscribe", false, query<&Query::unsubscribe>},
    Operation{"read", true, query<&Query::read>},
    Operation{"hash", true, query<&Query::hash>},
    Operation{"image", true, query<&Query::image>},
    Operation{"objects", true, query<&Query::objects>},
    Operation{"console", false, query<&Query::console>},
    Operation{"command", true, change<&Change::command>},
    Operation{"send", true, radio<&RadioOperations::send>},
    Operation{"receive", true, radio<&RadioOperations::receive>},
    Operation{"hold", true, change<&Change::hold>},
    Operation{"place", true, change<&Change::place>},
    Operation{"push", true, change<&Change::push>},
    Operation{"restart", true, change<&Change::restart>},
    Operation{"step", true, change<&Change::step>},
    Operation{"run", true, change<&Change::run>},
    Operation{"pause", true, pace<&Change::pause>},
    Operation{"reset", false, pace<&Change::reset>},
};

} // namespace

Reply answer(const std::string& operation, const RequestContext& request) {
    std::vector<std::string> names;
    for (const Operation& each : kOperations) {
        names.emplace_back(each.name);
        if (operation != each.name) continue;
        if (each.needsRun && !request.run.exists())
            return Reply::failed("ended", "there is no run, as it could not be built; reset it");
        return each.answer(request);
    }
    const std::vector<std::string> near = nearestWords(operation.substr(0, 100), names, 1);
    return Reply::failed("unknown_operation", "unknown operation " + shortenedMessage(operation) +
                                                  (near.empty() ? "" : "; did you mean " + near[0] + "?"));
}

} // namespace trundle
