#pragma once

#include <cstddef>
#include <functional>

#include "app/figures/report/report_document.h"
#include "app/figures/wording.h"
#include "core/base/result.h"
#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Rows of a table beyond which a report counts what it leaves out.
inline constexpr std::size_t kMaxReportRows = 20'000;

/// Returns what was decided, and on which numbers, in the order of time. These are verdicts, proposals, the operator's
/// actions with what was on the screen, phases, arming, link states and notes. Words of the event list and alarms are
/// left out. An estimate has its error where the truth was recorded. Errors name the session's file: the draws of an
/// estimate cannot be read. progress(share) cancels by returning false, which is an Error.
/// wording: makes the texts. Beyond maxRows a last row has the number of rows that are left out.
Result<DocumentPart> missionDecisions(SessionReader& session, const RobotModel& robot,
                                      const std::function<bool(double)>& progress = {},
                                      std::size_t maxRows = kMaxReportRows,
                                      const Wording& wording = inEnglish);

/// Returns each alarm with the times at which it was raised and acknowledged, and at which its cause was gone.
DocumentPart missionAlarms(const SessionReader& session, const Wording& wording = inEnglish);

/// Returns the settings of the estimates, a row from each change on.
DocumentPart missionSettings(const SessionReader& session, std::size_t maxRows = kMaxReportRows,
                             const Wording& wording = inEnglish);

}  // namespace terratact
