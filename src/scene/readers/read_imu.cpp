#include "scene/limits.hpp"
#include "scene/readers/readers.hpp"

namespace rigid_body_sim {
namespace {

struct GyroscopeUnits {
  static constexpr const char* kDensity = "rad/s/sqrt(Hz)";
  static constexpr const char* kBias = "rad/s";
  static constexpr const char* kWalk = "rad/s^2/sqrt(Hz)";
};

struct AccelerometerUnits {
  static constexpr const char* kDensity = "m/s^2/sqrt(Hz)";
  static constexpr const char* kBias = "m/s^2";
  static constexpr const char* kWalk = "m/s^3/sqrt(Hz)";
};

template <class Units>
SensorNoise readSensor(const Entry& entry) {
  using Def = SensorNoise;
  static const std::vector<Key<Def>> keys = {
      {"noise_density",
       [](const Entry& e, Def& d) { d.density = readNotNegative(e, Units::kDensity); }},
      {"bias", [](const Entry& e, Def& d) { d.bias = readVector3(e, Units::kBias); }},
      {"bias_walk", [](const Entry& e, Def& d) { d.bias_walk = readNotNegative(e, Units::kWalk); }},
  };
  SensorNoise noise;
  readMapping(entry, keys, noise);
  return noise;
}

double readImuRate(const Entry& value) {
  const double rate = readPositive(value, "Hz");
  if (rate > kMaxImuRate) value.failRule("must be > 0 and at most 1e6 Hz");
  return rate;
}

ImuDef readOne(const Entry& entry) {
  static const std::vector<Key<Imu>> keys = {
      {"position", [](const Entry& e, Imu& i) { i.position_B = readVector3(e, "m"); }},
      {"orientation", [](const Entry& e, Imu& i) { i.q_BS = readOrientation(e); }},
      {"rate", [](const Entry& e, Imu& i) { i.rate = readImuRate(e); }, true},
      {"seed", [](const Entry& e, Imu& i) { i.seed = readWhole(e); }},
      {"gyroscope", [](const Entry& e, Imu& i) { i.gyroscope = readSensor<GyroscopeUnits>(e); }},
      {"accelerometer",
       [](const Entry& e, Imu& i) { i.accelerometer = readSensor<AccelerometerUnits>(e); }},
  };
  ImuDef def;
  def.imu.name = std::string(entry.node().key());
  def.line = entry.node().line();
  if (!isName(def.imu.name)) entry.fail("imus: '" + printable(def.imu.name) + "' " + nameRule());
  readMapping(entry, keys, def.imu);
  return def;
}

}  // namespace

std::vector<ImuDef> readImus(const Entry& entry) {
  if (entry.node().kind() != YamlNode::Kind::kMapping)
    entry.failRule("must be a mapping of names to IMUs");
  entry.checkCount(kMaxImus, "imus");
  std::vector<ImuDef> imus;
  for (const YamlNode& node : entry.node().children()) imus.push_back(readOne(entry.child(node)));
  return imus;
}

}  // namespace rigid_body_sim
