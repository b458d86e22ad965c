#pragma once
// A movie of an experiment: run once more beside the window, as fast as it goes, and drawn at exact simulated times.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QObject>

#include "parts/parts.h"
#include "render/service.h"
#include "run/command.h"

namespace trundle {

/// Where to look from while bodies stand so.
using MovingView = std::function<CameraView(const BodyPoses& poses)>;

struct MovieJob {
    std::shared_ptr<const Loaded> loaded; ///< what runs
    std::vector<Command> commands;        ///< what was done by hand in the run that is repeated
    double begin = 0, end = 0;            ///< s, simulated
    std::string camera;                   ///< "robot0/eye"; or empty, and then:
    MovingView view;
    PictureRequest look; ///< size, what is drawn and what is hidden; scene, view and poses do not matter
    double framesPerSecond = 30;
    std::string path; ///< .mp4 or .webm; there only once the movie is whole

    [[nodiscard]] std::uint64_t frameCount() const;
};

/// At most one movie at a time.
class MovieRecorder final : public QObject {
    Q_OBJECT
public:
    /// Both outlive this.
    MovieRecorder(Parts& parts, RenderService& render, QObject* parent = nullptr);
    /// Waits at most two seconds; a controller that does not come back is left behind.
    ~MovieRecorder() override;

    void start(MovieJob job);
    /// After the picture in work: finished() follows, and nothing is left of the movie.
    void cancel();
    [[nodiscard]] bool isRecording() const { return m_work != nullptr; }

Q_SIGNALS:
    /// While it runs up to the beginning, 0 pictures.
    void progressed(quint64 pictures, double time);
    void finished(const QString& failure, bool cancelled); ///< both empty and false: the movie is written

private:
    struct Work;
    static void record(Work& work, const MovieJob& job);
    static Result<bool> film(Work& work, const MovieJob& job);

    Parts& m_parts;
    RenderService& m_render;
    std::shared_ptr<Work> m_work;
};

} // namespace trundle
