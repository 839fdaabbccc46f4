#include "app/figures/session_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "app/figures/canvas.h"
#include "app/figures/figure_colours.h"
#include "app/figures/payload_facts.h"
#include "app/recording/recorded_sides.h"
#include "app/recording/session_text.h"
#include "app/recording/what_if.h"
#include "core/base/text.h"
#include "core/infer/estimate/provenance.h"
#include "core/infer/verdict/estimate_text.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/robot/side_plane.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {

namespace {

constexpr int kPageWidth = 1240, kPageHeight = 1754;  // A4 at 150 dots per inch
constexpr double kPageMargin = 50.0, kLine = 24.0;

double degrees(double radians)
{
    return radians * 180.0 / std::numbers::pi;
}

std::string settingsText(const Settings& s)
{
    return fmt::format(
        "method {}, ceiling {}, contacts {}, contact above {} N, contact sd {} m, at "
        "most {} draws{}, {} chains, burn-in {}, scan {}, precision {}, inducing {}, "
        "seed {}, probe above {} m",
        name(s.method), name(s.ceiling), name(s.contacts), s.forceThreshold, s.contactSd, s.draws,
        s.stopEarly ? "" : " (all)", s.chains, s.burnIn, name(s.scan), name(s.precision),
        s.inducing, s.seed, s.probeAbove);
}

std::string forcesText(const std::array<std::optional<double>, kForceElements>& forces)
{
    std::string text;
    for (const std::optional<double>& force : forces)
        text += force ? fmt::format(" {:.1f}", *force) : " --";
    return text;
}

std::string poseText(const Measurement& m, bool onePlane)
{
    std::string forces;
    if (onePlane)
        for (std::size_t e = 0; e < m.force.size(); ++e)
            forces +=
                m.missing[kFirstForceFeature + e] ? " --" : fmt::format(" {:.1f}", m.force[e]);
    else
        forces = " left" + forcesText(m.sides.left) + ", right" + forcesText(m.sides.right);
    return fmt::format("pitch {:+.1f}°, roll {:+.1f}°; flippers front {:+.1f}° {:+.1f}°, rear "
                       "{:+.1f}° {:+.1f}°; forces{} N",
                       degrees(m.pitch), degrees(m.roll), degrees(m.frontLeft),
                       degrees(m.frontRight), degrees(m.rearLeft), degrees(m.rearRight), forces);
}

/// Returns what a verdict of one profile adds to its answer: why it is not CLEAR, or withheld.
std::string reasonsText(const Verdict& v)
{
    std::string text;
    if (v.shortfall != Shortfall::None) text.append("; ").append(describe(v.shortfall).english);
    if (!v.unfelt.empty()) text += "; " + describeUnfelt(v);
    for (const WithholdReason reason : v.withheldFor)
        text.append("; ").append(describe(reason).english);
    return text;
}

std::string stepText(const Verdict& v, double limit)
{
    return fmt::format("{}: a step ahead of more than {:.2f} m has probability {:.0f} %",
                       describeStepVerdict(v), limit, 100.0 * v.step.p)
         + reasonsText(v);
}

std::string crossSlopeText(const CrossSlope& slope)
{
    return fmt::format("{:+.1f}° (left higher) at {:+.1f} m; more than {:.1f}° to a side has "
                       "probability {:.0f} %",
                       degrees(slope.steepest), binCentre(slope.bin), degrees(slope.limit),
                       100.0 * slope.beyond.p);
}

using Facts = std::vector<std::pair<std::string, std::string>>;

/// Returns the verdict of each side and what both sides mean together; nothing of one plane.
Facts verdictFacts(const TwoTrackVerdict& v, double limit)
{
    if (v.onePlane) return {};
    return {{"left", stepText(v.side[0], limit)},
            {"right", stepText(v.side[1], limit)},
            {"either side", fmt::format("a step ahead of more than {:.2f} m has probability "
                                        "{:.0f} %",
                                        limit, 100.0 * v.either.p)},
            {"cross slope", crossSlopeText(v.crossSlope)}};
}

void addRows(std::vector<std::vector<std::string>>& table, const TerrainEstimate& e,
             const RecordedSide& side, bool names)
{
    for (std::size_t i = 0; i < kBins; ++i) {
        const int bin = static_cast<int>(i);
        std::vector<std::string>& row = table.emplace_back();
        if (names) row.emplace_back(side.name);
        for (std::string& cell : std::vector<std::string>{
                 signedNumber(binCentre(bin), 1), signedNumber(e.height[i], 3),
                 fmt::format("{:.0f}", 1000.0 * e.sd[i]), signedNumber(e.q10[i], 3),
                 signedNumber(e.q90[i], 3),
                 std::isfinite(e.ceiling[i]) ? signedNumber(e.ceiling[i], 3) : "none",
                 std::string(name(provenance(e, bin))), std::string(name(e.touch[i])),
                 rhatText(e.rhat[i]), fmt::format("{:.0f}", e.ess[i])})
            row.push_back(std::move(cell));
        if (table.front().back() == "truth [m]")
            row.push_back(side.truth ? signedNumber(side.truth->at(i), 3) : "");
    }
}

std::vector<std::vector<std::string>> tableOf(const TwoTrackEstimate& e, const SceneRow& scene)
{
    std::vector<std::vector<std::string>> table{{"bin [m]", "height [m]", "sd [mm]", "q10 [m]",
                                                 "q90 [m]", "ceiling [m]", "known by", "touch",
                                                 "R-hat", "ESS"}};
    const std::vector<RecordedSide> sides = recordedSides(e.onePlane, &scene);
    if (!e.onePlane) table.front().insert(table.front().begin(), "side");
    if (std::ranges::any_of(sides, [](const auto& side) { return side.truth.has_value(); }))
        table.front().emplace_back("truth [m]");
    for (const RecordedSide& side : sides) addRows(table, e.side.at(side.index), side, !e.onePlane);
    return table;
}

/// Returns the outline of the robot, in the vertical plane of a side if there are two.
Outline outlineOf(const RobotModel& robot, const Measurement& m, bool onePlane, std::size_t index)
{
    if (onePlane) {
        const Proprioception s = proprioception(m);
        return robotOutline(robot, s.pitch, s.front, s.rear);
    }
    const Side side = index == 0 ? Side::Left : Side::Right;
    const Proprioception s = sideReadings(twoTrackReadings(m), side);
    return robotOutline(inSidePlane(robot, m.roll, signOf(side) * robot.lateral.flipperY), s.pitch,
                        s.front, s.rear);
}

/// Returns the profile of one plane, or of the left and the right side. before: the estimate before
/// this one; null: none.
std::vector<FigureInput> figuresOf(const EstimateRow& row, const EstimateRow* before,
                                   const SceneRow& scene, const RobotModel& robot,
                                   const std::string& title)
{
    const bool onePlane = row.estimate.onePlane;
    std::vector<FigureInput> figures;
    for (const RecordedSide& side : recordedSides(onePlane, &scene))
        figures.push_back({.estimate = row.estimate.side.at(side.index),
                           .previous = before ? std::optional(before->estimate.side.at(side.index))
                                              : std::nullopt,
                           .outline = outlineOf(robot, scene.measurement, onePlane, side.index),
                           .truth = side.truth,
                           .title = onePlane ? title : fmt::format("{}: {}", side.name, title),
                           .proposedBin = std::nullopt});
    return figures;
}

/// Returns the warnings of an estimate, with their side if only one side has them.
std::string warningsText(const TwoTrackEstimate& e)
{
    return english(ofBothSides(e.side[0].warnings, e.side[1].warnings), "; ");
}

/// Returns the operator's actions from this scene until the next.
std::vector<std::string> eventsOf(const SessionReader& session, const SceneRow& scene)
{
    SessionTime end = session.end();
    for (const SceneRow& other : session.scenes())
        if (other.time > scene.time) end = std::min(end, other.time - 1);
    std::vector<std::string> texts;
    for (const EventRow& e : session.events()) {
        const bool operators = e.kind == EventKind::Decision || e.kind == EventKind::Marker;
        if (!operators || e.time < scene.time || e.time > end) continue;
        texts.push_back(fmt::format(
            "{} ({}) {}{}{}{}", utcText(wallTimeOf(session.start(), e.time)), momentText(e.time),
            e.subject.empty() ? "marker" : e.subject, e.text.empty() ? "" : ": " + e.text,
            e.shown.empty() ? "" : " — on the screen: ", e.shown));
    }
    return texts;
}

const SceneRow* sceneOf(const SessionReader& session, std::int64_t id)
{
    if (id != 0) return session.scene(id);
    const SceneRow* last = nullptr;
    for (const EstimateRow& estimate : session.estimates())
        if (const SceneRow* scene = session.scene(estimate.scene)) last = scene;
    return last;
}

/// A page that is filled from the top.
class Page {
public:
    explicit Page(Canvas& canvas) : canvas_(canvas) {}

