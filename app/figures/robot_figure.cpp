#include "app/figures/robot_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "app/figures/canvas.h"
#include "app/figures/figure_colours.h"
#include "core/base/degree.h"
#include "core/robot/attitude.h"
#include "core/robot/kinematics.h"
#include "core/terrain/bins.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {
namespace {

constexpr int kRobotWidth = 1280, kRobotHeight = 1040;  // [px]
constexpr double kSideFloor = 480.0, kTopMiddle = 800.0, kRobotMiddle = 560.0;
constexpr double kRaisedFlipper = 0.7;  // [rad]
constexpr Colour kBodyFill{0xdde3e9}, kTrackFill{0xbcc7d2}, kFlipperFill{0xcfe0f2, 0.8},
    kOutlineColour{0x51606e}, kElementColour{0x1558a6}, kMassColour{0x6a1b9a}, kImuColour{0xb06400},
    kArmColour{0x12804a};

/// Draws one robot. Positions are in the base frame [m].
class RobotSheet {
public:
    RobotSheet(Canvas& canvas, const RobotModel& robot)
        : canvas_(canvas), r_(robot), floor_(robot.trackZ - robot.trackRadius)
    {
        const double side = 1.1 * std::max(0.4, reachOf(robot));
        const double arm = robot.imu.x + robot.armReachEnd + 0.05;
        const double high = highest() - floor_ + 0.12;
        scale_ = std::min({(kRobotMiddle - 60.0) / side,
                           (kRobotWidth - 40.0 - kRobotMiddle) / std::max(side, arm),
                           (kSideFloor - 110.0) / high, 190.0 / (outer() + 0.06)});
    }

    void draw()
    {
        drawHead();
        drawFloor();
        drawOutline(kRaisedFlipper, true);
        drawOutline(0.0, false);
        drawElements();
        drawMasses();
        drawImu();
        drawArm();
        drawSides();
        drawNumbers();
    }

private:
    Point at(Vec2 p) const
    {
        return {kRobotMiddle + scale_ * p.x, kSideFloor - scale_ * (p.z - floor_)};
    }
    Point above(double x, double y) const
    {
        return {kRobotMiddle + scale_ * x, kTopMiddle - scale_ * y};
    }
    double outer() const
    {
        const LateralGeometry& y = r_.lateral;
        return std::max(
            {y.trackY + 0.5 * y.trackWidth, y.flipperY + 0.5 * y.flipperWidth, r_.halfWidth});
    }
    double highest() const
    {
        double top = std::max(r_.imu.z, r_.trackZ + r_.trackRadius);
        for (const FlipperGeometry& f : {r_.front, r_.rear})
            top =
                std::max(top, f.pivot.z + f.axleDistance * std::sin(kRaisedFlipper) + f.tipRadius);
        for (const auto& polygon : r_.body)
            for (const Vec2 p : polygon) top = std::max(top, p.z);
        return top;
    }
    void label(Point where, std::string_view text, Colour colour, Align align = Align::Left)
    {
        canvas_.text(where, text, {.colour = colour, .size = 13.0, .align = align});
    }

    void drawHead()
    {
        const TextStyle title{.colour = kFigureText, .size = 22.0, .bold = true};
        canvas_.text({20.0, 36.0},
                     canvas_.fitted(r_.name + ": the numbers of the robot file", 900.0, title),
                     title);
        label({20.0, 60.0},
              "Side view on a flat floor, flippers at angle 0; dashed: raised by 0.7 rad. Base "
              "frame, in metres.",
              kFigureMuted);
        label({20.0, 570.0}, "From above: left side up.", kFigureMuted);
    }

    void drawFloor()
    {
        const Stroke grid{kFigureGrid, 1.0, {}};
        for (int tenth = -20; tenth <= 20; ++tenth) {
            const double x = at({0.1 * tenth, floor_}).x;
            if (x < 30.0 || x > kRobotWidth - 20.0) continue;
            canvas_.line({x, 80.0}, {x, kSideFloor + 8.0}, grid);
            if (tenth % 2 == 0)
                label({x, kSideFloor + 24.0}, signedNumber(0.1 * tenth, 1), kFigureMuted,
                      Align::Centre);
        }
        canvas_.line({30.0, kSideFloor}, {kRobotWidth - 20.0, kSideFloor}, {kFigureText, 2.0, {}});
    }

    void drawOutline(double flippers, bool dashed)
    {
        for (const OutlinePart& part : robotOutline(r_, 0.0, flippers, flippers)) {
            const bool flipper = part.kind == OutlinePart::Kind::FrontFlipper
                              || part.kind == OutlinePart::Kind::RearFlipper;
            if (dashed && !flipper) continue;
            std::vector<Point> points;
            points.reserve(part.points.size());
            for (const auto& [x, z] : part.points)
                points.push_back(at({x + r_.imu.x, z + r_.imu.z}));
            const Colour fill = dashed                                ? Colour{0xffffff, 0.0}
                              : flipper                               ? kFlipperFill
                              : part.kind == OutlinePart::Kind::Track ? kTrackFill
                                                                      : kBodyFill;
            canvas_.polygon(
                points, fill,
                {kOutlineColour, 1.2, dashed ? std::vector{4.0, 4.0} : std::vector<double>{}});
        }
    }

    void drawElementsOf(const FlipperGeometry& flipper,
                        const std::array<double, kForceElements>& shares)
    {
        int number = 0;
        for (const double share : shares) {
            const Point p = at(edgePoint(flipper, 0.0, {}, share));
            canvas_.marker(Shape::Square, p, 8.0, kElementColour, {kElementColour, 1.0, {}});
            label({p.x, p.y - 8.0}, std::to_string(++number), kElementColour, Align::Centre);
        }
    }

