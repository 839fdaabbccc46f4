#pragma once

#include <string>
#include <vector>

#include "core/mapping/recording_survey.h"

namespace terratact {

/// Returns what a recording holds, in lines. The first names its format. A topic has its type, messages, rate, longest
/// gap, and the range of each field. Names are those of the file and untrusted.
std::string surveyText(const Recording& recording, const std::vector<TopicSurvey>& surveys);

}  // namespace terratact
