// Session files: written rows are read back.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "core/infer/verdict/verdict.h"
#include "core/log/session_reader.h"
#include "core/log/session_writer.h"
#include "core/robot/two_tracks.h"
#include "tests/core/log/session_fixture.h"
#include "tests/support/refusal.h"
#include "tests/support/sessions/sessions.h"

namespace terratact {
namespace {

TEST_F(Session, givesBackEveryRow)
{
    seal(path, 1000);
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_TRUE(reader->sealed());
    EXPECT_EQ(reader->start(), someStart());
    EXPECT_EQ(reader->frameCount(), 1000);
    EXPECT_EQ(reader->begin(), 0);
    EXPECT_EQ(reader->end(), 999'000'000);
    const auto frames = allFrames(*reader);
    ASSERT_EQ(frames.size(), 1000U);
    for (std::int64_t n = 0; n < 1000; ++n)
        EXPECT_EQ(frames[static_cast<std::size_t>(n)], someFrame(n));
    ASSERT_EQ(reader->scenes().size(), 2U);
    EXPECT_EQ(reader->scenes()[0], someScene(1, 250'000'000));
    EXPECT_EQ(reader->scenes()[1], someScene(2, 500'000'001));
    ASSERT_EQ(reader->estimates().size(), 2U);
    for (const std::int64_t id : {1, 2}) {
        EstimateRow expected = id == 1 ? someEstimate(1, 250'000'001) : someSides(2, 500'000'002);
        const auto draws = reader->draws(id);
        ASSERT_TRUE(draws) << draws.error().text;
        for (const std::size_t side : {0U, 1U}) {
            EXPECT_EQ(draws->at(side), expected.estimate.side.at(side).draws);
            expected.estimate.side.at(side).draws.clear();
        }
        EXPECT_EQ(*reader->estimate(id), expected);
    }
    ASSERT_EQ(reader->proposals().size(), 1U);
    EXPECT_EQ(reader->proposals()[0], someProposal(250'000'002));
    ASSERT_EQ(reader->events().size(), 2U);
    EXPECT_EQ(reader->events()[1], someDecision(500'000'000));
    EXPECT_EQ(reader->model(1)->name, "default.ttm");
    EXPECT_TRUE(reader->damage().empty());
    EXPECT_FALSE(std::filesystem::exists(path + "-wal"));
    const auto verified = reader->verify();
    EXPECT_FALSE(verified.broken);
    EXPECT_EQ(verified.frames, 1000);
}

TEST_F(Session, keepsWhatASceneLacks)
{
    auto writer = someSession(path, 100);
    ASSERT_TRUE(writer) << writer.error().text;
    SceneRow scene = someScene(3, 600'000'000);
    scene.measurement.force[3] = 0.0;
    scene.measurement.missing[kFirstForceFeature + 3] = true;
    scene.measurement.missing[kRearCurrentFeature] = true;
    EstimateRow estimate = someEstimate(3, 600'000'001);
    for (TerrainEstimate& side : estimate.estimate.side) side.missing = scene.measurement.missing;
    ASSERT_TRUE(writer->add(scene));
    ASSERT_TRUE(writer->add(estimate));
    ASSERT_TRUE(writer->seal());
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    ASSERT_EQ(reader->scenes().size(), 3U);
    EXPECT_EQ(reader->scenes()[2], scene);
    EXPECT_EQ(reader->estimate(3)->estimate.side[1].missing, scene.measurement.missing);
    EXPECT_TRUE(reader->estimate(1)->estimate.side[1].missing.none());
    EXPECT_FALSE(reader->verify().broken);
}

TEST_F(Session, keepsTheCurrentOfOneMotor)
{
    auto writer = someSession(path, 100);
    ASSERT_TRUE(writer) << writer.error().text;
    std::vector<SceneRow> lacking;
    for (std::size_t motor = 0; motor < kMotors; ++motor) {
        const auto more = static_cast<std::int64_t>(motor);
        SceneRow& scene = lacking.emplace_back(someScene(3 + more, 600'000'000 + more));
        MotorCurrents currents{0.1, 0.2, 0.3, 0.4};
        currents[motor].reset();
        setCurrents(scene.measurement, currents);
        ASSERT_TRUE(writer->add(scene));
    }
    ASSERT_TRUE(writer->seal());
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    ASSERT_EQ(reader->scenes().size(), 2 + kMotors);
    for (std::size_t motor = 0; motor < kMotors; ++motor)
        EXPECT_EQ(reader->scenes()[2 + motor], lacking[motor]) << motor;
    EXPECT_FALSE(reader->verify().broken);
}

TEST_F(Session, isRefusedByReadersThatExpectBothCurrents)
{
    seal(path, 100);
    std::ifstream file(path, std::ios::binary);
    file.seekg(63);  // last byte of the user version; sqlite.org/fileformat2.html §1.3
    EXPECT_EQ(file.get(), 7) << "readers of version 6 read a missing left current as 0 A";
}

TEST_F(Session, ofVersion6ReadsTheSame)
{
    seal(path, 1000);
    const auto scenes = SessionReader::open(path)->scenes();
    const auto events = SessionReader::open(path)->events();
    change(path, "PRAGMA user_version = 6");
    auto older = SessionReader::open(path);
    ASSERT_TRUE(older) << older.error().text;
    EXPECT_EQ(older->scenes(), scenes);
    EXPECT_EQ(older->events(), events);
    EXPECT_FALSE(older->verify().broken);
}

TEST_F(Session, keepsBothSidesOfAScene)
{
    SceneRow scene = someScene(3, 600'000'000);
    Measurement& m = scene.measurement;
    m.roll = -0.2;
    m.frontLeft = 0.3, m.frontRight = 0.1, m.rearLeft = 0.2, m.rearRight = 0.4;
    m.frontLeftCurrent = 1.0, m.frontRightCurrent = 2.0;
    SideForces front;
    for (std::size_t e = 0; e < kForceElements; ++e) {
        front.left[e] = 1.0 + static_cast<double>(e);
        if (e != 4) front.right[e] = 11.0 + static_cast<double>(e);
        m.rearSides.left[e] = 21.0 + static_cast<double>(e);
        if (e != 0) m.rearSides.right[e] = 31.0 + static_cast<double>(e);
    }
    setSides(m, front);
    m.differential = -0.07;
    m.arm = ArmReading{.bin = 9, .height = -0.04, .sd = 0.03, .side = ProbeSide::Right};
    auto writer = someSession(path, 100);
    ASSERT_TRUE(writer) << writer.error().text;
    ASSERT_TRUE(writer->add(scene));
    EstimateRow estimate = someEstimate(3, 600'000'001);
    estimate.readings = {*m.arm};
    ASSERT_TRUE(writer->add(estimate));
    ProposalRow proposal = someProposal(600'000'002);
    proposal.id = 2;
    proposal.side = ProbeSide::Left;
    ASSERT_TRUE(writer->add(proposal));
    ASSERT_TRUE(writer->seal());
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    ASSERT_EQ(reader->scenes().size(), 3U);
    EXPECT_EQ(reader->scenes()[2], scene);
    EXPECT_EQ(reader->estimates().back().readings, estimate.readings);
    EXPECT_EQ(reader->proposals().back(), proposal);
    EXPECT_EQ(twoTrackReadings(reader->scenes()[2].measurement), twoTrackReadings(m));
    EXPECT_FALSE(reader->verify().broken);
}

TEST_F(Session, withholdsAVerdictForTheRecordedReason)
{
    EstimateRow estimate = someEstimate(3, 600'000'001);
    for (TerrainEstimate& side : estimate.estimate.side) side.contradicts = true;
    auto writer = someSession(path, 100);
    ASSERT_TRUE(writer) << writer.error().text;
    ASSERT_TRUE(writer->add(someScene(3, 600'000'000)));
    ASSERT_TRUE(writer->add(estimate));
    ASSERT_TRUE(writer->seal());
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    const EstimateRow& read = reader->estimates().back();
    EXPECT_TRUE(read.estimate.side[0].contradicts);
    const Proprioception s = proprioception(reader->scenes().back().measurement);
    const Verdict verdict = verdictOf(read.estimate.side[0], s, 0.1);
    EXPECT_EQ(verdict.stepVerdict, StepVerdict::CannotTell);
    EXPECT_EQ(std::ranges::count(verdict.withheldFor, WithholdReason::Contradiction), 1);
    EXPECT_FALSE(reader->estimates().front().estimate.side[0].contradicts);
}

TEST_F(Session, isReadFromAReadOnlyFolderOnceSealed)
{
    seal(path, 100);
    std::filesystem::permissions(directory.file(""), std::filesystem::perms::owner_read
                                                         | std::filesystem::perms::owner_exec);
    const auto reader = SessionReader::open(path);
    EXPECT_TRUE(reader) << reader.error().text;
    std::filesystem::permissions(directory.file(""), std::filesystem::perms::owner_all);
}

TEST_F(Session, isReadWhileItIsWritten)
{
    auto writer = someSession(path, 200);
    ASSERT_TRUE(writer) << writer.error().text;
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_FALSE(reader->sealed());
    EXPECT_EQ(reader->frameCount(), 200);
    EXPECT_FALSE(*reader->refresh());
    ASSERT_TRUE(writer->add(someFrame(200)));
    EXPECT_FALSE(*reader->refresh()) << "what is not committed is not there";
    ASSERT_TRUE(writer->commit());
    EXPECT_TRUE(*reader->refresh());
    EXPECT_EQ(reader->frameCount(), 201);
    EXPECT_EQ(allFrames(*reader).back(), someFrame(200));
    EXPECT_TRUE(reader->damage().empty());
    EXPECT_EQ(*recoverSession(path), SessionRecovery::InUse);
}

TEST_F(Session, refusesReferencesToMissingRows)
{
    auto writer = SessionWriter::create(path, someStart());
    ASSERT_TRUE(writer);
    EXPECT_THROW((void)writer->add(someEstimate(1, 0)), std::invalid_argument);
    ASSERT_TRUE(writer->add(someScene(2, 0)));
    EXPECT_THROW((void)writer->add(someScene(2, 0)), std::invalid_argument);
}

TEST_F(Session, existingFileIsLeftAlone)
{
    seal(path, 100);
    const auto again = SessionWriter::create(path, someStart());
    ASSERT_FALSE(again);
    EXPECT_NE(again.error().text.find(path), std::string::npos);
    EXPECT_TRUE(SessionReader::open(path));
    std::filesystem::create_symlink("nowhere", path + "-wal");
    EXPECT_TRUE(refused(SessionWriter::create(path, someStart()), path, {": is there already"}));
    std::filesystem::remove(path + "-wal");
}

TEST_F(Session, rowsFurtherAwayThanReadersTakeAreRefused)
{
    for (const SessionTime sign : {1, -1}) {
        const std::string file = path + (sign > 0 ? "+" : "-");
        auto writer = SessionWriter::create(file, someStart());
        ASSERT_TRUE(writer);
        FrameRow frame = someFrame(1);
        frame.time = sign * kMaxSessionTime;
        EXPECT_TRUE(writer->add(frame));
        frame.time += sign;
        EXPECT_TRUE(
            refused(writer->add(frame), file, {"more than 36 years from the session's begin"}));
    }
}

TEST_F(Session, nothingIsLeftWhereAFileBesideItIsInTheWay)
{
    for (const char* const end : {"-wal", "-shm", "-journal"}) {
        const std::string beside = path + end;
        std::filesystem::create_symlink("nowhere", beside);
        EXPECT_TRUE(
            refused(SessionWriter::create(path, someStart()), path,
                    {std::filesystem::path(beside).filename().string() + " is there already"}));
        EXPECT_FALSE(std::filesystem::exists(path)) << end;
        EXPECT_TRUE(std::filesystem::is_symlink(beside));
        std::filesystem::remove(beside);
    }
    EXPECT_TRUE(SessionWriter::create(path, someStart()));
}

}  // namespace
}  // namespace terratact
