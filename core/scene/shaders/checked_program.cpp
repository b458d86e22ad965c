#include "scene/shaders/checked_program.h"

#include <osg/State>

namespace trundle {
namespace {

/// The first line of a compiler log.
std::string firstWords(const std::string& log) {
    constexpr std::size_t most = 200;
    const std::size_t begin = log.find_first_not_of(" \t\r\n");
    if (begin == std::string::npos) return "no reason given";
    return log.substr(begin, std::min(log.find_first_of("\r\n", begin) - begin, most));
}

} // namespace

void CheckedProgram::apply(osg::State& state) const {
    osg::Program::apply(state);
    if (state.getLastAppliedProgramObject() || !m_failure.empty()) return;
    std::string log;
    for (unsigned i = 0; i < getNumShaders(); ++i) {
        const osg::Shader::PerContextShader* shader = getShader(i)->getPCS(state);
        if (shader && !shader->isCompiled() && shader->getInfoLog(log)) break;
    }
    if (log.empty()) getPCP(state)->getInfoLog(log);
    m_failure = "the program \"" + getName() + "\" does not suit this OpenGL: " + firstWords(log);
}

std::string CheckedProgram::takeFailure() const { return std::exchange(m_failure, {}); }

} // namespace trundle
