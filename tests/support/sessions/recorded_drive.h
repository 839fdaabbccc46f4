#pragma once

#include <cblas.h>
#include <gtest/gtest.h>

#include <string>

#include "core/infer/estimator.h"
#include "core/learn/model/file/model_file.h"
#include "core/log/session_reader.h"
#include "core/robot/robot_model.h"
#include "tests/support/sessions/recorded_session.h"
#include "tests/support/temporary_directory.h"

namespace terratact {

inline constexpr const char* kModel = TERRATACT_SOURCE_DIR "/resources/models/default.ttm";
inline constexpr const char* kRobot = TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml";

/// A recorded drive with a probe, and the shipped model.
struct Drive : testing::Test {
    static void SetUpTestSuite()
    {
        openblas_set_num_threads(1);
        folder = new TemporaryDirectory;
        recordDrive(folder->file("drive.tts"));
        models = new Models(readModel(kModel)->data, *readRobotModel(kRobot));
    }
    static void TearDownTestSuite()
    {
        delete models;
        delete folder;
    }

    TemporaryDirectory directory;
    SessionReader reader = *SessionReader::open(folder->file("drive.tts"));

    static inline TemporaryDirectory* folder = nullptr;
    static inline const Models* models = nullptr;
};

}  // namespace terratact
