#include "core/wire/can_error.h"

#include <gtest/gtest.h>

#include <linux/can/error.h>

#include <set>
#include <stdexcept>

namespace terratact {
namespace {

CanFrame errorFrame(std::uint32_t classes, std::array<std::uint8_t, kFdBytes> data = {})
{
    return {.id = classes, .error = true, .length = 8, .data = data};
}

TEST(CanError, aFrameOfDataHasNoErrorInIt)
{
    EXPECT_THROW((void)controllerState(CanFrame{}), std::invalid_argument);
    EXPECT_THROW((void)describeError(CanFrame{}), std::invalid_argument);
}

TEST(CanError, describesWhatTheControllerMayStillDo)
{
    using enum ControllerState;
    struct Row {
        std::uint32_t classes;
        std::uint8_t controller;
        std::optional<ControllerState> expected;
    };
    for (const Row& row :
         {Row{CAN_ERR_BUSOFF, 0, BusOff},
          {CAN_ERR_BUSOFF | CAN_ERR_CRTL, CAN_ERR_CRTL_ACTIVE, BusOff},
          {CAN_ERR_RESTARTED, 0, Active},
          {CAN_ERR_CRTL, CAN_ERR_CRTL_RX_PASSIVE, Passive},
          {CAN_ERR_CRTL, CAN_ERR_CRTL_TX_PASSIVE, Passive},
          {CAN_ERR_CRTL, CAN_ERR_CRTL_TX_PASSIVE | CAN_ERR_CRTL_RX_WARNING, Passive},
          {CAN_ERR_CRTL, CAN_ERR_CRTL_RX_WARNING, Warning},
          {CAN_ERR_CRTL, CAN_ERR_CRTL_TX_WARNING, Warning},
          {CAN_ERR_CRTL, CAN_ERR_CRTL_ACTIVE, Active},
          {CAN_ERR_CRTL, CAN_ERR_CRTL_RX_OVERFLOW, std::nullopt},
          {CAN_ERR_PROT, CAN_ERR_CRTL_TX_PASSIVE, std::nullopt},
          {CAN_ERR_ACK, 0, std::nullopt},
          {0, 0, std::nullopt}})
        EXPECT_EQ(controllerState(errorFrame(row.classes, {0, row.controller})), row.expected)
            << std::hex << row.classes << " " << int{row.controller};
}

TEST(CanError, missingBytesCountAsUnspecified)
{
    CanFrame frame = errorFrame(CAN_ERR_CRTL, {0, CAN_ERR_CRTL_TX_PASSIVE});
    frame.length = 1;
    EXPECT_EQ(controllerState(frame), std::nullopt);
    EXPECT_EQ(describeError(frame), "controller: unspecified");
}

TEST(CanError, hasATextForPeople)
{
    EXPECT_EQ(describeError(errorFrame(CAN_ERR_BUSOFF | CAN_ERR_CNT, {0, 0, 0, 0, 0, 0, 136, 12})),
              "bus-off; 136 transmit and 12 receive errors");
    EXPECT_EQ(describeError(errorFrame(CAN_ERR_LOSTARB, {12})), "arbitration lost in bit 12");
    EXPECT_EQ(describeError(errorFrame(CAN_ERR_LOSTARB)), "arbitration lost");
    EXPECT_EQ(describeError(errorFrame(CAN_ERR_CRTL, {0, 0x30})),
              "controller: error passive in receiving, error passive in transmitting");
    EXPECT_EQ(describeError(errorFrame(
                  CAN_ERR_PROT | CAN_ERR_BUSERROR,
                  {0, 0, CAN_ERR_PROT_STUFF | CAN_ERR_PROT_TX, CAN_ERR_PROT_LOC_CRC_SEQ})),
              "bus error; protocol: bit stuffing, in transmitting at checksum");
    EXPECT_EQ(describeError(errorFrame(CAN_ERR_TRX, {0, 0, 0, 0, 0x47})),
              "transceiver: CAN-H shorted to ground, CAN-L has no wire");
    EXPECT_EQ(describeError(errorFrame(0)), "unspecified error");
    EXPECT_EQ(describeError(errorFrame(0x00010000)), "unknown class 0x10000");
    EXPECT_EQ(describeError(errorFrame(CAN_ERR_TRX, {0, 0, 0, 0, 0x09})),
              "transceiver: unknown state 0x09");
}

// Every class with every value of every detail byte has its own text.
TEST(CanError, noTwoDifferentDetailsReadTheSame)
{
    struct Detail {
        std::uint32_t classes;
        std::size_t byte;
        std::size_t different;  // of the 256 values
    };
    for (const Detail& detail : {Detail{CAN_ERR_LOSTARB, 0, 256},
                                 {CAN_ERR_CRTL, 1, 128},  // seven bits have a meaning
                                 {CAN_ERR_PROT, 2, 256},
                                 {CAN_ERR_PROT, 3, 256},
                                 {CAN_ERR_TRX, 4, 256},
                                 {CAN_ERR_CNT, 6, 256},
                                 {CAN_ERR_CNT, 7, 256}}) {
        std::set<std::string> words;
        for (int value = 0; value < 256; ++value) {
            CanFrame frame = errorFrame(detail.classes);
            frame.data[detail.byte] = static_cast<std::uint8_t>(value);
            words.insert(describeError(frame));
        }
        EXPECT_EQ(words.size(), detail.different) << "class " << detail.classes;
    }
}

TEST(CanError, everyClassIsNamed)
{
    std::set<std::string> words;
    for (std::uint32_t bit = 1; bit <= CAN_ERR_CNT; bit <<= 1)
        words.insert(describeError(errorFrame(bit)));
    EXPECT_EQ(words.size(), 10u);
    for (const std::string& word : words)
        EXPECT_EQ(word.find("unknown"), std::string::npos) << word;
}

}  // namespace
}  // namespace terratact