    void draw(const SessionReport& report)
    {
        y_ = 62.0;
        write(report.title, {.colour = kFigureText, .size = 27.0, .bold = true}, 34.0);
        write(report.verdict, {.colour = kFigureText, .size = 20.0, .bold = true}, 28.0);
        drawProfiles(report.figures);
        drawTable(report.table);
        for (const auto& [what, text] : report.facts) drawFact(what, text);
        drawEvents(report.events);
    }

private:
    void write(const std::string& text, const TextStyle& style, double line)
    {
        for (const std::string& part :
             canvas_.wrapped(text, kPageWidth - 2.0 * kPageMargin, style)) {
            canvas_.text({kPageMargin, y_}, part, style);
            y_ += line;
        }
    }

    /// Draws the profiles side by side.
    void drawProfiles(const std::vector<FigureInput>& figures)
    {
        const double width = (kPageWidth - 2.0 * kPageMargin) / static_cast<double>(figures.size());
        const double scale = width / kProfileWidth;
        for (std::size_t k = 0; k < figures.size(); ++k)
            canvas_.place({kPageMargin + width * static_cast<double>(k), y_ - 18.0}, scale,
                          [&](Canvas& canvas) { drawProfile(canvas, figures[k]); });
        y_ += scale * kProfileHeight;
    }

