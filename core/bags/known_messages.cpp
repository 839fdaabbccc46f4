#include "core/bags/known_messages.h"

#include <algorithm>
#include <array>
#include <utility>

namespace terratact {
namespace {

// Only names, types and order of the members count (ROS 2 common_interfaces, geometry2).
#define TERRATACT_PART(name) "================\nMSG: " name "\n"
#define TERRATACT_HEADER                                                                           \
    TERRATACT_PART("std_msgs/Header")                                                              \
    "builtin_interfaces/Time stamp\nstring frame_id\n" TERRATACT_PART(                             \
        "builtin_interfaces/Time") "int32 sec\nuint32 nanosec\n"
#define TERRATACT_VECTOR TERRATACT_PART("geometry_msgs/Vector3") "float64 x\nfloat64 y\nfloat64 z\n"
#define TERRATACT_QUATERNION                                                                       \
    TERRATACT_PART("geometry_msgs/Quaternion") "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"
#define TERRATACT_TWIST                                                                            \
    TERRATACT_PART("geometry_msgs/Twist") "Vector3 linear\nVector3 angular\n" TERRATACT_VECTOR
#define TERRATACT_LAYOUT                                                                           \
    TERRATACT_PART("std_msgs/MultiArrayLayout")                                                    \
    "MultiArrayDimension[] dim\nuint32 data_offset\n" TERRATACT_PART(                              \
        "std_msgs/MultiArrayDimension") "string label\nuint32 size\nuint32 stride\n"

constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kDefinitions{{
    {"sensor_msgs/JointState", "std_msgs/Header header\nstring[] name\nfloat64[] position\n"
                               "float64[] velocity\nfloat64[] effort\n" TERRATACT_HEADER},
    {"sensor_msgs/Imu",
     "std_msgs/Header header\n"
     "geometry_msgs/Quaternion orientation\nfloat64[9] orientation_covariance\n"
     "geometry_msgs/Vector3 angular_velocity\nfloat64[9] angular_velocity_covariance\n"
     "geometry_msgs/Vector3 linear_acceleration\nfloat64[9] "
     "linear_acceleration_covariance\n" TERRATACT_HEADER TERRATACT_QUATERNION TERRATACT_VECTOR},
    {"nav_msgs/Odometry",
     "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance "
     "pose\n"
     "geometry_msgs/TwistWithCovariance twist\n" TERRATACT_HEADER TERRATACT_PART(
         "geometry_msgs/PoseWithCovariance") "Pose pose\nfloat64[36] "
                                             "covariance"
                                             "\n" TERRATACT_PART(
                                                 "geomet"
                                                 "ry_"
                                                 "msgs/"
                                                 "Pose") "Point position\nQuaternion "
                                                         "orientation\n" TERRATACT_PART(
                                                             "geomet"
                                                             "ry_"
                                                             "msgs/"
                                                             "Point") "float64 x\nfloat64 "
                                                                      "y\nfloat64 "
                                                                      "z\n" TERRATACT_QUATERNION
                                                                          TERRATACT_PART(
                                                                              "geometry_msgs/"
                                                                              "TwistWithCovarianc"
                                                                              "e") "Twist "
                                                                                   "twist\nfloat6"
                                                                                   "4[36] "
                                                                                   "covariance"
                                                                                   "\n" TERRATACT_TWIST},
    {"geometry_msgs/TwistStamped",
     "std_msgs/Header header\nTwist twist\n" TERRATACT_HEADER TERRATACT_TWIST},
    {"std_msgs/Float64", "float64 data\n"},
    {"std_msgs/Float32", "float32 data\n"},
    {"std_msgs/Float64MultiArray", "MultiArrayLayout layout\nfloat64[] data\n" TERRATACT_LAYOUT},
    {"std_msgs/Float32MultiArray", "MultiArrayLayout layout\nfloat32[] data\n" TERRATACT_LAYOUT},
    {"tf2_msgs/TFMessage",
     "geometry_msgs/TransformStamped[] transforms\n" TERRATACT_PART(
         "geometry_msgs/TransformStamped") "std_msgs/Header header\nstring "
                                           "child_frame_id\n"
                                           "Transform transform\n" TERRATACT_HEADER TERRATACT_PART(
                                               "geometry_msgs/Transform") "Vector3 "
                                                                          "translat"
                                                                          "ion\nQua"
                                                                          "ternion "
                                                                          "rotation"
                                                                          "\n" TERRATACT_VECTOR
                                                                              TERRATACT_QUATERNION},
}};

#undef TERRATACT_PART
#undef TERRATACT_HEADER
#undef TERRATACT_VECTOR
#undef TERRATACT_QUATERNION
#undef TERRATACT_TWIST
#undef TERRATACT_LAYOUT

}  // namespace

std::string_view knownDefinition(std::string_view type)
{
    constexpr std::string_view kMiddle = "/msg/";
    const auto middle = type.find(kMiddle);
    const std::string_view package = type.substr(0, middle);
    const auto* const found = std::ranges::find_if(kDefinitions, [&](const auto& known) {
        if (middle == std::string_view::npos) return known.first == type;
        const std::size_t slash = known.first.find('/');
        return known.first.substr(0, slash) == package
            && known.first.substr(slash + 1) == type.substr(middle + kMiddle.size());
    });
    return found == kDefinitions.end() ? std::string_view{} : found->second;
}

}  // namespace terratact
