#include "app/figures/report/payload_facts.h"

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <optional>

#include "app/link/can_text.h"
#include "core/base/text.h"
#include "core/wire/dbc/dbc_text.h"

namespace terratact {
namespace {

/// The newest values of one kind of frame; a multiplexed signal keeps its last one.
struct NewestPayload {
    std::shared_ptr<const DescribedFrame> described;
    std::string id;
    SessionTime time = 0;
    std::vector<std::optional<std::uint64_t>> bits{};

    void add(const FrameRow& row)
    {
        const DbcMessage& message = described->message;
        std::vector<std::optional<std::uint64_t>> now(message.payload.size());
        decodeBits(message, row.frame, now);
        bits.resize(now.size());
        for (std::size_t i = 0; i < now.size(); ++i)
            if (now[i]) bits[i] = now[i];
        time = row.time;
    }

    std::string text(SessionTime until, const Wording& wording) const
    {
        std::string values;
        for (std::size_t i = 0; i < bits.size(); ++i) {
            const DbcSignal& signal = described->message.payload[i];
            if (!bits[i]) continue;
            const std::string unit = shownDbcText(signal.unit);
            values += fmt::format("{}{} {}{}{}", values.empty() ? "" : ", ", signal.name,
                                  wordOrNumber(signal, *bits[i]), unit.empty() ? "" : " ", unit);
        }
        return printable(wording(
            {TR_NOOP("Report", "%1 %2: %3, %4 s before"), id, described->message.name,
             values.empty() ? Message(TR_NOOP("Report", "no value")) : Message::verbatim(values),
             fixed(secondsOf(until - time), 1)}));
    }
};

}  // namespace

std::vector<std::pair<std::string, std::string>>
payloadFacts(SessionReader& session, const std::shared_ptr<const DbcBook>& book, SessionTime time,
             const Wording& wording)
{
    std::vector<std::pair<std::string, std::string>> facts;
    if (!book) return facts;
    std::map<std::pair<bool, std::uint32_t>, NewestPayload> newest;
    const SessionTime from = time - sessionTimeOf(kPayloadWindow);
    for (std::size_t i = session.batchAt(from);
         i < session.batches().size() && session.batches()[i].first <= time; ++i)
        for (const FrameRow& row : session.frames(i)) {
            if (row.time < from || row.time > time) continue;
            const std::pair key(row.frame.extended, row.frame.id);
            auto found = newest.find(key);
            if (found == newest.end()) {
                auto described = book->find(row.frame);
                if (!described) continue;
                found = newest.emplace(key, NewestPayload{std::move(described), idText(row.frame)})
                            .first;
            }
            found->second.add(row);
        }
    const std::string what = wording(TR_NOOP("Report", "payload"));
    for (const auto& [key, payload] : newest) {
        if (facts.size() == kMaxPayloadFacts) {
            facts.emplace_back(what, wording({TR_NOOP("Report", "… and %1 more in the session"),
                                              newest.size() - facts.size()}));
            break;
        }
        facts.emplace_back(what, payload.text(time, wording));
    }
    return facts;
}

}  // namespace terratact