    void drawTable(const std::vector<std::vector<std::string>>& table)
    {
        const double column =
            (kPageWidth - 2.0 * kPageMargin) / static_cast<double>(table.front().size());
        constexpr std::size_t kRoomy = 11;  // columns that the usual size of letters leaves apart
        const double size = table.front().size() > kRoomy ? 13.5 : 16.0;
        for (std::size_t row = 0; row < table.size(); ++row) {
            const TextStyle style{.colour = row == 0 ? kFigureMuted : kFigureText,
                                  .size = size,
                                  .bold = row == 0,
                                  .align = Align::Right};
            for (std::size_t k = 0; k < table[row].size(); ++k)
                canvas_.text({kPageMargin + column * static_cast<double>(k + 1) - 8.0, y_},
                             table[row][k], style);
            y_ += kLine - 1.0;
            if (row == 0) rule(y_ - 18.0);
        }
        rule(y_ - 16.0);
        y_ += 10.0;
    }

    void rule(double y)
    {
        canvas_.line({kPageMargin, y}, {kPageWidth - kPageMargin, y}, {kFigureFrame, 1.0, {}});
    }

    void drawFact(const std::string& what, const std::string& text)
    {
        constexpr double kColumn = 130.0;
        const TextStyle heading{.colour = kFigureMuted, .size = 16.0, .bold = true};
        const TextStyle style{.colour = kFigureText, .size = 16.0};
        canvas_.text({kPageMargin, y_}, what, heading);
        for (const std::string& part :
             canvas_.wrapped(text, kPageWidth - 2.0 * kPageMargin - kColumn, style)) {
            canvas_.text({kPageMargin + kColumn, y_}, part, style);
            y_ += kLine - 1.0;
        }
    }

