#include "app/figures/session_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "app/figures/canvas.h"
#include "app/figures/figure_colours.h"
#include "app/recording/session_text.h"
#include "app/recording/what_if.h"
#include "core/base/text.h"
#include "core/infer/estimate/provenance.h"
#include "core/infer/verdict/verdict.h"
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

std::string poseText(const Measurement& m)
{
    std::string forces;
    for (std::size_t e = 0; e < m.force.size(); ++e)
        forces += m.missing[kFirstForceFeature + e] ? " --" : fmt::format(" {:.1f}", m.force[e]);
    return fmt::format("pitch {:+.1f}°, roll {:+.1f}°; flippers front {:+.1f}° {:+.1f}°, rear "
                       "{:+.1f}° {:+.1f}°; forces{} N",
                       degrees(m.pitch), degrees(m.roll), degrees(m.frontLeft),
                       degrees(m.frontRight), degrees(m.rearLeft), degrees(m.rearRight), forces);
}

std::string verdictText(const EstimateRow& row, const SceneRow& scene)
{
    const Verdict v = verdictOf(row.estimate.side[0], scene.measurement, {}, row.stepLimit);
    std::string text =
        fmt::format("{}: a step ahead of more than {:.2f} m has probability {:.0f} %",
                    describeStepVerdict(v), row.stepLimit, 100.0 * v.step.p);
    if (v.shortfall != Shortfall::None) text.append("; ").append(describe(v.shortfall).english);
    if (!v.unfelt.empty()) text += "; " + describeUnfelt(v);
    for (const WithholdReason reason : v.withheldFor)
        text.append("; ").append(describe(reason).english);
    return text;
}

std::vector<std::vector<std::string>> tableOf(const TerrainEstimate& e, const SceneRow& scene)
{
    std::vector<std::vector<std::string>> table{{"bin [m]", "height [m]", "sd [mm]", "q10 [m]",
                                                 "q90 [m]", "ceiling [m]", "known by", "touch",
                                                 "R-hat", "ESS"}};
    if (scene.truth) table.front().emplace_back("truth [m]");
    for (std::size_t i = 0; i < kBins; ++i) {
        const int bin = static_cast<int>(i);
        table.push_back({signedNumber(binCentre(bin), 1), signedNumber(e.height[i], 3),
                         fmt::format("{:.0f}", 1000.0 * e.sd[i]), signedNumber(e.q10[i], 3),
                         signedNumber(e.q90[i], 3),
                         std::isfinite(e.ceiling[i]) ? signedNumber(e.ceiling[i], 3) : "none",
                         std::string(name(provenance(e, bin))), std::string(name(e.touch[i])),
                         rhatText(e.rhat[i]), fmt::format("{:.0f}", e.ess[i])});
        if (scene.truth) table.back().push_back(signedNumber(scene.truth->at(i), 3));
    }
    return table;
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
        const double scale = (kPageWidth - 2.0 * kPageMargin) / kProfileWidth;
        canvas_.place({kPageMargin, y_ - 18.0}, scale,
                      [&](Canvas& canvas) { drawProfile(canvas, report.figure); });
        y_ += scale * kProfileHeight;
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

    void drawTable(const std::vector<std::vector<std::string>>& table)
    {
        const double column =
            (kPageWidth - 2.0 * kPageMargin) / static_cast<double>(table.front().size());
        for (std::size_t row = 0; row < table.size(); ++row) {
            const TextStyle style{.colour = row == 0 ? kFigureMuted : kFigureText,
                                  .size = 16.0,
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
    for (const char c : text) {
        if (c == '<')
            html += "&lt;";
        else if (c == '>')
            html += "&gt;";
        else if (c == '&')
            html += "&amp;";
        else if (c == '"')
            html += "&quot;";
        else
            html += c;
    }
    return html;
}

std::string htmlOf(const SessionReport& report)
{
    std::string svg = svgText(kProfileWidth, kProfileHeight,
                              [&](Canvas& canvas) { drawProfile(canvas, report.figure); });
    svg.erase(0, svg.find("<svg"));
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
        text += fmt::format("{}{:+.3f} m at {:+.1f} m (sd {:.0f} mm)", text.empty() ? "" : ", ",
                            r.height, binCentre(r.bin), 1000.0 * r.sd);
    return text.empty() ? "none" : text;
}

}  // namespace

Result<SessionReport> reportOf(SessionReader& session, std::int64_t wanted,
                               const std::function<bool(double)>& progress)
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
    const Proprioception s = proprioception(scene->measurement);
    bool goesOn = true;
    const SessionVerification found =
        session.verify([&](double share) { return goesOn = !progress || progress(share); });
    if (!goesOn) return fileError(session.path(), "no report: ended before all was read");
    SessionReport report;
    report.title = fmt::format("Scene {} of {}", scene->id,
                               std::filesystem::path(session.path()).filename().string());
    report.verdict = verdictText(row, *scene);
    report.figure = {
        .estimate = row.estimate.side[0],
        .previous =
            rows.size() > 1 ? std::optional(rows[rows.size() - 2]->estimate.side[0]) : std::nullopt,
        .outline = robotOutline(*robot, s.pitch, s.front, s.rear),
        .truth = scene->truth,
        .title = fmt::format("Estimate {}, {}", row.id, utcText(wallTimeOf(start, row.time))),
        .proposedBin = std::nullopt};
    report.table = tableOf(row.estimate.side[0], *scene);
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
        {"pose", poseText(scene->measurement)},
        {"arm", readingsText(row)},
        {"settings", settingsText(row.estimate.side[0].settings)},
        {"robot", fmt::format("{}, SHA-256 {}", robot->name, start.robotHash)},
        {"model", model ? fmt::format("{}, SHA-256 {}", model->name, model->hash) : "damaged"},
        {"session",
         fmt::format("{}; last link of its chain {}",
                     found.damage.empty() && !found.broken ? "every hash holds"
                                                           : "PARTS ARE NOT WHAT WAS RECORDED",
                     found.chain)}};
    if (!row.estimate.side[0].warnings.empty())
        report.facts.insert(report.facts.begin(),
                            {"warnings", english(row.estimate.side[0].warnings, "; ")});
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
