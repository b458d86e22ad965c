#include "editor/shell/recent_files.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include "editor/widgets/resources.h"

namespace trundle {

static constexpr int kMaxRecent = 12;

QStringList recentFiles() {
    QStringList files = QSettings().value(QStringLiteral("recentFiles")).toStringList();
    files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
    return files;
}

void addRecentFile(const QString& path) {
    QStringList files = QSettings().value(QStringLiteral("recentFiles")).toStringList();
    files.removeAll(path);
    files.prepend(path);
    QSettings().setValue(QStringLiteral("recentFiles"), files.mid(0, kMaxRecent));
}

QString documentsFolder() {
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

QList<Sample> sampleExperiments(const QString& configs) {
    const std::initializer_list<std::array<const char*, 3>> samples{
        {"linear_motion", "Linear motion", "One metre straight ahead, measured."},
        {"arc_motion", "Arc motion", "A full circle at a commanded speed and turn rate."},
        {"obstacle_detection", "Obstacle detection", "Bump, back off, turn, continue: a walled arena."},
        {"wall_follow", "Wall follow", "Once around a room along its walls, with a lidar."},
        {"line_follow", "Line follow", "Finds a line on the floor and goes once around on it."},
        {"braitenberg", "Braitenberg", "Two light sensors, two wheels: it comes to rest before the lamp."},
        {"collect", "Collect", "Finds cans with a lidar, grips them and brings them home."},
        {"docking", "Docking", "When its battery is low, it finds its charger by the light on it."},
        {"lidar_map", "Lidar map", "Explores a room, draws its map and saves it as a picture."},
        {"swarm", "Swarm", "A hundred robots, each on a random walk of its own."},
        {"camera_swarm", "Camera swarm", "Twenty robots with a camera each, all after one red ball."},
        {"blob_follow", "Blob follow", "Looks around with a camera, drives to the red ball."},
        {"soccer", "Soccer", "Four omni wheels: around the ball, then to the goal with it."},
        {"stacking", "Stacking", "An arm with a suction cup takes a pile apart and builds it up again."},
        {"train", "Train", "A tractor with two trailers on joints between robots; a region counts its laps."},
        {"car", "Car", "Steered and sprung like the real thing, on circles narrow and wide."},
        {"maze", "Maze", "Explores a maze, goes back, then runs the shortest way it has seen."},
        {"rover", "Rover", "Six wheels on a rocker-bogie climb a ledge as high as they are."},
        {"directional_antenna", "Directional antenna", "Turns once, finds three motes by how strong they are."},
        {"turn_angle", "Turn angle", "How exactly a turn finds the bearings of five motes."},
        {"sensor_network_amr", "Sensor network", "A carrier follows nine motes to the one out of its range."},
        {"network_navigation", "Network navigation", "By signal strength alone to a target that is out of range."},
        {"thesis_figure_3_4", "Figure 3.4", "After the thesis's figure 3.4; robot and arena are ours."},
    };
    QList<Sample> found;
    for (const auto& [name, title, description] : samples) {
        QString path = configs + QStringLiteral("/experiments/") + QLatin1String(name) + QStringLiteral(".sim");
        if (!QFileInfo::exists(path)) path.replace(QStringLiteral(".sim"), QStringLiteral(".txt"));
        if (!QFileInfo::exists(path)) continue;
        found.append({path, QLatin1String(title), QLatin1String(description),
                      resourcePath(QStringLiteral("pictures/samples/%1.png").arg(QLatin1String(name)))});
    }
    return found;
}

QList<Sample> sampleParts(const QString& configs) {
    const std::initializer_list<std::array<const char*, 3>> context{
        {"robots/simple_robot", "Simple robot", "Two driven wheels, a slider, a touch-sensing bumper."},
        {"robots/evbot", "EvBot", "A sturdy indoor robot, bumpers front and back."},
        {"robots/amr", "AMR", "A heavy carrier for halls and corridors."},
        {"robots/camera_robot", "Camera robot", "Two driven wheels and a camera on a mast."},
        {"robots/lidar_robot", "Lidar robot", "Small, for classrooms: a lidar on three decks, an IMU."},
        {"robots/round_robot", "Round robot", "Palm-sized: infrared all around, sensors for lines on the floor."},
        {"robots/research_base", "Research base", "Sixteen sonars, a lidar, a gripper with a lift."},
        {"robots/soccer_robot", "Soccer robot", "Moves in any direction on four omni wheels, with a camera."},
        {"robots/maze_robot", "Maze robot", "A fast mouse for mazes, with four distance sensors."},
        {"robots/radio_robot", "Radio robot", "Carries a patch antenna that looks ahead."},
        {"robots/tmote_sky", "Tmote Sky", "A radio mote, lying on its batteries."},
        {"arenas/medium_arena", "Medium arena", "A square room, 4 m x 4 m, with low walls."},
        {"arenas/furnished_room", "Furnished room", "5 m x 4 m, with a partition, a cupboard and a column."},
        {"arenas/depot", "Depot", "A hall, 6 m x 5 m, with a home zone on its floor."},
        {"arenas/maze", "Maze", "Eight by eight cells of 18 cm, with loops."},
        {"arenas/soccer_field", "Soccer field", "5.2 m x 3.6 m with two goals, one blue, one yellow."},
        {"arenas/line_course", "Line course", "A floor with a closed black line to follow."},
        {"arenas/colour_yard", "Colour yard", "A red ball to find among things of other colours."},
    };
    QList<Sample> found;
    for (const auto& [name, title, description] : context) {
        const QString path = configs + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".sim");
        if (!QFileInfo::exists(path)) continue;
        const QString picture = QStringLiteral("pictures/gallery/%1.png").arg(QFileInfo(path).completeBaseName());
        found.append({path, QLatin1String(title), QLatin1String(description), resourcePath(picture)});
    }
    return found;
}

} // namespace trundle
