#pragma once
#include <string>

#include <osg/Program>

namespace trundle {

/// A GLSL program that records compile and link errors of the driver. OpenGL itself continues silently and draws something else.
class CheckedProgram final : public osg::Program {
public:
    void apply(osg::State& state) const override;
    /// Error of the draws since the last call, with the first line of the compiler log; empty if there was none.
    [[nodiscard]] std::string takeFailure() const;

private:
    mutable std::string m_failure;
};

} // namespace trundle
