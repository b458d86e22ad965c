#pragma once
#include <string>

#include <osg/Program>

namespace trundle {

/// A program that notices where a driver does not take it: OpenGL goes on without a word, and draws something else.
class CheckedProgram final : public osg::Program {
public:
    void apply(osg::State& state) const override;
    /// Why what was drawn since the last call is wrong, with the compiler's own words; empty: it is not.
    [[nodiscard]] std::string takeFailure() const;

private:
    mutable std::string m_failure;
};

} // namespace trundle