    /// Draws as many events as fit, and the number of omitted ones.
    void drawEvents(const std::vector<std::string>& events)
    {
        const TextStyle style{.colour = kFigureText, .size = 16.0};
        const double bottom = kPageHeight - kPageMargin;
        y_ += 8.0;
        write(events.empty() ? "The operator decided nothing here" : "The operator",
              {.colour = kFigureMuted, .size = 16.0, .bold = true}, kLine);
        for (std::size_t k = 0; k < events.size(); ++k) {
            const auto lines = canvas_.wrapped(events[k], kPageWidth - 2.0 * kPageMargin, style);
            const double needed = kLine * static_cast<double>(lines.size());
            const double reserved = k + 1 < events.size() ? kLine : 0.0;
            if (y_ + needed + reserved > bottom) {
                write(fmt::format("… and {} more in the session", events.size() - k), style, kLine);
                return;
            }
            write(events[k], style, kLine);
        }
    }

    Canvas& canvas_;
    double y_ = 0.0;  ///< base line of the next item
};

std::string escaped(std::string_view text)
{
    std::string html;
    for (const char c : text) switch (c) {
        case '<': html += "&lt;"; break;
        case '>': html += "&gt;"; break;
        case '&': html += "&amp;"; break;
        case '"': html += "&quot;"; break;
        default: html += c;
        }
    return html;
}

std::string htmlOf(const SessionReport& report)
{
    std::string svg;
    for (const FigureInput& figure : report.figures) {
        const std::string profile = svgText(kProfileWidth, kProfileHeight,
                                            [&](Canvas& canvas) { drawProfile(canvas, figure); });
        svg += profile.substr(profile.find("<svg"));
    }
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n"
        "<style>body{{font-family:sans-serif;color:#16222e;max-width:1200px;margin:2em "
        "auto;padding:0 1em}}"
        "svg{{width:100%;height:auto}}table{{border-collapse:collapse;width:100%}}"
        "td,th{{text-align:right;padding:.2em .6em;border-bottom:1px solid #cfd8e1}}"
        "dt{{font-weight:bold;color:#4a5866}}dd{{margin:0 0 .4em "
        "1em;overflow-wrap:anywhere}}</style></head>\n"
        "<body><h1>{0}</h1>\n<p><strong>{1}</strong></p>\n{2}\n<table>\n",
        escaped(report.title), escaped(report.verdict), svg);
    for (std::size_t row = 0; row < report.table.size(); ++row) {
        html += "<tr>";
        for (const std::string& cell : report.table[row])
            html += fmt::format("<{0}>{1}</{0}>", row == 0 ? "th" : "td", escaped(cell));
        html += "</tr>\n";
    }
    html += "</table>\n<dl>\n";
    for (const auto& [what, text] : report.facts)
        html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(what), escaped(text));
    html += "</dl>\n<h2>The operator</h2>\n<ul>\n";
    for (const std::string& event : report.events)
        html += fmt::format("<li>{}</li>\n", escaped(event));
    return html + "</ul></body></html>\n";
}

/// Returns the scene's estimates in order, without those of a second method.
std::vector<const EstimateRow*> estimatesOf(const SessionReader& session, std::int64_t scene)
{
    std::vector<const EstimateRow*> rows;
    for (const EstimateRow& row : session.estimates())
        if (row.scene == scene && row.role != EstimateRole::Second) rows.push_back(&row);
    return rows;
}

std::string readingsText(const EstimateRow& row)
{
    std::string text;
    for (const ArmReading& r : row.readings)
        text += fmt::format("{}{:+.3f} m at {:+.1f} m{} (sd {:.0f} mm)", text.empty() ? "" : ", ",
                            r.height, binCentre(r.bin),
                            r.side == ProbeSide::Middle ? "" : fmt::format(" {}", name(r.side)),
                            1000.0 * r.sd);
    return text.empty() ? "none" : text;
}

}  // namespace

