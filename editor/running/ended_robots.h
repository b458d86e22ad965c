#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <QObject>
#include <QString>

#include "world/world.h"

namespace trundle {

class RunEdits;
struct RunResults;

/// The robots and objects that ended by a fault of their own while the run continues, as the panels show them.
class EndedRobots final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive this object.
    EndedRobots(const RunResults& results, const RunEdits& edits, QObject* parent = nullptr);

    /// After a new snapshot, or a run that ended or began.
    void update();

    [[nodiscard]] bool empty() const { return m_ends.empty(); }
    [[nodiscard]] std::size_t robots() const { return m_ends.size() - m_objects; }
    [[nodiscard]] std::size_t objects() const { return m_objects; } ///< those without joints, devices and controller
    /// Number of them: 1 or 0 for "robot0" or "swarm_3", that of its members for a Grid or Scatter "swarm".
    [[nodiscard]] std::size_t countOf(std::string_view instance) const;
    /// Of a robot or a part of one; false for a Grid or Scatter, which has no body of its own.
    [[nodiscard]] bool hasEnded(std::string_view path) const;
    /// "ended", of a Grid or Scatter "3 ended"; empty if none has.
    [[nodiscard]] QString label(std::string_view instance) const;
    /// When and why, for an instance or a part of one ("robot0.leftMotor"); empty if it has not ended.
    [[nodiscard]] QString explanation(std::string_view path) const;
    /// All of them in a few lines; empty: none.
    [[nodiscard]] QString summary() const;

Q_SIGNALS:
    void changed();

private:
    struct End {
        std::string robot;
        Fault fault;
    };
    using Ends = std::vector<const End*>;
    [[nodiscard]] const Ends* endsOf(std::string_view instance) const;
    [[nodiscard]] std::string_view instanceIn(std::string_view path) const;
    [[nodiscard]] static QString namesOf(const Ends& ends);

    const RunResults& m_results;
    const RunEdits& m_edits;
    std::vector<End> m_ends; // of the newest snapshot
    std::size_t m_objects = 0;
    std::map<std::string, Ends, std::less<>> m_byInstance; // robots, and their Grids and Scatters
};

} // namespace trundle
