#pragma once
// Checks the model of the texts in a thread of its own, so that typing never waits for it.

#include <memory>
#include <stop_token>
#include <vector>

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include "base/diagnostic.h"
#include "project/project.h"

namespace trundle {

/// One check at a time, of the text alone: no module's code runs and no port is bound.
class ModelChecker final : public QObject {
    Q_OBJECT
public:
    explicit ModelChecker(QObject* parent = nullptr);
    ~ModelChecker() override;

    /// Checks this load soon; a later call takes its place and stops a check that is under way. Null: nothing.
    void request(std::shared_ptr<const Loaded> loaded);

Q_SIGNALS:
    /// What was found in the load that was asked for last.
    void checked(const std::shared_ptr<const trundle::Loaded>& loaded, const std::vector<trundle::Diagnostic>& found);

private:
    void start();
    void finish(const std::shared_ptr<const Loaded>& loaded, const std::vector<Diagnostic>& found);

    std::shared_ptr<const Loaded> m_wanted;
    bool m_busy = false;
    std::stop_source m_stop; ///< of the check that is under way
    QTimer m_delay{this};
    QThreadPool m_pool; ///< one thread; the last member, so that it ends first
};

} // namespace trundle
