// Takes the place of ODE's solver for the rows of an island, where dWorldStep spends most of its time: a shared library calls the
// program's definition of a function that both have. What cannot be solved here goes to ODE's own. Needs: ODE 0.16 as a shared
// library; with any other way of linking ODE keeps its own solver, and a test says so.

#include "world/ode/lcp/solve_lcp.h"
#include "world/ode/lcp/work.h"

#include <algorithm>
#include <string_view>

#include <ode/version.h>

#include "base/platform/next_symbol.h"
#include "world/ode/lcp/row_solver.h"
#include "world/ode/lcp/row_sweeps.h"

static_assert(std::string_view(dODE_VERSION).starts_with("0.16."), "dxSolveLCP may have other parameters in this version of ODE");

struct dxWorldProcessMemArena;

/// Solves A x = b + w, lo <= x <= hi. `w` is null in dWorldStep; the first `nub` rows have no bounds; `n` padded to four is A's stride.
__attribute__((visibility("default"))) void dxSolveLCP(dxWorldProcessMemArena* arena, unsigned n, double* a, double* pairsbx,
                                                       double* w, unsigned nub, double* pairslh, int* findex);

namespace {

using SolveLcp = decltype(dxSolveLCP);
thread_local trundle::SolvedIslands t_solved;
constexpr double kPassesPerSecond = 12e3;
constexpr int kLeastPasses = 120, kMostPasses = 360;
constexpr double kTolerance = 5e-3;  // m/s^2
constexpr double kParting = 5e-7;    // m by which a contact may part in a tick: what lies on it lightly is as deep
constexpr unsigned kRowsOfOde = 260; // so many it solves in some ten milliseconds
thread_local bool t_onlyQuick = false, t_gaveUp = false, t_swept = false;
thread_local trundle::SweepLimits t_limits{};

} // namespace

void dxSolveLCP(dxWorldProcessMemArena* arena, unsigned n, double* a, double* pairsbx, double* w, unsigned nub, double* pairslh,
                int* findex) {
    static auto* const ofOde =
        reinterpret_cast<SolveLcp*>(trundle::nextSymbol("_Z10dxSolveLCPP22dxWorldProcessMemArenajPdS1_S1_jS1_Pi"));
    thread_local trundle::RowSolver solver;
    ++t_solved.count;
    thread_local trundle::RowSweeps sweeps;
    if (!w && t_swept && n > 1) {
        t_gaveUp |= !solver.solve({n, a, trundle::TileMatrix::padded(n), pairslh, findex}, pairsbx, sweeps, t_limits);
        return;
    }
    if (!w && solver.solve({n, a, n > 1 ? trundle::TileMatrix::padded(n) : 1, pairslh, findex}, pairsbx)) {
        t_gaveUp |= t_onlyQuick && !solver.isExact();
        return;
    }
    if (t_onlyQuick && n > kRowsOfOde) {
        t_gaveUp = true;
        return;
    }
    if (!w) trundle::t_multiplications += std::uint64_t(n) * n * n;
    ++t_solved.leftToOde;
    ofOde(arena, n, a, pairsbx, w, nub, pairslh, findex);
}

namespace trundle {

SweptIslands::SweptIslands(double h) {
    t_swept = true, t_gaveUp = false;
    t_limits = {std::clamp(static_cast<int>(kPassesPerSecond * h), kLeastPasses, kMostPasses),
                std::min(kTolerance, kParting / (h * h))};
}
SweptIslands::~SweptIslands() { t_swept = false; }
bool SweptIslands::gaveUp() const { return t_gaveUp; }

SolvedIslands solvedIslands() { return t_solved; }

OnlyQuickIslands::OnlyQuickIslands() : m_before(t_multiplications) { t_onlyQuick = true, t_gaveUp = false; }
OnlyQuickIslands::~OnlyQuickIslands() { t_onlyQuick = false; }
bool OnlyQuickIslands::gaveUp() const { return t_gaveUp; }
std::uint64_t OnlyQuickIslands::work() const { return t_multiplications - m_before; }

} // namespace trundle
