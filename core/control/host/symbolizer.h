#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace trundle {

/// A place in the code of a module; inlined functions are frames of their own.
struct SourceFrame {
    std::string function; ///< empty: unknown
    std::string file;     ///< empty: unknown
    int line = 0;
    std::string address; ///< "libzoo.so+0x12ab"
};

/// The places of return addresses, given as (0, offset in `library`); others are left out. By addr2line, which comes with every
/// compiler; without it the frames have addresses alone.
[[nodiscard]] std::vector<SourceFrame> symbolize(const std::string& library,
                                                 const std::vector<std::pair<std::uint32_t, std::uint64_t>>& frames);
/// The innermost frame in code of the module's author rather than in a header of the system or the SDK; nullptr: none.
[[nodiscard]] const SourceFrame* ownFrame(const std::vector<SourceFrame>& frames);
/// "act(std::string const&) at plugins/zoo.cpp:316".
[[nodiscard]] std::string frameText(const SourceFrame& frame);
/// The frames as lines, without those of the SDK; of equal ones in sequence, as in a recursion, one is shown with their number.
[[nodiscard]] std::vector<std::string> backtraceOf(const std::vector<SourceFrame>& frames);

} // namespace trundle
