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

/// The signals of a recording that DBC files describe: those of every message that comes in it.
class PayloadSignals {
public:
    static constexpr std::size_t kMaxSignals = 2000;  ///< messages beyond have none

    /// A message that comes.
    struct Message {
        std::shared_ptr<const DescribedFrame> described;
        std::string name;             ///< no other has it: "EEC1 from 0x00" of a parameter group
        std::size_t firstSignal = 0;  ///< how many signals the messages before it have
    };

    /// book: null: there are none.
    explicit PayloadSignals(std::shared_ptr<const DbcBook> book) : book_(std::move(book)) {}

    bool hasBook() const { return book_ != nullptr; }

    /// To be called with every frame of the recording, before the rest.
    void note(const CanFrame& frame);
    void name();  ///< after the last of them

    const std::vector<Message>& messages() const { return messages_; }
    std::size_t signals() const { return signals_; }         ///< of all messages
    std::size_t leftOut() const { return leftOut_.size(); }  ///< messages beyond kMaxSignals

    /// Which of messages() a frame is; empty: none.
    std::optional<std::size_t> find(const CanFrame& frame) const;

private:
    std::shared_ptr<const DbcBook> book_;
    std::map<std::pair<bool, std::uint32_t>, std::size_t> byId_;
    std::set<std::pair<bool, std::uint32_t>> leftOut_;
    std::vector<std::uint32_t> ids_;  // of messages
    std::vector<Message> messages_;
    std::size_t signals_ = 0;
};

/// "GasSensor.Oxygen [%]"
std::string headingOf(const PayloadSignals::Message& message, const DbcSignal& signal);

/// A JSON schema of its signals, and the values of a frame of it: {"Oxygen":20.7}.  What is no finite number is not in
/// it.
std::string jsonSchemaOf(const PayloadSignals::Message& message);
std::string jsonValuesOf(const DbcMessage& message, const CanFrame& frame);

/// The numbers of a frame in the order of the message's signals, with all their digits; empty where one is not in it.
std::vector<std::string> numbersOf(const DbcMessage& message, const CanFrame& frame);

}  // namespace terratact