    void drawElements()
    {
        drawElementsOf(r_.front, r_.elementShare);
        if (r_.rearElementShare) drawElementsOf(r_.rear, *r_.rearElementShare);
    }

    void drawMass(Vec2 where, const std::string& text)
    {
        const Point p = at(where);
        canvas_.marker(Shape::Diamond, p, 12.0, kMassColour, {kMassColour, 1.0, {}});
        label({p.x + 10.0, p.y - 4.0}, text, kMassColour);
    }

    void drawMasses()
    {
        drawMass(r_.bodyCom, fmt::format("body {:.1f} kg", r_.bodyMass));
        for (const FlipperGeometry& f : {r_.front, r_.rear}) {
            const Vec2 axis = flipperAxis(f, 0.0);
            drawMass({f.pivot.x + f.comDistance * axis.x, f.pivot.z + f.comDistance * axis.z},
                     fmt::format("{:.2f} kg", f.mass));
        }
    }

    void drawImu()
    {
        const Point imu = at(r_.imu);
        canvas_.marker(Shape::Triangle, imu, 13.0, kImuColour, {kImuColour, 1.0, {}});
        label({imu.x - 10.0, imu.y - 6.0}, "IMU", kImuColour, Align::Right);
        for (int i = 0; i <= kBins; ++i) {
            const double x = at({r_.imu.x + binBegin(i), 0.0}).x;
            canvas_.line({x, kSideFloor + 32.0}, {x, kSideFloor + 44.0}, {kImuColour, 1.5, {}});
        }
        label({30.0, kSideFloor + 44.0}, "bins", kImuColour);
    }

    void drawArm()
    {
        const double from = at({r_.imu.x + r_.armReachBegin, 0.0}).x,
                     to = at({r_.imu.x + r_.armReachEnd, 0.0}).x;
        canvas_.line({from, kSideFloor + 52.0}, {to, kSideFloor + 52.0}, {kArmColour, 4.0, {}});
        label({to, kSideFloor + 70.0}, "reach of the arm", kArmColour, Align::Right);
    }

    void drawPart(double x0, double x1, double y, double width, Colour fill)
    {
        for (const double side : {1.0, -1.0}) {
            const double inner = side * (y - 0.5 * width), outer = side * (y + 0.5 * width);
            canvas_.polygon(
                {above(x0, inner), above(x1, inner), above(x1, outer), above(x0, outer)}, fill,
                {kOutlineColour, 1.2, {}});
        }
    }

    void drawSides()
    {
        const LateralGeometry& y = r_.lateral;
        const double end = 0.5 * r_.trackAxle + r_.trackRadius;
        drawPart(-end, end, y.trackY, y.trackWidth, kTrackFill);
        drawPart(r_.front.pivot.x - r_.front.pivotRadius,
                 r_.front.pivot.x + r_.front.axleDistance + r_.front.tipRadius, y.flipperY,
                 y.flipperWidth, kFlipperFill);
        drawPart(r_.rear.pivot.x - r_.rear.axleDistance - r_.rear.tipRadius,
                 r_.rear.pivot.x + r_.rear.pivotRadius, y.flipperY, y.flipperWidth, kFlipperFill);
        for (const double half : {r_.halfWidth, -r_.halfWidth})
            canvas_.line(above(-end, half), above(end, half), {kMassColour, 1.5, {6.0, 4.0}});
        label({above(-end, r_.halfWidth).x + 6.0, above(-end, r_.halfWidth).y + 16.0},
              "tips over this line", kMassColour);
        const Point com = above(r_.bodyCom.x, y.bodyComY);
        canvas_.marker(Shape::Diamond, com, 12.0, kMassColour, {kMassColour, 1.0, {}});
        canvas_.marker(Shape::Triangle, above(r_.imu.x, 0.0), 13.0, kImuColour,
                       {kImuColour, 1.0, {}});
    }

    void drawNumbers()
    {
        const TipOver tips = tipOver(r_, 0.0, 0.0);
        const std::array lines{
            fmt::format("track {:.3f} m long, flippers {:.3f} m front, {:.3f} m rear from pivot to "
                        "tip; robot {:.1f} kg",
                        r_.trackAxle + 2.0 * r_.trackRadius,
                        r_.front.axleDistance + r_.front.tipRadius,
                        r_.rear.axleDistance + r_.rear.tipRadius, r_.totalMass()),
            fmt::format("tips over at {:.0f}° nose up, {:.0f}° nose down, {:.0f}° sideways, with "
                        "flippers flat; {:.3g} N m per A, at most {:.3g} N m",
                        tips.noseUp / kDegree, tips.noseDown / kDegree,
                        std::min(tips.leftUp, tips.rightUp) / kDegree, r_.torquePerAmpere,
                        r_.maxFlipperTorque)};
        for (std::size_t i = 0; i < lines.size(); ++i)
            label({20.0, kRobotHeight - 36.0 + 18.0 * static_cast<double>(i)}, lines.at(i),
                  kFigureText);
    }

    Canvas& canvas_;
    const RobotModel& r_;
    double floor_;
    double scale_ = 1.0;  // [px/m]
};

}  // namespace

Status writeRobotFigure(const std::string& path, const RobotModel& robot)
{
    return writePicture(path, kRobotWidth, kRobotHeight,
                        [&](Canvas& canvas) { RobotSheet(canvas, robot).draw(); });
}

}  // namespace terratact
