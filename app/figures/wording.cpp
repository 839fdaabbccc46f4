#include "app/figures/wording.h"

#include <utility>

namespace terratact {
namespace {

/// Texts of tables: names of enumerators, for translators.
[[maybe_unused]] constexpr SourceText kTableNames[] = {
    TR_NOOP("Report", "both"),         TR_NOOP("Report", "left"),
    TR_NOOP("Report", "right"),        TR_NOOP("Report", "arm"),
    TR_NOOP("Report", "contact"),      TR_NOOP("Report", "constrained"),
    TR_NOOP("Report", "sampled"),      TR_NOOP("Report", "prior only"),
    TR_NOOP("Report", "felt"),         TR_NOOP("Report", "remembered"),
    TR_NOOP("Report", "felt in part"), TR_NOOP("Report", "bounded"),
    TR_NOOP("Report", "not felt"),     TR_NOOP("Report", "not recorded"),
    TR_NOOP("Report", "converged"),    TR_NOOP("Report", "sweeps"),
    TR_NOOP("Report", "time"),
};

Message inContext(const char* context, std::string text)
{
    Message message = Message::verbatim(std::move(text));
    message.context = context;
    return message;
}

}  // namespace

std::string inEnglish(const Message& message)
{
    return message.english();
}

Message eventName(std::string name)
{
    return inContext("event", std::move(name));
}

Message sourceMessage(std::string_view name)
{
    constexpr std::string_view kReplayed = "REPLAY ";
    if (!name.starts_with(kReplayed)) return inContext("source", std::string(name));
    return {TR_NOOP("source", "REPLAY %1"), name.substr(kReplayed.size())};
}

Message tableWord(std::string_view name)
{
    return inContext("Report", std::string(name));
}

}  // namespace terratact
