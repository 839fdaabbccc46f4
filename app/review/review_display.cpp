#include "app/review/review_display.h"

#include <QLabel>
#include <algorithm>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/text/robot_text.h"
#include "app/review/review_timeline.h"
#include "core/atem/link_watch.h"
#include "widgets/control/robot_readout.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"

namespace terratact {
namespace {

EventSeverity severityOf(const EventRow& event)
{
    const bool isBad = event.subject == "bad" || event.kind == EventKind::Gap
                    || (event.kind == EventKind::Alarm && event.number == 3.0)
                    || (event.kind == EventKind::Link && event.subject != kLinkUp);
    return isBad                    ? EventSeverity::Bad
         : event.subject == "doubt" ? EventSeverity::Warning
                                    : EventSeverity::Note;
}

}  // namespace

ReviewDisplay::ReviewDisplay(const SessionReader& session, const Places& places)
    : session_(session), places_(places)
{
}

void ReviewDisplay::show(const ReviewMoment& moment)
{
    showHeader(moment);
    showDamage(moment);
    showEvents(moment.time);
}

void ReviewDisplay::showLink(const ReviewMoment& moment)
{
    const bool isMeasured = moment.measurement.has_value();
    const double age = secondsOf(moment.time - (isMeasured ? moment.measured : moment.linkSince));
    if (moment.linkAlive && isMeasured)
        places_.header.setLink(tr("link %1 Hz").arg(format::number(moment.linesPerSecond, 0)),
                               Tone::Good);
    else if (!moment.linkAlive && moment.linkSince > 0)
        places_.header.setLink(QStringLiteral("%1 · %2").arg(
                                   translated(describe(LinkAccount{.standing = LinkStanding::Lost,
                                                                   .alone = moment.telemetryAlone}))
                                       .toUpper(),
                                   format::age(age)),
                               Tone::Bad);
    else
        places_.header.setLink(tr("no telemetry"), Tone::Warning);
}

void ReviewDisplay::showHeader(const ReviewMoment& moment)
{
    StatusHeader& header = places_.header;
    showLink(moment);
    if (moment.measurement && secondsOf(moment.time - moment.measured) <= kStaleAfter)
        header.setRobot(glance(moment.measurement->activity), toneOf(moment.measurement->activity));
    else
        header.setRobot(tr("robot: --"), Tone::Plain);
    if (moment.model)
        header.setModel(tr("model %1").arg(format::shownName(moment.model->name)), Tone::Plain,
                        format::text(moment.model->details));
    else
        header.setModel(tr("no model"), Tone::Warning);
    header.setOverridden(translatedLine(moment.overridden));
    const auto unseen =
        std::count_if(moment.alarms.begin(), moment.alarms.end(),
                      [](const Alarm& alarm) { return alarm.state != AlarmState::Acknowledged; });
    header.setAlarms(static_cast<int>(unseen), static_cast<int>(moment.alarms.size()));
}

void ReviewDisplay::showDamage(const ReviewMoment& moment)
{
    places_.damage.setVisible(moment.damage.has_value());
    if (moment.damage)
        places_.damage.setText(tr("DAMAGED from %1 to %2; this part is not shown: %3")
                                   .arg(timeText(secondsOf(moment.damage->first)),
                                        timeText(secondsOf(moment.damage->last)),
                                        translated(moment.damage->why)));
}

/// Shows the events up to this time, as the operator saw them.
void ReviewDisplay::showEvents(SessionTime until)
{
    constexpr std::size_t kListed = 40;
    std::vector<const EventRow*> last;
    for (const EventRow& event : session_.events())
        if (event.time <= until && event.kind != EventKind::Session) last.push_back(&event);
    const std::int64_t newest = last.empty() ? 0 : last.back()->id;
    if (newest == listed_) return;
    listed_ = newest;
    places_.events.clear();
    const std::size_t from = last.size() - std::min(last.size(), kListed);
    for (std::size_t i = from; i < last.size(); ++i)
        places_.events.add(sentenceOf(*last[i]), severityOf(*last[i]),
                           wallClock(session_, last[i]->time).time());
}

}  // namespace terratact