Result<SessionReport> reportOf(SessionReader& session, std::int64_t wanted,
                               const std::function<bool(double)>& progress,
                               const std::shared_ptr<const DbcBook>& book)
{
    const SceneRow* scene = sceneOf(session, wanted);
    if (!scene)
        return fileError(session.path(), wanted != 0 ? fmt::format("has no scene {}", wanted)
                                                     : "has no scene with an estimate");
    const auto rows = estimatesOf(session, scene->id);
    if (rows.empty())
        return fileError(session.path(), fmt::format("scene {} was not estimated", scene->id));
    const auto robot = robotOf(session);
    if (!robot) return robot.error();
    EstimateRow row = *rows.back();
    auto full = recordedEstimate(session, row);
    if (!full) return full.error();
    row.estimate = std::move(*full);

    const SessionStart& start = session.start();
    const ModelRow* model = session.model(row.model);
    bool goesOn = true;
    const SessionVerification found =
        session.verify([&](double share) { return goesOn = !progress || progress(share); });
    if (!goesOn) return fileError(session.path(), "no report: ended before all was read");
    SessionReport report;
    report.title = fmt::format("Scene {} of {}", scene->id,
                               std::filesystem::path(session.path()).filename().string());
    const TwoTrackVerdict verdict =
        verdictOf(row.estimate, *robot, scene->measurement, {}, row.stepLimit);
    report.verdict =
        verdict.onePlane ? stepText(verdict.side[0], row.stepLimit) : describe(verdict);
    report.figures =
        figuresOf(row, rows.size() > 1 ? rows[rows.size() - 2] : nullptr, *scene, *robot,
                  fmt::format("Estimate {}, {}", row.id, utcText(wallTimeOf(start, row.time))));
    report.table = tableOf(row.estimate, *scene);
    report.facts = {
        {"source",
         fmt::format("{}, bus {}, recorded by {}", start.source, start.bus, start.program)},
        {"captured", fmt::format("{}, {} after the session's start",
                                 utcText(wallTimeOf(start, scene->time)), momentText(scene->time))},
        {"estimated",
         fmt::format("{}, in {:.2f} s{}", momentText(row.time), row.seconds,
                     row.estimate.side[0].ending == Ending::NotSampled
                         ? ""
                         : fmt::format(", sampling ended: {}", name(row.estimate.side[0].ending)))},
        {"pose", poseText(scene->measurement, row.estimate.onePlane)},
        {"arm", readingsText(row)},
        {"settings", settingsText(row.estimate.side[0].settings)},
        {"robot", fmt::format("{}, SHA-256 {}", robot->name, start.robotHash)},
        {"model", model ? fmt::format("{}, SHA-256 {}", model->name, model->hash) : "damaged"},
        {"session",
         fmt::format("{}; last link of its chain {}",
                     found.damage.empty() && !found.broken ? "every hash holds"
                                                           : "PARTS ARE NOT WHAT WAS RECORDED",
                     found.chain)}};
    const Facts payload = payloadFacts(session, book, scene->time);
    report.facts.insert(report.facts.end(), payload.begin(), payload.end());
    const Facts verdicts = verdictFacts(verdict, row.stepLimit);
    report.facts.insert(report.facts.begin(), verdicts.begin(), verdicts.end());
    if (const std::string warnings = warningsText(row.estimate); !warnings.empty())
        report.facts.insert(report.facts.begin(), {"warnings", warnings});
    report.events = eventsOf(session, *scene);
    return report;
}

Status writeReport(const std::string& path, const SessionReport& report)
{
    if (path.ends_with(".html")) return writeFileAtomically(path, htmlOf(report));
    return writePicture(path, kPageWidth, kPageHeight,
                        [&](Canvas& canvas) { Page(canvas).draw(report); });
}

}  // namespace terratact
