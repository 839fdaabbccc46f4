#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/link/dbc_book.h"
#include "core/wire/can_frame.h"

namespace terratact {

/// The DBC-described signals of a recording: those of every described message that occurs in it.
class PayloadSignals {
public:
    /// Bound on signals; messages beyond it are left out.
    static constexpr std::size_t kMaxSignals = 2000;

    /// A described message that occurs in the recording.
    struct Message {
        std::shared_ptr<const DescribedFrame> described;
        std::string name;             ///< unique name: "EEC1 from 0x00" for a parameter group
        std::size_t firstSignal = 0;  ///< number of signals in earlier messages
    };

    /// book: null: no descriptions.
    explicit PayloadSignals(std::shared_ptr<const DbcBook> book) : book_(std::move(book)) {}

    bool hasBook() const { return book_ != nullptr; }

    /// Registers a frame. Call with every frame of the recording before using messages().
    void note(const CanFrame& frame);
    void name();  ///< call after the last note()

    const std::vector<Message>& messages() const { return messages_; }
    std::size_t signals() const { return signals_; }  ///< total over all messages
    /// Returns the number of messages beyond kMaxSignals.
    std::size_t leftOut() const { return leftOut_.size(); }

    /// Returns the index of a frame's message in messages(); empty: none.
    std::optional<std::size_t> find(const CanFrame& frame) const;

private:
    std::shared_ptr<const DbcBook> book_;
    std::map<std::pair<bool, std::uint32_t>, std::size_t> byId_;
    std::set<std::pair<bool, std::uint32_t>> leftOut_;
    std::vector<std::uint32_t> ids_;  // ids of messages()
    std::vector<Message> messages_;
    std::size_t signals_ = 0;
};

/// Returns a column heading: "GasSensor.Oxygen [%]".
std::string headingOf(const PayloadSignals::Message& message, const DbcSignal& signal);

/// Return the JSON schema of a message's signals, and a frame's values: {"Oxygen":20.7}. Numbers that are not finite
/// are null. Signals that the frame lacks are omitted.
std::string jsonSchemaOf(const PayloadSignals::Message& message);
std::string jsonValuesOf(const DbcMessage& message, const CanFrame& frame);

/// Returns a frame's values in the order of the message's signals, with all digits; empty for an absent signal.
std::vector<std::string> numbersOf(const DbcMessage& message, const CanFrame& frame);

}  // namespace terratact
