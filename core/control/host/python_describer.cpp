#include "control/host/python_describer.h"

#include "base/platform/read_file.h"
#include "control/host/host_fault.h"
#include "control/kinds_json.h"
#include "control/python_kinds.h"

namespace trundle {
namespace {

constexpr double kLongestS = 10;

} // namespace

Result<std::vector<Kind>> PythonDescriber::kinds(const std::string& file) {
    const std::lock_guard lock(m_mutex);
    if (auto known = cachedPythonKinds(file)) return std::move(*known);
    return describe(file);
}

Result<std::vector<Kind>> PythonDescriber::describe(const std::string& file) {
    const auto stamp = regularFileStamp(file);
    if (!stamp) return Error{Code::PythonModule, stamp.error().message};
    const std::int64_t modified = stamp.value().modifiedNs;
    if (const auto known = m_endless.find(file); known != m_endless.end() && known->second.first == modified)
        return known->second.second;
    auto host = HostConnection::start(
        m_programs, file, 0, {[](const HostCall&) { return kLongestS; }, [](const HostCall&, double) {}, [] { return false; }});
    if (!host) return host.error();
    Status done = Error{Code::PythonModule, file + " cannot be described"};
    std::string json;
    const bool alive = host.value()->call(HostRequest::Load, WireWriter().bytes(file).view(),
                                          [&](HostRecord record, std::uint32_t, WireReader& in) {
                                              if (record == HostRecord::Done) {
                                                  done = in.status();
                                                  if (done) json = in.text();
                                              }
                                              return std::string();
                                          });
    if (!alive) {
        const HostEnd& end = host.value()->end();
        const Error error = errorOfLoading(Code::PythonModule, end, file);
        if (end.cause == HostEnd::Cause::NotResponding) m_endless.insert_or_assign(file, std::pair(modified, error));
        return error;
    }
    if (!done) return Error{Code::PythonModule, done.error().message, done.error().place};
    auto kinds = kindsFromJson(json, file);
    if (!kinds) return Error{Code::PythonModule, kinds.error().message};
    cachePythonKinds(file, json);
    return kinds;
}

} // namespace trundle
